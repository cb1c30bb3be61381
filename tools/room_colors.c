#include "room_colors.h"

#include <stdlib.h>
#include <string.h>

/* Neighbours weigh more than rooms behind a wall, which weigh less with distance. */
#define NEIGHBOUR_WEIGHT 20.0
#define NEARBY_CELLS 10.0

/* Comparing every two rooms takes too long above this; then only neighbours count. */
#define MAX_ROOMS_COMPARED 2000u

/* Below these distances in CIELAB two colours begin to look alike: side by side, where the
 * difference must strike, and with a wall between them. */
#define CLEAR_BESIDE 50.0
#define CLEAR_NEARBY 28.0

#define NO_COLOR 255u

/* L, a, b: the same colour in CIELAB (D65), where distances are what an eye sees. */
static const struct {
    color paint;
    int8_t l, a, b;
} palette[ROOM_COLOR_COUNT] = {
    {{143, 216, 232}, 82, -19, -15}, /* cyan */
    {{249, 207, 139}, 85, 6, 39},    /* apricot */
    {{181, 221, 140}, 84, -27, 36},  /* green */
    {{246, 165, 160}, 75, 29, 15},   /* salmon */
    {{185, 163, 232}, 71, 22, -32},  /* violet */
    {{247, 240, 154}, 94, -10, 42},  /* yellow */
    {{147, 181, 236}, 73, 2, -31},   /* blue */
    {{143, 214, 176}, 80, -30, 12},  /* mint */
    {{234, 166, 220}, 76, 33, -17},  /* pink */
    {{217, 185, 155}, 77, 7, 19},    /* sand */
    {{252, 213, 224}, 89, 15, 0},    /* rose */
};

color room_color(uint8_t index) {
    return palette[index].paint;
}

/* 1 for the same colour, falling to 0 at a distance of `clear`. */
static double similarity(int i, int j, double clear) {
    double l = palette[i].l - palette[j].l;
    double a = palette[i].a - palette[j].a;
    double b = palette[i].b - palette[j].b;
    double share = (l * l + a * a + b * b) / (clear * clear);
    return share < 1.0 ? 1.0 - share : 0.0;
}

/* Index of the room on the other side of room i's k-th doorway. */
static uint32_t neighbour(const roomseg_result *r, uint32_t i, uint32_t k) {
    const roomseg_doorway *d = &r->doorways[r->links[r->rooms[i].link_first + k]];
    return (uint32_t)(d->room_a == r->rooms[i].label ? d->room_b : d->room_a) - 1;
}

static int gap(int low_a, int high_a, int low_b, int high_b) {
    return low_b > high_a ? low_b - high_a : low_a > high_b ? low_a - high_b : 0;
}

/* How much a room at the distance of the two bounding boxes matters. */
static double nearness(const roomseg_room *a, const roomseg_room *b) {
    int x = gap(a->min_x, a->max_x, b->min_x, b->max_x);
    int y = gap(a->min_y, a->max_y, b->min_y, b->max_y);
    double steps = 1.0 + (x > y ? x : y) / NEARBY_CELLS;
    return 1.0 / (steps * steps);
}

/* Chooses for room i, given the rooms that have a colour already. */
static uint8_t choose(const roomseg_result *r, uint32_t i, const uint8_t *index) {
    double nearby[ROOM_COLOR_COUNT] = {0};
    uint8_t taken[ROOM_COLOR_COUNT] = {0};
    for (uint32_t k = 0; k < r->rooms[i].link_count; k++) {
        uint8_t other = index[neighbour(r, i, k)];
        if (other != NO_COLOR) {
            taken[other] = 1;
        }
    }
    for (uint32_t j = 0; j < r->room_count && r->room_count <= MAX_ROOMS_COMPARED; j++) {
        if (index[j] != NO_COLOR) {
            nearby[index[j]] += nearness(&r->rooms[i], &r->rooms[j]);
        }
    }
    int best = -1;
    double best_cost = 0;
    for (int c = 0; c < ROOM_COLOR_COUNT; c++) {
        double cost = 0;
        for (int other = 0; other < ROOM_COLOR_COUNT; other++) {
            cost += NEIGHBOUR_WEIGHT * taken[other] * similarity(c, other, CLEAR_BESIDE) +
                    nearby[other] * similarity(c, other, CLEAR_NEARBY);
        }
        if (!taken[c] && (best < 0 || cost < best_cost)) {
            best = c;
            best_cost = cost;
        }
    }
    return best < 0 ? 0 : (uint8_t)best;
}

/* Orders the rooms so that each has few neighbours before it: takes away, again and again,
 * the rooms with at most `most` neighbours left, smallest room first; the reverse is the
 * order. Rooms in the plane are a planar graph, in which 5 always suffice. */
static void order_rooms(const roomseg_result *r, uint32_t *order, uint32_t *degree,
                        uint8_t *removed) {
    uint32_t left = r->room_count;
    uint32_t most = 5;
    for (uint32_t i = 0; i < r->room_count; i++) {
        degree[i] = r->rooms[i].link_count;
    }
    while (left > 0) {
        uint32_t before = left;
        for (uint32_t i = r->room_count; i-- > 0;) {
            if (removed[i] || degree[i] > most) {
                continue;
            }
            removed[i] = 1;
            order[--left] = i;
            for (uint32_t k = 0; k < r->rooms[i].link_count; k++) {
                degree[neighbour(r, i, k)]--;
            }
        }
        most += left == before;
    }
}

int room_colors_choose(const roomseg_result *result, uint8_t *index) {
    size_t count = result->room_count;
    uint32_t *order = malloc((count + 1) * sizeof *order);
    uint32_t *degree = malloc((count + 1) * sizeof *degree);
    uint8_t *removed = calloc(count + 1, 1);
    int rc = -1;
    if (order != NULL && degree != NULL && removed != NULL) {
        memset(index, NO_COLOR, count);
        order_rooms(result, order, degree, removed);
        for (size_t i = 0; i < count; i++) {
            index[order[i]] = choose(result, order[i], index);
        }
        rc = 0;
    }
    free(order);
    free(degree);
    free(removed);
    return rc;
}
