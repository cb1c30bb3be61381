/* How narrow regions are, against the eigenvalues of their second moments in floating point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shape.h"
#include "stage.h"
#include "unity.h"

enum { SIDE = 200 };

static rs_frame frame;
static rs_labels labels;
static rs_shape shapes[3];
static rs_ticker ticker;

void setUp(void)
{
    memset(&ticker, 0, sizeof ticker);
    frame = stage_frame(SIDE, SIDE);
    labels = stage_labels(&frame);
}

void tearDown(void)
{
    free(labels.cells);
}

static void new_frame(uint32_t width, uint32_t height)
{
    free(labels.cells);
    frame = stage_frame(width, height);
    labels = stage_labels(&frame);
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

static void measure(void)
{
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_shape_measure(&frame, &labels, 2, shapes, &ticker));
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
            measure();
            double wanted = width_of_label_1();
            TEST_ASSERT_DOUBLE_WITHIN(1.0, width, wanted);
            for (uint32_t limit = 1; limit < 60; limit++) {
                if (fabs(limit - wanted) > 1e-4) {
                    TEST_ASSERT_EQUAL_INT(limit > wanted,
                                          rs_shape_is_narrow(&shapes[1], 100, 100, limit));
                }
            }
        }
    }
}

static void test_sides_of_a_rectangle_are_exact(void)
{
    paint(20, 30, 90, 7, 1);
    paint(150, 30, 1, 1, 2);
    measure();
    TEST_ASSERT_TRUE(rs_shape_is_narrow(&shapes[1], 20, 30, 7));
    TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[1], 20, 30, 6));
    TEST_ASSERT_TRUE(rs_shape_is_narrow(&shapes[2], 150, 30, 1));
    TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[2], 150, 30, 0));
}

/* The cell around which moments are taken may lie elsewhere. */
static void test_the_reference_does_not_matter(void)
{
    paint_turned(100, 12, 33);
    measure();
    for (uint32_t x = 0; x < SIDE; x += 20) {
        TEST_ASSERT_TRUE(rs_shape_is_narrow(&shapes[1], x, SIDE - 1 - x, 13));
        TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[1], x, SIDE - 1 - x, 11));
    }
}

static void test_parts_make_up_the_whole(void)
{
    paint(20, 20, 60, 10, 1);
    paint(80, 22, 50, 11, 2);
    measure();
    rs_shape both = rs_shape_join(&shapes[1], &shapes[2]);
    paint(80, 22, 50, 11, 1);
    measure();
    TEST_ASSERT_EQUAL_MEMORY(&both, &shapes[1], sizeof both);
    TEST_ASSERT_EQUAL_UINT(60 * 10 + 50 * 11, both.cells);
    TEST_ASSERT_EQUAL_UINT(0, shapes[2].cells);
    TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[2], 0, 0, 2000));
}

static void test_at_the_far_end_of_a_wide_map(void)
{
    new_frame(65535, 40);
    paint(65135, 5, 400, 30, 1);
    measure();
    TEST_ASSERT_TRUE(rs_shape_is_narrow(&shapes[1], 65300, 20, 30));
    TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[1], 65300, 20, 29));
}

/* What no home has is never a hall: arithmetic ends there. */
static void test_beyond_all_halls(void)
{
    new_frame(65535, 17);
    paint(0, 0, 65535, 3, 1); /* too long */
    measure();
    TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[1], 100, 1, 50));
    paint(0, 0, 65535, 17, 1); /* 2^20 cells and more */
    measure();
    TEST_ASSERT_FALSE(rs_shape_is_narrow(&shapes[1], 32768, 8, 50));
    paint(0, 0, 65535, 17, 0);
    paint(0, 0, 2000, 17, 1);
    measure();
    TEST_ASSERT_TRUE(rs_shape_is_narrow(&shapes[1], 1000, 8, 50));
}

static void test_cancelled(void)
{
    uint32_t calls = 0;
    new_frame(600, 600);
    ticker = stage_canceller(&calls);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                          rs_shape_measure(&frame, &labels, 2, shapes, &ticker));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_strip_in_all_directions);
    RUN_TEST(test_sides_of_a_rectangle_are_exact);
    RUN_TEST(test_the_reference_does_not_matter);
    RUN_TEST(test_parts_make_up_the_whole);
    RUN_TEST(test_at_the_far_end_of_a_wide_map);
    RUN_TEST(test_beyond_all_halls);
    RUN_TEST(test_cancelled);
    return UNITY_END();
}
