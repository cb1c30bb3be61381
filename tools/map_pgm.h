/* PGM files, and what a Neato robot says in their header. */
#ifndef ROOMSEG_TOOLS_MAP_PGM_H
#define ROOMSEG_TOOLS_MAP_PGM_H

#include <stddef.h>

#include "image.h"
#include "tool_error.h"

/* Decodes P2 (text) or P5 (binary, one or two bytes a sample, high byte first).
 * Comments may stand anywhere in the header, in a P2 also between the samples.
 * Fails iff: the file is another kind of netpbm file, the header is malformed, the size is
 * outside the limits of image.h, maxval is outside 1..65535, samples are missing, above
 * maxval or too many, or memory runs out. Returns 0, or -1 with *error set; *out then
 * holds nothing that needs to be freed but by image_free. */
int pgm_decode(const unsigned char *bytes, size_t size, const char *name, image *out,
               tool_error *error);

/* The header comment of a map that a Neato robot exports:
 *     # Neato metadata: origin_x=X origin_y=Y resolution=R alignment=A
 * X, Y: world position of the map's corner [mm]; R: edge of a cell [mm]; A: direction of
 * the flat's walls [rad], which turns nothing and is not used here. */
typedef struct neato_metadata {
    int found; /* 0: there is no such comment, the rest is 0 */
    double origin_x_mm, origin_y_mm, resolution_mm;
} neato_metadata;

/* Looks through the header of a PGM. Each of the four keys may be missing, others are
 * passed over. Fails iff: a value of the first three is not a number, or resolution is
 * missing. Returns 0, or -1 with *error set. */
int pgm_neato_metadata(const unsigned char *bytes, size_t size, const char *name,
                       neato_metadata *out, tool_error *error);

#endif
