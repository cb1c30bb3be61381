/* Runs the library on a map and looks after the memory. */
#ifndef ROOMSEG_TOOLS_SEGMENT_H
#define ROOMSEG_TOOLS_SEGMENT_H

#include <stddef.h>
#include <stdint.h>

#include "map.h"
#include "roomseg/roomseg.h"
#include "tool_error.h"

typedef struct segmentation {
    uint16_t *labels;      /* width * height of the map, owned */
    roomseg_result result; /* its arrays lie in the arena */
    roomseg_config config; /* with the capacities that the map took */
    void *arena;           /* owned; NULL when no cell is free */
    size_t arena_bytes;
} segmentation;

/* The map as the library sees it: shares the cells, resolution rounded to whole mm. */
roomseg_grid segment_grid(const map *m);

/* Segments a map. Capacities for regions and rooms that turn out too small are doubled
 * up to the library's limit.
 * name: the map's file, for messages.
 * Returns 0, or -1 with *error set and *out zeroed. */
int segment_map(const map *m, const roomseg_config *config, const char *name,
                segmentation *out, tool_error *error);

/* Runs once more in the memory that is there; for measuring time. m: the same map.
 * Returns a roomseg_status. */
int segment_again(const map *m, segmentation *s);

/* Frees the labels alone; the result stays. */
void segmentation_free_labels(segmentation *s);

/* Frees the memory and zeroes the record. */
void segmentation_free(segmentation *s);

#endif
