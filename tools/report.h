/* What a segmentation found, for programs and for people. */
#ifndef ROOMSEG_TOOLS_REPORT_H
#define ROOMSEG_TOOLS_REPORT_H

#include <stddef.h>
#include <stdio.h>

#include "map.h"
#include "segment.h"

/* Version of the JSON's fields; raised when one changes its meaning or goes. */
#define REPORT_JSON_VERSION 1

/* Writes rooms.json. file: the map's name as given. Positions come twice: in cells of the
 * map, row 0 being the top, and in metres in the map's frame (map_cell_to_world).
 * Numbers do not depend on the locale; the text is UTF-8 whatever the file is called.
 * What the stream could not take shows in its error flag. */
void report_json(const map *m, const segmentation *s, const char *file, FILE *stream);

/* Writes a table of the rooms. */
void report_table(const map *m, const segmentation *s, FILE *stream);

/* Writes labels as a binary PGM with the maxval 255, or 65535 when there are more rooms. */
void report_labels_pgm(const map *m, const segmentation *s, FILE *stream);

#endif
