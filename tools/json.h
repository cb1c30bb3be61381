/* Pieces of JSON text. */
#ifndef ROOMSEG_TOOLS_JSON_H
#define ROOMSEG_TOOLS_JSON_H

#include <stdio.h>

/* Writes a string with its quotes. Bytes that are no UTF-8 become U+FFFD. */
void json_string(FILE *stream, const char *text);

/* Writes a number with at most `decimals` (0..9) digits behind the point, trailing zeros
 * left out, the point being a point in every locale. Not finite or beyond 1e9: null. */
void json_number(FILE *stream, double value, int decimals);

#endif
