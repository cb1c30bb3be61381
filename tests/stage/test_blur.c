/* The box blur: weights, variance, constants, and against plain sums in floating point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "blur.h"
#include "stage.h"
#include "unity.h"

#define ROWS (RS_BLUR_MAX_RADIUS + 3u)

static rs_blur blur;
static uint16_t *before;

void setUp(void)
{
    memset(&blur, 0, sizeof blur);
    before = NULL;
}

void tearDown(void)
{
    free(blur.cells);
    free(blur.scratch.sums);
    free(blur.scratch.prefix);
    free(blur.scratch.ring);
    free(before);
}

static void prepare(uint32_t width, uint32_t height, uint32_t ring_rows)
{
    tearDown();
    blur.width = width;
    blur.height = height;
    blur.cells = stage_scratch((size_t)width * height, sizeof *blur.cells);
    blur.scratch.sums = stage_scratch(width, sizeof *blur.scratch.sums);
    blur.scratch.prefix = stage_scratch(width + 2 * ring_rows, sizeof *blur.scratch.prefix);
    blur.scratch.ring = stage_scratch((size_t)ring_rows * width, sizeof *blur.scratch.ring);
    blur.scratch.ring_rows = ring_rows;
    before = stage_scratch((size_t)width * height, sizeof *before);
}

static void run_blur(void)
{
    memcpy(before, blur.cells, (size_t)blur.width * blur.height * sizeof *before);
    rs_blur_begin(&blur);
    for (uint32_t y = 0; y < blur.height; y++) {
        TEST_ASSERT_EQUAL_PTR(blur.cells + (size_t)y * blur.width, rs_blur_row(&blur, y));
    }
}

static double weight(const rs_box *box, int offset)
{
    int r = (int)box->radius, distance = abs(offset);
    return (distance <= r ? box->centre : (distance == r + 1 ? box->end : 0)) / 65536.0;
}

static void test_weights_add_up_and_have_the_variance(void)
{
    for (uint32_t variance = 0; variance < 1000u << 16; variance += variance / 50 + 77) {
        rs_box box = rs_box_of_variance(variance);
        double sum = 0, second = 0;
        int reach = (int)box.radius + 1;
        for (int k = -reach; k <= reach; k++) {
            sum += weight(&box, k);
            second += weight(&box, k) * k * k;
        }
        TEST_ASSERT_EQUAL_DOUBLE(1.0, sum);
        TEST_ASSERT_EQUAL_DOUBLE(second * 65536, rs_box_variance(&box));
        /* Weights are whole numbers, which shows in large boxes. */
        TEST_ASSERT_DOUBLE_WITHIN(0.006 * second + 0.001, variance / 65536.0, second);
        TEST_ASSERT_LESS_OR_EQUAL_UINT(box.centre + 2 * box.radius + 2, box.end);
    }
}

static void test_the_largest_box(void)
{
    rs_box box = rs_box_of_variance(UINT32_MAX);
    TEST_ASSERT_EQUAL_UINT(RS_BLUR_MAX_RADIUS, box.radius);
    TEST_ASSERT_EQUAL_UINT(65536, (2 * box.radius + 1) * box.centre + 2 * box.end);
}

/* A constant stays what it is where the box does not reach beyond the plane. */
static void test_constants_stay(void)
{
    const uint16_t values[] = {0, 1, 2, 255, 32767, 32768, 62259, 65534, 65535};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        for (uint32_t variance = 1u << 14; variance < 30u << 16; variance *= 3) {
            prepare(50, 40, ROWS);
            for (uint32_t k = 0; k < 50 * 40; k++) {
                blur.cells[k] = values[i];
            }
            blur.box = rs_box_of_variance(variance);
            uint32_t reach = blur.box.radius + 1;
            run_blur();
            for (uint32_t y = reach; y < 40 - reach; y++) {
                for (uint32_t x = reach; x < 50 - reach; x++) {
                    TEST_ASSERT_EQUAL_UINT16(values[i], blur.cells[y * 50 + x]);
                }
            }
        }
    }
}

static double value_before(int x, int y)
{
    if (x < 0 || y < 0 || x >= (int)blur.width || y >= (int)blur.height) {
        return 0;
    }
    return before[(size_t)y * blur.width + (size_t)x];
}

/* Along the row and rounded, then down the columns. */
static void expect_plain_sums(void)
{
    int reach = (int)blur.box.radius + 1;
    for (int y = 0; y < (int)blur.height; y++) {
        for (int x = 0; x < (int)blur.width; x++) {
            double sum = 0;
            for (int v = -reach; v <= reach; v++) {
                double along = 0;
                for (int u = -reach; u <= reach; u++) {
                    along += weight(&blur.box, u) * value_before(x + u, y + v);
                }
                sum += weight(&blur.box, v) * floor(along + 0.5);
            }
            TEST_ASSERT_EQUAL_UINT16(floor(sum + 0.5),
                                     blur.cells[(size_t)y * blur.width + (size_t)x]);
        }
    }
}

static void test_against_plain_sums(void)
{
    uint32_t seed = 7;
    for (uint32_t width = 1; width <= 30; width += 4) {
        for (uint32_t height = 1; height <= 25; height += 6) {
            blur.box = rs_box_of_variance((width * height % 23) << 15);
            rs_box box = blur.box;
            prepare(width, height, box.radius + 3);
            blur.box = box;
            for (uint32_t k = 0; k < width * height; k++) {
                seed = seed * 1664525 + 1013904223;
                blur.cells[k] = (uint16_t)(seed >> 31 != 0 ? 65535 : seed >> 15);
            }
            run_blur();
            expect_plain_sums();
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_weights_add_up_and_have_the_variance);
    RUN_TEST(test_the_largest_box);
    RUN_TEST(test_constants_stay);
    RUN_TEST(test_against_plain_sums);
    return UNITY_END();
}
