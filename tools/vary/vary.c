#include "vary.h"

#include <stdlib.h>
#include <string.h>

#include "simulate/turn.h"

#define PLACES_TRIED 1000
#define MM2_IN_1000_M2 UINT64_C(1000000000)

/* 1 when a square of `side` cells at (x, y) lies inside the map and all of it is free. */
static int is_free_square(const scene *s, uint8_t free_max, int64_t x, int64_t y,
                          int64_t side) {
    if (x < 0 || y < 0 || x + side > s->m.width || y + side > s->m.height) {
        return 0;
    }
    for (int64_t row = y; row < y + side; row++) {
        const uint8_t *cells = s->m.cells + (size_t)row * s->m.width + x;
        for (int64_t i = 0; i < side; i++) {
            if (cells[i] > free_max) {
                return 0;
            }
        }
    }
    return 1;
}

static uint64_t count_free(const scene *s, uint8_t free_max) {
    size_t count = (size_t)s->m.width * s->m.height;
    uint64_t cells = 0;
    for (size_t i = 0; i < count; i++) {
        cells += s->m.cells[i] <= free_max;
    }
    return cells;
}

/* Returns 1 when a place was found. */
static int place_piece(scene *s, uint8_t free_max, int32_t side, int32_t gap, rng *r) {
    for (int i = 0; i < PLACES_TRIED; i++) {
        int32_t x = rng_range(r, 0, (int32_t)s->m.width - 1);
        int32_t y = rng_range(r, 0, (int32_t)s->m.height - 1);
        if (is_free_square(s, free_max, (int64_t)x - gap, (int64_t)y - gap, side + 2 * gap)) {
            for (int32_t row = y; row < y + side; row++) {
                memset(s->m.cells + (size_t)row * s->m.width + x, 255, (size_t)side);
            }
            return 1;
        }
    }
    return 0;
}

uint32_t vary_clutter(scene *s, uint8_t free_max, uint32_t per_1000_m2, rng *r) {
    int32_t mm = scene_resolution_mm(s);
    int32_t gap = (VARY_CLUTTER_GAP_MM + mm / 2) / mm;
    uint64_t area_mm2 = count_free(s, free_max) * (uint64_t)mm * (uint64_t)mm;
    uint64_t pieces = area_mm2 * per_1000_m2 / MM2_IN_1000_M2;
    uint32_t placed = 0;
    for (uint64_t i = 0; i < pieces; i++) {
        int32_t edge = rng_range(r, VARY_CLUTTER_MIN_MM, VARY_CLUTTER_MAX_MM);
        placed += (uint32_t)place_piece(s, free_max, (edge + mm / 2) / mm, gap, r);
    }
    return placed;
}

typedef struct rotation {
    int64_t sine, cosine; /* times 65536 */
    int64_t width, height, new_width, new_height;
} rotation;

static int64_t floor_div(int64_t a, int64_t b) {
    return a / b - (a % b < 0);
}

/* Positions are counted from the middle in halves of a cell, so that they are whole. */
static size_t rotation_source(const void *user, uint32_t x, uint32_t y) {
    const rotation *t = user;
    int64_t dx = 2 * (int64_t)x + 1 - t->new_width;
    int64_t dy = 2 * (int64_t)y + 1 - t->new_height;
    int64_t old_x = floor_div(t->cosine * dx + t->sine * dy + t->width * 65536, 131072);
    int64_t old_y = floor_div(t->cosine * dy - t->sine * dx + t->height * 65536, 131072);
    if (old_x < 0 || old_y < 0 || old_x >= t->width || old_y >= t->height) {
        return SCENE_OUTSIDE;
    }
    return (size_t)(old_y * t->width + old_x);
}

/* 1 when an image may have this size. */
static int fits(int64_t width, int64_t height) {
    return width <= (int64_t)IMAGE_MAX_SIDE && height <= (int64_t)IMAGE_MAX_SIDE &&
           width * height <= (int64_t)IMAGE_MAX_CELLS;
}

int vary_turn(scene *s, int32_t turn) {
    rotation t = {turn_sin(turn), turn_cos(turn), s->m.width, s->m.height, 0, 0};
    int64_t sine = llabs(t.sine);
    int64_t cosine = llabs(t.cosine);
    t.new_width = (t.width * cosine + t.height * sine + 65535) / 65536;
    t.new_height = (t.width * sine + t.height * cosine + 65535) / 65536;
    if (!fits(t.new_width, t.new_height)) {
        return -1;
    }
    return scene_rearrange(s, (uint32_t)t.new_width, (uint32_t)t.new_height, rotation_source,
                           &t);
}

typedef struct scaling {
    uint64_t from_mm, to_mm;
    uint32_t width, height; /* of the old scene */
} scaling;

/* The old cell in which the middle of new cell i lies. */
static uint64_t scaled_middle(const scaling *c, uint64_t i, uint32_t limit) {
    uint64_t source = (2 * i + 1) * c->to_mm / (2 * c->from_mm);
    return source < limit ? source : limit - 1;
}

static size_t scaling_source(const void *user, uint32_t x, uint32_t y) {
    const scaling *c = user;
    return (size_t)(scaled_middle(c, y, c->height) * c->width + scaled_middle(c, x, c->width));
}

/* The new cell that covers the middle of old cell i. */
static uint64_t covering(const scaling *c, uint64_t i) {
    return (2 * i + 1) * c->from_mm / (2 * c->to_mm);
}

int vary_resample(scene *s, int resolution_mm) {
    scaling c = {(uint64_t)scene_resolution_mm(s), (uint64_t)resolution_mm, s->m.width,
                 s->m.height};
    uint64_t width = (c.width * c.from_mm + c.to_mm - 1) / c.to_mm;
    uint64_t height = (c.height * c.from_mm + c.to_mm - 1) / c.to_mm;
    size_t old_count = (size_t)c.width * c.height;
    uint8_t *old = malloc(old_count);
    if (old == NULL || !fits((int64_t)width, (int64_t)height)) {
        free(old);
        return -1;
    }
    memcpy(old, s->m.cells, old_count);
    if (scene_rearrange(s, (uint32_t)width, (uint32_t)height, scaling_source, &c) != 0) {
        free(old);
        return -1;
    }
    s->m.resolution_m = resolution_mm / 1000.0;
    for (size_t i = 0; i < old_count; i++) {
        uint8_t *cell = s->m.cells + covering(&c, i / c.width) * width +
                        covering(&c, i % c.width);
        *cell = old[i] > *cell ? old[i] : *cell;
    }
    free(old);
    return 0;
}

void vary_salt(scene *s, uint32_t per_million, rng *r) {
    size_t count = (size_t)s->m.width * s->m.height;
    for (size_t i = 0; i < count; i++) {
        if (scene_is_known(s->m.cells[i]) &&
            (uint32_t)rng_range(r, 0, 999999) < per_million) {
            s->m.cells[i] = rng_range(r, 0, 1) != 0 ? 255 : 0;
        }
    }
}
