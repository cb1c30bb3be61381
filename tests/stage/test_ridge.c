/* The ridge map, against Meijering's formula in floating point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ridge.h"
#include "stage.h"
#include "unity.h"

static sketch s;
static rs_frame frame;
static uint8_t *cells;
static double *exact;

void setUp(void)
{
    memset(&s, 0, sizeof s);
    cells = NULL;
    exact = NULL;
}

void tearDown(void)
{
    sketch_free(&s);
    free(cells);
    free(exact);
}

static void run_ridge(uint32_t sigma_mm)
{
    rs_ticker ticker = {0};
    rs_ridge_scratch scratch;
    frame = stage_frame(s.grid.width, s.grid.height);
    free(cells);
    cells = stage_mask(&frame, &s);
    scratch.roots = stage_scratch((size_t)frame.width * frame.height, sizeof *scratch.roots);
    scratch.rows =
        stage_scratch((size_t)ROOMSEG_RIDGE_ROWS * frame.stride, sizeof *scratch.rows);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_ridge_run(&frame, sigma_mm, s.grid.resolution_mm, cells,
                                                   &scratch, &ticker));
    free(scratch.roots);
    free(scratch.rows);
}

static uint8_t ridge_at(uint32_t x, uint32_t y)
{
    return cells[rs_frame_index(&frame, x, y)];
}

static double obstacle_at(int x, int y)
{
    bool inside = x >= 0 && y >= 0 && x < (int)s.grid.width && y < (int)s.grid.height;
    return !inside || s.memory[(size_t)y * s.grid.stride + (size_t)x] != 0;
}

/* Derivatives of a Gaussian; order 0 to 2. */
static double gauss(int order, int k, double sigma)
{
    double g = exp(-k * k / (2 * sigma * sigma)) / (sqrt(2 * acos(-1.0)) * sigma);
    if (order == 0) {
        return g;
    }
    return order == 1 ? -k / (sigma * sigma) * g
                      : (k * k / (sigma * sigma) - 1) / (sigma * sigma) * g;
}

static double derivative(int order_x, int order_y, int x, int y, double sigma)
{
    int reach = (int)ceil(5 * sigma);
    double sum = 0;
    for (int v = -reach; v <= reach; v++) {
        for (int u = -reach; u <= reach; u++) {
            sum += gauss(order_x, u, sigma) * gauss(order_y, v, sigma) * obstacle_at(x - u, y - v);
        }
    }
    return sum;
}

static double meijering(int x, int y, double sigma)
{
    double xx = derivative(2, 0, x, y, sigma), yy = derivative(0, 2, x, y, sigma);
    double xy = derivative(1, 1, x, y, sigma);
    double root = sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    double p = (xx + yy) / 2 + root, q = (xx + yy) / 2 - root;
    double a = p + q / 3, b = q + p / 3;
    double larger = fabs(a) >= fabs(b) ? a : b;
    return larger > 0 ? larger : 0;
}

/* Correlation, over the free cells, of the map with its square root taken back. *far_off:
 * share of cells that are off by more than 0.05. There are some at saddles, where the larger
 * of the two combinations changes its sign. */
static double correlation(double sigma, double *far_off)
{
    double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0, greatest = 0;
    exact = stage_scratch((size_t)frame.width * frame.height, sizeof *exact);
    for (uint32_t i = 0; i < frame.width * frame.height; i++) {
        bool free_cell = obstacle_at((int)(i % frame.width), (int)(i / frame.width)) == 0;
        exact[i] = free_cell ? meijering((int)(i % frame.width), (int)(i / frame.width), sigma) : 0;
        greatest = exact[i] > greatest ? exact[i] : greatest;
    }
    *far_off = 0;
    for (uint32_t i = 0; i < frame.width * frame.height; i++) {
        double code = ridge_at(i % frame.width, i / frame.width);
        if (code == RS_RIDGE_OBSTACLE) {
            continue;
        }
        double a = code * code / (RS_RIDGE_MAX * RS_RIDGE_MAX), b = exact[i] / greatest;
        *far_off += fabs(a - b) > 0.05;
        n++;
        sa += a;
        sb += b;
        saa += a * a;
        sbb += b * b;
        sab += a * b;
    }
    *far_off /= n;
    return (n * sab - sa * sb) / sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

static const char *const flat[] = {
    "################", "#......#.......#", "#......#.......#", "#..............#",
    "#......#....#..#", "#......#.......#", "##.#####.#######", "#..............#",
    "################", NULL,
};

static void test_against_floating_point(void)
{
    const uint32_t resolutions[] = {20, 40, 50, 80};
    for (size_t i = 0; i < sizeof resolutions / sizeof *resolutions; i++) {
        double far_off, cell = resolutions[i];
        tearDown();
        setUp();
        s = sketch_make(flat, 240 / resolutions[i] + 1, 0, resolutions[i]);
        run_ridge(80);
        double r = correlation(80 / cell, &far_off);
        TEST_ASSERT_TRUE(r > 0.999);
        /* At 80 mm sigma is one cell, and differences are coarse derivatives. */
        TEST_ASSERT_TRUE(far_off < (resolutions[i] < 80 ? 0.002 : 0.05));
    }
}

/* A line of 5 free cells between obstacles: highest along its middle, the same on both sides.
 * In a wide room: 0 in the middle. */
static void test_a_line(void)
{
    s = sketch_blank(101, 61, 255, 40);
    sketch_fill(&s, 0, 10, 101, 5, 0);
    sketch_fill(&s, 20, 24, 60, 36, 0);
    run_ridge(80);
    TEST_ASSERT_EQUAL_UINT8(RS_RIDGE_OBSTACLE, ridge_at(50, 9));
    TEST_ASSERT_GREATER_THAN_UINT8(240, ridge_at(50, 12));
    TEST_ASSERT_GREATER_THAN_UINT8(ridge_at(50, 11), ridge_at(50, 12));
    TEST_ASSERT_GREATER_THAN_UINT8(ridge_at(50, 10), ridge_at(50, 11));
    TEST_ASSERT_GREATER_THAN_UINT8(0, ridge_at(50, 10));
    for (uint32_t y = 10; y < 15; y++) {
        TEST_ASSERT_EQUAL_UINT8(ridge_at(50, y), ridge_at(50, 24 - y));
    }
    TEST_ASSERT_EQUAL_UINT8(0, ridge_at(50, 41));
}

static void test_the_greatest_value_is_reached(void)
{
    uint8_t greatest = 0;
    s = sketch_make(flat, 5, 0, 40);
    run_ridge(80);
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint8_t value = ridge_at(x, y);
            bool obstacle = obstacle_at((int)x, (int)y) != 0;
            TEST_ASSERT_EQUAL(obstacle, value == RS_RIDGE_OBSTACLE);
            greatest = !obstacle && value > greatest ? value : greatest;
        }
    }
    TEST_ASSERT_EQUAL_UINT8(RS_RIDGE_MAX, greatest);
}

static void test_the_map_turned(void)
{
    uint8_t *straight;
    s = sketch_make(flat, 4, 0, 40);
    run_ridge(80);
    straight = cells;
    cells = NULL;
    uint32_t width = frame.width, height = frame.height;
    sketch turned = sketch_blank(height, width, 255, 40);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            turned.memory[x * turned.grid.stride + height - 1 - y] =
                s.memory[(size_t)y * s.grid.stride + x];
        }
    }
    rs_frame first = frame;
    sketch_free(&s);
    s = turned;
    run_ridge(80);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            TEST_ASSERT_UINT8_WITHIN(1, straight[rs_frame_index(&first, x, y)],
                                     ridge_at(height - 1 - y, x));
        }
    }
    free(straight);
}

static void test_tiny_maps(void)
{
    for (uint32_t side = 1; side < 12; side++) {
        sketch_free(&s);
        s = sketch_blank(side, 12 - side, 0, 200);
        run_ridge(80);
        sketch_free(&s);
        s = sketch_blank(side, 12 - side, 255, 20);
        run_ridge(80);
        TEST_ASSERT_EQUAL_UINT8(RS_RIDGE_OBSTACLE, ridge_at(0, 0));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_against_floating_point);
    RUN_TEST(test_a_line);
    RUN_TEST(test_the_greatest_value_is_reached);
    RUN_TEST(test_the_map_turned);
    RUN_TEST(test_tiny_maps);
    return UNITY_END();
}
