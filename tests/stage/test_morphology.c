/* Obstacles grown and shrunk by a square, against counting cells one by one. */
#include <stdlib.h>
#include <string.h>

#include "morphology.h"
#include "stage.h"
#include "unity.h"

static rs_frame frame;
static uint8_t *cells, *before, *columns;

void setUp(void)
{
    cells = NULL;
    before = NULL;
    columns = NULL;
}

void tearDown(void)
{
    free(cells);
    free(before);
    free(columns);
}

static void prepare(uint32_t width, uint32_t height)
{
    tearDown();
    frame = stage_frame(width, height);
    cells = stage_buffer(&frame);
    before = stage_buffer(&frame);
    columns = stage_scratch(frame.stride, 1);
}

static void keep(void)
{
    memcpy(before, cells, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
}

/* Whether a cell of this value lies within the square around (x, y); all cells outside of the
 * crop are obstacles. */
static bool is_near(uint8_t value, uint32_t radius, uint32_t x, uint32_t y)
{
    for (uint32_t ny = y - radius; ny != y + radius + 1; ny++) {
        for (uint32_t nx = x - radius; nx != x + radius + 1; nx++) {
            bool outside = nx >= frame.width || ny >= frame.height;
            if ((outside ? 0 : before[rs_frame_index(&frame, nx, ny)]) == value) {
                return true;
            }
        }
    }
    return false;
}

static void expect(bool grown, uint32_t radius)
{
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint8_t wanted = grown ? !is_near(0, radius, x, y) : is_near(1, radius, x, y);
            TEST_ASSERT_EQUAL_UINT8(wanted, cells[rs_frame_index(&frame, x, y)]);
        }
    }
    for (uint32_t x = 0; x < frame.stride; x++) {
        TEST_ASSERT_EQUAL_UINT8(0, cells[x]);
        TEST_ASSERT_EQUAL_UINT8(0, cells[(size_t)(frame.height + 1) * frame.stride + x]);
    }
}

static void check(uint32_t radius)
{
    rs_ticker ticker = {0};
    keep();
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_morphology_grow_obstacles(&frame, radius, cells,
                                                                   columns, &ticker));
    expect(true, radius);
    memcpy(cells, before, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_morphology_shrink_obstacles(&frame, radius, cells,
                                                                     columns, &ticker));
    expect(false, radius);
}

static void test_one_obstacle_and_one_free_cell(void)
{
    for (uint32_t radius = 0; radius <= 4; radius++) {
        for (uint8_t value = 0; value <= 1; value++) {
            prepare(15, 13);
            for (uint32_t y = 0; y < frame.height; y++) {
                memset(cells + rs_frame_index(&frame, 0, y), !value, frame.width);
            }
            cells[rs_frame_index(&frame, 7, 6)] = value;
            check(radius);
        }
    }
}

static void test_random_maps_of_many_sizes(void)
{
    uint32_t seed = 1;
    for (uint32_t width = 1; width <= 40; width += 3) {
        for (uint32_t height = 1; height <= 30; height += 4) {
            prepare(width, height);
            for (uint32_t y = 0; y < height; y++) {
                for (uint32_t x = 0; x < width; x++) {
                    seed = seed * 1664525 + 1013904223;
                    cells[rs_frame_index(&frame, x, y)] = (seed >> 16) % 13 < 12;
                }
            }
            check(seed >> 20 & 3);
        }
    }
}

static void test_growing_three_times_by_one_is_growing_by_three(void)
{
    rs_ticker ticker = {0};
    prepare(40, 30);
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            cells[rs_frame_index(&frame, x, y)] = (x * 7 + y * 11) % 97 != 0;
        }
    }
    keep();
    rs_morphology_grow_obstacles(&frame, 3, before, columns, &ticker);
    for (int i = 0; i < 3; i++) {
        rs_morphology_grow_obstacles(&frame, 1, cells, columns, &ticker);
    }
    TEST_ASSERT_EQUAL_MEMORY(before, cells, ROOMSEG_PLAN_CELLS(40, 30));
}

static void test_cancelling(void)
{
    prepare(300, 300);
    for (uint32_t calls = 0; calls < 3; calls++) {
        uint32_t left = calls;
        rs_ticker ticker = stage_canceller(&left);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                              rs_morphology_grow_obstacles(&frame, 3, cells, columns, &ticker));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_obstacle_and_one_free_cell);
    RUN_TEST(test_random_maps_of_many_sizes);
    RUN_TEST(test_growing_three_times_by_one_is_growing_by_three);
    RUN_TEST(test_cancelling);
    return UNITY_END();
}
