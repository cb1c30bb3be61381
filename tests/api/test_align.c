/* config.align: turned maps give the rooms of the straight one, in the caller's own cells. */
#include <stdlib.h>
#include <string.h>

#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

static const char *const flat[] = {
    "########################",
    "#........#.............#",
    "#........#.............#",
    "#........#.............#",
    "#......................#",
    "#......................#",
    "#........#.............#",
    "####..####.............#",
    "#........#.............#",
    "#........#.............#",
    "#........#####..########",
    "#........#.............#",
    "#........#.............#",
    "#........#.............#",
    "#........#.............#",
    "########################",
    NULL,
};

static roomseg_config config;
static sketch straight;
static sketch s;
static uint32_t calls;
static uint32_t stop_at;
static unsigned stages_seen;

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    (void)user;
    (void)permille;
    stages_seen |= 1u << stage;
    return calls++ == stop_at;
}

void setUp(void)
{
    config = roomseg_config_default();
    config.align = ROOMSEG_ALIGN_ON;
    config.progress = hook;
    calls = 0;
    stop_at = UINT32_MAX;
    stages_seen = 0;
    memset(&s, 0, sizeof s);
    straight = sketch_make(flat, 8, 0, 50);
}

void tearDown(void)
{
    sketch_free(&s);
    sketch_free(&straight);
}

static void test_walls_along_the_axes_are_left_alone(void)
{
    run aligned = run_checked(&config, &straight.grid);
    config.align = NULL;
    run plain = run_checked(&config, &straight.grid);
    TEST_ASSERT_INT_WITHIN(50, 0, aligned.result.wall_angle);
    aligned.arena_size = plain.arena_size; /* the only thing that may differ */
    run_assert_same(&plain, &aligned);
    run_free(&plain);
    run_free(&aligned);
}

static void test_turned_maps_give_the_same_rooms(void)
{
    const int degrees[] = {3, 17, 30, 44, -8, -40};
    config.align = NULL;
    run plain = run_checked(&config, &straight.grid);
    TEST_ASSERT_EQUAL_UINT(4, plain.result.room_count);
    config.align = ROOMSEG_ALIGN_ON;
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++) {
        s = sketch_turned(&straight, degrees[i]);
        run r = run_checked(&config, &s.grid);
        TEST_ASSERT_INT_WITHIN(100, degrees[i] * 100, r.result.wall_angle);
        TEST_ASSERT_EQUAL_UINT(4, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(plain.result.doorway_count, r.result.doorway_count);
        for (uint32_t k = 0; k < 4; k++) {
            uint32_t cells = plain.result.rooms[k].area_cells;
            TEST_ASSERT_UINT32_WITHIN(cells / 20, cells, r.result.rooms[k].area_cells);
        }
        run_free(&r);
        sketch_free(&s);
    }
    run_free(&plain);
}

static void test_all_stages_are_reported_for_a_turned_map(void)
{
    s = sketch_turned(&straight, 20);
    run r = run_checked(&config, &s.grid);
    unsigned paper_stages = 1u << ROOMSEG_STAGE_SEEDS | 1u << ROOMSEG_STAGE_RIDGE;
    TEST_ASSERT_EQUAL_HEX(((1u << ROOMSEG_STAGE_COUNT) - 1u) & ~paper_stages, stages_seen);
    run_free(&r);
}

static void test_each_call_can_cancel(void)
{
    s = sketch_turned(&straight, 20);
    run fresh = run_unchecked(&config, &s.grid);
    uint32_t all = calls;
    size_t cells = (size_t)s.grid.width * s.grid.height;
    guard arena = guard_make(fresh.arena_size, 0);
    run again = fresh;
    again.labels = malloc(cells * sizeof *again.labels);
    TEST_ASSERT_NOT_NULL(again.labels);
    for (stop_at = 0; stop_at < all; stop_at++) {
        calls = 0;
        memset(again.labels, 0xEE, cells * sizeof *again.labels);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                              roomseg_run(&config, &s.grid, again.labels, s.grid.width,
                                          &again.result, arena.memory, arena.size));
        TEST_ASSERT_EQUAL_UINT(stop_at + 1, calls);
        TEST_ASSERT_EACH_EQUAL_UINT16(0, again.labels, cells);
        TEST_ASSERT_EQUAL_UINT(0, again.result.room_count);
        TEST_ASSERT_EQUAL_INT(0, again.result.wall_angle);
        guard_check(&arena);
    }
    stop_at = UINT32_MAX;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_run(&config, &s.grid, again.labels, s.grid.width,
                                      &again.result, arena.memory, arena.size));
    run_assert_same(&fresh, &again);
    guard_check(&arena);
    free(again.labels);
    guard_free(&arena);
    run_free(&fresh);
}

static void test_arena_below_the_need(void)
{
    s = sketch_turned(&straight, 20);
    run fresh = run_unchecked(&config, &s.grid);
    guard arena = guard_make(fresh.arena_size, 0);
    uint16_t *labels = calloc((size_t)s.grid.width * s.grid.height, sizeof *labels);
    TEST_ASSERT_NOT_NULL(labels);
    for (size_t i = 0; i < 128; i++) {
        size_t size = i < 64 ? fresh.arena_size / 64 * i : fresh.arena_size - 128 + i;
        roomseg_result result;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ARENA_SIZE,
                              roomseg_run(&config, &s.grid, labels, s.grid.width, &result,
                                          arena.memory, size));
        TEST_ASSERT_EQUAL_size_t(fresh.arena_size, result.arena_used);
        guard_check_beyond(&arena, size);
    }
    free(labels);
    guard_free(&arena);
    run_free(&fresh);
}

static void test_macro_and_query_agree(void)
{
    const uint32_t sides[] = {1, 2, 3, 10, 57, 100, 333, 1000, 2047, 5000};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            size_t query;
            TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, sides[i], sides[k],
                                                                 50, &query));
            TEST_ASSERT_EQUAL_size_t(
                query, ROOMSEG_ARENA_SIZE_DEFAULT_ALIGNED(sides[i], sides[k], 50));
        }
    }
}

/* The turned crop has its own limit: (width + height + 2)^2 / 2. */
static void test_the_largest_crop_is_halved(void)
{
    size_t query;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 11584, 11584, 50, &query));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE,
                          roomseg_arena_size(&config, 11585, 11585, 50, &query));
    config.align = NULL;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 11585, 11585, 50, &query));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_walls_along_the_axes_are_left_alone);
    RUN_TEST(test_turned_maps_give_the_same_rooms);
    RUN_TEST(test_all_stages_are_reported_for_a_turned_map);
    RUN_TEST(test_each_call_can_cancel);
    RUN_TEST(test_arena_below_the_need);
    RUN_TEST(test_macro_and_query_agree);
    RUN_TEST(test_the_largest_crop_is_halved);
    return UNITY_END();
}
