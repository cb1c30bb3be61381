/* Draws the plan: walls, floors, openings, door leaves, and what is outside. */
#include "flat.h"
#include "frame.h"
#include "turn.h"

enum {
    LEAF_THICKNESS = 4, /* of a door [cm] */
    CRACK = 5           /* edge of the patch at a corner where beams slip by [cm] */
};

box flat_floor(const flat *f, int part_index) {
    box b = f->parts[part_index].area;
    int half = f->wall / 2;
    return (box){b.x0 + half, b.y0 + half, b.x1 - half, b.y1 - half};
}

box flat_gap(const opening *o, int depth) {
    return o->upright ? (box){o->line - depth, o->from, o->line + depth, o->to}
                      : (box){o->from, o->line - depth, o->to, o->line + depth};
}

/* The part of the gap between `near` and `far` cm from the wall's middle, on one side. */
static box gap_side(const opening *o, int high, int near, int far) {
    int low = high ? o->line + near : o->line - far;
    int end = high ? o->line + far : o->line - near;
    return o->upright ? (box){low, o->from, end, o->to} : (box){o->from, low, o->to, end};
}

/* Garden, balcony or street behind a window: free for a while, then ragged. */
static void draw_outside(const flat *f, world *w, rng *r) {
    for (int i = 0; i < f->opening_count; i++) {
        const opening *o = &f->openings[i];
        if (o->low >= 0 && o->high >= 0) {
            continue;
        }
        int high = o->high < 0;
        int fence = rng_range(r, 90, 330);
        box land = gap_side(o, high, fence, FLAT_MARGIN);
        int reach = rng_range(r, 60, 250);
        if (o->upright) {
            land.y0 -= reach;
            land.y1 += reach;
        } else {
            land.x0 -= reach;
            land.x1 += reach;
        }
        world_fill_box(w, land, MAT_HAZE, 0);
        for (int n = rng_range(r, 1, 7); n > 0; n--) {
            int x = rng_range(r, land.x0 - 60, land.x1 + 60);
            int y = rng_range(r, land.y0 - 60, land.y1 + 60);
            int radius = rng_range(r, 4, 30);
            world_fill_disc(w, x, y, radius, MAT_SOLID, 0);
        }
    }
}

static void draw_floors(const flat *f, world *w) {
    int out = f->outer_wall - f->wall / 2;
    for (int i = 0; i < f->part_count; i++) {
        box b = f->parts[i].area;
        if (f->parts[i].kind != PART_VOID) {
            world_fill_box(w, (box){b.x0 - out, b.y0 - out, b.x1 + out, b.y1 + out}, MAT_WALL,
                           0);
        }
    }
    for (int i = 0; i < f->part_count; i++) {
        const part *p = &f->parts[i];
        if (p->kind != PART_VOID) {
            material m = p->kind == PART_STAIRS ? MAT_HAZE : MAT_FLOOR;
            world_fill_box(w, flat_floor(f, i), m, p->room);
        }
    }
}

/* Floor of one side of a passage: it belongs to the room on that side. */
static void draw_passage_side(const flat *f, world *w, const opening *o, int high) {
    const part *p = &f->parts[high ? o->high : o->low];
    material m = p->kind == PART_STAIRS ? MAT_HAZE : MAT_FLOOR;
    int near = o->shut ? LEAF_THICKNESS / 2 : 0;
    world_fill_box(w, gap_side(o, high, near, f->wall / 2), m, p->room);
}

/* Frames, curtains and what stands before a window leave some gaps to look through. */
static void draw_curtains(world *w, const opening *o, rng *r) {
    for (int at = o->from; at < o->to;) {
        int shown = at + rng_range(r, 4, 60);
        int end = shown + rng_range(r, 4, 55);
        opening closed = *o;
        closed.from = shown < o->to ? shown : o->to;
        closed.to = end < o->to ? end : o->to;
        world_fill_box(w, flat_gap(&closed, 5), MAT_SOLID, 0);
        at = end;
    }
}

static void draw_opening(const flat *f, world *w, const opening *o, rng *r) {
    if (o->low >= 0 && o->high >= 0) {
        draw_passage_side(f, w, o, 0);
        draw_passage_side(f, w, o, 1);
        return;
    }
    int high = o->high < 0;
    world_fill_box(w, gap_side(o, !high, 0, f->wall / 2), MAT_OUTSIDE, 0);
    world_fill_box(w, gap_side(o, high, 0, f->outer_wall - f->wall / 2), MAT_OUTSIDE, 0);
    if (o->kind == OPENING_GLASS) {
        world_fill_box(w, gap_side(o, high, 0, 4), MAT_GLASS, 0);
        draw_curtains(w, o, r);
    }
}

static void draw_door_leaf(const flat *f, world *w, const opening *o) {
    /* Closed, the leaf runs from its hinge along the wall; it opens clockwise or not. */
    int32_t closed = o->upright ? TURN_QUARTER : 0;
    closed += o->hinge_at_to ? TURN_FULL / 2 : 0;
    int clockwise = (o->leaf_in_high == o->hinge_at_to) == (o->upright != 0);
    int32_t open = TURN_DEGREES(o->leaf_degrees);
    int face = o->line + (o->leaf_in_high ? f->wall / 2 : -f->wall / 2);
    int end = o->hinge_at_to ? o->to : o->from;
    frame hinge = frame_at(o->upright ? face : end, o->upright ? end : face,
                           clockwise ? closed + open : closed - open);
    frame_box(w, &hinge, 0, -LEAF_THICKNESS / 2, o->to - o->from - 3, LEAF_THICKNESS / 2,
              MAT_SOLID);
}

/* 1 when an opening of the part lies within `reach` of the point, on either axis. */
static int near_opening(const flat *f, int part_index, int x, int y, int reach) {
    for (int i = 0; i < f->opening_count; i++) {
        const opening *o = &f->openings[i];
        box g = flat_gap(o, f->outer_wall);
        int touches = o->low == part_index || o->high == part_index;
        if (touches && x + reach > g.x0 && x - reach < g.x1 && y + reach > g.y0 &&
            y - reach < g.y1) {
            return 1;
        }
    }
    return 0;
}

/* Fills the corner of a room that lies at (x, y), (sx, sy) pointing into the room: with a
 * slanted wall, or with a shaft. */
static void fill_corner(world *w, int x, int y, int sx, int sy, int size_x, int size_y,
                        int slanted) {
    int32_t far_x = (x + sx * size_x) * 16;
    int32_t far_y = (y + sy * size_y) * 16;
    int32_t cx = x * 16;
    int32_t cy = y * 16;
    if (!slanted) {
        box b = {x < x + sx * size_x ? x : x - size_x, y < y + sy * size_y ? y : y - size_y, 0, 0};
        b.x1 = b.x0 + size_x;
        b.y1 = b.y0 + size_y;
        world_fill_box(w, b, MAT_WALL, 0);
    } else if (sx * sy > 0) {
        const int32_t triangle[3][2] = {{cx, cy}, {far_x, cy}, {cx, far_y}};
        world_fill_convex(w, triangle, 3, MAT_WALL, 0);
    } else {
        const int32_t triangle[3][2] = {{cx, cy}, {cx, far_y}, {far_x, cy}};
        world_fill_convex(w, triangle, 3, MAT_WALL, 0);
    }
}

/* Roughens the walls around the corner at (x, y); (sx, sy) points into the room. */
static void draw_crack(world *w, int room, int x, int y, int sx, int sy) {
    box around = {x - CRACK, y - CRACK, x + CRACK, y + CRACK};
    box inner = {sx > 0 ? x : around.x0, sy > 0 ? y : around.y0, sx > 0 ? around.x1 : x,
                 sy > 0 ? around.y1 : y};
    world_fill_box(w, around, MAT_CRACK, 0);
    world_fill_box(w, inner, MAT_FLOOR, room);
}

static void draw_corners(const flat *f, world *w, rng *r, int index) {
    box b = flat_floor(f, index);
    int large = b.x1 - b.x0 > 330 && b.y1 - b.y0 > 330;
    for (int corner = 0; corner < 4; corner++) {
        int sx = corner % 2 == 0 ? 1 : -1;
        int sy = corner / 2 == 0 ? 1 : -1;
        int x = sx > 0 ? b.x0 : b.x1;
        int y = sy > 0 ? b.y0 : b.y1;
        int slanted = large && rng_chance(r, 80);
        int shaft = rng_chance(r, 110);
        int size_x = slanted ? rng_range(r, 40, 130) : rng_range(r, 20, 65);
        int size_y = slanted ? size_x : rng_range(r, 20, 65);
        int reach = (size_x > size_y ? size_x : size_y) + 25;
        int crack = rng_chance(r, 350);
        if (near_opening(f, index, x, y, reach)) {
            continue;
        }
        if (slanted || shaft) {
            fill_corner(w, x, y, sx, sy, size_x, size_y, slanted);
        } else if (crack) {
            draw_crack(w, f->parts[index].room, x, y, sx, sy);
        }
    }
}

/* Sockets, slots, glossy skirting: spots of a wall where beams go deeper or slip by. */
static void draw_spot(const flat *f, world *w, rng *r, const opening *wall_line, int high) {
    int half = f->wall / 2;
    int deep = rng_range(r, 8, 50);
    int slot = rng_chance(r, 600);
    box face = gap_side(wall_line, high, half - CRACK, half);
    box inside = gap_side(wall_line, high, half - deep, half);
    if (!world_is_all(w, inside, MAT_WALL)) {
        inside = gap_side(wall_line, high, half - f->wall * 2 / 3, half);
    }
    if (slot && world_is_all(w, inside, MAT_WALL)) {
        world_fill_box(w, inside, MAT_OUTSIDE, 0);
    } else if (world_is_all(w, face, MAT_WALL)) {
        world_fill_box(w, face, MAT_CRACK, 0);
    }
}

static void draw_spots(const flat *f, world *w, rng *r, int index) {
    box a = f->parts[index].area;
    box b = flat_floor(f, index);
    const int lines[4] = {a.x0, a.x1, a.y0, a.y1};
    for (int side = 0; side < 4; side++) {
        int upright = side < 2;
        for (int n = rng_range(r, 0, 9); n > 0; n--) {
            int wide = rng_range(r, 2, 6);
            opening spot = {.upright = upright, .line = lines[side]};
            spot.from = upright ? rng_range(r, b.y0, b.y1 - wide) : rng_range(r, b.x0, b.x1 - wide);
            spot.to = spot.from + wide;
            draw_spot(f, w, r, &spot, side % 2 == 0);
        }
    }
}

/* Columns that stand in large rooms. */
static void draw_pillar(const flat *f, world *w, rng *r, int index) {
    box b = flat_floor(f, index);
    int wanted = rng_chance(r, 120);
    if (!wanted || b.x1 - b.x0 < 420 || b.y1 - b.y0 < 420) {
        return;
    }
    int x = rng_range(r, b.x0 + 130, b.x1 - 130);
    int y = rng_range(r, b.y0 + 130, b.y1 - 130);
    int radius = rng_range(r, 11, 24);
    world_fill_disc(w, x, y, radius, MAT_WALL, 0);
}

void flat_draw(const flat *f, world *w, rng *r) {
    draw_outside(f, w, r);
    draw_floors(f, w);
    for (int i = 0; i < f->part_count; i++) {
        part_kind kind = f->parts[i].kind;
        if (kind != PART_VOID && kind != PART_STAIRS && kind != PART_HALL) {
            draw_corners(f, w, r, i);
            draw_pillar(f, w, r, i);
        }
    }
    for (int i = 0; i < f->opening_count; i++) {
        draw_opening(f, w, &f->openings[i], r);
    }
    for (int i = 0; i < f->opening_count; i++) {
        const opening *o = &f->openings[i];
        if (o->has_leaf && !o->shut) {
            draw_door_leaf(f, w, o);
        }
    }
    for (int i = 0; i < f->part_count; i++) {
        if (f->parts[i].room != 0) {
            draw_spots(f, w, r, i);
        }
    }
}
