/* How narrow regions are, against the eigenvalues of their second moments in floating point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cluster.h"
#include "shape.h"
#include "stage.h"
#include "unity.h"

enum { SIDE = 200, OCCUPIED = 204 };

static rs_frame frame;
static rs_labels labels;
static uint8_t *cells; /* of the grid: all free until a test says otherwise */
static rs_region regions[3];
static rs_shape shapes[3];
static rs_graph graph;
static rs_ticker ticker;

static void new_frame(uint32_t width, uint32_t height)
{
    frame = stage_frame(width, height);
    free(labels.cells);
    labels = stage_labels(&frame);
    free(cells);
    cells = calloc((size_t)width * height, 1);
    TEST_ASSERT_NOT_NULL(cells);
}

void setUp(void)
{
    memset(&ticker, 0, sizeof ticker);
    memset(regions, 0, sizeof regions);
    graph = (rs_graph){regions, NULL, shapes, 2, 0, 0};
    new_frame(SIDE, SIDE);
}

void tearDown(void)
{
    free(labels.cells);
    free(cells);
    labels.cells = NULL;
    cells = NULL;
}

static void paint(uint32_t x, uint32_t y, uint32_t width, uint32_t height, uint16_t label)
{
    for (uint32_t row = y; row < y + height; row++) {
        for (uint32_t column = x; column < x + width; column++) {
            labels.cells[row * labels.stride + column] = label;
        }
    }
}

/* A rectangle around the middle of the frame, its long side at some degrees. */
static void paint_turned(double length, double width, double degrees)
{
    double c = cos(degrees * 3.14159265358979 / 180.0), d = sin(degrees * 3.14159265358979 / 180.0);
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            double u = x - frame.width / 2.0, v = y - frame.height / 2.0;
            bool in = fabs(c * u + d * v) <= length / 2.0 && fabs(c * v - d * u) <= width / 2.0;
            labels.cells[y * labels.stride + x] = in ? 1 : 0;
        }
    }
}

/* Measures both labels, with the place of their peak and their area as the graph has them. */
static void measure(uint32_t peak_x, uint32_t peak_y)
{
    const roomseg_grid grid = {cells, frame.width, frame.height, frame.width, 50};
    for (uint16_t label = 1; label <= 2; label++) {
        regions[label] = (rs_region){.parent = label,
                                     .peak = label,
                                     .peak_x = (uint16_t)peak_x,
                                     .peak_y = (uint16_t)peak_y,
                                     .first_half = RS_NO_HALF};
    }
    for (size_t i = 0; i < (size_t)frame.width * frame.height; i++) {
        regions[labels.cells[i]].area += cells[i] < OCCUPIED;
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_shape_measure(&frame, &grid, OCCUPIED, &labels, &graph, &ticker));
}

static bool is_narrow(uint16_t label, uint32_t width)
{
    return rs_shape_are_narrow(&graph, label, label, width);
}

/* Width of the rectangle with the same second moments, from the cells one by one. */
static double width_of_label_1(void)
{
    double n = 0, mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            if (labels.cells[y * labels.stride + x] == 1) {
                n += 1;
                mx += x;
                my += y;
                xx += (double)x * x;
                xy += (double)x * y;
                yy += (double)y * y;
            }
        }
    }
    mx /= n;
    my /= n;
    xx = xx / n - mx * mx + 1 / 12.0;
    yy = yy / n - my * my + 1 / 12.0;
    xy = xy / n - mx * my;
    return sqrt(12 * ((xx + yy) / 2 - hypot((xx - yy) / 2, xy)));
}

static void test_a_strip_in_all_directions(void)
{
    for (int degrees = 0; degrees < 180; degrees += 5) {
        for (double width = 6; width < 40; width += 5.5) {
            paint_turned(130, width, degrees);
            measure(100, 100);
            double wanted = width_of_label_1();
            TEST_ASSERT_DOUBLE_WITHIN(1.0, width, wanted);
            for (uint32_t limit = 1; limit < 60; limit++) {
                if (fabs(limit - wanted) > 1e-4) {
                    TEST_ASSERT_EQUAL_INT(limit > wanted, is_narrow(1, limit));
                }
            }
        }
    }
}

static void test_sides_of_a_rectangle_are_exact(void)
{
    paint(0, 0, 90, 7, 1);
    paint(SIDE - 1, SIDE - 1, 1, 1, 2);
    measure(20, 30);
    TEST_ASSERT_TRUE(is_narrow(1, 7));
    TEST_ASSERT_FALSE(is_narrow(1, 6));
    TEST_ASSERT_TRUE(is_narrow(2, 1));
    TEST_ASSERT_FALSE(is_narrow(2, 0));
}

static void test_the_place_of_the_peak_does_not_matter(void)
{
    paint_turned(100, 12, 33);
    for (uint32_t x = 0; x < SIDE; x += 20) {
        measure(x, SIDE - 1 - x);
        TEST_ASSERT_TRUE(is_narrow(1, 13));
        TEST_ASSERT_FALSE(is_narrow(1, 11));
    }
}

/* What stands on the floor for certain is no part of a region's area. */
static void test_certain_obstacles_do_not_count(void)
{
    paint(20, 20, 100, 30, 1);
    for (uint32_t y = 30; y < 50; y++) {
        memset(cells + y * frame.width + 20, OCCUPIED, 100);
    }
    measure(40, 25);
    TEST_ASSERT_TRUE(is_narrow(1, 10));
    TEST_ASSERT_FALSE(is_narrow(1, 9));
}

/* Together, and united, they are what they would be as one. */
static void test_parts_make_up_the_whole(void)
{
    for (uint32_t turn = 0; turn < 2; turn++) {
        uint16_t longer = turn == 0 ? 1 : 2, shorter = turn == 0 ? 2 : 1;
        paint(20, 20, 60, 10, longer);
        paint(80, 26, 50, 11, shorter);
        measure(70, 25);
        bool as_two[20];
        for (uint32_t width = 0; width < 20; width++) {
            as_two[width] = rs_shape_are_narrow(&graph, 1, 2, width);
        }
        TEST_ASSERT_TRUE(is_narrow(longer, 10) && as_two[19] && !as_two[10]);
        TEST_ASSERT_EQUAL_UINT(longer, rs_cluster_unite(&graph, 1, 2));
        rs_shape united = shapes[longer];
        paint(80, 26, 50, 11, longer);
        measure(70, 25);
        TEST_ASSERT_EQUAL_MEMORY(&shapes[longer], &united, sizeof united);
        for (uint32_t width = 0; width < 20; width++) {
            TEST_ASSERT_EQUAL_INT(as_two[width], is_narrow(longer, width));
        }
    }
}

static void test_the_sums_move_to_the_new_peak(void)
{
    paint(20, 20, 60, 10, 1);
    paint(80, 26, 50, 11, 2);
    measure(70, 25);
    rs_shape_unite(&graph, 1, 2, 90, 30);
    rs_shape united = shapes[1];
    paint(80, 26, 50, 11, 1);
    measure(90, 30);
    TEST_ASSERT_EQUAL_MEMORY(&shapes[1], &united, sizeof united);
}

static void test_at_the_far_end_of_a_wide_map(void)
{
    new_frame(65535, 40);
    paint(65135, 5, 400, 30, 1);
    measure(65300, 20);
    TEST_ASSERT_TRUE(is_narrow(1, 30));
    TEST_ASSERT_FALSE(is_narrow(1, 29));
}

/* What no home has is never a hall: arithmetic ends there. */
static void test_beyond_all_halls(void)
{
    new_frame(65535, 17);
    paint(0, 0, 65535, 3, 1); /* too long */
    measure(100, 1);
    TEST_ASSERT_FALSE(is_narrow(1, 50));
    paint(0, 0, 65535, 17, 1); /* 2^20 cells and more */
    measure(32768, 8);
    TEST_ASSERT_FALSE(is_narrow(1, 50));
    paint(0, 0, 65535, 17, 0);
    paint(0, 0, 2000, 17, 1);
    paint(2000, 0, 8000, 17, 2);
    measure(2000, 8);
    TEST_ASSERT_TRUE(is_narrow(1, 50));
    TEST_ASSERT_FALSE(rs_shape_are_narrow(&graph, 1, 2, 50)); /* too much together */
    TEST_ASSERT_EQUAL_UINT(2, rs_cluster_unite(&graph, 1, 2));
    TEST_ASSERT_FALSE(is_narrow(2, 50)); /* and for good */
}

static void test_cancelled(void)
{
    uint32_t calls = 0;
    new_frame(600, 600);
    const roomseg_grid grid = {cells, 600, 600, 600, 50};
    ticker = stage_canceller(&calls);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                          rs_shape_measure(&frame, &grid, OCCUPIED, &labels, &graph, &ticker));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_strip_in_all_directions);
    RUN_TEST(test_sides_of_a_rectangle_are_exact);
    RUN_TEST(test_the_place_of_the_peak_does_not_matter);
    RUN_TEST(test_certain_obstacles_do_not_count);
    RUN_TEST(test_parts_make_up_the_whole);
    RUN_TEST(test_the_sums_move_to_the_new_peak);
    RUN_TEST(test_at_the_far_end_of_a_wide_map);
    RUN_TEST(test_beyond_all_halls);
    RUN_TEST(test_cancelled);
    return UNITY_END();
}
