/* One map from its file to the files with its rooms. */
#ifndef ROOMSEG_TOOLS_SEGMENT_FILE_H
#define ROOMSEG_TOOLS_SEGMENT_FILE_H

#include "map.h"
#include "segment.h"
#include "tool_error.h"

/* What is written into the folder. */
#define SEGMENT_FILE_NAMES "{labels.pgm,rooms.json,rooms.png}"

/* Reads and segments a map and writes labels.pgm, rooms.json and rooms.png into a folder, which
 * is made when it is missing. All three files are there in the end, or what was there before.
 * Returns 0 with *m and *s to be freed, m->cells and s->labels being gone already, or -1 with
 * *error set. */
int segment_file(const char *path, const char *folder, const map_options *options,
                 const roomseg_config *config, map *m, segmentation *s, tool_error *error);

#endif
