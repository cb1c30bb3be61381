#include "facts.h"

#include <stdlib.h>

#include "colors.h"
#include "ridge.h"
#include "truth.h"

color rule_paint(int rule) {
    static const color paints[JOIN_COUNT] = {
        {73, 80, 87},   /* apart */
        {47, 158, 68},  /* wide opening */
        {25, 113, 194}, /* passages */
        {240, 140, 0},  /* niche */
        {156, 54, 181}, /* no wall */
        {12, 133, 153}, /* hall */
        {160, 92, 46},  /* too small */
    };
    return paints[rule];
}

color dropped_paint(fate f) {
    return f == FATE_ALONE ? PAINT_AMBER : PAINT_SIGNAL;
}

double plane_most(const observation *o, int plane) {
    uint8_t most = 1;
    for (uint32_t y = 0; y < o->frame.height; y++) {
        for (uint32_t x = 0; x < o->frame.width; x++) {
            uint8_t value = plane_at(o, plane, x, y);
            int counts = plane != PLANE_RIDGE || value != RS_RIDGE_OBSTACLE;
            most = counts && value > most ? value : most;
        }
    }
    return most;
}

int count_change(const observation *o, int became_free, change *out) {
    const rs_frame *f = &o->frame;
    label_image marks = {malloc((size_t)f->width * f->height * sizeof *marks.values), f->width,
                         f->height};
    *out = (change){0, 0};
    if (marks.values == NULL) {
        return -1;
    }
    for (uint32_t y = 0; y < f->height; y++) {
        for (uint32_t x = 0; x < f->width; x++) {
            int before = plane_at(o, PLANE_FREE, x, y) != 0;
            int after = plane_at(o, PLANE_CLEARED, x, y) != 0;
            int changed = before != after && after == became_free;
            marks.values[(size_t)y * f->width + x] = (uint32_t)changed;
            out->cells += (uint64_t)changed;
        }
    }
    int rc = truth_label_components(&marks);
    for (size_t i = 0; i < (size_t)f->width * f->height; i++) {
        out->parts = marks.values[i] > out->parts ? marks.values[i] : out->parts;
    }
    free(marks.values);
    return rc;
}

cell_counts count_cells(const explanation *e) {
    cell_counts n = {0, 0, 0};
    for (uint32_t y = 0; y < e->frame.height; y++) {
        const uint8_t *row = e->m.cells + (size_t)(e->frame.y + y) * e->m.width + e->frame.x;
        for (uint32_t x = 0; x < e->frame.width; x++) {
            n.free += row[x] <= e->config.free_max;
            n.occupied += row[x] >= e->config.occupied_min;
        }
    }
    n.unsure = (uint64_t)e->frame.width * e->frame.height - n.free - n.occupied;
    return n;
}

uint64_t count_label(const observation *o, int labels, uint16_t label) {
    size_t cells = (size_t)o->frame.width * o->frame.height;
    uint64_t count = 0;
    for (size_t i = 0; i < cells; i++) {
        count += o->labels[labels][i] == label;
    }
    return count;
}

edge_counts count_edges_of(const explanation *e) {
    edge_counts n = {0, 0, 0, {0}, 0};
    for (uint32_t i = 0; i < e->o.before.edge_count; i++) {
        const rs_edge *edge = &e->o.before.edges[i];
        n.touching += edge->border > 0;
        n.walled += edge->wall > 0;
        n.long_walled += edge->wall >= e->config.shared_wall_mm / cell_mm(e);
        n.long_border += edge->border > e->config.longest_border_mm / cell_mm(e);
        if (e->joins != NULL && edge->border > 0) {
            n.by_rule[e->joins[i]]++;
        }
    }
    return n;
}
