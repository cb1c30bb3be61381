#define _POSIX_C_SOURCE 200809L

#include "album.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int encode_thumbnail(const canvas *c, encoded_png *out) {
    canvas small;
    if (canvas_shrink(c, ALBUM_THUMBNAIL_PX, ALBUM_THUMBNAIL_PX, &small) != 0) {
        return -1;
    }
    int rc = png_encode(&small, out);
    canvas_free(&small);
    return rc;
}

static char *file_name(size_t number, const char *name) {
    size_t size = strlen(name) + sizeof "18446744073709551615_.png";
    char *file = malloc(size);
    if (file != NULL) {
        snprintf(file, size, "%02zu_%s.png", number, name);
    }
    return file;
}

int album_add(album *a, const char *name, canvas *c) {
    figure *figures = realloc(a->figures, (a->count + 1) * sizeof *figures);
    int rc = -1;
    if (figures != NULL) {
        figure *f = &figures[a->count];
        a->figures = figures;
        memset(f, 0, sizeof *f);
        f->name = strdup(name);
        f->file = file_name(++a->count, name);
        if (f->name != NULL && f->file != NULL && png_encode(c, &f->full) == 0) {
            rc = encode_thumbnail(c, &f->thumbnail);
        }
    }
    canvas_free(c);
    return rc;
}

const figure *album_find(const album *a, const char *name) {
    for (size_t i = 0; i < a->count; i++) {
        if (strcmp(a->figures[i].name, name) == 0) {
            return &a->figures[i];
        }
    }
    return NULL;
}

void album_free(album *a) {
    for (size_t i = 0; i < a->count; i++) {
        free(a->figures[i].name);
        free(a->figures[i].file);
        free(a->figures[i].full.bytes);
        free(a->figures[i].thumbnail.bytes);
    }
    free(a->figures);
    *a = (album){NULL, 0};
}
