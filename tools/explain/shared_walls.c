#include "shared_walls.h"

#include <stdlib.h>

/* Length of the wall between two regions, by their pair, in rising order. */
typedef struct wall_length {
    uint32_t pair; /* lower label in the high half */
    uint32_t cells;
} wall_length;

typedef struct marking {
    const observation *o;
    wall_length *lengths;
    size_t count;
    uint32_t keeps_apart, thickest;
    uint8_t *walls;
    uint64_t crossings;
} marking;

static int compare_lengths(const void *left, const void *right) {
    const wall_length *a = left;
    const wall_length *b = right;
    return (a->pair > b->pair) - (a->pair < b->pair);
}

static uint32_t pair_of(uint16_t p, uint16_t q) {
    return p < q ? (uint32_t)p << 16 | q : (uint32_t)q << 16 | p;
}

static uint8_t kind_of(const marking *m, uint16_t p, uint16_t q) {
    wall_length key = {pair_of(p, q), 0};
    const wall_length *found =
        m->count > 0 ? bsearch(&key, m->lengths, m->count, sizeof key, compare_lengths) : NULL;
    return found != NULL && found->cells >= m->keeps_apart ? WALL_LONG : WALL_SHORT;
}

/* One row (dx = 1) or column (dy = 1), `length` cells from (x, y) on. */
static void mark_line(marking *m, uint32_t x, uint32_t y, uint32_t dx, uint32_t dy,
                      uint32_t length) {
    uint16_t last = 0;
    uint32_t last_at = 0;
    for (uint32_t i = 0; i < length; i++) {
        uint16_t here = label_at(m->o, LABELS_REGIONS, x + i * dx, y + i * dy);
        if (here == 0) {
            continue;
        }
        uint32_t thickness = i - last_at - 1;
        if (last != 0 && last != here && thickness > 0 && thickness <= m->thickest) {
            uint8_t kind = kind_of(m, last, here);
            m->crossings++;
            for (uint32_t k = last_at + 1; k < i; k++) {
                uint8_t *cell = &m->walls[(size_t)(y + k * dy) * m->o->frame.width + x + k * dx];
                *cell = *cell > kind ? *cell : kind;
            }
        }
        last = here;
        last_at = i;
    }
}

int shared_walls_mark(const observation *o, uint32_t keeps_apart, uint8_t *walls,
                      uint64_t *crossings) {
    const rs_graph *graph = &o->before;
    marking m = {o,           malloc(((size_t)graph->edge_count + 1) * sizeof *m.lengths),
                 0,           keeps_apart,
                 RS_GRAPH_WALL_MM / segment_grid(o->m).resolution_mm, walls, 0};
    if (m.lengths == NULL) {
        return -1;
    }
    for (uint32_t e = 0; e < graph->edge_count; e++) {
        const rs_edge *edge = &graph->edges[e];
        m.lengths[m.count++] = (wall_length){pair_of(edge->a, edge->b), edge->wall};
    }
    if (m.count > 0) {
        qsort(m.lengths, m.count, sizeof *m.lengths, compare_lengths);
    }
    for (uint32_t y = 0; y < o->frame.height; y++) {
        mark_line(&m, 0, y, 1, 0, o->frame.width);
    }
    for (uint32_t x = 0; x < o->frame.width; x++) {
        mark_line(&m, x, 0, 0, 1, o->frame.height);
    }
    *crossings = m.crossings;
    free(m.lengths);
    return 0;
}
