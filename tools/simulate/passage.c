#include "passage.h"

#include <string.h>

enum {
    REACH = 3,            /* clearance: 3.8 cells = 19 cm between cell centres */
    REACH2_TIMES_4 = 58,  /* (2 * 3.8)^2 */
    SHARE_PERCENT = 70,   /* of the standing room that has to be in reach */
    CAN_STAND = 1,
    REACHED = 2
};

void passage_block_around(uint8_t *mask, int columns, int rows, int x, int y) {
    for (int dy = -REACH; dy <= REACH; dy++) {
        for (int dx = -REACH; dx <= REACH; dx++) {
            int inside = x + dx >= 0 && y + dy >= 0 && x + dx < columns && y + dy < rows;
            if (inside && 4 * (dx * dx + dy * dy) <= REACH2_TIMES_4) {
                mask[(y + dy) * columns + x + dx] = 0;
            }
        }
    }
}

/* Marks where the robot can stand; returns the number of cells. */
static int32_t find_standing_room(const passage_grid *g, box area) {
    int32_t count = 0;
    for (int y = area.y0; y < area.y1; y++) {
        memset(g->mask + y * g->columns + area.x0, CAN_STAND, (size_t)(area.x1 - area.x0));
    }
    for (int y = area.y0; y < area.y1; y++) {
        for (int x = area.x0; x < area.x1; x++) {
            if ((g->flags[y * g->columns + x] & g->taken) != 0) {
                passage_block_around(g->mask, g->columns, g->rows, x, y);
            }
        }
    }
    for (int y = area.y0; y < area.y1; y++) {
        for (int x = area.x0; x < area.x1; x++) {
            count += g->mask[y * g->columns + x] == CAN_STAND;
        }
    }
    return count;
}

/* A cell of the box that has the mark, or -1. */
static int32_t find_mark(const passage_grid *g, box b, uint8_t mark) {
    for (int y = b.y0; y < b.y1; y++) {
        for (int x = b.x0; x < b.x1; x++) {
            if (g->mask[y * g->columns + x] == mark) {
                return y * g->columns + x;
            }
        }
    }
    return -1;
}

/* Floods from a cell; returns the number of cells reached. */
static int32_t flood(const passage_grid *g, box area, int32_t start) {
    static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    int32_t head = 0;
    int32_t tail = 0;
    g->queue[tail++] = start;
    g->mask[start] = REACHED;
    while (head < tail) {
        int32_t cell = g->queue[head++];
        for (int i = 0; i < 4; i++) {
            int x = cell % g->columns + steps[i][0];
            int y = cell / g->columns + steps[i][1];
            int inside = x >= area.x0 && y >= area.y0 && x < area.x1 && y < area.y1;
            if (inside && g->mask[y * g->columns + x] == CAN_STAND) {
                g->mask[y * g->columns + x] = REACHED;
                g->queue[tail++] = y * g->columns + x;
            }
        }
    }
    return tail;
}

int passage_is_open(const passage_grid *g, box area, const box *gates, int gate_count) {
    int32_t standing = find_standing_room(g, area);
    int32_t start = gate_count > 0 ? find_mark(g, gates[0], CAN_STAND) : -1;
    if (start < 0 || flood(g, area, start) * 100 < standing * SHARE_PERCENT) {
        return 0;
    }
    for (int i = 1; i < gate_count; i++) {
        if (find_mark(g, gates[i], REACHED) < 0) {
            return 0;
        }
    }
    return 1;
}
