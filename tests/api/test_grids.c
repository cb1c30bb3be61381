/* Grids of all kinds: sizes, strides, read-only memory, noise, places in a larger grid. */
#include <stdbool.h>
#include <string.h>

#include "fixture.h"
#include "unity.h"

static const char *const flat[] = {
    "####################",
    "#........#.........#",
    "#........#.........#",
    "#........#.........#",
    "#..................#",
    "#..................#",
    "#........#.........#",
    "####..####.........#",
    "#........#.........#",
    "#........#.........#",
    "#........#.........#",
    "#........#.........#",
    "####################",
    NULL,
};

static void test_a_single_free_cell(void)
{
    s = sketch_blank(1, 1, 0, 50);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(0, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, r.result.crop_width);
    run_free(&r);
    config.smallest_room_mm2 = 0;
    config.isolated_permille = 0;
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, r.labels[0]);
    TEST_ASSERT_EQUAL_UINT(25, r.result.rooms[0].area_cm2);
    TEST_ASSERT_EQUAL_UINT(0, r.result.rooms[0].interior_x);
}

static void test_a_single_cell_that_is_not_free(void)
{
    s = sketch_blank(1, 1, 127, 50);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(0, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, r.labels[0]);
}

static void test_no_free_cell(void)
{
    s = sketch_blank(70, 30, 255, 50);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_size_t(0, r.arena_size);
    TEST_ASSERT_EQUAL_UINT(0, r.result.room_count);
    TEST_ASSERT_EACH_EQUAL_UINT16(0, r.labels, 70 * 30);
}

/* Free up to the edge of the grid on all sides. */
static void test_a_grid_without_walls(void)
{
    s = sketch_blank(90, 40, 0, 50);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EACH_EQUAL_UINT16(1, r.labels, 90 * 40);
}

/* Bands of one cell, and every size of grid up to 12 x 12, free throughout and chequered. */
static void test_every_small_size(void)
{
    config.smallest_room_mm2 = 0;
    config.isolated_permille = 0;
    for (uint32_t height = 1; height <= 12; height++) {
        for (uint32_t width = 1; width <= 12; width++) {
            s = sketch_blank(width, height, 0, 200);
            r = run_checked(&config, &s.grid);
            TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
            run_free(&r);
            for (size_t i = 0; i < (size_t)width * height; i++) {
                s.memory[i] = (i % width + i / width) % 2 == 0 ? 0 : 255;
            }
            config.speck_mm2 = 0;
            config.clutter_mm = 0;
            r = run_checked(&config, &s.grid);
            TEST_ASSERT_EQUAL_UINT((width * height + 1) / 2, r.result.room_count);
            run_free(&r);
            config.speck_mm2 = 96000;
            config.clutter_mm = 1500;
            r = run_checked(&config, &s.grid);
            run_free(&r);
            sketch_free(&s);
        }
    }
}

static void test_a_stride_changes_nothing(void)
{
    s = sketch_make(flat, 8, 0, 50);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(3, r.result.room_count);
    for (uint32_t gap = 1; gap < 40; gap += 13) {
        sketch padded = sketch_make(flat, 8, s.grid.width + gap, 50);
        run other = run_checked(&config, &padded.grid);
        run_assert_same(&r, &other);
        run_free(&other);
        sketch_free(&padded);
    }
}

/* What an arena held before makes no difference, nor does more of it than needed. */
static void test_old_contents_of_the_arena_do_not_matter(void)
{
    s = sketch_make(flat, 8, 0, 50);
    r = run_checked(&config, &s.grid);
    for (int filler = 0; filler <= 255; filler += 51) {
        run other = run_unchecked(&config, &s.grid);
        memset(other.arena, filler, other.arena_size);
        memset(other.labels, filler, (size_t)s.grid.width * s.grid.height * 2);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                              roomseg_run(&config, &s.grid, other.labels, s.grid.width,
                                          &other.result, other.arena, other.arena_size));
        run_assert_same(&r, &other);
        run_free(&other);
    }
}

static const uint8_t read_only_cells[12 * 12] = {0};

static void test_cells_may_be_read_only(void)
{
    const roomseg_grid grid = {read_only_cells, 12, 12, 12, 200};
    r = run_checked(&config, &grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
}

/* A map inside a larger unknown grid gives the same rooms, moved. */
static void test_the_place_in_the_grid_does_not_matter(void)
{
    s = sketch_make(flat, 8, 0, 50);
    r = run_checked(&config, &s.grid);
    const uint32_t offsets[][2] = {{0, 0}, {1, 0}, {0, 1}, {37, 11}, {200, 100}};
    for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++) {
        uint32_t dx = offsets[i][0];
        uint32_t dy = offsets[i][1];
        sketch wide = sketch_blank(s.grid.width + 230, s.grid.height + 120, 127, 50);
        for (uint32_t y = 0; y < s.grid.height; y++) {
            memcpy(wide.memory + (size_t)(y + dy) * wide.grid.stride + dx,
                   s.memory + (size_t)y * s.grid.stride, s.grid.width);
        }
        run other = run_checked(&config, &wide.grid);
        TEST_ASSERT_EQUAL_UINT(r.result.room_count, other.result.room_count);
        TEST_ASSERT_EQUAL_size_t(r.arena_size, other.arena_size);
        for (uint32_t y = 0; y < s.grid.height; y++) {
            for (uint32_t x = 0; x < s.grid.width; x++) {
                TEST_ASSERT_EQUAL_UINT(run_label(&r, x, y), run_label(&other, x + dx, y + dy));
            }
        }
        const roomseg_doorway *d = r.result.doorways;
        const roomseg_doorway *moved = other.result.doorways;
        for (uint32_t k = 0; k < r.result.doorway_count; k++) {
            TEST_ASSERT_EQUAL_UINT(d[k].x + dx, moved[k].x);
            TEST_ASSERT_EQUAL_UINT(d[k].y + dy, moved[k].y);
            TEST_ASSERT_EQUAL_UINT(d[k].width_mm, moved[k].width_mm);
        }
        run_free(&other);
        sketch_free(&wide);
    }
}

/* 51 is free and 52 is not; 203 in a speck carries the room's label, 204 does not. */
static void test_the_thresholds(void)
{
    s = sketch_blank(60, 60, 51, 50);
    const uint8_t values[] = {52, 127, 203, 204, 255};
    for (uint32_t i = 0; i < 5; i++) {
        sketch_fill(&s, 5 + 10 * i, 30, 2, 3, values[i]);
    }
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(3600 - 12, r.result.rooms[0].area_cells);
    for (uint32_t i = 0; i < 5; i++) {
        TEST_ASSERT_EQUAL_UINT(i < 3 ? 1 : 0, run_label(&r, 5 + 10 * i, 30));
    }
    run_free(&r);
    config.speck_mm2 = 0;
    config.clutter_mm = 0;
    r = run_checked(&config, &s.grid);
    for (uint32_t i = 0; i < 5; i++) {
        TEST_ASSERT_EQUAL_UINT(0, run_label(&r, 5 + 10 * i, 30));
    }
}

/* Obstacles up to the limits change neither the number of rooms nor the inscribed circle. */
static void test_noise_and_clutter_do_not_shape_rooms(void)
{
    static const struct {
        uint32_t x, y, width, height;
        bool shapes;
    } obstacles[] = {
        {80, 60, 30, 30, false}, /* 1500 mm: clutter */
        {60, 60, 31, 30, true},  /* 1550 mm: too long */
        {80, 60, 20, 10, false}, /* twice as long as wide */
        {80, 60, 20, 9, true},   /* more than that: a piece of a wall */
        {30, 30, 38, 1, false},  /* 95,000 mm2: noise, whatever its shape */
        {30, 30, 39, 1, true},   /* 97,500 mm2 */
    };
    s = sketch_blank(121, 121, 0, 50);
    r = run_checked(&config, &s.grid);
    uint16_t radius = r.result.rooms[0].inscribed_radius_mm;
    run_free(&r);
    for (size_t i = 0; i < sizeof obstacles / sizeof obstacles[0]; i++) {
        sketch_fill(&s, obstacles[i].x, obstacles[i].y, obstacles[i].width, obstacles[i].height,
                    255);
        r = run_checked(&config, &s.grid);
        TEST_ASSERT_EQUAL_INT(obstacles[i].shapes,
                              r.result.rooms[0].inscribed_radius_mm < radius);
        run_free(&r);
        sketch_fill(&s, obstacles[i].x, obstacles[i].y, obstacles[i].width, obstacles[i].height,
                    0);
    }
    /* A cross of 9 x 9 cells fills less than a third of its box when its arms are thin. */
    config.speck_mm2 = 0;
    sketch_fill(&s, 80, 64, 9, 1, 255);
    sketch_fill(&s, 84, 60, 1, 9, 255);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_LESS_THAN_UINT(radius, r.result.rooms[0].inscribed_radius_mm);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_single_free_cell);
    RUN_TEST(test_a_single_cell_that_is_not_free);
    RUN_TEST(test_no_free_cell);
    RUN_TEST(test_a_grid_without_walls);
    RUN_TEST(test_every_small_size);
    RUN_TEST(test_a_stride_changes_nothing);
    RUN_TEST(test_old_contents_of_the_arena_do_not_matter);
    RUN_TEST(test_cells_may_be_read_only);
    RUN_TEST(test_the_place_in_the_grid_does_not_matter);
    RUN_TEST(test_the_thresholds);
    RUN_TEST(test_noise_and_clutter_do_not_shape_rooms);
    return UNITY_END();
}
