/* Where the rooms are: the plan is cut in two again and again, around corridors. */
#include "flat.h"

enum {
    STRIP_PARTS = 12,    /* from so many parts on, strips and regions are cut no more */
    REGION_PARTS = 10,
    MIN_SIDE = 150,      /* shortest side of a room, between wall centres [cm] */
    ROOM_STOP_LOW = 8,   /* below a random area in this range nothing is cut on [m2] */
    ROOM_STOP_HIGH = 24,
    LIVING_MAX_M2 = 42,
    CM2_PER_M2 = 10000
};

typedef struct layout {
    flat *f;
    rng *r;
    int halls, max_halls;
} layout;

static int width_of(box b) {
    return b.x1 - b.x0;
}

static int height_of(box b) {
    return b.y1 - b.y0;
}

static int is_wide(box b) {
    return width_of(b) >= height_of(b);
}

static int long_side(box b) {
    return is_wide(b) ? width_of(b) : height_of(b);
}

static int short_side(box b) {
    return is_wide(b) ? height_of(b) : width_of(b);
}

/* Takes the first `length` cm along x (or y) off the box and returns them. */
static box take(box *b, int along_x, int length) {
    box first = *b;
    if (along_x) {
        first.x1 = b->x0 + length;
        b->x0 = first.x1;
    } else {
        first.y1 = b->y0 + length;
        b->y0 = first.y1;
    }
    return first;
}

static void add_part(layout *l, box b, part_kind kind) {
    /* Beyond the capacity the plan keeps a hole, as a flat around a shaft does. */
    if (l->f->part_count < FLAT_MAX_PARTS) {
        l->f->parts[l->f->part_count++] = (part){b, kind, 0};
    }
}

/* Rooms side by side along a corridor, each as deep as the strip. */
static void cut_strip(layout *l, box b, int along_x) {
    for (;;) {
        int length = along_x ? width_of(b) : height_of(b);
        int narrow = rng_chance(l->r, 300);
        int next = narrow ? rng_range(l->r, 165, 230) : rng_range(l->r, 250, 440);
        int full = l->f->part_count >= STRIP_PARTS;
        if (full || length - next < MIN_SIDE) {
            add_part(l, b, PART_BED);
            return;
        }
        add_part(l, take(&b, along_x, next), PART_BED);
    }
}

static void cut_region(layout *l, box b);

static void cut_side(layout *l, box b, int along_x) {
    int depth = along_x ? height_of(b) : width_of(b);
    if (depth > 520 && rng_chance(l->r, 500)) {
        cut_region(l, b);
    } else {
        cut_strip(l, b, along_x);
    }
}

/* A corridor along the longer side, rooms on one or both sides of it. */
static void cut_around_hall(layout *l, box b) {
    int along_x = is_wide(b);
    int hall = rng_range(l->r, 100, 165);
    int rest = short_side(b) - hall;
    int first = rest < 2 * 230 ? 0 : rng_range(l->r, 230, rest - 230);
    int hall_first = first == 0 && rng_chance(l->r, 500);
    l->halls++;
    if (first > 0) {
        cut_side(l, take(&b, !along_x, first), along_x);
    }
    if (first > 0 || hall_first) {
        add_part(l, take(&b, !along_x, hall), PART_HALL);
        cut_side(l, b, along_x);
    } else {
        cut_side(l, take(&b, !along_x, rest), along_x);
        add_part(l, b, PART_HALL);
    }
}

/* Anything: a room, a corridor with rooms, or two regions. Ends, as each cut leaves at
 * least a third less. */
static void cut_region(layout *l, box b) {
    int stop = rng_range(l->r, ROOM_STOP_LOW, ROOM_STOP_HIGH) * CM2_PER_M2;
    int length = long_side(b);
    int slim = length > 2 * short_side(b);
    int full = l->f->part_count >= REGION_PARTS;
    if (full || length < 2 * MIN_SIDE + 60 || (box_area(b) <= stop && !slim)) {
        add_part(l, b, PART_BED);
        return;
    }
    if (l->halls < l->max_halls && length >= 560 && short_side(b) >= 400 &&
        rng_chance(l->r, 750)) {
        cut_around_hall(l, b);
        return;
    }
    int at = length * rng_range(l->r, 36, 64) / 100;
    box first = take(&b, is_wide(b), at);
    cut_region(l, first);
    cut_region(l, b);
}

/* The largest integer whose square is at most n, n < 2^30. */
static int root(int n) {
    int low = 0;
    for (int bit = 1 << 14; bit > 0; bit >>= 1) {
        if ((low + bit) * (low + bit) <= n) {
            low += bit;
        }
    }
    return low;
}

static box choose_outline(flat_size size, rng *r) {
    static const int areas_m2[3][2] = {{38, 62}, {65, 115}, {120, 190}};
    int area = rng_range(r, areas_m2[size][0], areas_m2[size][1]) * CM2_PER_M2;
    int aspect = rng_range(r, 100, 185);
    int width = root(area / 100 * aspect);
    return (box){0, 0, width, area / width};
}

/* Mirrors and transposes the plan at random and moves it behind the margin. */
static void place_plan(flat *f, box outline, rng *r) {
    int mirror_x = rng_chance(r, 500);
    int mirror_y = rng_chance(r, 500);
    int transpose = rng_chance(r, 500);
    for (int i = 0; i < f->part_count; i++) {
        box b = f->parts[i].area;
        if (mirror_x) {
            b = (box){outline.x1 - b.x1, b.y0, outline.x1 - b.x0, b.y1};
        }
        if (mirror_y) {
            b = (box){b.x0, outline.y1 - b.y1, b.x1, outline.y1 - b.y0};
        }
        if (transpose) {
            b = (box){b.y0, b.x0, b.y1, b.x1};
        }
        f->parts[i].area = (box){b.x0 + FLAT_MARGIN, b.y0 + FLAT_MARGIN, b.x1 + FLAT_MARGIN,
                                 b.y1 + FLAT_MARGIN};
    }
    f->width = (transpose ? outline.y1 : outline.x1) + 2 * FLAT_MARGIN;
    f->height = (transpose ? outline.x1 : outline.y1) + 2 * FLAT_MARGIN;
}

/* Corners of the plan that a part touches: 0, 1, or more for one that spans a side. */
static int corners_touched(const flat *f, box b) {
    int x = (b.x0 == FLAT_MARGIN) + (b.x1 == f->width - FLAT_MARGIN);
    int y = (b.y0 == FLAT_MARGIN) + (b.y1 == f->height - FLAT_MARGIN);
    return x * y;
}

/* Takes parts at the plan's corners away, so that not every flat is a rectangle. */
static void carve_corners(flat *f, rng *r) {
    int total = (f->width - 2 * FLAT_MARGIN) * (f->height - 2 * FLAT_MARGIN);
    for (int i = 0; i < f->part_count && f->part_count >= 6; i++) {
        part *p = &f->parts[i];
        int fits = p->kind != PART_HALL && corners_touched(f, p->area) == 1 &&
                   box_area(p->area) < total / 6;
        if (fits && rng_chance(r, 420)) {
            p->kind = PART_VOID;
        }
    }
}

/* What a room of this size is for; takes note of what the flat has already. */
static part_kind choose_kind(int area_m2, int shortest, int *baths, int *kitchens, rng *r) {
    if (area_m2 <= 8 && *baths < 3 && (*baths == 0 || rng_chance(r, 500))) {
        ++*baths;
        return PART_BATH;
    }
    if (area_m2 < 5 || shortest < 180) {
        return PART_STORE;
    }
    if (*kitchens == 0 && area_m2 >= 6 && area_m2 <= 18 && rng_chance(r, 500)) {
        ++*kitchens;
        return PART_KITCHEN;
    }
    if (area_m2 >= 12 && rng_chance(r, 150)) {
        return PART_DINING;
    }
    return rng_chance(r, 280) ? PART_STUDY : PART_BED;
}

static void choose_kinds(flat *f, rng *r) {
    int largest = -1;
    int baths = 0;
    int kitchens = 0;
    for (int i = 0; i < f->part_count; i++) {
        const part *p = &f->parts[i];
        if (p->kind == PART_BED &&
            (largest < 0 || box_area(p->area) > box_area(f->parts[largest].area))) {
            largest = i;
        }
    }
    for (int i = 0; i < f->part_count; i++) {
        part *p = &f->parts[i];
        if (i == largest) {
            p->kind = PART_LIVING;
        } else if (p->kind == PART_BED) {
            p->kind = choose_kind(box_area(p->area) / CM2_PER_M2, short_side(p->area), &baths,
                                  &kitchens, r);
        }
    }
}

static void choose_structure(flat *f, rng *r) {
    f->wall = 2 * rng_range(r, 5, 9);
    f->outer_wall = rng_range(r, 30, 60);
    f->bend_permille = 0;
    f->bend_from = f->width * rng_range(r, 30, 70) / 100;
    if (rng_chance(r, 250)) {
        int slope = rng_range(r, 40, 160);
        f->bend_permille = rng_chance(r, 500) ? slope : -slope;
    }
}

void flat_layout(flat *f, flat_size size, rng *r) {
    box outline = choose_outline(size, r);
    layout l = {f, r, 0, size == FLAT_LARGE ? 3 : 2};
    box rest = outline;
    f->part_count = 0;
    f->room_count = 0;
    f->opening_count = 0;
    /* A living room at one end, over the plan's whole depth, in most flats. */
    int share = rng_range(r, 25, 38);
    if (rng_chance(r, 700)) {
        box end = take(&rest, 1, outline.x1 * share / 100);
        if (box_area(end) <= LIVING_MAX_M2 * CM2_PER_M2 && short_side(end) >= 280) {
            add_part(&l, end, PART_BED);
        } else {
            cut_region(&l, end);
        }
    }
    cut_region(&l, rest);
    place_plan(f, outline, r);
    carve_corners(f, r);
    choose_kinds(f, r);
    choose_structure(f, r);
}
