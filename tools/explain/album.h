/* The pictures of an explanation, as PNG files in memory. */
#ifndef ROOMSEG_EXPLAIN_ALBUM_H
#define ROOMSEG_EXPLAIN_ALBUM_H

#include "png.h"

typedef struct figure {
    char *name; /* "distance"; owned */
    char *file; /* "04_distance.png"; owned */
    encoded_png full, thumbnail;
} figure;

typedef struct album {
    figure *figures;
    size_t count;
} album;

/* Longer side of a thumbnail [px]. */
#define ALBUM_THUMBNAIL_PX 168u

/* Adds a picture; its file gets the next number. The canvas is freed in any case.
 * Fails iff: memory runs out. Returns 0 or -1. */
int album_add(album *a, const char *name, canvas *c);

/* The picture of that name, or NULL. */
const figure *album_find(const album *a, const char *name);

/* Frees the pictures and zeroes the record. */
void album_free(album *a);

#endif
