/* An image whose values are labels: what a segmentation gave, or the truth. */
#ifndef ROOMSEG_TOOLS_LABEL_IMAGE_H
#define ROOMSEG_TOOLS_LABEL_IMAGE_H

#include <stdint.h>

#include "tool_error.h"

typedef struct label_image {
    uint32_t *values; /* width * height, row 0 = top; 0 = no room; owned */
    uint32_t width, height;
} label_image;

/* Reads a PGM or a grey PNG. Values are taken as the file holds them, never scaled to a
 * maximum (but PNGs of 1, 2 or 4 bits: image.h). Fails iff: image_load does, or memory
 * runs out. Returns 0, or -1 with *error set and *out zeroed. */
int label_image_load(const char *path, label_image *out, tool_error *error);

/* Turns every cell of this value into "no room". */
void label_image_clear(label_image *labels, uint32_t value);

/* Frees the values and zeroes the record. */
void label_image_free(label_image *labels);

#endif
