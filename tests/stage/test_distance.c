/* The distance map against a search over all obstacles. */
#include <stdlib.h>

#include "distance.h"
#include "random.h"
#include "stage.h"
#include "unity.h"

static rs_frame frame;
static uint8_t *surface;
static uint8_t *before;
static uint32_t state;

void setUp(void)
{
    surface = NULL;
    before = NULL;
    state = 11;
}

void tearDown(void)
{
    free(surface);
    free(before);
}

static uint32_t next_random(uint32_t range)
{
    return random_next(&state) % range;
}

static void prepare(uint32_t width, uint32_t height)
{
    free(surface);
    free(before);
    frame = stage_frame(width, height);
    surface = stage_buffer(&frame);
    before = stage_buffer(&frame);
}

static int run(uint32_t resolution_mm, rs_ticker *ticker)
{
    rs_distance_scratch scratch = {stage_scratch(frame.stride, sizeof *scratch.envelope),
                                   stage_scratch(RS_DISTANCE_MAX + 1u, sizeof *scratch.least)};
    memcpy(before, surface, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
    int status = rs_distance_run(&frame, resolution_mm, surface, &scratch, ticker);
    free(scratch.envelope);
    free(scratch.least);
    return status;
}

/* Squared distance to the nearest obstacle, the border included [cells^2]. */
static uint32_t nearest(uint32_t x, uint32_t y)
{
    uint32_t best = UINT32_MAX;
    for (uint32_t oy = 0; oy < frame.height + 2u; oy++) {
        for (uint32_t ox = 0; ox < frame.stride; ox++) {
            uint32_t dx = ox > x + 1u ? ox - x - 1u : x + 1u - ox;
            uint32_t dy = oy > y + 1u ? oy - y - 1u : y + 1u - oy;
            if (before[oy * frame.stride + ox] == 0 && dx * dx + dy * dy < best) {
                best = dx * dx + dy * dy;
            }
        }
    }
    return best;
}

static void check(uint32_t resolution_mm)
{
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint32_t i = rs_frame_index(&frame, x, y), level = 0;
            if (before[i] != 0) {
                uint32_t mm2 = nearest(x, y) * resolution_mm * resolution_mm;
                level = 1;
                while (level < RS_DISTANCE_MAX && (level + 1u) * (level + 1u) *
                                                          RS_DISTANCE_UNIT_MM *
                                                          RS_DISTANCE_UNIT_MM <= mm2) {
                    level++;
                }
            }
            TEST_ASSERT_EQUAL_UINT8(level, surface[i]);
        }
    }
}

/* From a few specks in the open to hardly a free cell. */
static void test_random_maps(void)
{
    const uint32_t resolutions[] = {20, 40, 50, 133, 200};
    for (uint32_t i = 0; i < 300; i++) {
        rs_ticker ticker = {0};
        uint32_t share = 1 + next_random(i % 3 == 0 ? 8 : 300);
        prepare(1 + next_random(40), 1 + next_random(40));
        for (uint32_t y = 0; y < frame.height; y++) {
            for (uint32_t x = 0; x < frame.width; x++) {
                surface[rs_frame_index(&frame, x, y)] = next_random(share) != 0 || share == 1;
            }
        }
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(resolutions[i % 5], &ticker));
        check(resolutions[i % 5]);
    }
}

/* Rectangles: long runs of equal vertical distance, whose parabolas cross within the runs. */
static void test_straight_walls(void)
{
    for (uint32_t i = 0; i < 60; i++) {
        rs_ticker ticker = {0};
        prepare(60 + next_random(20), 30 + next_random(30));
        for (uint32_t y = 0; y < frame.height; y++) {
            memset(surface + rs_frame_index(&frame, 0, y), 1, frame.width);
        }
        for (uint32_t k = next_random(6); k > 0; k--) {
            uint32_t x = next_random(frame.width), y = next_random(frame.height);
            uint32_t end = x + next_random(frame.width - x), low = y + next_random(6);
            for (; y <= low && y < frame.height; y++) {
                memset(surface + rs_frame_index(&frame, x, y), 0, end - x + 1u);
            }
        }
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(40, &ticker));
        check(40);
    }
}

/* 255 cells and 255 units are the ends of the scale. */
static void test_far_from_everything(void)
{
    rs_ticker ticker = {0};
    prepare(700, 620);
    for (uint32_t y = 0; y < frame.height; y++) {
        memset(surface + rs_frame_index(&frame, 0, y), 1, frame.width);
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(50, &ticker));
    TEST_ASSERT_EQUAL_UINT8(RS_DISTANCE_MAX, surface[rs_frame_index(&frame, 350, 310)]);
    TEST_ASSERT_EQUAL_UINT8(1, surface[rs_frame_index(&frame, 0, 310)]);
    TEST_ASSERT_EQUAL_UINT8(250, surface[rs_frame_index(&frame, 199, 310)]);
    TEST_ASSERT_EQUAL_UINT8(250, surface[rs_frame_index(&frame, 350, 199)]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_random_maps);
    RUN_TEST(test_straight_walls);
    RUN_TEST(test_far_from_everything);
    return UNITY_END();
}
