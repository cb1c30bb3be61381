/* The maps of a data set side by side with their rooms: a picture for each set, and a page. */
#ifndef ROOMSEG_EXPLAIN_SHEET_H
#define ROOMSEG_EXPLAIN_SHEET_H

#include "map.h"
#include "roomseg/roomseg.h"
#include "tool_error.h"

typedef struct sheet_request {
    const char *dataset;   /* as dataset_open takes it */
    const char *set;       /* NULL: all */
    const char *reference; /* folder with labels of another program, NULL: none */
    map_options options;
    roomseg_config by_default, by_paper; /* of the two columns */
} sheet_request;

/* Writes FOLDER/NN_SET.png for each set, and FOLDER/sheet.html. *maps: how many are on it.
 * Labels of another program are those of the first file that exists of reference/SET/NAME.pgm,
 * .png, and the same with the digits alone with which NAME begins.
 * Fails iff: the data set cannot be read or has no such set, sheet_row_make fails for a map, the
 * files cannot be written, or memory runs out. Returns 0, or -1 with *error set; then no file is
 * written. */
int sheet_write(const sheet_request *q, const char *folder, size_t *maps, tool_error *error);

#endif
