#include <stdbool.h>
#include <stdlib.h>

#include "check.h"
#include "fail.h"
#include "reference.h"
#include "unity.h"

/* Walks over 4-connected cells. */
typedef struct walk {
    const run *r;
    const uint8_t *kinds;
    uint32_t *seen; /* number of the last walk that came by */
    size_t *list;
} walk;

/* Cells that can be reached from `start` without a step on a wall or, unless `label` is 0, on a
 * cell that carries another label. Returns how many are in list; the start comes first. */
static size_t walk_from(const walk *w, size_t start, uint16_t label, uint32_t number)
{
    uint32_t width = w->r->grid.width;
    size_t cells = (size_t)width * w->r->grid.height;
    size_t count = 0;
    w->list[count++] = start;
    w->seen[start] = number;
    for (size_t head = 0; head < count; head++) {
        size_t at = w->list[head];
        const bool exists[4] = {at % width > 0, at % width + 1 < width, at >= width,
                                at + width < cells};
        const size_t next[4] = {at - 1, at + 1, at - width, at + width};
        for (int i = 0; i < 4; i++) {
            if (!exists[i] || w->seen[next[i]] == number || w->kinds[next[i]] == CELL_WALL ||
                (label != 0 && w->kinds[next[i]] == CELL_OPEN &&
                 w->r->labels[next[i]] != label)) {
                continue;
            }
            w->seen[next[i]] = number;
            w->list[count++] = next[i];
        }
    }
    return count;
}

static void check_each_cell(const run *r, const uint8_t *kinds)
{
    size_t cells = (size_t)r->grid.width * r->grid.height;
    for (size_t i = 0; i < cells; i++) {
        if (kinds[i] != CELL_OPEN && r->labels[i] != 0) {
            fail_with("the obstacle at %u, %u carries label %u",
                      (unsigned)(i % r->grid.width), (unsigned)(i / r->grid.width),
                      r->labels[i]);
        }
        if (r->labels[i] > r->result.room_count) {
            fail_with("label %u of %u rooms", r->labels[i], (unsigned)r->result.room_count);
        }
    }
}

static void check_connected(const walk *w)
{
    size_t cells = (size_t)w->r->grid.width * w->r->grid.height;
    bool *met = calloc(w->r->result.room_count + 1u, sizeof *met);
    TEST_ASSERT_NOT_NULL(met);
    for (size_t i = 0; i < cells; i++) {
        uint16_t label = w->r->labels[i];
        if (label == 0 || w->seen[i] == label) {
            continue;
        }
        if (met[label]) {
            fail_with("room %u is in pieces: %u, %u cannot be reached", label,
                      (unsigned)(i % w->r->grid.width), (unsigned)(i / w->r->grid.width));
        }
        met[label] = true;
        walk_from(w, i, label, label);
    }
    for (uint32_t label = 1; label <= w->r->result.room_count; label++) {
        if (!met[label]) {
            fail_with("no cell carries label %u", (unsigned)label);
        }
    }
    free(met);
}

/* Open cells and cells with a label in the area that walls enclose around `start`. */
typedef struct area {
    uint64_t open, labelled;
} area;

static area measure(const walk *w, size_t start, uint32_t number)
{
    area a = {0, 0};
    size_t count = walk_from(w, start, 0, number);
    for (size_t k = 0; k < count; k++) {
        a.open += w->kinds[w->list[k]] == CELL_OPEN;
        a.labelled += w->r->labels[w->list[k]] != 0;
    }
    return a;
}

/* All cells of an area that walls enclose carry a label, or none and the area is small. Where
 * rooms without walls are dropped, less than half of an area may lack a label. In a turned grid
 * an area without labels may be large: turning breaks passages one cell wide, noise is full of
 * them, and each piece is small. */
static void check_areas(const walk *w)
{
    const run *r = w->r;
    size_t cells = (size_t)r->grid.width * r->grid.height;
    uint64_t whole = 0;
    for (size_t i = 0; i < cells; i++) {
        whole += w->kinds[i] != CELL_WALL;
    }
    uint64_t cell_mm2 = (uint64_t)r->grid.resolution_mm * r->grid.resolution_mm;
    uint64_t limit_mm2 = whole * cell_mm2 * r->config.isolated_permille / 1000u;
    if (limit_mm2 < r->config.smallest_room_mm2) {
        limit_mm2 = r->config.smallest_room_mm2;
    }
    if (r->result.wall_angle >= 100 || r->result.wall_angle <= -100) {
        limit_mm2 = UINT64_MAX;
    }
    const uint32_t number = UINT32_MAX;
    for (size_t i = 0; i < cells; i++) {
        if (w->kinds[i] == CELL_WALL || w->seen[i] == number) {
            continue;
        }
        area a = measure(w, i, number);
        bool whole_area = a.labelled == a.open;
        bool too_small = a.labelled == 0 && a.open * cell_mm2 < limit_mm2;
        bool unwalled = r->config.unwalled_percent > 0 &&
                        (a.labelled == 0 ? a.open * 10 < whole : a.labelled * 2 > a.open);
        if (!whole_area && !too_small && !unwalled) {
            fail_with("around %u, %u only %u of %u cells carry a label",
                      (unsigned)(i % r->grid.width), (unsigned)(i / r->grid.width),
                      (unsigned)a.labelled, (unsigned)a.open);
        }
    }
}

static walk make_walk(const run *r, const uint8_t *kinds)
{
    size_t cells = (size_t)r->grid.width * r->grid.height;
    walk w = {r, kinds, calloc(cells, sizeof *w.seen), malloc(cells * sizeof *w.list)};
    TEST_ASSERT_TRUE(w.seen != NULL && w.list != NULL);
    return w;
}

static void free_walk(walk *w)
{
    free(w->list);
    free(w->seen);
}

void check_labels(const run *r, const uint8_t *kinds)
{
    walk w = make_walk(r, kinds);
    check_each_cell(r, kinds);
    check_connected(&w);
    free_walk(&w);
}

void check_dropped(const run *r, const uint8_t *kinds)
{
    walk w = make_walk(r, kinds);
    check_areas(&w);
    free_walk(&w);
}
