#include "pieces.h"

#include "turn.h"

static const piece_size sizes[PIECE_COUNT] = {
    [PIECE_CABINET] = {60, 220, 40, 65, 60, 1},
    [PIECE_SHELF] = {60, 180, 25, 40, 50, 1},
    [PIECE_BED] = {95, 190, 195, 215, 50, 1},
    [PIECE_SOFA] = {140, 240, 80, 100, 60, 1},
    [PIECE_CORNER_SOFA] = {220, 300, 150, 200, 60, 1},
    [PIECE_ARMCHAIR] = {95, 115, 95, 115, 5, 0},
    [PIECE_DESK] = {100, 180, 115, 135, 30, 1},
    [PIECE_DINING_SET] = {180, 290, 175, 215, 15, 0},
    [PIECE_COFFEE_TABLE] = {60, 125, 50, 80, 35, 0},
    [PIECE_ISLAND] = {120, 240, 75, 115, 70, 0},
    [PIECE_COUNTER] = {150, 380, 58, 66, 85, 1},
    [PIECE_TUB] = {150, 180, 70, 82, 55, 1},
    [PIECE_SHOWER] = {80, 100, 80, 100, 50, 1},
    [PIECE_TOILET] = {40, 40, 55, 65, 50, 1},
    [PIECE_SINK] = {50, 100, 42, 52, 55, 1},
    [PIECE_PLANT] = {24, 50, 24, 50, 0, 0},
    [PIECE_RACK] = {60, 120, 45, 60, 10, 0},
    [PIECE_BOX] = {22, 65, 22, 60, 0, 0},
    [PIECE_TOYS] = {50, 130, 50, 130, 0, 0},
    [PIECE_JUNK] = {50, 220, 15, 55, 45, 1},
    [PIECE_CHAIR] = {60, 70, 60, 70, 0, 0},
};

const piece_size *piece_size_of(piece_kind kind) {
    return &sizes[kind];
}

/* Gaps below and between: beams slip into the piece here and there along its front. */
static void draw_slits(world *w, const frame *f, int width, int depth, rng *r) {
    for (int n = rng_range(r, 0, 3); n > 0; n--) {
        int u = rng_range(r, -width / 2, width / 2 - 10);
        int wide = rng_range(r, 3, 9);
        int deep = rng_range(r, 5, depth - 3);
        if (rng_chance(r, 500)) {
            frame_box(w, f, u, depth - deep, u + wide, depth, MAT_OUTSIDE);
        } else {
            frame_box(w, f, u, depth - 6, u + wide, depth, MAT_CRACK);
        }
    }
}

/* A leg: a bar of `edge` cm around (u, v). */
static void draw_leg(world *w, const frame *f, int u, int v, int edge) {
    frame_box(w, f, u - edge / 2, v - edge / 2, u - edge / 2 + edge, v - edge / 2 + edge,
              MAT_SOLID);
}

static void draw_four_legs(world *w, const frame *f, int u0, int v0, int u1, int v1, int edge) {
    int in = edge / 2 + 1;
    draw_leg(w, f, u0 + in, v0 + in, edge);
    draw_leg(w, f, u1 - in, v0 + in, edge);
    draw_leg(w, f, u0 + in, v1 - in, edge);
    draw_leg(w, f, u1 - in, v1 - in, edge);
}

/* A chair around (u, v), its legs, turned a little. */
static void draw_chair(world *w, const frame *f, int u, int v, rng *r) {
    int32_t angle = rng_normal(r, TURN_DEGREES(9));
    int edge = rng_range(r, 36, 44);
    int leg = rng_range(r, 4, 5);
    frame chair = frame_inside(f, u, v, angle);
    draw_four_legs(w, &chair, -edge / 2, -edge / 2, edge / 2, edge / 2, leg);
}

/* The five-armed foot of an office chair. */
static void draw_star(world *w, const frame *f, int u, int v, rng *r) {
    int32_t angle = rng_range(r, 0, TURN_FULL / 5);
    for (int i = 0; i < 5; i++) {
        frame arm = frame_inside(f, u, v, angle + i * (TURN_FULL / 5));
        frame_box(w, &arm, 0, -2, 31, 2, MAT_SOLID);
    }
}

static void draw_bed(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    int style = rng_range(r, 0, 9);
    frame_box(w, f, -half, 0, half, 6, MAT_SOLID);
    if (style < 4) {
        frame_box(w, f, -half, 0, half, depth, MAT_SOLID);
    } else if (style < 6) {
        frame_box(w, f, -half + 12, 0, half - 12, depth - 12, MAT_SOLID);
    } else {
        draw_four_legs(w, f, -half, 0, half, depth, 7);
        draw_leg(w, f, 0, depth / 2, 6);
    }
}

static void draw_sofa(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    if (rng_chance(r, 700)) {
        frame_box(w, f, -half, 0, half, depth, MAT_SOLID);
        draw_slits(w, f, width, depth, r);
        return;
    }
    draw_four_legs(w, f, -half, 4, half, depth, 6);
    draw_leg(w, f, 0, depth - 5, 5);
    draw_leg(w, f, 0, 8, 5);
}

static void draw_corner_sofa(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    int end = rng_chance(r, 500) ? -half : half - 90;
    frame_box(w, f, -half, 0, half, 90, MAT_SOLID);
    frame_box(w, f, end, 0, end + 90, depth, MAT_SOLID);
}

static void draw_armchair(world *w, const frame *f, int width, int depth, rng *r) {
    int32_t angle = rng_range(r, TURN_DEGREES(10), TURN_DEGREES(80));
    int half = (width < depth ? width : depth) * 36 / 100;
    frame seat = frame_inside(f, 0, depth / 2, angle);
    if (rng_chance(r, 600)) {
        frame_box(w, &seat, -half, -half, half, half, MAT_SOLID);
    } else {
        draw_four_legs(w, &seat, -half, -half, half, half, 5);
    }
}

static void draw_desk(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    depth -= 55; /* the rest is for the chair */
    draw_four_legs(w, f, -half, 2, half, depth, 5);
    if (rng_chance(r, 500)) {
        frame_box(w, f, -half, 2, -half + 42, depth - 5, MAT_SOLID);
    }
    if (rng_chance(r, 300)) {
        frame_box(w, f, -half, 2, half, 6, MAT_SOLID);
    }
    int v = depth + rng_range(r, -25, 20);
    if (rng_chance(r, 550)) {
        draw_star(w, f, rng_range(r, 0, half / 3), v, r);
    } else {
        draw_chair(w, f, rng_range(r, 0, half / 3), v, r);
    }
}

static void draw_dining_set(world *w, const frame *f, int width, int depth, rng *r) {
    int chairs = (width - 110) / 55;
    int half = (width - 110) / 2;
    int v0 = 55;
    int v1 = depth - 55;
    if (rng_chance(r, 700)) {
        draw_four_legs(w, f, -half, v0, half, v1, 7);
    } else {
        frame_disc(w, f, 0, depth / 2, rng_range(r, 10, 28), MAT_SOLID);
    }
    for (int i = 0; i < chairs; i++) {
        int u = -half + (2 * i + 1) * half / chairs;
        int push = rng_range(r, -12, 16);
        draw_chair(w, f, u, v0 - push, r);
        push = rng_range(r, -12, 16);
        draw_chair(w, f, u, v1 + push, r);
    }
    for (int end = -1; end <= 1; end += 2) {
        if (rng_chance(r, 400)) {
            draw_chair(w, f, end * (half + 12), depth / 2, r);
        }
    }
}

static void draw_coffee_table(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    int style = rng_range(r, 0, 9);
    if (style < 5) {
        draw_four_legs(w, f, -half, 0, half, depth, 5);
    } else if (style < 8) {
        frame_box(w, f, -half, 0, half, depth, MAT_SOLID);
    } else {
        frame_disc(w, f, 0, depth / 2, depth / 2, MAT_SOLID);
    }
}

static void draw_island(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    int stools = rng_range(r, 0, width / 55);
    frame_box(w, f, -half, 0, half, depth - 20, MAT_SOLID);
    for (int i = 0; i < stools; i++) {
        int radius = rng_range(r, 3, 14);
        frame_disc(w, f, -half + 30 + i * 55, depth, radius, MAT_SOLID);
    }
}

static void draw_shower(world *w, const frame *f, int width, int depth) {
    int half = width / 2;
    frame_box(w, f, -half, depth - 4, half - 25, depth, MAT_GLASS);
    frame_box(w, f, -half, 0, -half + 4, depth, MAT_GLASS);
    frame_box(w, f, half - 4, 0, half, depth, MAT_GLASS);
}

static void draw_toilet(world *w, const frame *f, int depth) {
    frame_box(w, f, -19, 0, 19, 16, MAT_SOLID);
    frame_box(w, f, -11, 0, 11, depth - 20, MAT_SOLID);
    frame_disc(w, f, 0, depth - 18, 17, MAT_SOLID);
}

static void draw_sink(world *w, const frame *f, int width, int depth, rng *r) {
    if (rng_chance(r, 700)) {
        frame_box(w, f, -width / 2, 0, width / 2, depth, MAT_SOLID);
    } else {
        frame_disc(w, f, 0, depth / 2, 11, MAT_SOLID);
    }
}

/* Clothes horse or folding frame: thin bars that cross. */
static void draw_rack(world *w, const frame *f, int width, int depth, rng *r) {
    int32_t angle = rng_range(r, TURN_DEGREES(15), TURN_DEGREES(40));
    for (int sign = -1; sign <= 1; sign += 2) {
        frame bar = frame_inside(f, 0, depth / 2, sign * angle);
        frame_box(w, &bar, -width / 2, -2, width / 2, 2, MAT_SOLID);
    }
}

static void draw_box(world *w, const frame *f, int width, int depth, rng *r) {
    int32_t angle = rng_range(r, 0, TURN_QUARTER);
    int wide = width * 7 / 20;
    int deep = depth * 7 / 20;
    frame turned = frame_inside(f, 0, depth / 2, angle);
    material m = rng_chance(r, 150) ? MAT_DARK : MAT_SOLID;
    frame_box(w, &turned, -wide, -deep, wide, deep, m);
}

static void draw_toys(world *w, const frame *f, int width, int depth, rng *r) {
    for (int n = rng_range(r, 3, 12); n > 0; n--) {
        int u = rng_range(r, -width / 2 + 8, width / 2 - 8);
        int v = rng_range(r, 8, depth - 8);
        int radius = rng_range(r, 2, 7);
        frame_disc(w, f, u, v, radius, MAT_SOLID);
    }
}

/* Things in a row along a wall: bags, shoes, radiators, toys, each of its own depth. */
static void draw_junk(world *w, const frame *f, int width, int depth, rng *r) {
    int half = width / 2;
    for (int u = -half; u < half - 6;) {
        int next = u + rng_range(r, 6, 45);
        int v = rng_range(r, 3, depth);
        int style = rng_range(r, 0, 9);
        next = next < half ? next : half;
        if (style < 4) {
            frame_box(w, f, u, rng_range(r, 0, v - 3), next, v, MAT_SOLID);
        } else if (style < 7) {
            frame_disc(w, f, (u + next) / 2, v, rng_range(r, 2, 9), MAT_SOLID);
        } else if (style < 8) {
            frame_box(w, f, u, 0, next, v, MAT_CRACK);
        }
        u = next;
    }
}

static void draw_solid(world *w, const frame *f, int width, int depth, rng *r) {
    material m = rng_chance(r, 100) ? MAT_DARK : MAT_SOLID;
    frame_box(w, f, -width / 2, 0, width / 2, depth, m);
    draw_slits(w, f, width, depth, r);
}

static void draw_small(world *w, piece_kind kind, const frame *f, int width, int depth,
                       rng *r) {
    switch (kind) {
    case PIECE_PLANT:
        frame_disc(w, f, 0, depth / 2, (width < depth ? width : depth) / 2, MAT_SOLID);
        break;
    case PIECE_RACK:
        draw_rack(w, f, width, depth, r);
        break;
    case PIECE_BOX:
        draw_box(w, f, width, depth, r);
        break;
    case PIECE_TOYS:
        draw_toys(w, f, width, depth, r);
        break;
    case PIECE_JUNK:
        draw_junk(w, f, width, depth, r);
        break;
    case PIECE_CHAIR:
        draw_chair(w, f, 0, depth / 2, r);
        break;
    default: /* cabinets, shelves, counters, tubs */
        draw_solid(w, f, width, depth, r);
        break;
    }
}

void piece_draw(world *w, piece_kind kind, const frame *f, int width, int depth, rng *r) {
    switch (kind) {
    case PIECE_BED:
        draw_bed(w, f, width, depth, r);
        break;
    case PIECE_SOFA:
        draw_sofa(w, f, width, depth, r);
        break;
    case PIECE_CORNER_SOFA:
        draw_corner_sofa(w, f, width, depth, r);
        break;
    case PIECE_ARMCHAIR:
        draw_armchair(w, f, width, depth, r);
        break;
    case PIECE_DESK:
        draw_desk(w, f, width, depth, r);
        break;
    case PIECE_DINING_SET:
        draw_dining_set(w, f, width, depth, r);
        break;
    case PIECE_COFFEE_TABLE:
        draw_coffee_table(w, f, width, depth, r);
        break;
    case PIECE_ISLAND:
        draw_island(w, f, width, depth, r);
        break;
    case PIECE_SHOWER:
        draw_shower(w, f, width, depth);
        break;
    case PIECE_TOILET:
        draw_toilet(w, f, depth);
        break;
    case PIECE_SINK:
        draw_sink(w, f, width, depth, r);
        break;
    default:
        draw_small(w, kind, f, width, depth, r);
        break;
    }
}
