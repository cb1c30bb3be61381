/* Many maps in one call: a fleet's. */
#ifndef ROOMSEG_TOOLS_SEGMENT_BATCH_H
#define ROOMSEG_TOOLS_SEGMENT_BATCH_H

#include <stddef.h>

#include "map.h"
#include "roomseg/roomseg.h"
#include "tool_error.h"

typedef struct segment_batch {
    const char *const *paths;
    size_t count;
    const char *folder; /* map DIR/NAME.pgm goes to FOLDER/NAME/ */
    map_options options;
    roomseg_config config;
    int workers;
} segment_batch;

/* Segments all maps and prints one line a map in the order of the paths: rooms and area on
 * standard output, or what failed on standard error. One map's failure does not stop the others.
 * Fails iff: two maps have the same NAME, memory runs out (nothing is done in both cases), or at
 * least one map failed. Returns 0, or -1 with *error set. */
int segment_batch_run(const segment_batch *batch, tool_error *error);

#endif
