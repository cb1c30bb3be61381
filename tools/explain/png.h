/* PNG files in memory. */
#ifndef ROOMSEG_EXPLAIN_PNG_H
#define ROOMSEG_EXPLAIN_PNG_H

#include <stddef.h>
#include <stdint.h>

#include "draw.h"

typedef struct encoded_png {
    char *bytes; /* owned */
    size_t size;
    uint32_t width, height;
} encoded_png;

/* Returns 0, or -1 when memory runs out; out->bytes is to be freed in both cases. */
int png_encode(const canvas *c, encoded_png *out);

/* A smaller copy that fits into width x height pixels, each the mean of those that it stands
 * for; a canvas that fits already is copied as it is.
 * Returns 0, or -1 with *out zeroed when memory runs out. */
int canvas_shrink(const canvas *c, uint32_t width, uint32_t height, canvas *out);

#endif
