/* config.align: rooms of grids that lie askew, in the caller's frame. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "turn.h"
#include "unity.h"

static roomseg_config config;
static sketch s;
static roomseg_grid turned;

void setUp(void)
{
    config = roomseg_config_default();
    config.align = ROOMSEG_ALIGN_ON;
}

void tearDown(void)
{
    sketch_free(&s);
    free((void *)turned.cells);
    memset(&turned, 0, sizeof turned);
}

static void assert_near(double expected, double found, double slack)
{
    TEST_ASSERT_TRUE(fabs(expected - found) <= slack);
}

static void test_it_is_off_by_default(void)
{
    TEST_ASSERT_NULL(roomseg_config_default().align);
}

/* Nothing to straighten: the same bits as without alignment. */
static void test_a_straight_grid_is_left_alone(void)
{
    s = sketch_rooms(3, 2, 60, 14, 50);
    run with = run_checked(&config, &s.grid);
    config.align = NULL;
    run without = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_INT(0, with.result.wall_angle);
    TEST_ASSERT_GREATER_THAN_size_t(without.result.arena_used, with.result.arena_used);
    run_assert_same(&with, &without);
    run_free(&with);
    run_free(&without);
}

/* Six rooms stay six rooms of the same size, at whatever angle they lie. */
static void test_rooms_of_a_turned_grid(void)
{
    s = sketch_rooms(3, 2, 60, 14, 50);
    for (int degrees = -44; degrees <= 44; degrees += 11) {
        turned = turn_grid(&s.grid, degrees);
        run r = run_checked(&config, &turned);
        assert_near(degrees, r.result.wall_angle / 100.0, 0.5);
        TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(7, r.result.doorway_count);
        for (uint32_t i = 0; i < 6; i++) {
            TEST_ASSERT_UINT_WITHIN(180, 3600, r.result.rooms[i].area_cells);
        }
        for (uint32_t i = 0; i < 7; i++) {
            TEST_ASSERT_UINT_WITHIN(120, 700, r.result.doorways[i].width_mm);
        }
        run_free(&r);
        free((void *)turned.cells);
        turned.cells = NULL;
    }
}

/* Centroid and interior point lie where the turned room does. */
static void test_positions_are_those_of_the_caller(void)
{
    s = sketch_blank(200, 120, 255, 50);
    sketch_fill(&s, 20, 30, 150, 60, 0);
    turned = turn_grid(&s.grid, 25.0);
    run r = run_checked(&config, &turned);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    double angle = 25.0 * acos(-1.0) / 180.0;
    double dx = 94.5 - 99.5;
    double x = dx * cos(angle) + (turned.width - 1) / 2.0;
    double y = dx * sin(angle) + (turned.height - 1) / 2.0;
    assert_near(x, r.result.rooms[0].centroid_x_q8 / 256.0, 0.5);
    assert_near(y, r.result.rooms[0].centroid_y_q8 / 256.0, 0.5);
    run_free(&r);
}

/* The crop lies anywhere in the grid, and rows may have a gap. */
static void test_the_place_in_the_grid_does_not_matter(void)
{
    s = sketch_rooms(2, 2, 50, 12, 50);
    turned = turn_grid(&s.grid, 30.0);
    run here = run_checked(&config, &turned);
    uint32_t stride = turned.width + 71;
    uint8_t *cells = malloc((size_t)stride * (turned.height + 40));
    TEST_ASSERT_NOT_NULL(cells);
    memset(cells, 127, (size_t)stride * (turned.height + 40));
    for (uint32_t y = 0; y < turned.height; y++) {
        memcpy(cells + (size_t)(y + 13) * stride + 37, turned.cells + (size_t)y * turned.width,
               turned.width);
    }
    roomseg_grid moved = {cells, turned.width + 64, turned.height + 40, stride, 50};
    run there = run_checked(&config, &moved);
    TEST_ASSERT_EQUAL_UINT(here.result.room_count, there.result.room_count);
    for (uint32_t y = 0; y < turned.height; y++) {
        for (uint32_t x = 0; x < turned.width; x++) {
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
        turned = turn_grid(&s.grid, 20.0 + percent);
        uint8_t *cells = (uint8_t *)turned.cells;
        for (size_t i = 0; i < (size_t)turned.width * turned.height; i++) {
            random = random * 1664525u + 1013904223u;
            if ((random >> 16) % 100u < (uint32_t)percent) {
                cells[i] = (uint8_t)(random >> 8);
            }
        }
        config.max_regions = 8192;
        config.speck_mm2 = percent % 2 == 0 ? 0 : 96000;
        config.smallest_room_mm2 = percent % 2 == 0 ? 0 : 1000000;
        config.max_rooms = 4096;
        run r = run_checked(&config, &turned);
        run_free(&r);
        free((void *)turned.cells);
        turned.cells = NULL;
    }
}

/* The macro, the query and the run need the same. */
static void expect_size(uint32_t width, uint32_t height)
{
    size_t small = ROOMSEG_PLAN_SMALL(config.speck_mm2, config.clutter_mm, 50u);
    size_t inner = ROOMSEG_ARENA_SIZE(ROOMSEG_PLAN_TURNED_WIDTH(width, height),
                                      ROOMSEG_PLAN_TURNED_HEIGHT(width, height), small,
                                      config.max_regions, config.max_rooms);
    size_t query = 0;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, width, height, 50, &query));
    TEST_ASSERT_EQUAL_size_t(
        query, ROOMSEG_ARENA_SIZE_ALIGNED(width, height, small, config.max_rooms, inner));
}

static uint64_t static_arena[ROOMSEG_ARENA_SIZE_DEFAULT_ALIGNED(100, 80, 50) / 8];

static void test_the_arena_size(void)
{
    const uint32_t sides[] = {1, 2, 3, 7, 20, 100, 101, 333, 1000, 4096, 11000};
    size_t query;
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            config.max_regions = 1024;
            config.max_rooms = 255;
            expect_size(sides[i], sides[k]);
            config.max_regions = 1;
            config.max_rooms = 1;
            expect_size(sides[i], sides[k]);
        }
    }
    config = roomseg_config_default();
    config.align = ROOMSEG_ALIGN_ON;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 100, 80, 50, &query));
    TEST_ASSERT_EQUAL_size_t(sizeof static_arena, query);
}

static void test_too_large_to_turn(void)
{
    size_t query = 1;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE,
                          roomseg_arena_size(&config, 16384, 16384, 50, &query));
    TEST_ASSERT_EQUAL_size_t(0, query);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE,
                          roomseg_arena_size(&config, 65535, 1, 50, &query));
    config.align = NULL;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 16384, 16384, 50, &query));
}

/* A smaller arena gives the clean error, the exact one never a write outside. */
static void test_arena_shrunk(void)
{
    s = sketch_rooms(2, 1, 40, 12, 50);
    config.max_regions = 64;
    config.max_rooms = 8;
    turned = turn_grid(&s.grid, 33.0);
    run exact = run_checked(&config, &turned);
    size_t need = exact.result.arena_used;
    uint16_t *labels = malloc((size_t)turned.width * turned.height * sizeof *labels);
    TEST_ASSERT_NOT_NULL(labels);
    for (size_t size = 0; size <= need; size += size + 997 < need ? 997 : 1) {
        roomseg_result result;
        guard arena = guard_make(size, 0);
        int rc = roomseg_run(&config, &turned, labels, turned.width, &result, arena.memory, size);
        TEST_ASSERT_EQUAL_INT(size < need ? ROOMSEG_ERR_ARENA_SIZE : ROOMSEG_OK, rc);
        TEST_ASSERT_EQUAL_size_t(need, result.arena_used);
        guard_check(&arena);
        guard_free(&arena);
    }
    TEST_ASSERT_EQUAL_INT(0, memcmp(labels, exact.labels, (size_t)turned.width * turned.height *
                                                              sizeof *labels));
    free(labels);
    run_free(&exact);
}

static uint32_t calls, stop_at;
static int last_stage;
static unsigned last_permille, stages_seen;

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    (void)user;
    TEST_ASSERT_GREATER_OR_EQUAL_INT(last_stage, (int)stage);
    TEST_ASSERT_TRUE((int)stage != last_stage || permille >= last_permille);
    last_stage = (int)stage;
    last_permille = permille;
    stages_seen |= 1u << stage;
    return calls++ == stop_at;
}

static void start_counting(uint32_t stop)
{
    calls = 0;
    stop_at = stop;
    last_stage = -1;
    last_permille = 0;
    stages_seen = 0;
}

/* Stops at each call of the hook in turn. */
static void test_cancelling(void)
{
    s = sketch_rooms(4, 3, 60, 14, 50);
    turned = turn_grid(&s.grid, 40.0);
    config.progress = hook;
    start_counting(UINT32_MAX);
    run whole = run_checked(&config, &turned);
    uint32_t all = calls;
    TEST_ASSERT_EQUAL_HEX((1u << ROOMSEG_STAGE_COUNT) - 1u, stages_seen);
    TEST_ASSERT_GREATER_THAN_UINT(ROOMSEG_STAGE_COUNT + 5, all);
    size_t cells = (size_t)turned.width * turned.height;
    uint16_t *labels = malloc(cells * sizeof *labels);
    TEST_ASSERT_NOT_NULL(labels);
    for (uint32_t call = 0; call < all; call++) {
        roomseg_result result;
        memset(labels, 0xEE, cells * sizeof *labels);
        start_counting(call);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                              roomseg_run(&config, &turned, labels, turned.width, &result,
                                          whole.arena, whole.arena_size));
        TEST_ASSERT_EQUAL_UINT_MESSAGE(call + 1, calls, "called again after it had cancelled");
        TEST_ASSERT_EACH_EQUAL_UINT16(0, labels, cells);
        TEST_ASSERT_EQUAL_INT(0, result.wall_angle);
    }
    free(labels);
    run_free(&whole);
}

/* Errors of the profile come through. */
static void test_capacities_of_the_profile(void)
{
    roomseg_result result;
    s = sketch_rooms(4, 3, 40, 10, 50);
    turned = turn_grid(&s.grid, 40.0);
    config.max_regions = 5;
    config.max_rooms = 5;
    size_t need;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &turned, &need));
    uint16_t *labels = malloc((size_t)turned.width * turned.height * sizeof *labels);
    void *arena = malloc(need);
    TEST_ASSERT_TRUE(labels != NULL && arena != NULL);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS, roomseg_run(&config, &turned, labels, turned.width,
                                                           &result, arena, need));
    TEST_ASSERT_EQUAL_UINT(6, result.region_count);
    TEST_ASSERT_EACH_EQUAL_UINT16(0, labels, (size_t)turned.width * turned.height);
    free(labels);
    free(arena);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_it_is_off_by_default);
    RUN_TEST(test_a_straight_grid_is_left_alone);
    RUN_TEST(test_rooms_of_a_turned_grid);
    RUN_TEST(test_positions_are_those_of_the_caller);
    RUN_TEST(test_the_place_in_the_grid_does_not_matter);
    RUN_TEST(test_grids_without_walls);
    RUN_TEST(test_noisy_turned_rooms);
    RUN_TEST(test_the_arena_size);
    RUN_TEST(test_too_large_to_turn);
    RUN_TEST(test_arena_shrunk);
    RUN_TEST(test_cancelling);
    RUN_TEST(test_capacities_of_the_profile);
    return UNITY_END();
}
