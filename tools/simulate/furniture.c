#include "furniture.h"

#include <stdlib.h>

#include "passage.h"
#include "pieces.h"
#include "turn.h"

enum {
    CELL = PASSAGE_CELL, /* of the map of what is taken */
    TAKEN = 1,        /* flag: something stands there */
    DOORWAY = 2,      /* flag: to be kept free for the door */
    CLEAR = 4,        /* flag: in front of a piece */
    TRIED = 8,        /* flag: something would stand there */
    DOOR_DEPTH = 85,  /* kept free on both sides of a door [cm] */
    TRIES = 30,       /* places looked at for one piece */
    STREAM_PARTS = 100
};

typedef struct placer {
    const flat *f;
    world *w;
    rng r;
    uint8_t *flags; /* one byte of flags a cell */
    int columns, rows;
    int clutter;
    uint8_t *mask;  /* scratch of passage_is_open */
    int32_t *queue; /* the same */
    box floor;      /* of the part that is being furnished */
    box gates[FLAT_MAX_OPENINGS]; /* its doors, in cells */
    int gate_count;
} placer;

/* The cells that a box touches, within the map. */
static box cells_of(const placer *p, box b) {
    box c = {b.x0 / CELL, b.y0 / CELL, (b.x1 + CELL - 1) / CELL, (b.y1 + CELL - 1) / CELL};
    c.x0 = c.x0 > 0 ? c.x0 : 0;
    c.y0 = c.y0 > 0 ? c.y0 : 0;
    c.x1 = c.x1 < p->columns ? c.x1 : p->columns;
    c.y1 = c.y1 < p->rows ? c.y1 : p->rows;
    return c;
}

static box grown(box b, int by) {
    return (box){b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by};
}

static int any_flag(const placer *p, box b, int flags) {
    box c = cells_of(p, b);
    for (int y = c.y0; y < c.y1; y++) {
        for (int x = c.x0; x < c.x1; x++) {
            if ((p->flags[y * p->columns + x] & flags) != 0) {
                return 1;
            }
        }
    }
    return 0;
}

static void set_flag(placer *p, box b, int flag) {
    box c = cells_of(p, b);
    for (int y = c.y0; y < c.y1; y++) {
        for (int x = c.x0; x < c.x1; x++) {
            p->flags[y * p->columns + x] |= (uint8_t)flag;
        }
    }
}

static void drop_flag(placer *p, box b, int flag) {
    box c = cells_of(p, b);
    for (int y = c.y0; y < c.y1; y++) {
        for (int x = c.x0; x < c.x1; x++) {
            p->flags[y * p->columns + x] &= (uint8_t)~flag;
        }
    }
}

static void read_world(placer *p) {
    for (int y = 0; y < p->rows * CELL; y++) {
        for (int x = 0; x < p->columns * CELL; x++) {
            if (world_material(p->w, x, y) != MAT_FLOOR) {
                p->flags[y / CELL * p->columns + x / CELL] |= TAKEN;
            }
        }
    }
    for (int i = 0; i < p->f->opening_count; i++) {
        const opening *o = &p->f->openings[i];
        if (o->kind != OPENING_MERGED && o->kind != OPENING_GLASS) {
            set_flag(p, flat_gap(o, DOOR_DEPTH), DOORWAY);
        }
    }
}

/* Whether the robot gets through the part when something stands at the place. */
static int stays_passable(placer *p, box place) {
    passage_grid g = {p->flags, TAKEN | TRIED, p->columns, p->rows, p->mask, p->queue};
    set_flag(p, place, TRIED);
    int open = passage_is_open(&g, cells_of(p, grown(p->floor, p->f->wall)), p->gates,
                               p->gate_count);
    drop_flag(p, place, TRIED);
    return open;
}

/* Takes the place when `core`, the place without what may touch walls, has none of the flags,
 * the room around it is not blocked, and the robot still gets through. */
static int claim(placer *p, box place, box core, box around, int flags) {
    if (any_flag(p, core, flags) || any_flag(p, around, TAKEN)) {
        return 0;
    }
    if (!stays_passable(p, place)) {
        return 0;
    }
    set_flag(p, place, TAKEN);
    set_flag(p, around, CLEAR);
    return 1;
}

/* 1 when a wall is behind the back of a place: at both ends and in the middle. */
static int has_wall(const placer *p, int side, int from, int to) {
    const int lines[4] = {p->floor.y0 - 3, p->floor.x1 + 2, p->floor.y1 + 2, p->floor.x0 - 3};
    const int at[3] = {from + 2, (from + to) / 2, to - 3};
    for (int i = 0; i < 3; i++) {
        int upright = side % 2;
        material m = upright ? world_material(p->w, lines[side], at[i])
                             : world_material(p->w, at[i], lines[side]);
        if (m < MAT_CRACK) {
            return 0;
        }
    }
    return 1;
}

/* A place along side 0..3 (top, right, bottom, left) of the part, from..from + width. */
static box place_at_side(const placer *p, int side, int from, int width, int gap, int depth) {
    box b = p->floor;
    int to = from + width;
    switch (side) {
    case 0:
        return (box){from, b.y0 + gap, to, b.y0 + gap + depth};
    case 1:
        return (box){b.x1 - gap - depth, from, b.x1 - gap, to};
    case 2:
        return (box){from, b.y1 - gap - depth, to, b.y1 - gap};
    default:
        return (box){b.x0 + gap, from, b.x0 + gap + depth, to};
    }
}

static int try_at_wall(placer *p, piece_kind kind, int width, int depth, int front) {
    int side = rng_range(&p->r, 0, 3);
    int upright = side % 2;
    int from = upright ? p->floor.y0 : p->floor.x0;
    int last = (upright ? p->floor.y1 : p->floor.x1) - width;
    int end = rng_range(&p->r, 0, 3);
    int gap = rng_range(&p->r, 0, 3);
    if (last < from) {
        return 0;
    }
    int start = rng_range(&p->r, from, last);
    start = end == 0 ? from : end == 1 ? last : start;
    box place = place_at_side(p, side, start, width, gap, depth);
    box around = place_at_side(p, side, start, width, gap + depth, front);
    /* The cells of the wall itself are taken: look at the place without its rim. */
    if (!has_wall(p, side, start, start + width) ||
        !claim(p, place, grown(place, -CELL), around, TAKEN | DOORWAY | CLEAR)) {
        return 0;
    }
    const int origins[4][2] = {{start + width / 2, place.y0},
                               {place.x1, start + width / 2},
                               {start + width / 2, place.y1},
                               {place.x0, start + width / 2}};
    /* v has to point into the room: u runs to the right at the top, down at the right. */
    frame f = frame_at(origins[side][0], origins[side][1], side * TURN_QUARTER);
    piece_draw(p->w, kind, &f, width, depth, &p->r);
    return 1;
}

static int try_free(placer *p, piece_kind kind, int width, int depth, int front) {
    int turned = rng_chance(&p->r, 500);
    int half_x = (turned ? depth : width) / 2;
    int half_y = (turned ? width : depth) / 2;
    box b = {p->floor.x0 + half_x, p->floor.y0 + half_y, p->floor.x1 - half_x,
             p->floor.y1 - half_y};
    if (b.x1 < b.x0 || b.y1 < b.y0) {
        return 0;
    }
    int x = rng_range(&p->r, b.x0, b.x1);
    int y = rng_range(&p->r, b.y0, b.y1);
    int32_t tilt = rng_normal(&p->r, TURN_DEGREES(3));
    box place = {x - half_x, y - half_y, x + half_x, y + half_y};
    int flags = front > 0 ? TAKEN | DOORWAY | CLEAR : TAKEN | DOORWAY;
    if (!claim(p, place, place, grown(place, front), flags)) {
        return 0;
    }
    frame centre = frame_at(x, y, (turned ? TURN_QUARTER : 0) + tilt);
    frame f = frame_inside(&centre, 0, -depth / 2, 0);
    piece_draw(p->w, kind, &f, width, depth, &p->r);
    return 1;
}

static void put_piece(placer *p, piece_kind kind) {
    const piece_size *s = piece_size_of(kind);
    int done = 0;
    for (int i = 0; i < TRIES && !done; i++) {
        int width = rng_range(&p->r, s->width_low, s->width_high);
        int depth = rng_range(&p->r, s->depth_low, s->depth_high);
        done = s->at_wall ? try_at_wall(p, kind, width, depth, s->front)
                          : try_free(p, kind, width, depth, s->front);
    }
}

/* What stands in a room of a kind: how likely, and how often that is tried. */
typedef struct wish {
    part_kind room;
    piece_kind piece;
    int permille, count;
} wish;

static const wish wishes[] = {
    {PART_LIVING, PIECE_CORNER_SOFA, 350, 1}, {PART_LIVING, PIECE_SOFA, 700, 2},
    {PART_LIVING, PIECE_CABINET, 700, 3},     {PART_LIVING, PIECE_DINING_SET, 700, 1},
    {PART_LIVING, PIECE_COFFEE_TABLE, 800, 1}, {PART_LIVING, PIECE_SHELF, 400, 2},
    {PART_LIVING, PIECE_ARMCHAIR, 500, 2},    {PART_LIVING, PIECE_PLANT, 500, 2},
    {PART_DINING, PIECE_DINING_SET, 900, 1},  {PART_DINING, PIECE_CABINET, 600, 2},
    {PART_DINING, PIECE_PLANT, 400, 1},       {PART_KITCHEN, PIECE_COUNTER, 950, 3},
    {PART_KITCHEN, PIECE_ISLAND, 400, 1},     {PART_KITCHEN, PIECE_DINING_SET, 300, 1},
    {PART_KITCHEN, PIECE_CABINET, 400, 1},    {PART_BED, PIECE_BED, 950, 1},
    {PART_BED, PIECE_CABINET, 700, 3},        {PART_BED, PIECE_DESK, 300, 1},
    {PART_BED, PIECE_SHELF, 400, 1},          {PART_BED, PIECE_CHAIR, 300, 1},
    {PART_BED, PIECE_RACK, 120, 1},
    {PART_BATH, PIECE_TUB, 550, 1},           {PART_BATH, PIECE_SHOWER, 450, 1},
    {PART_BATH, PIECE_TOILET, 900, 1},        {PART_BATH, PIECE_SINK, 900, 1},
    {PART_STUDY, PIECE_DESK, 950, 2},         {PART_STUDY, PIECE_SHELF, 700, 3},
    {PART_STUDY, PIECE_SOFA, 300, 1},         {PART_STUDY, PIECE_CABINET, 400, 1},
    {PART_STORE, PIECE_SHELF, 800, 3},        {PART_STORE, PIECE_CABINET, 400, 1},
    {PART_HALL, PIECE_SHELF, 500, 2},
};

/* Loose things, the more the fuller the flat: about one in 2 m2 at clutter 50. In corridors
 * they stand along the walls. */
static void put_loose_things(placer *p, part_kind kind) {
    static const piece_kind kinds[] = {PIECE_JUNK, PIECE_JUNK, PIECE_JUNK, PIECE_TOYS,
                                       PIECE_BOX,  PIECE_CHAIR, PIECE_TOYS, PIECE_PLANT};
    int area_dm2 = (p->floor.x1 - p->floor.x0) * (p->floor.y1 - p->floor.y0) / 100;
    int most = area_dm2 * p->clutter / 6000;
    for (int n = rng_range(&p->r, most / 2, most + 1); n > 0 && p->clutter > 0; n--) {
        piece_kind piece = kinds[rng_range(&p->r, 0, 7)];
        put_piece(p, kind == PART_HALL ? PIECE_JUNK : piece);
    }
}

static void put_rug(placer *p) {
    int width = rng_range(&p->r, 120, 240);
    int depth = rng_range(&p->r, 80, 170);
    int x = rng_range(&p->r, p->floor.x0, p->floor.x1);
    int y = rng_range(&p->r, p->floor.y0, p->floor.y1);
    box rug = {x, y, x + width, y + depth};
    if (world_is_all(p->w, rug, MAT_FLOOR)) {
        world_fill_box(p->w, rug, MAT_RUG, ROOM_KEEP);
    }
}

static void find_gates(placer *p, int part_index) {
    p->gate_count = 0;
    for (int i = 0; i < p->f->opening_count; i++) {
        const opening *o = &p->f->openings[i];
        int inner = o->low >= 0 && o->high >= 0 && !o->shut;
        if (inner && (o->low == part_index || o->high == part_index)) {
            p->gates[p->gate_count++] = cells_of(p, flat_gap(o, CELL));
        }
    }
}

static void furnish_part(placer *p, part_kind kind) {
    put_rug(p);
    for (size_t i = 0; i < sizeof wishes / sizeof wishes[0]; i++) {
        const wish *want = &wishes[i];
        for (int n = 0; want->room == kind && n < want->count; n++) {
            if (rng_chance(&p->r, want->permille)) {
                put_piece(p, want->piece);
            }
        }
    }
    put_loose_things(p, kind);
}

static void furnish_parts(placer *p, const uint8_t *skip, uint64_t seed) {
    read_world(p);
    for (int i = 0; i < p->f->part_count; i++) {
        const part *one = &p->f->parts[i];
        if (one->room != 0 && !skip[one->room]) {
            rng_seed(&p->r, seed, STREAM_PARTS + (uint32_t)i);
            p->floor = flat_floor(p->f, i);
            find_gates(p, i);
            furnish_part(p, one->kind);
        }
    }
}

int furniture_place(const flat *f, world *w, int clutter, const uint8_t *skip, uint64_t seed) {
    placer p = {.f = f, .w = w, .clutter = clutter};
    p.columns = w->width / CELL;
    p.rows = w->height / CELL;
    size_t count = (size_t)p.columns * (size_t)p.rows;
    p.flags = calloc(count, 1);
    p.mask = calloc(count, 1);
    p.queue = malloc(count * sizeof *p.queue);
    int rc = p.flags == NULL || p.mask == NULL || p.queue == NULL ? -1 : 0;
    if (rc == 0) {
        furnish_parts(&p, skip, seed);
    }
    free(p.flags);
    free(p.mask);
    free(p.queue);
    return rc;
}
