#include "colors.h"

#include <stdlib.h>
#include <string.h>

#include "room_colors.h"

const color PAINT_FREE = {255, 255, 255};
const color PAINT_UNKNOWN = {226, 230, 234};
const color PAINT_OBSTACLE = {52, 58, 64};
const color PAINT_BACKGROUND = {173, 181, 189};
const color PAINT_INK = {33, 37, 41};
const color PAINT_HALO = {255, 255, 255};
const color PAINT_SIGNAL = {214, 29, 84};
const color PAINT_SECOND = {25, 113, 194};
const color PAINT_QUIET = {134, 142, 150};
const color PAINT_AMBER = {245, 159, 0};

color paint_mix(color first, color second, double share) {
    double rest = 1 - share;
    color mixed = {(uint8_t)(first.r * rest + second.r * share + 0.5),
                   (uint8_t)(first.g * rest + second.g * share + 0.5),
                   (uint8_t)(first.b * rest + second.b * share + 0.5)};
    return mixed;
}

static color on_ramp(const color *stops, int count, double share) {
    double at = share <= 0 ? 0 : share >= 1 ? count - 1 : share * (count - 1);
    int i = (int)at;
    return i + 1 < count ? paint_mix(stops[i], stops[i + 1], at - i) : stops[count - 1];
}

color paint_heat(double share) {
    static const color stops[] = {
        {43, 16, 85}, {52, 66, 145}, {36, 119, 142}, {41, 168, 123}, {139, 207, 79}, {250, 236, 96},
    };
    return on_ramp(stops, sizeof stops / sizeof stops[0], share);
}

color paint_ridge(double share) {
    static const color stops[] = {
        {255, 255, 255}, {253, 214, 170}, {238, 130, 90}, {178, 40, 70}, {86, 10, 60},
    };
    return on_ramp(stops, sizeof stops / sizeof stops[0], share);
}

/* Cells across which two labels still count as neighbours. */
#define NEIGHBOUR_REACH 4u

/* Two labels that are near each other, the lower one first. */
typedef struct pair {
    uint16_t a, b;
} pair;

typedef struct pair_list {
    pair *pairs;
    size_t count, capacity;
} pair_list;

static int compare_pairs(const void *left, const void *right) {
    const pair *p = left;
    const pair *q = right;
    return p->a != q->a ? (p->a < q->a ? -1 : 1) : (p->b > q->b) - (p->b < q->b);
}

/* Leaves each pair once. */
static void tidy(pair_list *list) {
    size_t kept = 0;
    if (list->count > 0) {
        qsort(list->pairs, list->count, sizeof *list->pairs, compare_pairs);
    }
    for (size_t i = 0; i < list->count; i++) {
        if (kept == 0 || compare_pairs(&list->pairs[kept - 1], &list->pairs[i]) != 0) {
            list->pairs[kept++] = list->pairs[i];
        }
    }
    list->count = kept;
}

static int add_pair(pair_list *list, uint16_t p, uint16_t q) {
    pair fresh = {p < q ? p : q, p < q ? q : p};
    if (list->count > 0 && compare_pairs(&list->pairs[list->count - 1], &fresh) == 0) {
        return 0;
    }
    if (list->count == list->capacity) {
        tidy(list);
    }
    if (list->count > list->capacity / 2 || list->capacity == 0) {
        size_t capacity = list->capacity > 0 ? 2 * list->capacity : 4096;
        pair *moved = realloc(list->pairs, capacity * sizeof *moved);
        if (moved == NULL) {
            return -1;
        }
        list->pairs = moved;
        list->capacity = capacity;
    }
    list->pairs[list->count++] = fresh;
    return 0;
}

typedef struct label_plane {
    const uint16_t *labels;
    uint32_t width, height, count;
} label_plane;

static uint16_t label_of(const label_plane *p, uint32_t x, uint32_t y) {
    uint16_t label = x < p->width && y < p->height ? p->labels[(size_t)y * p->width + x] : 0;
    return label <= p->count ? label : 0;
}

static int find_pairs(const label_plane *p, pair_list *list) {
    for (uint32_t y = 0; y < p->height; y++) {
        for (uint32_t x = 0; x < p->width; x++) {
            uint16_t here = label_of(p, x, y);
            for (uint32_t step = 1; here != 0 && step <= NEIGHBOUR_REACH; step++) {
                uint16_t right = label_of(p, x + step, y);
                uint16_t lower = label_of(p, x, y + step);
                if ((right != 0 && right != here && add_pair(list, here, right) != 0) ||
                    (lower != 0 && lower != here && add_pair(list, here, lower) != 0)) {
                    return -1;
                }
            }
        }
    }
    tidy(list);
    return 0;
}

/* Bounding boxes, as the records of rooms have them. */
static void find_boxes(const label_plane *p, roomseg_room *rooms) {
    for (uint32_t i = 0; i < p->count; i++) {
        rooms[i] = (roomseg_room){.label = (uint16_t)(i + 1), .min_x = UINT16_MAX,
                                  .min_y = UINT16_MAX};
    }
    for (uint32_t y = 0; y < p->height; y++) {
        for (uint32_t x = 0; x < p->width; x++) {
            uint16_t label = label_of(p, x, y);
            if (label == 0) {
                continue;
            }
            roomseg_room *room = &rooms[label - 1];
            room->min_x = (uint16_t)(x < room->min_x ? x : room->min_x);
            room->max_x = (uint16_t)(x > room->max_x ? x : room->max_x);
            room->min_y = (uint16_t)(y < room->min_y ? y : room->min_y);
            room->max_y = (uint16_t)(y > room->max_y ? y : room->max_y);
        }
    }
}

/* The pairs as doorways, each in the lists of both rooms. */
static void link_rooms(const pair_list *list, uint32_t count, roomseg_room *rooms,
                       roomseg_doorway *doorways, uint16_t *links) {
    uint32_t first = 0;
    for (size_t i = 0; i < list->count; i++) {
        doorways[i] = (roomseg_doorway){.room_a = list->pairs[i].a, .room_b = list->pairs[i].b};
        rooms[list->pairs[i].a - 1].link_count++;
        rooms[list->pairs[i].b - 1].link_count++;
    }
    for (uint32_t i = 0; i < count; i++) {
        rooms[i].link_first = first;
        first += rooms[i].link_count;
        rooms[i].link_count = 0;
    }
    for (size_t i = 0; i < list->count; i++) {
        roomseg_room *a = &rooms[list->pairs[i].a - 1];
        roomseg_room *b = &rooms[list->pairs[i].b - 1];
        links[a->link_first + a->link_count++] = (uint16_t)i;
        links[b->link_first + b->link_count++] = (uint16_t)i;
    }
}

int label_colors_choose(const uint16_t *labels, uint32_t width, uint32_t height, uint32_t count,
                        uint8_t *index) {
    label_plane plane = {labels, width, height, count};
    pair_list list = {NULL, 0, 0};
    roomseg_room *rooms = malloc(((size_t)count + 1) * sizeof *rooms);
    int rc = rooms != NULL ? find_pairs(&plane, &list) : -1;
    /* Links are 16 bits wide; beyond that some neighbours may look alike. */
    list.count = list.count > UINT16_MAX ? UINT16_MAX : list.count;
    roomseg_doorway *doorways = malloc((list.count + 1) * sizeof *doorways);
    uint16_t *links = malloc((2 * list.count + 1) * sizeof *links);
    if (rc == 0 && doorways != NULL && links != NULL) {
        find_boxes(&plane, rooms);
        link_rooms(&list, count, rooms, doorways, links);
        roomseg_result result = {.rooms = rooms, .doorways = doorways, .links = links,
                                 .room_count = count,
                                 .doorway_count = (uint32_t)list.count};
        rc = room_colors_choose(&result, index + 1);
    } else {
        rc = -1;
    }
    index[0] = 0;
    free(list.pairs);
    free(rooms);
    free(doorways);
    free(links);
    return rc;
}
