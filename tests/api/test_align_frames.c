/* config.align: where results lie, and grids that are hard to turn. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

static roomseg_config config;
static sketch s;
static sketch turned;

void setUp(void)
{
    config = roomseg_config_default();
    config.align = ROOMSEG_ALIGN_ON;
    memset(&s, 0, sizeof s);
    memset(&turned, 0, sizeof turned);
}

void tearDown(void)
{
    sketch_free(&s);
    sketch_free(&turned);
}

static void assert_near(double expected, double found, double slack)
{
    TEST_ASSERT_TRUE(fabs(expected - found) <= slack);
}

/* Six rooms stay six rooms of the same size, at whatever angle they lie. */
static void test_rooms_of_a_turned_grid(void)
{
    s = sketch_rooms(3, 2, 60, 14, 50);
    for (int degrees = -44; degrees <= 44; degrees += 11) {
        turned = sketch_turned(&s, degrees);
        run r = run_checked(&config, &turned.grid);
        assert_near(degrees, r.result.wall_angle / 100.0, 1.0);
        TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(7, r.result.doorway_count);
        for (uint32_t i = 0; i < 6; i++) {
            TEST_ASSERT_UINT_WITHIN(180, 3600, r.result.rooms[i].area_cells);
        }
        for (uint32_t i = 0; i < 7; i++) {
            TEST_ASSERT_UINT_WITHIN(120, 700, r.result.doorways[i].width_mm);
        }
        run_free(&r);
        sketch_free(&turned);
    }
}

/* Centroid and interior point lie where the turned room does. */
static void test_positions_are_those_of_the_caller(void)
{
    s = sketch_blank(200, 120, 255, 50);
    sketch_fill(&s, 20, 30, 150, 60, 0);
    turned = sketch_turned(&s, 25.0);
    run r = run_checked(&config, &turned.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    double angle = 25.0 * acos(-1.0) / 180.0;
    double dx = 94.5 - 99.5;
    double x = dx * cos(angle) + (turned.grid.width - 1) / 2.0;
    double y = dx * sin(angle) + (turned.grid.height - 1) / 2.0;
    assert_near(x, r.result.rooms[0].centroid_x_q8 / 256.0, 0.5);
    assert_near(y, r.result.rooms[0].centroid_y_q8 / 256.0, 0.5);
    run_free(&r);
}

/* The crop lies anywhere in the grid, and rows may have a gap. */
static void test_the_place_in_the_grid_does_not_matter(void)
{
    s = sketch_rooms(2, 2, 50, 12, 50);
    turned = sketch_turned(&s, 30.0);
    run here = run_checked(&config, &turned.grid);
    uint32_t stride = turned.grid.width + 71;
    uint8_t *cells = malloc((size_t)stride * (turned.grid.height + 40));
    TEST_ASSERT_NOT_NULL(cells);
    memset(cells, 127, (size_t)stride * (turned.grid.height + 40));
    for (uint32_t y = 0; y < turned.grid.height; y++) {
        memcpy(cells + (size_t)(y + 13) * stride + 37,
               turned.grid.cells + (size_t)y * turned.grid.width, turned.grid.width);
    }
    roomseg_grid moved = {cells, turned.grid.width + 64, turned.grid.height + 40, stride, 50};
    run there = run_checked(&config, &moved);
    TEST_ASSERT_EQUAL_UINT(here.result.room_count, there.result.room_count);
    for (uint32_t y = 0; y < turned.grid.height; y++) {
        for (uint32_t x = 0; x < turned.grid.width; x++) {
            TEST_ASSERT_EQUAL_UINT(run_label(&here, x, y), run_label(&there, x + 37, y + 13));
        }
    }
    TEST_ASSERT_EQUAL_UINT(here.result.rooms[0].interior_x + 37,
                           there.result.rooms[0].interior_x);
    run_free(&here);
    run_free(&there);
    free(cells);
}

/* Grids too small for any line, and noise that has no direction. */
static void test_grids_without_walls(void)
{
    uint32_t random = 12345;
    config.smallest_room_mm2 = 0;
    for (uint32_t side = 1; side <= 40; side++) {
        s = sketch_blank(side, 41 - side, 255, 50);
        for (size_t i = 0; i < (size_t)side * (41 - side); i++) {
            random = random * 1664525u + 1013904223u;
            s.memory[i] = (random >> 24) < 150 ? 0 : (uint8_t)(random >> 16);
        }
        run r = run_checked(&config, &s.grid);
        run_free(&r);
        sketch_free(&s);
    }
    s = sketch_blank(30, 30, 255, 50);
    run r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(0, r.result.room_count);
    TEST_ASSERT_EQUAL_size_t(0, r.arena_size);
    run_free(&r);
}

/* Rooms, and whatever turning tears off and closes when everything is full of noise. */
static void test_noisy_turned_rooms(void)
{
    uint32_t random = 99;
    s = sketch_rooms(2, 2, 60, 14, 50);
    for (int percent = 1; percent <= 30; percent += 7) {
        turned = sketch_turned(&s, 20.0 + percent);
        uint8_t *cells = turned.memory;
        for (size_t i = 0; i < (size_t)turned.grid.width * turned.grid.height; i++) {
            random = random * 1664525u + 1013904223u;
            if ((random >> 16) % 100u < (uint32_t)percent) {
                cells[i] = (uint8_t)(random >> 8);
            }
        }
        config.max_regions = 8192;
        config.speck_mm2 = percent % 2 == 0 ? 0 : 96000;
        config.smallest_room_mm2 = percent % 2 == 0 ? 0 : 1000000;
        config.max_rooms = 4096;
        run r = run_checked(&config, &turned.grid);
        run_free(&r);
        sketch_free(&turned);
    }
}

/* Errors of the profile come through. */
static void test_capacities_of_the_profile(void)
{
    roomseg_result result;
    s = sketch_rooms(4, 3, 40, 10, 50);
    turned = sketch_turned(&s, 40.0);
    config.max_regions = 5;
    config.max_rooms = 5;
    size_t need;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &turned.grid, &need));
    uint16_t *labels = malloc((size_t)turned.grid.width * turned.grid.height * sizeof *labels);
    void *arena = malloc(need);
    TEST_ASSERT_TRUE(labels != NULL && arena != NULL);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS,
                          roomseg_run(&config, &turned.grid, labels, turned.grid.width, &result,
                                      arena, need));
    TEST_ASSERT_EQUAL_UINT(6, result.region_count);
    TEST_ASSERT_EACH_EQUAL_UINT16(0, labels, (size_t)turned.grid.width * turned.grid.height);
    free(labels);
    free(arena);
}

/* The paper's system: rooms and border lines come back too, and the records fit them. */
static void test_the_paper_profile(void)
{
    config = roomseg_config_paper();
    s = sketch_rooms(3, 2, 60, 14, 50);
    for (int degrees = -44; degrees <= 44; degrees += 11) {
        config.align = ROOMSEG_ALIGN_ON;
        turned = sketch_turned(&s, degrees);
        run r = run_unchecked(&config, &turned.grid);
        check_rooms(&r, NULL);
        TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(7, r.result.doorway_count);
        for (uint32_t i = 0; i < 7; i++) {
            const roomseg_doorway *door = &r.result.doorways[i];
            TEST_ASSERT_EQUAL_UINT16(0, run_label(&r, door->x, door->y));
            /* The line runs askew: a stair of up to 14 (cos + sin) cells. */
            TEST_ASSERT_TRUE(door->border_cells >= 8 && door->border_cells <= 20);
            TEST_ASSERT_UINT_WITHIN(160, 640, door->width_mm);
        }
        for (uint32_t y = 1; y < turned.grid.height; y++) {
            for (uint32_t x = 1; x < turned.grid.width; x++) {
                uint16_t here = run_label(&r, x, y);
                const uint16_t others[3] = {run_label(&r, x - 1, y), run_label(&r, x, y - 1),
                                            run_label(&r, x - 1, y - 1)};
                for (int k = 0; k < 3; k++) {
                    TEST_ASSERT_TRUE(here == 0 || others[k] == 0 || here == others[k]);
                }
            }
        }
        run_free(&r);
        sketch_free(&turned);
    }
}

static void test_the_paper_profile_in_exact_memory(void)
{
    const uint32_t sides[] = {1, 2, 3, 7, 20, 100, 333, 1000, 4096};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            config = roomseg_config_paper();
            config.align = ROOMSEG_ALIGN_ON;
            for (int small = 0; small < 2; small++) {
                size_t query;
                size_t cells = ROOMSEG_PLAN_SMALL(config.speck_mm2, config.clutter_mm, 50u);
                size_t inner = ROOMSEG_ARENA_SIZE_PAPER(
                    ROOMSEG_PLAN_TURNED_WIDTH(sides[i], sides[k]),
                    ROOMSEG_PLAN_TURNED_HEIGHT(sides[i], sides[k]), cells, config.max_regions,
                    config.max_rooms);
                TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, sides[i], sides[k],
                                                                     50, &query));
                TEST_ASSERT_EQUAL_size_t(
                    query, ROOMSEG_ARENA_SIZE_ALIGNED(sides[i], sides[k], cells, config.max_rooms,
                                                      inner));
                config.max_regions = 1;
                config.max_rooms = 1;
            }
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_rooms_of_a_turned_grid);
    RUN_TEST(test_positions_are_those_of_the_caller);
    RUN_TEST(test_the_place_in_the_grid_does_not_matter);
    RUN_TEST(test_grids_without_walls);
    RUN_TEST(test_noisy_turned_rooms);
    RUN_TEST(test_capacities_of_the_profile);
    RUN_TEST(test_the_paper_profile);
    RUN_TEST(test_the_paper_profile_in_exact_memory);
    return UNITY_END();
}
