/* A map on the host: an occupancy grid with its place in the world. */
#ifndef ROOMSEG_TOOLS_MAP_H
#define ROOMSEG_TOOLS_MAP_H

#include <stddef.h>
#include <stdint.h>

#include "tool_error.h"

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
    int invert;          /* not 0: white is free in bare images; a YAML says it itself */
} map_options;

/* Reads PNG, PGM (P2/P5) or a ROS map_server YAML with its image, by content.
 * Returns 0, or -1 with *error set and *out zeroed. */
int map_load(const char *path, const map_options *options, map *out, tool_error *error);

/* Frees the cells and zeroes the record. */
void map_free(map *m);

/* World position of the centre of cell (x, y); fractions allowed [cells -> m]. */
void map_cell_to_world(const map *m, double x, double y, double *world_x_m,
                       double *world_y_m);

#endif
