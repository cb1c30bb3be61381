/* Loosens the plan: not every room fills the rectangle that it was given. */
#include "flat.h"

enum {
    KEEP_SIDE = 190, /* what a room keeps of its width and depth at least [cm] */
    CLEARANCE = 30   /* to the openings of the room [cm] */
};

/* The strip of this depth along side 0..3 (left, right, top, bottom) of a box. */
static box strip_of(box b, int side, int depth) {
    switch (side) {
    case 0:
        return (box){b.x0, b.y0, b.x0 + depth, b.y1};
    case 1:
        return (box){b.x1 - depth, b.y0, b.x1, b.y1};
    case 2:
        return (box){b.x0, b.y0, b.x1, b.y0 + depth};
    default:
        return (box){b.x0, b.y1 - depth, b.x1, b.y1};
    }
}

static box without_strip(box b, int side, int depth) {
    b.x0 += side == 0 ? depth : 0;
    b.x1 -= side == 1 ? depth : 0;
    b.y0 += side == 2 ? depth : 0;
    b.y1 -= side == 3 ? depth : 0;
    return b;
}

static int has_opening_near(const flat *f, int part_index, box strip) {
    box near = {strip.x0 - CLEARANCE, strip.y0 - CLEARANCE, strip.x1 + CLEARANCE,
                strip.y1 + CLEARANCE};
    for (int i = 0; i < f->opening_count; i++) {
        const opening *o = &f->openings[i];
        int touches = o->low == part_index || o->high == part_index;
        if (touches && box_overlap(near, flat_gap(o, f->wall))) {
            return 1;
        }
    }
    return 0;
}

/* 1 when the side lies on the outline of the plan. */
static int is_outer(const flat *f, box b, int side) {
    const int places[4] = {b.x0, f->width - b.x1, b.y0, f->height - b.y1};
    return places[side] == FLAT_MARGIN;
}

void flat_set_back(flat *f, rng *r) {
    for (int i = 0; i < f->part_count; i++) {
        part *p = &f->parts[i];
        for (int side = 0; side < 4; side++) {
            int outer = is_outer(f, p->area, side);
            int wanted = rng_chance(r, outer ? 330 : 200);
            int depth = rng_range(r, 25, outer ? 150 : 75);
            box rest = without_strip(p->area, side, depth);
            int roomy = rest.x1 - rest.x0 >= KEEP_SIDE && rest.y1 - rest.y0 >= KEEP_SIDE;
            if (wanted && roomy && p->kind != PART_HALL &&
                !has_opening_near(f, i, strip_of(p->area, side, depth))) {
                p->area = rest;
            }
        }
    }
}
