/* An arena of every size below the need: always the clean error, never a write outside; at the
 * need and above it the same result. */
#include <stdlib.h>
#include <string.h>

#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

static roomseg_config config;
static sketch s;
static run expected;
static guard arena;
static guard labels;

void setUp(void)
{
    config = roomseg_config_default();
}

void tearDown(void)
{
    guard_free(&labels);
    guard_free(&arena);
    run_free(&expected);
    sketch_free(&s);
}

/* Reference run, and guarded memory with room for `spare` bytes above the need. */
static void prepare(size_t spare)
{
    expected = run_unchecked(&config, &s.grid);
    TEST_ASSERT_GREATER_THAN_UINT(1, expected.result.room_count);
    arena = guard_make(expected.arena_size + spare, 0);
    labels = guard_make((size_t)s.grid.width * s.grid.height * sizeof(uint16_t), 0);
}

static void expect_refused(size_t size)
{
    roomseg_result result;
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ARENA_SIZE,
                          roomseg_run(&config, &s.grid, (uint16_t *)labels.memory, s.grid.width,
                                      &result, arena.memory, size));
    TEST_ASSERT_EQUAL_size_t(expected.arena_size, result.arena_used);
    TEST_ASSERT_EQUAL_UINT(0, result.room_count);
    TEST_ASSERT_NULL(result.rooms);
    guard_check_beyond(&arena, size);
    guard_check_untouched(&labels);
}

static void expect_same(size_t size)
{
    run again = expected;
    again.labels = (uint16_t *)labels.memory;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_run(&config, &s.grid, again.labels, s.grid.width,
                                      &again.result, arena.memory, size));
    TEST_ASSERT_EQUAL_size_t(expected.arena_size, again.result.arena_used);
    run_assert_same(&expected, &again);
    guard_check_beyond(&arena, expected.arena_size);
    guard_check(&labels);
}

static void test_every_byte_on_a_small_map(void)
{
    config.max_regions = 64;
    config.max_rooms = 16;
    s = sketch_rooms(2, 2, 30, 7, 100);
    prepare(3);
    for (size_t size = 0; size < expected.arena_size; size++) {
        expect_refused(size);
    }
    for (size_t size = expected.arena_size; size <= expected.arena_size + 3; size++) {
        expect_same(size);
    }
}

/* The default capacities, where the graph outweighs the cells; and a larger map, where the
 * cells outweigh the graph. */
static void sweep(void)
{
    prepare(4096);
    size_t need = expected.arena_size;
    for (size_t i = 0; i < 251; i++) {
        expect_refused(need / 251 * i);
    }
    for (size_t size = need - 128; size < need; size++) {
        expect_refused(size);
    }
    for (size_t spare = 0; spare <= 4096; spare += 1024) {
        expect_same(need + spare);
    }
}

static void test_sweep_with_the_default_capacities(void)
{
    s = sketch_rooms(3, 2, 40, 12, 50);
    sweep();
}

static void test_sweep_on_a_larger_map(void)
{
    s = sketch_rooms(7, 5, 80, 18, 50);
    sweep();
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_every_byte_on_a_small_map);
    RUN_TEST(test_sweep_with_the_default_capacities);
    RUN_TEST(test_sweep_on_a_larger_map);
    return UNITY_END();
}
