#include "world.h"

#include <stdlib.h>
#include <string.h>

int box_area(box b) {
    return (b.x1 - b.x0) * (b.y1 - b.y0);
}

int box_overlap(box a, box b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

int world_make(world *w, int width, int height) {
    size_t count = (size_t)width * (size_t)height;
    *w = (world){width, height, malloc(count), calloc(count, 1)};
    if (w->materials == NULL || w->rooms == NULL) {
        world_free(w);
        return -1;
    }
    memset(w->materials, MAT_RIM, count);
    world_fill_box(w, (box){0, 0, width, height}, MAT_OUTSIDE, 0);
    return 0;
}

void world_free(world *w) {
    free(w->materials);
    free(w->rooms);
    *w = (world){0, 0, NULL, NULL};
}

static int at_least(int value, int low) {
    return value > low ? value : low;
}

static int at_most(int value, int high) {
    return value < high ? value : high;
}

static box inside_rim(const world *w, box b) {
    return (box){at_least(b.x0, 1), at_least(b.y0, 1), at_most(b.x1, w->width - 1),
                 at_most(b.y1, w->height - 1)};
}

static void fill_run(world *w, int x0, int x1, int y, material m, int room) {
    if (x0 >= x1) {
        return;
    }
    size_t at = (size_t)y * (size_t)w->width + (size_t)x0;
    memset(w->materials + at, (int)m, (size_t)(x1 - x0));
    if (room != ROOM_KEEP) {
        memset(w->rooms + at, room, (size_t)(x1 - x0));
    }
}

void world_fill_box(world *w, box b, material m, int room) {
    box c = inside_rim(w, b);
    for (int y = c.y0; y < c.y1; y++) {
        fill_run(w, c.x0, c.x1, y, m, room);
    }
}

void world_fill_disc(world *w, int x, int y, int radius, material m, int room) {
    box c = inside_rim(w, (box){x - radius, y - radius, x + radius + 1, y + radius + 1});
    for (int py = c.y0; py < c.y1; py++) {
        for (int px = c.x0; px < c.x1; px++) {
            int dx = px - x;
            int dy = py - y;
            if (dx * dx + dy * dy <= radius * radius) {
                fill_run(w, px, px + 1, py, m, room);
            }
        }
    }
}

/* 1 when the point lies on the inner side of every edge. */
static int in_convex(const int32_t (*corners)[2], int count, int32_t x, int32_t y) {
    for (int i = 0; i < count; i++) {
        const int32_t *a = corners[i];
        const int32_t *b = corners[(i + 1) % count];
        int64_t side = (int64_t)(b[0] - a[0]) * (y - a[1]) - (int64_t)(b[1] - a[1]) * (x - a[0]);
        if (side < 0) {
            return 0;
        }
    }
    return 1;
}

void world_fill_convex(world *w, const int32_t (*corners)[2], int count, material m, int room) {
    int32_t low[2] = {corners[0][0], corners[0][1]};
    int32_t high[2] = {corners[0][0], corners[0][1]};
    for (int i = 1; i < count; i++) {
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = at_most(low[axis], corners[i][axis]);
            high[axis] = at_least(high[axis], corners[i][axis]);
        }
    }
    box c = inside_rim(w, (box){low[0] / 16, low[1] / 16, high[0] / 16 + 1, high[1] / 16 + 1});
    for (int y = c.y0; y < c.y1; y++) {
        for (int x = c.x0; x < c.x1; x++) {
            if (in_convex(corners, count, x * 16 + 8, y * 16 + 8)) {
                fill_run(w, x, x + 1, y, m, room);
            }
        }
    }
}

int world_is_all(const world *w, box b, material m) {
    box c = inside_rim(w, b);
    if (c.x0 != b.x0 || c.y0 != b.y0 || c.x1 != b.x1 || c.y1 != b.y1) {
        return 0;
    }
    for (int y = c.y0; y < c.y1; y++) {
        for (int x = c.x0; x < c.x1; x++) {
            if (world_material(w, x, y) != m) {
                return 0;
            }
        }
    }
    return 1;
}

/* Moves one column down by n pixels, or up when n < 0; what enters is outside. */
static void slide_column(world *w, int x, int n) {
    int first = n > 0 ? w->height - 2 : 1;
    int step = n > 0 ? -1 : 1;
    for (int y = first; y >= 1 && y <= w->height - 2; y += step) {
        size_t to = (size_t)y * (size_t)w->width + (size_t)x;
        int source = y - n;
        int known = source >= 1 && source <= w->height - 2;
        size_t from = (size_t)(known ? source : y) * (size_t)w->width + (size_t)x;
        w->materials[to] = known ? w->materials[from] : (uint8_t)MAT_OUTSIDE;
        w->rooms[to] = known ? w->rooms[from] : 0;
    }
}

void world_bend(world *w, int from, int slope_permille) {
    for (int x = at_least(from, 1); x < w->width - 1; x++) {
        int n = (x - from) * slope_permille / 1000;
        if (n != 0) {
            slide_column(w, x, n);
        }
    }
}

material world_material(const world *w, int x, int y) {
    return (material)w->materials[(size_t)y * (size_t)w->width + (size_t)x];
}
