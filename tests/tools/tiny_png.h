/* PNG files byte by byte, of kinds that an image library does not like to write. */
#ifndef TESTS_TOOLS_TINY_PNG_H
#define TESTS_TOOLS_TINY_PNG_H

#include <stddef.h>
#include <stdint.h>

enum { PNG_GRAY = 0, PNG_RGB = 2, PNG_PALETTE = 3, PNG_GRAY_ALPHA = 4 };

#define TINY_PNG_MAX_BYTES 1024

typedef struct tiny_png {
    uint8_t bytes[TINY_PNG_MAX_BYTES];
    size_t size;
    size_t idat; /* offset of the IDAT chunk */
} tiny_png;

/* rows: height rows of row_bytes each, as the PNG holds them, without filter bytes.
 * palette: palette_size RGB triples for PNG_PALETTE, else NULL. */
tiny_png tiny_png_make(uint32_t width, uint32_t height, int bit_depth, int color_type,
                       const uint8_t *rows, size_t row_bytes, size_t row_count,
                       const uint8_t *palette, size_t palette_size);

/* A PNG around a compressed stream; `out` has room for 100 bytes more than that. Returns the
 * size. */
size_t tiny_png_wrap(uint32_t width, uint32_t height, int bit_depth, int color_type,
                     const uint8_t *stream, size_t stream_size, uint8_t *out);

#endif
