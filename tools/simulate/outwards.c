/* Openings to the outside: windows down to the floor, the front door. */
#include "flat.h"

enum { CLEAR_DEPTH = 70 /* no other room within this distance behind a window [cm] */ };

/* 1 when nothing but air is behind the opening. */
static int leads_outside(const flat *f, const opening *o) {
    int inner = o->low < 0 ? o->high : o->low;
    box gap = flat_gap(o, CLEAR_DEPTH);
    for (int i = 0; i < f->part_count; i++) {
        if (i != inner && f->parts[i].kind != PART_VOID && box_overlap(gap, f->parts[i].area)) {
            return 0;
        }
    }
    return 1;
}

/* Tries one place for an opening of this width in side 0..3 of a part: left, right,
 * top, bottom. Returns 1 when it was set. */
static int try_opening(flat *f, rng *r, int index, int side, opening_kind kind, int width) {
    box b = flat_floor(f, index);
    box a = f->parts[index].area;
    int upright = side < 2;
    int from = (upright ? b.y0 : b.x0) + 20;
    int to = (upright ? b.y1 : b.x1) - 20 - width;
    const int lines[4] = {a.x0, a.x1, a.y0, a.y1};
    if (to < from || f->opening_count == FLAT_MAX_OPENINGS) {
        return 0;
    }
    int start = rng_range(r, from, to);
    int inner_is_high = side % 2 == 0;
    opening o = {kind, inner_is_high ? -1 : index, inner_is_high ? index : -1, upright,
                 lines[side], start, start + width, 0, 0, 0, 0, 0};
    if (!leads_outside(f, &o)) {
        return 0;
    }
    f->openings[f->opening_count++] = o;
    return 1;
}

static int window_permille(part_kind kind) {
    switch (kind) {
    case PART_LIVING:
        return 170;
    case PART_DINING:
        return 120;
    case PART_KITCHEN:
    case PART_BED:
    case PART_STUDY:
        return 40;
    default:
        return 0;
    }
}

static void set_windows(flat *f, rng *r) {
    for (int i = 0; i < f->part_count; i++) {
        for (int side = 0; side < 4; side++) {
            int wanted = rng_chance(r, window_permille(f->parts[i].kind));
            int width = rng_range(r, 70, 220);
            if (wanted) {
                try_opening(f, r, i, side, OPENING_GLASS, width);
            }
        }
    }
}

static void set_front_door(flat *f, rng *r) {
    int done = !rng_chance(r, 200);
    for (int i = 0; i < f->part_count && !done; i++) {
        part_kind kind = f->parts[i].kind;
        for (int side = 0; side < 4 && !done; side++) {
            if (kind == PART_HALL || kind == PART_LIVING) {
                done = try_opening(f, r, i, side, OPENING_OUTER, 95);
            }
        }
    }
}

void flat_open_outwards(flat *f, rng *r) {
    set_windows(f, r);
    set_front_door(f, r);
}
