#include "drive.h"

#include <stdlib.h>
#include <string.h>

#include "passage.h"

enum {
    CELL = PASSAGE_CELL,
    SWEEP = 3,     /* half width of what counts as visited [cells] */
    STOP_EVERY = 7 /* a scan each 35 cm */
};

typedef struct planner {
    int columns, rows;
    uint8_t *passable; /* the robot's centre may be here */
    uint8_t *covered;
    int32_t *queue;    /* cells of the search that is under way */
    int32_t *parents;
    uint32_t *seen;    /* number of the last search that met the cell */
    uint32_t search;
    size_t capacity; /* of the route */
    route *out;
} planner;

static const int neighbours[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

static int is_open(const world *w, int column, int row) {
    for (int y = row * CELL; y < (row + 1) * CELL; y++) {
        for (int x = column * CELL; x < (column + 1) * CELL; x++) {
            material m = world_material(w, x, y);
            if (m != MAT_FLOOR && m != MAT_RUG) {
                return 0;
            }
        }
    }
    return 1;
}

static void find_passable(planner *p, const world *w) {
    memset(p->passable, 1, (size_t)(p->columns * p->rows));
    for (int row = 0; row < p->rows; row++) {
        for (int column = 0; column < p->columns; column++) {
            if (!is_open(w, column, row)) {
                passage_block_around(p->passable, p->columns, p->rows, column, row);
            }
        }
    }
}

/* Breadth-first from a cell. Returns the first cell that is not covered yet, or -1; then
 * *reached receives the number of cells in reach. */
static int32_t search_from(planner *p, int32_t start, size_t *reached) {
    size_t head = 0;
    size_t tail = 0;
    p->search++;
    p->queue[tail++] = start;
    p->seen[start] = p->search;
    p->parents[start] = start;
    while (head < tail) {
        int32_t cell = p->queue[head++];
        if (!p->covered[cell]) {
            return cell;
        }
        for (int i = 0; i < 4; i++) {
            /* The rim of the world is never passable: no neighbour is beyond the grid. */
            int32_t next = cell + neighbours[i][0] + neighbours[i][1] * p->columns;
            if (p->passable[next] && p->seen[next] != p->search) {
                p->seen[next] = p->search;
                p->parents[next] = cell;
                p->queue[tail++] = next;
            }
        }
    }
    *reached = tail;
    return -1;
}

/* A random cell of the largest connected floor, -1 when there is no floor. */
static int32_t choose_start(planner *p, rng *r) {
    size_t best = 0;
    int32_t start = -1;
    size_t count = (size_t)(p->columns * p->rows);
    memset(p->covered, 1, count);
    for (size_t cell = 0; cell < count; cell++) {
        size_t reached = 0;
        /* A cell that an earlier search met lies in a floor that was counted. */
        if (p->passable[cell] && p->seen[cell] == 0) {
            search_from(p, (int32_t)cell, &reached);
        }
        if (reached > best) {
            best = reached;
            start = p->queue[rng_range(r, 0, (int32_t)reached - 1)];
        }
    }
    memset(p->covered, 0, count);
    return start;
}

static void cover_around(planner *p, int32_t cell) {
    int x = cell % p->columns;
    int y = cell / p->columns;
    for (int dy = -SWEEP; dy <= SWEEP; dy++) {
        for (int dx = -SWEEP; dx <= SWEEP; dx++) {
            int inside = x + dx >= 0 && y + dy >= 0 && x + dx < p->columns && y + dy < p->rows;
            if (inside && dx * dx + dy * dy <= SWEEP * SWEEP) {
                p->covered[(y + dy) * p->columns + x + dx] = 1;
            }
        }
    }
}

static int add_stop(planner *p, const world *w, int32_t cell) {
    route *out = p->out;
    if (out->count == p->capacity) {
        size_t capacity = p->capacity == 0 ? 512 : p->capacity * 2;
        int(*stops)[2] = realloc(out->stops, capacity * sizeof *stops);
        if (stops == NULL) {
            return -1;
        }
        out->stops = stops;
        p->capacity = capacity;
    }
    int x = cell % p->columns * CELL + CELL / 2;
    int y = cell / p->columns * CELL + CELL / 2;
    out->stops[out->count][0] = x;
    out->stops[out->count][1] = y;
    out->count++;
    out->visited[w->rooms[(size_t)y * (size_t)w->width + (size_t)x]] = 1;
    return 0;
}

/* Drives until nothing in reach is left uncovered. */
static int cover_all(planner *p, const world *w, int32_t start) {
    int32_t here = start;
    size_t driven = 0;
    size_t reached;
    cover_around(p, start);
    if (add_stop(p, w, start) != 0) {
        return -1;
    }
    for (int32_t goal = search_from(p, here, &reached); goal >= 0;
         goal = search_from(p, here, &reached)) {
        /* The way leads from the goal back to here; it is walked in that order, as the
         * order of a few scans does not show. */
        for (int32_t cell = goal; cell != here; cell = p->parents[cell]) {
            cover_around(p, cell);
            if (++driven % STOP_EVERY == 0 && add_stop(p, w, cell) != 0) {
                return -1;
            }
        }
        here = goal;
    }
    return 0;
}

int drive_cover(const world *w, rng *r, route *out) {
    planner p = {w->width / CELL, w->height / CELL, NULL, NULL, NULL, NULL, NULL, 0, 0, out};
    size_t count = (size_t)(p.columns * p.rows);
    int rc = -1;
    *out = (route){NULL, 0, {0}};
    p.passable = malloc(count);
    p.covered = malloc(count);
    p.queue = malloc(count * sizeof *p.queue);
    p.parents = malloc(count * sizeof *p.parents);
    p.seen = calloc(count, sizeof *p.seen);
    if (p.passable != NULL && p.covered != NULL && p.queue != NULL && p.parents != NULL &&
        p.seen != NULL) {
        find_passable(&p, w);
        int32_t start = choose_start(&p, r);
        rc = start < 0 ? 0 : cover_all(&p, w, start);
    }
    free(p.passable);
    free(p.covered);
    free(p.queue);
    free(p.parents);
    free(p.seen);
    return rc;
}

void drive_free(route *way) {
    free(way->stops);
    *way = (route){NULL, 0, {0}};
}
