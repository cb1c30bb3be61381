/* A map with its true rooms, to be changed together. */
#ifndef ROOMSEG_VARY_SCENE_H
#define ROOMSEG_VARY_SCENE_H

#include "label_image.h"
#include "map.h"
#include "tool_error.h"

typedef struct scene {
    map m;             /* resolution in whole mm; the origin has no meaning any more */
    label_image truth; /* as large as the map; values NULL: there is none */
} scene;

/* Reads both and cuts them to the box of what is known, with a margin of one cell.
 * truth_path: NULL when there is none.
 * Fails iff: a file cannot be read, the sizes differ, or memory runs out. Returns 0, or -1
 * with *error set and *out zeroed. */
int scene_load(const char *map_path, const char *truth_path, const map_options *options,
               scene *out, tool_error *error);

/* Writes FOLDER/map.pgm and FOLDER/truth.pgm, both or neither; the folder is made when it is
 * missing. Returns 0, or -1 with *error set. */
int scene_write(const scene *s, const char *folder, tool_error *error);

/* Frees the cells and zeroes the record. */
void scene_free(scene *s);

/* 1 for a cell that the robot has seen: all but 127 and 128. */
int scene_is_known(uint8_t cell);

/* Edge of a cell [mm]. */
int scene_resolution_mm(const scene *s);

/* Takes the cells from `source` into a new scene of the given size, which replaces *s.
 * source_of: index of the cell in the old scene, or SCENE_OUTSIDE for unknown without a
 * room. Returns 0, or -1 when memory runs out; *s then is as it was. */
#define SCENE_OUTSIDE ((size_t)-1)
typedef size_t (*scene_source_fn)(const void *user, uint32_t x, uint32_t y);
int scene_rearrange(scene *s, uint32_t width, uint32_t height, scene_source_fn source_of,
                    const void *user);

#endif
