/* A map on the host: an occupancy grid with its place in the world. */
#ifndef ROOMSEG_TOOLS_MAP_H
#define ROOMSEG_TOOLS_MAP_H

#include <stddef.h>
#include <stdint.h>

#include "image.h"
#include "tool_error.h"

#define MAP_UNKNOWN 127u

/* Resolution of a map that nobody has said: that of many robots and of the usual
 * benchmarks [m]. */
#define MAP_DEFAULT_RESOLUTION_M 0.04

typedef struct map {
    uint8_t *cells;      /* width * height bytes, row 0 = top of the image; owned.
                            0 free .. 255 occupied, 127 or 128 unknown */
    uint32_t width, height;
    double resolution_m; /* edge of a cell [m] */
    /* World pose of the lower left corner of the lower left cell (ROS map_server's
     * convention): x right, y up, yaw counter-clockwise [m, m, rad]. */
    double origin_x_m, origin_y_m, origin_yaw_rad;
} map;

/* How to read an image that does not say it itself. */
typedef struct map_options {
    double resolution_m; /* > 0 overrides the file's; 0: what the file says, else 0.04 */
    int invert;          /* not 0: white is free, black occupied; for bare images only,
                            a YAML says it itself */
} map_options;

/* Reads PNG, PGM (P2/P5) or a ROS map_server YAML with its image, by content.
 *
 * Bare images hold occupancies, scaled to 0..255 from what white is in them; pixels that
 * are not opaque are unknown. A PNG's origin is 0. A PGM may carry the comment of a Neato
 * robot (map_pgm.h), from which resolution and origin are taken. It does not say which
 * corner its origin means (known files are square and centred on the origin, so that it
 * makes no difference); the lower left one is assumed, as for map_server. Its alignment is
 * the direction of the flat's walls, not of the map: yaw stays 0.
 *
 * Fails iff: a file cannot be read, is none of these formats or damaged (image.h, yaml.h,
 * map_yaml.h), the resolution rounds to less than ROOMSEG_MIN_RESOLUTION_MM or more than
 * ROOMSEG_MAX_RESOLUTION_MM, options->invert is set for a YAML, or memory runs out.
 * Returns 0, or -1 with *error set and *out zeroed. */
int map_load(const char *path, const map_options *options, map *out, tool_error *error);

/* Cells from the samples of an image. cell_of: for each sample 0..maxval its cell; pixels
 * that are not opaque become MAP_UNKNOWN. Resolution and origin are left 0.
 * Returns 0, or -1 with *error set and *out zeroed. */
int map_from_image(const image *img, const uint8_t *cell_of, const char *name, map *out,
                   tool_error *error);

/* Frees the cells alone. */
void map_free_cells(map *m);

/* Frees the cells and zeroes the record. */
void map_free(map *m);

/* World position of the centre of cell (x, y); fractions allowed [cells -> m]. */
void map_cell_to_world(const map *m, double x, double y, double *world_x_m,
                       double *world_y_m);

#endif
