#include "slam.h"

#include <stdlib.h>
#include <string.h>

#include "turn.h"

enum {
    ONE = 65536,
    HIT = 30,           /* what a beam's end adds to a cell, */
    HIT_AGAIN = 110,    /* and to one that was hit more often than crossed so far */
    MISS_NEAR = 8,      /* what a beam takes off the cells that it crosses: near the robot, */
    MISS_FAR = 2,       /* and at the laser's full range */
    WARP_MM = 45,       /* largest displacement of a node of the warp, at noise 50 */
    DRIFT_KEEP = 995,   /* permille of the drift that is left at the next scan */
    DRIFT_STEP_MM = 2,
    DRIFT_STEP_TURN = 5,
    JITTER_TURN = 25,   /* of each beam: 0.14 degrees */
    SHY_MM = 70,        /* so close before its end, a beam hardly frees a cell */
    TILTS = 45,         /* scans that look at the floor, on a doorstep or a rug [permille] */
    MARGIN_CELLS = 4
};

static int64_t floor_div(int64_t a, int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/* Millimetres as a length of the world [1/65536 cm], at this noise. */
static int32_t noisy_mm(const slam *s, int32_t mm) {
    return (int32_t)((int64_t)mm * ONE / 10 * s->noise / 50);
}

static int make_warp(slam *s, const world *w) {
    s->warp_columns = w->width / WARP_STEP + 2;
    s->warp_rows = w->height / WARP_STEP + 2;
    size_t count = (size_t)(s->warp_columns * s->warp_rows);
    int32_t most = noisy_mm(s, WARP_MM);
    s->warp = malloc(count * sizeof *s->warp);
    if (s->warp == NULL) {
        return -1;
    }
    for (size_t i = 0; i < count; i++) {
        s->warp[i][0] = rng_range(&s->r, -most, most);
        s->warp[i][1] = rng_range(&s->r, -most, most);
    }
    return 0;
}

int slam_make(slam *s, const world *w, int resolution_mm, int32_t turn, int noise, rng r) {
    int64_t c = turn_cos(turn);
    int64_t t = turn_sin(turn);
    int64_t wide = ((c < 0 ? -c : c) * w->width + (t < 0 ? -t : t) * w->height) / ONE;
    int64_t high = ((t < 0 ? -t : t) * w->width + (c < 0 ? -c : c) * w->height) / ONE;
    *s = (slam){0};
    s->width = (int)(wide * 10 / resolution_mm) + 2 * MARGIN_CELLS;
    s->height = (int)(high * 10 / resolution_mm) + 2 * MARGIN_CELLS;
    s->resolution_mm = resolution_mm;
    s->turn = turn;
    s->cos_turn = c;
    s->sin_turn = t;
    s->centre_x = w->width / 2;
    s->centre_y = w->height / 2;
    s->noise = noise;
    s->r = r;
    size_t count = (size_t)s->width * (size_t)s->height;
    s->cells = malloc(count);
    s->truth = calloc(count, 1);
    s->weights = calloc(count, 1);
    if (s->cells == NULL || s->truth == NULL || s->weights == NULL || make_warp(s, w) != 0) {
        slam_free(s);
        return -1;
    }
    memset(s->cells, SLAM_UNKNOWN, count);
    return 0;
}

void slam_free(slam *s) {
    free(s->cells);
    free(s->truth);
    free(s->weights);
    free(s->warp);
    *s = (slam){0};
}

/* What the warp does at a place: displacement, and the turn that goes with it. */
typedef struct shift {
    int32_t x, y;
    int32_t turn;
} shift;

static shift warp_at(const slam *s, position p) {
    const int64_t mesh = (int64_t)WARP_STEP * ONE;
    int column = (int)(p.x / mesh);
    int row = (int)(p.y / mesh);
    int64_t fx = p.x % mesh;
    int64_t fy = p.y % mesh;
    const int32_t(*top)[2] = (const int32_t(*)[2])(s->warp + row * s->warp_columns + column);
    const int32_t(*low)[2] = top + s->warp_columns;
    int64_t at[2];
    int64_t along_x[2]; /* growth over one mesh, along x and along y */
    int64_t along_y[2];
    for (int i = 0; i < 2; i++) {
        int64_t upper = top[0][i] + (top[1][i] - top[0][i]) * fx / mesh;
        int64_t lower = low[0][i] + (low[1][i] - low[0][i]) * fx / mesh;
        at[i] = upper + (lower - upper) * fy / mesh;
        along_x[i] = top[1][i] - top[0][i] + low[1][i] - low[0][i];
        along_y[i] = low[0][i] - top[0][i] + low[1][i] - top[1][i];
    }
    /* Half the curl [rad], from sums of two differences each; 10430 units are 1 rad. */
    int64_t turn = (along_x[1] - along_y[0]) * 10430 / (4 * mesh);
    return (shift){(int32_t)at[0], (int32_t)at[1], (int32_t)turn};
}

/* World to grid, without any error [1/65536 cm -> 1/65536 cell]. */
static position to_grid(const slam *s, int64_t x, int64_t y) {
    int64_t rx = x - (int64_t)s->centre_x * ONE;
    int64_t ry = y - (int64_t)s->centre_y * ONE;
    int64_t gx = (rx * s->cos_turn - ry * s->sin_turn) / ONE * 10 / s->resolution_mm;
    int64_t gy = (rx * s->sin_turn + ry * s->cos_turn) / ONE * 10 / s->resolution_mm;
    return (position){(int32_t)(gx + (int64_t)s->width * ONE / 2),
                      (int32_t)(gy + (int64_t)s->height * ONE / 2)};
}

static int room_at(const world *w, position p) {
    int64_t x = floor_div(p.x, ONE);
    int64_t y = floor_div(p.y, ONE);
    if (x < 0 || y < 0 || x >= w->width || y >= w->height) {
        return 0;
    }
    return w->rooms[(size_t)y * (size_t)w->width + (size_t)x];
}

/* The beams that cross a cell elect its room: one counter is enough for a majority. */
static void vote(slam *s, size_t cell, int room) {
    if (s->weights[cell] == 0) {
        s->truth[cell] = (uint8_t)room;
        s->weights[cell] = 1;
    } else if (s->truth[cell] != room) {
        s->weights[cell]--;
    } else if (s->weights[cell] < 255) {
        s->weights[cell]++;
    }
}

static void add_to(slam *s, size_t cell, int amount) {
    int value = s->cells[cell] + amount;
    s->cells[cell] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
}

/* One beam on its way through the grid and, at the same time, through the world. */
typedef struct beam {
    position grid, world;
    int32_t grid_dx, grid_dy; /* for each step of half a cell */
    int32_t world_dx, world_dy;
} beam;

static size_t cell_at(const slam *s, position p) {
    return (size_t)(p.y / ONE) * (size_t)s->width + (size_t)(p.x / ONE);
}

static int in_grid(const slam *s, int64_t x, int64_t y) {
    return x >= 0 && y >= 0 && x < (int64_t)s->width * ONE && y < (int64_t)s->height * ONE;
}

static void lay_beam(slam *s, const world *w, beam b, int32_t range_mm) {
    int steps = range_mm * 2 / s->resolution_mm;
    int64_t end_x = b.grid.x + (int64_t)b.grid_dx * steps;
    int64_t end_y = b.grid.y + (int64_t)b.grid_dy * steps;
    if (!in_grid(s, end_x, end_y) || !in_grid(s, b.grid.x, b.grid.y)) {
        return;
    }
    size_t end = cell_at(s, (position){(int32_t)end_x, (int32_t)end_y});
    size_t last = end;
    for (int i = 0; i < steps; i++) {
        size_t cell = cell_at(s, b.grid);
        int far = i * s->resolution_mm / 2;
        if (cell != last && cell != end) {
            int miss = MISS_NEAR - (MISS_NEAR - MISS_FAR) * far / LIDAR_MAX_MM;
            miss = far > range_mm - SHY_MM ? 1 : miss > 1 ? miss : 1;
            add_to(s, cell, -miss);
            vote(s, cell, room_at(w, b.world));
            last = cell;
        }
        b.grid.x += b.grid_dx;
        b.grid.y += b.grid_dy;
        b.world.x += b.world_dx;
        b.world.y += b.world_dy;
    }
    add_to(s, end, s->cells[end] > SLAM_UNKNOWN ? HIT_AGAIN : HIT);
}

static void drift_on(slam *s) {
    int32_t step = noisy_mm(s, DRIFT_STEP_MM);
    s->drift_x = s->drift_x * DRIFT_KEEP / 1000 + rng_normal(&s->r, step);
    s->drift_y = s->drift_y * DRIFT_KEEP / 1000 + rng_normal(&s->r, step);
    s->drift_turn = s->drift_turn * DRIFT_KEEP / 1000 +
                    rng_normal(&s->r, DRIFT_STEP_TURN * s->noise / 50);
}

/* A robot that tilts sees the floor on one side. */
typedef struct tilt {
    int32_t direction;
    int32_t nearest_mm; /* where the laser's plane meets the floor; 0 = nowhere */
} tilt;

static tilt draw_tilt(slam *s) {
    tilt t = {0, 0};
    if (rng_chance(&s->r, TILTS * s->noise / 50)) {
        t.direction = rng_range(&s->r, 0, TURN_FULL - 1);
        t.nearest_mm = rng_range(&s->r, 500, 2500);
    }
    return t;
}

/* What is measured of the range when the beam may meet the floor first. */
static int32_t cut_range(slam *s, const tilt *t, int32_t angle, int32_t range) {
    int64_t ahead = turn_cos(angle - t->direction);
    if (t->nearest_mm == 0 || ahead < ONE / 3) {
        return range;
    }
    int32_t floor_mm = (int32_t)(t->nearest_mm * (int64_t)ONE / ahead) + rng_normal(&s->r, 40);
    return range == 0 || floor_mm < range ? floor_mm : range;
}

void slam_scan(slam *s, const world *w, int x, int y) {
    position at;
    at.x = x * ONE + rng_range(&s->r, 0, ONE - 1);
    at.y = y * ONE + rng_range(&s->r, 0, ONE - 1);
    shift warp = warp_at(s, at);
    drift_on(s);
    beam b;
    b.grid = to_grid(s, (int64_t)at.x + warp.x + s->drift_x,
                     (int64_t)at.y + warp.y + s->drift_y);
    b.world = at;
    int32_t error = warp.turn + s->drift_turn + s->turn;
    tilt tilted = draw_tilt(s);
    int32_t heading = rng_range(&s->r, 0, TURN_FULL - 1);
    for (int i = 0; i < LIDAR_BEAMS; i++) {
        int32_t angle = heading + i * TURN_FULL / LIDAR_BEAMS;
        int32_t seen = angle + rng_normal(&s->r, JITTER_TURN * s->noise / 50);
        int32_t range = lidar_measure(w, at, angle, s->noise, &s->r);
        range = cut_range(s, &tilted, angle, range);
        b.grid_dx = turn_cos(seen + error) / 2;
        b.grid_dy = turn_sin(seen + error) / 2;
        b.world_dx = (int32_t)((int64_t)turn_cos(angle) * s->resolution_mm / 20);
        b.world_dy = (int32_t)((int64_t)turn_sin(angle) * s->resolution_mm / 20);
        if (range > 0) {
            lay_beam(s, w, b, range);
        }
    }
}

void slam_finish_truth(slam *s) {
    size_t count = (size_t)s->width * (size_t)s->height;
    for (size_t cell = 0; cell < count; cell++) {
        if (s->cells[cell] > SLAM_FREE) {
            s->truth[cell] = 0;
        }
    }
}

void slam_cell_of(const slam *s, int x, int y, int *column, int *row) {
    position at = {x * ONE, y * ONE};
    shift warp = warp_at(s, at);
    position grid = to_grid(s, (int64_t)at.x + warp.x, (int64_t)at.y + warp.y);
    *column = grid.x / ONE;
    *row = grid.y / ONE;
}
