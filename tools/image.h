/* Gray images from PNG and PGM files, and PNG out. */
#ifndef ROOMSEG_TOOLS_IMAGE_H
#define ROOMSEG_TOOLS_IMAGE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "tool_error.h"

#define IMAGE_MAX_SIDE 65535u
#define IMAGE_MAX_CELLS ((size_t)1 << 28)

/* A gray image with the samples as the file holds them. PNGs with 1, 2 or 4 bits come
 * scaled to 0..255, as the PNG standard asks for. */
typedef struct image {
    uint16_t *gray;         /* width * height samples 0..maxval, row 0 = top; owned */
    uint8_t *opaque;        /* width * height, 1 = fully opaque; NULL when all are; owned */
    uint32_t width, height; /* 1..IMAGE_MAX_SIDE */
    uint32_t maxval;        /* 1..65535, the white sample */
} image;

/* Decodes a PNG (gray of any depth; colour only when red = green = blue in each pixel) or
 * a PGM (P2, P5), by content. name: the file, for messages.
 * Fails iff: the bytes are neither, are damaged or truncated, the image has colours, is
 * larger than the limits above, or memory runs out. Returns 0, or -1 with *error set and
 * *out zeroed. */
int image_decode(const unsigned char *bytes, size_t size, const char *name, image *out,
                 tool_error *error);

/* The same from a file; fails also iff infile_read does. */
int image_load(const char *path, image *out, tool_error *error);

/* 1 when the bytes begin as a PNG or a netpbm file does. */
int image_is_png(const unsigned char *bytes, size_t size);
int image_is_pnm(const unsigned char *bytes, size_t size);

/* Returns 0 when the sides are within the limits, or -1 with *error set. */
int image_check_size(uint32_t width, uint32_t height, const char *name, tool_error *error);

/* Memory for the samples of an image of this size; the sides must be within the limits.
 * Returns 0, or -1 with *error set and *out zeroed. */
int image_allocate(uint32_t width, uint32_t height, uint32_t maxval, const char *name,
                   image *out, tool_error *error);

/* Frees the samples and zeroes the record. */
void image_free(image *img);

/* Writes 8-bit samples as PNG. channels: 1 gray, 3 RGB. Returns 0, or -1 when memory runs
 * out; what the stream could not take shows in its error flag. */
int image_write_png(FILE *stream, const uint8_t *pixels, uint32_t width, uint32_t height,
                    int channels);

#endif
