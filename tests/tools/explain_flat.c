#include "explain_flat.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scratch.h"
#include "unity.h"

enum { WIDTH = EXPLAIN_FLAT_WIDTH, HEIGHT = EXPLAIN_FLAT_HEIGHT };
enum { FREE = 0, UNKNOWN = 127, WALL = 255 };

static void fill(uint8_t *cells, int x0, int y0, int x1, int y1, uint8_t value) {
    for (int y = y0; y < y1; y++) {
        memset(cells + y * WIDTH + x0, value, (size_t)(x1 - x0));
    }
}

static void draw_flat(uint8_t *cells) {
    memset(cells, UNKNOWN, WIDTH * HEIGHT);
    fill(cells, 18, 18, 182, 122, WALL);
    fill(cells, 20, 20, 98, 88, FREE);
    fill(cells, 101, 20, 180, 88, FREE);
    fill(cells, 20, 91, 180, 120, FREE);
    fill(cells, 50, 88, 66, 91, FREE);
    fill(cells, 130, 88, 146, 91, FREE);
    fill(cells, 40, 40, 43, 43, WALL);
    fill(cells, 140, 50, 150, 60, UNKNOWN);
    fill(cells, 195, 60, 199, 64, FREE);
}

map explain_flat(void) {
    map m = {malloc(WIDTH * HEIGHT), WIDTH, HEIGHT, 0.05, 0, 0, 0};
    TEST_ASSERT_NOT_NULL(m.cells);
    draw_flat(m.cells);
    return m;
}

map explain_flat_turned(double degrees) {
    enum { SIDE = 280 };
    static uint8_t flat[WIDTH * HEIGHT];
    map m = {malloc(SIDE * SIDE), SIDE, SIDE, 0.05, 0, 0, 0};
    double c = cos(degrees * 3.14159265 / 180), s = sin(degrees * 3.14159265 / 180);
    TEST_ASSERT_NOT_NULL(m.cells);
    draw_flat(flat);
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            int dx = x - SIDE / 2, dy = y - SIDE / 2;
            int from_x = (int)lround(c * dx + s * dy) + WIDTH / 2;
            int from_y = (int)lround(c * dy - s * dx) + HEIGHT / 2;
            int inside = from_x >= 0 && from_x < WIDTH && from_y >= 0 && from_y < HEIGHT;
            m.cells[y * SIDE + x] = inside ? flat[from_y * WIDTH + from_x] : UNKNOWN;
        }
    }
    return m;
}

void explain_flat_truth(map *m) {
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        m->cells[i] = m->cells[i] == FREE ? 255 : 0;
    }
    fill(m->cells, 18, 88, 182, 91, 0);
    fill(m->cells, 195, 60, 199, 64, 0);
}

const char *explain_flat_write(const char *name, const map *m) {
    static char text[280 * 280 + 40];
    int head = snprintf(text, sizeof text, "P5\n%u %u\n255\n", (unsigned)m->width,
                        (unsigned)m->height);
    memcpy(text + head, m->cells, (size_t)m->width * m->height);
    return scratch_write(name, text, (size_t)head + (size_t)m->width * m->height);
}
