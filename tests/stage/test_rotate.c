/* Turning a grid, turning labels back, and making them whole. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rotate.h"
#include "spread.h"
#include "stage.h"
#include "unity.h"

static sketch s;
static rs_frame crop;
static rs_ticker ticker;

void setUp(void)
{
    memset(&s, 0, sizeof s);
    memset(&ticker, 0, sizeof ticker);
}

void tearDown(void)
{
    sketch_free(&s);
}

static rs_rotation rotation_of(int32_t angle)
{
    rs_rotation rotation;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_rotate_init(&crop, &s.grid, 51, angle, &rotation, &ticker));
    return rotation;
}

/* Obstacles from whole_min on count whole. */
static uint8_t *turn_halving(const rs_rotation *rotation, uint8_t whole_min)
{
    const rs_mixture mixture = {51, whole_min, 127};
    uint8_t *cells = stage_scratch((size_t)rotation->width * rotation->height, 1);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_rotate_grid(rotation, &s.grid, mixture, cells,
                                                     rotation->width, &ticker));
    return cells;
}

static uint8_t *turn(const rs_rotation *rotation)
{
    return turn_halving(rotation, 0);
}

static void test_no_angle_changes_nothing(void)
{
    s = sketch_rooms(2, 1, 20, 6, 50);
    crop = stage_frame(s.grid.width - 2, s.grid.height - 2);
    crop.x = 1;
    crop.y = 1;
    rs_rotation rotation = rotation_of(0);
    TEST_ASSERT_EQUAL_UINT(crop.width, rotation.width);
    TEST_ASSERT_EQUAL_UINT(crop.height, rotation.height);
    uint8_t *cells = turn(&rotation);
    for (uint32_t y = 0; y < crop.height; y++) {
        TEST_ASSERT_EQUAL_MEMORY(s.memory + (size_t)(y + 1) * s.grid.stride + 1,
                                 cells + (size_t)y * rotation.width, crop.width);
    }
    free(cells);
}

/* The frame holds all cells of at most free_max, here the ends of a strip, and no other ones. */
static void test_the_frame_ends_with_the_free_cells(void)
{
    s = sketch_blank(20, 6, 52, 50);
    sketch_fill(&s, 3, 2, 10, 1, 51);
    sketch_fill(&s, 4, 2, 8, 1, 0);
    crop = stage_frame(20, 6);
    rs_rotation rotation = rotation_of(0);
    TEST_ASSERT_EQUAL_UINT(10, rotation.width);
    TEST_ASSERT_EQUAL_UINT(1, rotation.height);
}

/* A room turned by an angle and turned back by the stage is upright again. */
static void test_a_turned_room_stands_upright(void)
{
    for (int degrees = -45; degrees <= 44; degrees++) {
        sketch straight = sketch_blank(120, 80, 255, 50);
        sketch_fill(&straight, 10, 10, 100, 60, 0);
        s = sketch_turned(&straight, degrees);
        crop = stage_frame(s.grid.width, s.grid.height);
        rs_rotation rotation = rotation_of(degrees * 100);
        TEST_ASSERT_UINT_WITHIN(2, 100, rotation.width);
        TEST_ASSERT_UINT_WITHIN(2, 60, rotation.height);
        uint8_t *cells = turn(&rotation);
        uint32_t free_cells = 0;
        for (size_t i = 0; i < (size_t)rotation.width * rotation.height; i++) {
            free_cells += cells[i] == 0;
        }
        /* Walls grow by up to 0.3 cells each side: at most 2 * 0.3 * 160 cells, and jags. */
        TEST_ASSERT_TRUE(free_cells <= 6050 && free_cells >= 5750);
        free(cells);
        sketch_free(&s);
        sketch_free(&straight);
    }
}

/* The unknown around a room takes less of it when it counts half: 0.1 cells a side. */
static void test_the_unknown_counts_half(void)
{
    s = sketch_blank(120, 80, 127, 50);
    sketch_fill(&s, 10, 10, 100, 60, 0);
    crop = stage_frame(120, 80);
    for (int32_t angle = -3700; angle < 4500; angle += 900) {
        rs_rotation rotation = rotation_of(angle);
        size_t cells = (size_t)rotation.width * rotation.height;
        uint8_t *whole = turn(&rotation), *half = turn_halving(&rotation, 204);
        long free_whole = 0, free_half = 0;
        for (size_t i = 0; i < cells; i++) {
            TEST_ASSERT_TRUE(whole[i] != 0 || half[i] == 0);
            free_whole += whole[i] == 0;
            free_half += half[i] == 0;
        }
        TEST_ASSERT_INT_WITHIN(40, 6000 - 96, free_whole);
        TEST_ASSERT_INT_WITHIN(40, 6000 - 32, free_half);
        free(whole);
        free(half);
    }
}

/* A wall one cell thick stays closed for 4-connected steps, whatever the angle. */
static bool leaks(const uint8_t *cells, uint32_t width, uint32_t height)
{
    uint8_t *seen = calloc((size_t)width * height, 1);
    uint32_t *list = malloc((size_t)width * height * sizeof *list);
    TEST_ASSERT_TRUE(seen != NULL && list != NULL);
    uint32_t count = 0;
    size_t free_cells = 0;
    for (uint32_t i = 0; i < width * height; i++) {
        free_cells += cells[i] == 0;
        if (cells[i] == 0 && count == 0) {
            seen[i] = 1;
            list[count++] = i;
        }
    }
    for (uint32_t head = 0; head < count; head++) {
        uint32_t x = list[head] % width, y = list[head] / width;
        const uint32_t next[4] = {x > 0 ? list[head] - 1 : list[head],
                                  x + 1 < width ? list[head] + 1 : list[head],
                                  y > 0 ? list[head] - width : list[head],
                                  y + 1 < height ? list[head] + width : list[head]};
        for (int k = 0; k < 4; k++) {
            if (cells[next[k]] == 0 && !seen[next[k]]) {
                seen[next[k]] = 1;
                list[count++] = next[k];
            }
        }
    }
    free(seen);
    free(list);
    return count > free_cells * 6 / 10; /* one side holds half of them */
}

static void test_thin_walls_stay_closed(void)
{
    for (int wall = 0; wall < 90; wall += 9) {
        sketch straight = sketch_blank(101, 100, 0, 50);
        sketch_fill(&straight, 0, 0, 101, 10, 255);
        sketch_fill(&straight, 0, 90, 101, 10, 255);
        sketch_fill(&straight, 0, 0, 10, 100, 255);
        sketch_fill(&straight, 91, 0, 10, 100, 255);
        sketch_fill(&straight, 50, 0, 1, 100, 255);
        s = sketch_turned(&straight, wall);
        crop = stage_frame(s.grid.width, s.grid.height);
        for (int32_t angle = -4500; angle < 4500; angle += 370) {
            rs_rotation rotation = rotation_of(angle);
            uint8_t *cells = turn(&rotation);
            TEST_ASSERT_FALSE(leaks(cells, rotation.width, rotation.height));
            free(cells);
        }
        sketch_free(&s);
        sketch_free(&straight);
    }
}

/* Whatever the size and the angle, the turned frame fits into its plan. */
static void test_the_plan_holds_every_turned_frame(void)
{
    for (uint32_t width = 1; width <= 300; width = width * 5 / 3 + 1) {
        for (uint32_t height = 1; height <= 300; height = height * 3 / 2 + 1) {
            s = sketch_blank(width, height, 0, 50);
            crop = stage_frame(width, height);
            for (int32_t angle = -4500; angle < 4500; angle += 111) {
                rs_rotation r = rotation_of(angle);
                size_t wide = ROOMSEG_PLAN_TURNED_WIDTH(width, height);
                size_t high = ROOMSEG_PLAN_TURNED_HEIGHT(width, height);
                TEST_ASSERT_LESS_OR_EQUAL_size_t(wide, r.width);
                TEST_ASSERT_LESS_OR_EQUAL_size_t(wide * high, (size_t)r.width * r.height);
                TEST_ASSERT_LESS_OR_EQUAL_size_t(ROOMSEG_PLAN_CELLS(wide, high),
                                                 ROOMSEG_PLAN_CELLS(r.width, r.height));
            }
            sketch_free(&s);
        }
    }
}

/* Every free cell finds its own place again: stripes of labels come back as stripes. */
static void test_labels_come_back(void)
{
    s = sketch_blank(90, 70, 0, 50);
    crop = stage_frame(90, 70);
    sketch_fill(&s, 40, 30, 5, 5, 255);
    uint8_t *mask = stage_mask(&crop, &s);
    rs_labels labels = stage_labels(&crop);
    for (int32_t angle = -4500; angle < 4500; angle += 700) {
        rs_rotation r = rotation_of(angle);
        double radians = angle * acos(-1.0) / 18000.0;
        uint16_t *turned = stage_scratch((size_t)r.width * r.height, sizeof *turned);
        for (uint32_t y = 0; y < r.height; y++) {
            for (uint32_t x = 0; x < r.width; x++) {
                double dx = (double)r.left + x, dy = (double)r.top + y;
                double crop_x = dx * cos(radians) - dy * sin(radians) + 45.0;
                turned[(size_t)y * r.width + x] = (uint16_t)(100 + lround(crop_x));
            }
        }
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                              rs_rotate_labels_back(&r, turned, mask, &labels, &ticker));
        for (uint32_t y = 0; y < 70; y++) {
            for (uint32_t x = 0; x < 90; x++) {
                uint16_t label = labels.cells[(size_t)y * 90 + x];
                if (mask[rs_frame_index(&crop, x, y)] == 0) {
                    TEST_ASSERT_EQUAL_UINT16(0, label);
                } else {
                    TEST_ASSERT_UINT_WITHIN(1, 100 + x, label);
                }
            }
        }
        free(turned);
    }
    free(labels.cells);
    free(mask);
}

static void test_cells_come_back(void)
{
    s = sketch_blank(31, 57, 0, 50);
    crop = stage_frame(31, 57);
    for (int32_t angle = -4500; angle < 4500; angle += 450) {
        rs_rotation r = rotation_of(angle);
        double radians = angle * acos(-1.0) / 18000.0;
        for (uint32_t y = 0; y < r.height; y += 3) {
            for (uint32_t x = 0; x < r.width; x += 3) {
                uint32_t crop_x, crop_y;
                double dx = (double)r.left + x, dy = (double)r.top + y;
                double exact_x = dx * cos(radians) - dy * sin(radians) + 15.0;
                double exact_y = dx * sin(radians) + dy * cos(radians) + 28.0;
                bool inside = rs_rotate_cell_back(&r, x, y, &crop_x, &crop_y);
                if (inside) {
                    TEST_ASSERT_TRUE(fabs(crop_x - exact_x) <= 0.5001);
                    TEST_ASSERT_TRUE(fabs(crop_y - exact_y) <= 0.5001);
                } else {
                    TEST_ASSERT_TRUE(exact_x < -0.49 || exact_x > 30.49 || exact_y < -0.49 ||
                                     exact_y > 56.49);
                }
            }
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_no_angle_changes_nothing);
    RUN_TEST(test_the_frame_ends_with_the_free_cells);
    RUN_TEST(test_a_turned_room_stands_upright);
    RUN_TEST(test_the_unknown_counts_half);
    RUN_TEST(test_thin_walls_stay_closed);
    RUN_TEST(test_the_plan_holds_every_turned_frame);
    RUN_TEST(test_labels_come_back);
    RUN_TEST(test_cells_come_back);
    return UNITY_END();
}
