/* How one gets from room to room: merged parts, doors, wide openings, windows. */
#include "flat.h"

enum {
    MAX_WALLS = 120,      /* pairs of parts that share a wall */
    JAMB = 12,            /* wall that is left beside a door at least [cm] */
    DOOR_LOW = 70,        /* clear widths [cm] */
    DOOR_HIGH = 98,
    WIDE_LOW = 115,
    WIDE_HIGH = 250,
    MERGED_MAX_CM2 = 480000, /* largest room that is made of several parts */
    NEVER = 1000          /* cost above which no door is set but to reach a part */
};

/* A wall that two parts share; it may become an opening. */
typedef struct shared_wall {
    int low, high; /* parts, on the side of smaller and of larger coordinates */
    int upright;
    int line, from, to;
    int cost; /* connections are made in rising order */
} shared_wall;

typedef struct connector {
    flat *f;
    rng *r;
    shared_wall walls[MAX_WALLS];
    int wall_count;
    int group[FLAT_MAX_PARTS];  /* parts of one group can reach each other */
    int merged[FLAT_MAX_PARTS]; /* parts of one number are one room */
} connector;

static int exists(const part *p) {
    return p->kind != PART_VOID;
}

static int smaller(int a, int b) {
    return a < b ? a : b;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

static int slimness(box b) {
    return smaller(b.x1 - b.x0, b.y1 - b.y0);
}

static void add_wall(connector *c, int low, int high, int upright, int line, int from, int to) {
    if (to - from >= DOOR_LOW + 2 * JAMB + c->f->wall && c->wall_count < MAX_WALLS) {
        c->walls[c->wall_count++] = (shared_wall){low, high, upright, line, from, to, 0};
    }
}

static void find_walls(connector *c) {
    const part *p = c->f->parts;
    for (int i = 0; i < c->f->part_count; i++) {
        for (int j = 0; j < c->f->part_count; j++) {
            box a = p[i].area;
            box b = p[j].area;
            if (i == j || !exists(&p[i]) || !exists(&p[j])) {
                continue;
            }
            if (a.x1 == b.x0) {
                add_wall(c, i, j, 1, a.x1, larger(a.y0, b.y0), smaller(a.y1, b.y1));
            } else if (a.y1 == b.y0) {
                add_wall(c, i, j, 0, a.y1, larger(a.x0, b.x0), smaller(a.x1, b.x1));
            }
        }
    }
}

/* All of one number take the other's. */
static void join(int *numbers, int count, int kept, int gone) {
    for (int i = 0; i < count; i++) {
        if (numbers[i] == gone) {
            numbers[i] = kept;
        }
    }
}

static opening *add_opening(connector *c, opening_kind kind, const shared_wall *w, int from,
                            int to) {
    flat *f = c->f;
    if (f->opening_count == FLAT_MAX_OPENINGS) {
        return NULL;
    }
    opening *o = &f->openings[f->opening_count++];
    *o = (opening){kind, w->low, w->high, w->upright, w->line, from, to, 0, 0, 0, 0, 0};
    return o;
}

static int merged_area(const connector *c, int room) {
    int sum = 0;
    for (int i = 0; i < c->f->part_count; i++) {
        sum += c->merged[i] == room ? box_area(c->f->parts[i].area) : 0;
    }
    return sum;
}

static int may_be_open_plan(part_kind kind) {
    return kind == PART_LIVING || kind == PART_DINING || kind == PART_KITCHEN ||
           kind == PART_STUDY;
}

/* Whether the wall may go without leaving two rooms in all but name: it has to be nearly
 * as long as the smaller part is wide. */
static int can_merge(const connector *c, const shared_wall *w) {
    const part *a = &c->f->parts[w->low];
    const part *b = &c->f->parts[w->high];
    int length = w->to - w->from;
    if (a->kind == PART_HALL && b->kind == PART_HALL) {
        return length >= smaller(slimness(a->area), slimness(b->area)) * 9 / 10;
    }
    if (!may_be_open_plan(a->kind) || !may_be_open_plan(b->kind)) {
        return 0;
    }
    int side_a = w->upright ? a->area.y1 - a->area.y0 : a->area.x1 - a->area.x0;
    int side_b = w->upright ? b->area.y1 - b->area.y0 : b->area.x1 - b->area.x0;
    int together = merged_area(c, c->merged[w->low]) + merged_area(c, c->merged[w->high]);
    return length * 10 >= smaller(side_a, side_b) * 9 && together <= MERGED_MAX_CM2 &&
           slimness(a->area) >= 200 && slimness(b->area) >= 200;
}

static void merge_parts(connector *c) {
    int half = c->f->wall / 2;
    int count = c->f->part_count;
    for (int i = 0; i < c->wall_count; i++) {
        const shared_wall *w = &c->walls[i];
        int halls = c->f->parts[w->low].kind == PART_HALL;
        int wanted = rng_chance(c->r, halls ? 1000 : 550);
        if (wanted && c->merged[w->low] != c->merged[w->high] && can_merge(c, w)) {
            add_opening(c, OPENING_MERGED, w, w->from + half, w->to - half);
            join(c->merged, count, c->merged[w->low], c->merged[w->high]);
            join(c->group, count, c->group[w->low], c->group[w->high]);
        }
    }
}

/* How unlikely a door between rooms of these kinds is. */
static int kind_cost(part_kind a, part_kind b) {
    if (a == PART_STAIRS || b == PART_STAIRS) {
        return a == PART_HALL || b == PART_HALL ? 60 : NEVER;
    }
    if (a == PART_HALL || b == PART_HALL) {
        return 0;
    }
    if (a == PART_STORE || b == PART_STORE) {
        return 30;
    }
    if (a == PART_BATH || b == PART_BATH) {
        return a == PART_BED || b == PART_BED ? 45 : 120;
    }
    if (may_be_open_plan(a) && may_be_open_plan(b)) {
        return 20;
    }
    return a == PART_LIVING || b == PART_LIVING ? 40 : 150;
}

static void sort_walls(connector *c) {
    for (int i = 0; i < c->wall_count; i++) {
        shared_wall *w = &c->walls[i];
        w->cost = kind_cost(c->f->parts[w->low].kind, c->f->parts[w->high].kind) +
                  rng_range(c->r, 0, 40);
    }
    /* Insertion keeps equal ones in order, so the result is the same everywhere. */
    for (int i = 1; i < c->wall_count; i++) {
        shared_wall w = c->walls[i];
        int j = i;
        for (; j > 0 && c->walls[j - 1].cost > w.cost; j--) {
            c->walls[j] = c->walls[j - 1];
        }
        c->walls[j] = w;
    }
}

/* Clear width of a passage without a door, or 0 where there is to be a door. The gap is
 * clearly narrower than the rooms on both sides: they are two rooms to everybody. */
static int wide_width(const connector *c, const shared_wall *w) {
    const part *a = &c->f->parts[w->low];
    const part *b = &c->f->parts[w->high];
    int hall = a->kind == PART_HALL || b->kind == PART_HALL;
    int open = hall ? may_be_open_plan(a->kind) || may_be_open_plan(b->kind)
                    : may_be_open_plan(a->kind) && may_be_open_plan(b->kind);
    int limit = smaller(slimness(a->area), slimness(b->area)) - c->f->wall;
    limit = hall ? limit - 10 : limit * 6 / 10;
    limit = smaller(limit, w->to - w->from - c->f->wall - 2 * JAMB);
    if (!open || !rng_chance(c->r, 500)) {
        return 0;
    }
    int width = rng_range(c->r, WIDE_LOW, WIDE_HIGH);
    width = smaller(width, limit);
    return width >= DOOR_LOW + 15 ? width : 0;
}

static void hang_door_leaf(connector *c, opening *o) {
    const part *parts = c->f->parts;
    o->has_leaf = rng_chance(c->r, 700);
    o->hinge_at_to = rng_chance(c->r, 500);
    o->leaf_in_high = rng_chance(c->r, 500);
    if (parts[o->low].kind == PART_HALL) {
        o->leaf_in_high = 1;
    } else if (parts[o->high].kind == PART_HALL) {
        o->leaf_in_high = 0;
    }
    int against_wall = rng_chance(c->r, 650);
    o->leaf_degrees = against_wall ? rng_range(c->r, 84, 100) : rng_range(c->r, 82, 172);
}

static void set_passage(connector *c, const shared_wall *w) {
    int from = w->from + c->f->wall / 2 + JAMB;
    int to = w->to - c->f->wall / 2 - JAMB;
    int width = wide_width(c, w);
    if (width > 0) {
        int start = rng_range(c->r, from, to - width);
        add_opening(c, OPENING_WIDE, w, start, start + width);
        return;
    }
    width = rng_range(c->r, DOOR_LOW, DOOR_HIGH);
    width = smaller(width, to - from);
    /* Doors like corners: at one end of the wall, or anywhere. */
    int at_end = rng_chance(c->r, 600);
    int low_end = rng_chance(c->r, 500);
    int start = rng_range(c->r, from, to - width);
    if (at_end) {
        start = low_end ? from : to - width;
    }
    opening *o = add_opening(c, OPENING_DOOR, w, start, start + width);
    if (o != NULL) {
        hang_door_leaf(c, o);
    }
}

/* Whether two rooms that can reach each other get one more passage. */
static int wants_loop(connector *c, const shared_wall *w) {
    int open = may_be_open_plan(c->f->parts[w->low].kind) +
               may_be_open_plan(c->f->parts[w->high].kind);
    int wanted = rng_chance(c->r, 120 + 110 * open);
    return wanted && w->cost < 60 && c->merged[w->low] != c->merged[w->high];
}

static int already_open(const flat *f, const shared_wall *w) {
    for (int i = 0; i < f->opening_count; i++) {
        if (f->openings[i].low == w->low && f->openings[i].high == w->high) {
            return 1;
        }
    }
    return 0;
}

static void set_passages(connector *c) {
    sort_walls(c);
    for (int i = 0; i < c->wall_count; i++) {
        const shared_wall *w = &c->walls[i];
        if (c->group[w->low] != c->group[w->high]) {
            set_passage(c, w);
            join(c->group, c->f->part_count, c->group[w->low], c->group[w->high]);
        }
    }
    for (int i = 0; i < c->wall_count; i++) {
        const shared_wall *w = &c->walls[i];
        if (c->group[w->low] == c->group[w->high] && !already_open(c->f, w) &&
            wants_loop(c, w)) {
            set_passage(c, w);
        }
    }
}

/* Rooms with one door only may have it shut. */
static void shut_doors(connector *c) {
    flat *f = c->f;
    int passages[FLAT_MAX_PARTS] = {0};
    for (int i = 0; i < f->opening_count; i++) {
        passages[c->merged[f->openings[i].low]]++;
        passages[c->merged[f->openings[i].high]]++;
    }
    for (int i = 0; i < f->opening_count; i++) {
        opening *o = &f->openings[i];
        int shut = rng_chance(c->r, 60);
        for (int side = 0; side < 2 && shut && o->kind == OPENING_DOOR; side++) {
            int inner = side == 0 ? o->low : o->high;
            part_kind kind = f->parts[inner].kind;
            if (passages[c->merged[inner]] == 1 && kind != PART_LIVING && kind != PART_HALL) {
                o->shut = 1;
            }
        }
    }
}

/* The parts that the largest group does not reach are none of the flat. */
static void drop_unreached(connector *c) {
    flat *f = c->f;
    int best = -1;
    int best_area = 0;
    for (int i = 0; i < f->part_count; i++) {
        int sum = 0;
        for (int j = 0; j < f->part_count; j++) {
            int same = exists(&f->parts[j]) && c->group[j] == c->group[i];
            sum += same ? box_area(f->parts[j].area) : 0;
        }
        if (exists(&f->parts[i]) && sum > best_area) {
            best_area = sum;
            best = c->group[i];
        }
    }
    for (int i = 0; i < f->part_count; i++) {
        if (c->group[i] != best) {
            f->parts[i].kind = PART_VOID;
        }
    }
}

static void number_rooms(connector *c) {
    flat *f = c->f;
    for (int i = 0; i < f->part_count; i++) {
        part *p = &f->parts[i];
        if (!exists(p) || p->kind == PART_STAIRS || p->room != 0) {
            continue;
        }
        f->room_count++;
        for (int j = i; j < f->part_count; j++) {
            if (c->merged[j] == c->merged[i]) {
                f->parts[j].room = f->room_count;
            }
        }
    }
}

void flat_connect(flat *f, rng *r) {
    connector c = {f, r, {{0, 0, 0, 0, 0, 0, 0}}, 0, {0}, {0}};
    for (int i = 0; i < f->part_count; i++) {
        c.group[i] = i;
        c.merged[i] = i;
    }
    find_walls(&c);
    merge_parts(&c);
    set_passages(&c);
    drop_unreached(&c);
    shut_doors(&c);
    number_rooms(&c);
}
