#include "simulate.h"

#include <stdlib.h>
#include <string.h>

#include "drive.h"
#include "furniture.h"
#include "slam.h"
#include "turn.h"

enum {
    BORDER = 8,   /* unknown cells that are left around the map */
    MIN_ROOMS = 3
};

/* Streams of random numbers, so that an option changes only what it is about. */
enum { STREAM_FLAT = 1, STREAM_WALLS, STREAM_DRIVE, STREAM_SLAM, STREAM_TURN };

sim_options sim_options_default(void) {
    return (sim_options){0, 50, FLAT_MEDIUM, 1, 50, 50, 0, 0};
}

/* Draws the flat, without furniture in the rooms that are flagged. */
static int build_world(const sim_options *o, const flat *f, const uint8_t *skip, world *w) {
    rng r;
    if (world_make(w, f->width, f->height) != 0) {
        return -1;
    }
    rng_seed(&r, o->seed, STREAM_WALLS);
    flat_draw(f, w, &r);
    if (o->furnished && furniture_place(f, w, o->clutter, skip, o->seed) != 0) {
        world_free(w);
        return -1;
    }
    world_bend(w, f->bend_from, f->bend_permille);
    return 0;
}

/* Takes the open door leaves out of two rooms. Returns how many. */
static int unhang_leaves(flat *f, int room_a, int room_b) {
    int gone = 0;
    for (int i = 0; i < f->opening_count; i++) {
        opening *o = &f->openings[i];
        int room = o->has_leaf ? f->parts[o->leaf_in_high ? o->high : o->low].room : 0;
        if (room != 0 && (room == room_a || room == room_b)) {
            o->has_leaf = 0;
            gone++;
        }
    }
    return gone;
}

/* Clears the way where the robot did not get through a passage: the rooms on both sides
 * lose their door leaves, or, having none, their furniture (flags in skip). Returns how
 * much was changed. */
static int clear_blocked(flat *f, const route *way, uint8_t *skip) {
    int changed = 0;
    for (int i = 0; i < f->opening_count; i++) {
        const opening *o = &f->openings[i];
        if (o->low < 0 || o->high < 0 || o->shut) {
            continue;
        }
        int a = f->parts[o->low].room;
        int b = f->parts[o->high].room;
        if (a == 0 || b == 0 || (way->visited[a] && way->visited[b])) {
            continue;
        }
        int leaves = unhang_leaves(f, a, b);
        changed += leaves > 0 || !skip[a] || !skip[b];
        if (leaves == 0) {
            skip[a] = 1;
            skip[b] = 1;
        }
    }
    return changed;
}

/* Builds the flat and the robot's way through it, again and again until the robot gets into
 * each room that is open to it. */
static int build_and_drive(const sim_options *o, flat *f, world *w, route *way) {
    uint8_t skip[FLAT_MAX_PARTS + 1] = {0};
    for (;;) {
        rng r;
        if (build_world(o, f, skip, w) != 0) {
            return -1;
        }
        rng_seed(&r, o->seed, STREAM_DRIVE);
        if (drive_cover(w, &r, way) != 0) {
            drive_free(way);
            world_free(w);
            return -1;
        }
        if (clear_blocked(f, way, skip) == 0) {
            return 0;
        }
        drive_free(way);
        world_free(w);
    }
}

/* A robot starts in any direction, mostly along the walls. */
static int32_t choose_turn(uint64_t seed) {
    rng r;
    rng_seed(&r, seed, STREAM_TURN);
    int straight = rng_chance(&r, 500);
    int most = straight ? TURN_DEGREES(3) : TURN_DEGREES(20);
    return rng_range(&r, -most, most);
}

/* The box of the cells that any beam has met, with a border. */
static box known_box(const slam *s) {
    box b = {s->width, s->height, 0, 0};
    for (int y = 0; y < s->height; y++) {
        for (int x = 0; x < s->width; x++) {
            if (s->cells[(size_t)y * (size_t)s->width + (size_t)x] != SLAM_UNKNOWN) {
                b.x0 = x < b.x0 ? x : b.x0;
                b.y0 = y < b.y0 ? y : b.y0;
                b.x1 = x >= b.x1 ? x + 1 : b.x1;
                b.y1 = y + 1;
            }
        }
    }
    b.x0 = b.x0 > BORDER ? b.x0 - BORDER : 0;
    b.y0 = b.y0 > BORDER ? b.y0 - BORDER : 0;
    b.x1 = b.x1 + BORDER < s->width ? b.x1 + BORDER : s->width;
    b.y1 = b.y1 + BORDER < s->height ? b.y1 + BORDER : s->height;
    return b;
}

/* New numbers 1, 2, ... for the rooms that the robot has entered, 0 for the others. */
static int renumber(const flat *f, const route *way, uint8_t numbers[256]) {
    int count = 0;
    memset(numbers, 0, 256);
    for (int room = 1; room <= f->room_count; room++) {
        if (way->visited[room]) {
            numbers[room] = (uint8_t)++count;
        }
    }
    return count;
}

static int copy_out(const slam *s, const uint8_t numbers[256], box b, sim_map *out) {
    out->width = (uint32_t)(b.x1 - b.x0);
    out->height = (uint32_t)(b.y1 - b.y0);
    size_t count = (size_t)out->width * out->height;
    out->cells = malloc(count);
    out->truth = malloc(count);
    if (out->cells == NULL || out->truth == NULL) {
        return -1;
    }
    for (uint32_t y = 0; y < out->height; y++) {
        size_t from = ((size_t)b.y0 + y) * (size_t)s->width + (size_t)b.x0;
        size_t to = (size_t)y * out->width;
        memcpy(out->cells + to, s->cells + from, out->width);
        for (uint32_t x = 0; x < out->width; x++) {
            out->truth[to + x] = numbers[s->truth[from + x]];
        }
    }
    return 0;
}

static int map_flat(const sim_options *o, const flat *f, const world *w, const route *way,
                    sim_map *out) {
    slam s;
    rng r;
    uint8_t numbers[256];
    out->turn = o->has_turn ? o->turn : choose_turn(o->seed);
    rng_seed(&r, o->seed, STREAM_SLAM);
    if (slam_make(&s, w, o->resolution_mm, out->turn, o->noise, r) != 0) {
        return -1;
    }
    for (size_t i = 0; i < way->count; i++) {
        slam_scan(&s, w, way->stops[i][0], way->stops[i][1]);
    }
    slam_finish_truth(&s);
    box b = known_box(&s);
    int start_x = 0;
    int start_y = 0;
    if (way->count > 0) {
        slam_cell_of(&s, way->stops[0][0], way->stops[0][1], &start_x, &start_y);
    }
    out->resolution_mm = o->resolution_mm;
    out->origin_x_mm = (b.x0 - start_x) * o->resolution_mm;
    out->origin_y_mm = (start_y - b.y1) * o->resolution_mm;
    out->room_count = renumber(f, way, numbers);
    int rc = copy_out(&s, numbers, b, out);
    slam_free(&s);
    return rc;
}

static int is_valid(const sim_options *o) {
    return o->resolution_mm >= 20 && o->resolution_mm <= 200 && o->clutter >= 0 &&
           o->clutter <= 100 && o->noise >= 0 && o->noise <= 100 && o->size >= FLAT_SMALL &&
           o->size <= FLAT_LARGE;
}

/* Draws plans until one has enough rooms; nearly all have. */
static void plan_flat(flat *f, const sim_options *o) {
    rng r;
    rng_seed(&r, o->seed, STREAM_FLAT);
    do {
        flat_layout(f, o->size, &r);
        flat_connect(f, &r);
    } while (f->room_count < MIN_ROOMS);
    flat_set_back(f, &r);
    flat_open_outwards(f, &r);
}

int sim_run(const sim_options *options, sim_map *out) {
    flat f;
    world w;
    route way;
    *out = (sim_map){0};
    if (!is_valid(options)) {
        return -1;
    }
    plan_flat(&f, options);
    if (build_and_drive(options, &f, &w, &way) != 0) {
        return -1;
    }
    int rc = map_flat(options, &f, &w, &way, out);
    if (rc != 0) {
        sim_map_free(out);
    }
    drive_free(&way);
    world_free(&w);
    return rc;
}

void sim_map_free(sim_map *map) {
    free(map->cells);
    free(map->truth);
    *map = (sim_map){0};
}
