/* One map of the sheet: the same crop with the map, the truth and each program's rooms. */
#ifndef ROOMSEG_EXPLAIN_SHEET_ROW_H
#define ROOMSEG_EXPLAIN_SHEET_ROW_H

#include "dataset.h"
#include "draw.h"
#include "map.h"
#include "roomseg/roomseg.h"
#include "tool_error.h"

enum { SHEET_MAP, SHEET_TRUTH, SHEET_DEFAULT, SHEET_PAPER, SHEET_REFERENCE, SHEET_COLUMNS };

/* Pixels that a picture of the sheet may take. */
enum { SHEET_CELL_WIDTH = 300, SHEET_CELL_HEIGHT = 260 };

typedef struct sheet_cell {
    canvas picture; /* without pixels: there is none; owned */
    int has_rooms, has_score;
    uint32_t rooms;
    double v;       /* V-measure, 0 to 1 */
} sheet_cell;

typedef struct sheet_row {
    const char *name; /* the map's, not owned */
    sheet_cell cells[SHEET_COLUMNS];
} sheet_row;

/* Rooms that overlap a true room by more than any other have that room's colour in all columns,
 * with a seam between rooms; without truth those of the default profile take its place.
 * reference: path of another program's labels, NULL: none; 255 is no room. Labels of another
 * size than the map, or of a turned one, are drawn by themselves.
 * Fails iff: a file cannot be read, the truth has another size, the library refuses the map, no
 * cell is free, or memory runs out. Returns 0, or -1 with *error set and *out zeroed. */
int sheet_row_make(const dataset_map *files, const char *reference, const map_options *options,
                   const roomseg_config *by_default, const roomseg_config *by_paper,
                   sheet_row *out, tool_error *error);

void sheet_row_free(sheet_row *row);

#endif
