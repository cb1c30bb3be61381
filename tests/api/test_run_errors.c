/* roomseg_run: every documented failure, and the state that it leaves behind. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "config_fields.h"
#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

#define GAP 3u              /* label cells between the width and the stride */
#define UNTOUCHED 0xBEEFu   /* what labels hold before a run */

/* Two rooms, each about 9 m2, and a door. */
static const char *const plan[] = {
    "##################",
    "#........#.......#",
    "#........#.......#",
    "#........#.......#",
    "#................#",
    "#................#",
    "#........#.......#",
    "#........#.......#",
    "#........#.......#",
    "##################",
    NULL,
};

static roomseg_config config;
static sketch s;
static uint16_t *labels;
static uint32_t label_stride;
static size_t label_count;
static guard arena;
static roomseg_result result;

void setUp(void)
{
    config = roomseg_config_default();
    config.clutter_mm = 0;
    s = sketch_make(plan, 4, 0, 100);
    label_stride = s.grid.width + GAP;
    label_count = (size_t)label_stride * s.grid.height;
    labels = malloc(label_count * sizeof *labels);
    TEST_ASSERT_NOT_NULL(labels);
    for (size_t i = 0; i < label_count; i++) {
        labels[i] = UNTOUCHED;
    }
    size_t need;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &need));
    arena = guard_make(need, 0);
    memset(&result, 0xEE, sizeof result);
}

void tearDown(void)
{
    guard_check(&arena);
    guard_free(&arena);
    free(labels);
    sketch_free(&s);
}

static void expect_result_zeroed(size_t arena_used, uint32_t region_count)
{
    TEST_ASSERT_NULL(result.rooms);
    TEST_ASSERT_NULL(result.doorways);
    TEST_ASSERT_NULL(result.links);
    TEST_ASSERT_EQUAL_UINT(0, result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(region_count, result.region_count);
    TEST_ASSERT_EQUAL_UINT(0, result.crop_x);
    TEST_ASSERT_EQUAL_UINT(0, result.crop_y);
    TEST_ASSERT_EQUAL_UINT(0, result.crop_width);
    TEST_ASSERT_EQUAL_UINT(0, result.crop_height);
    TEST_ASSERT_EQUAL_size_t(arena_used, result.arena_used);
}

static void expect_labels(uint16_t inside)
{
    for (size_t i = 0; i < label_count; i++) {
        bool in_gap = i % label_stride >= s.grid.width;
        TEST_ASSERT_EQUAL_HEX16(in_gap ? UNTOUCHED : inside, labels[i]);
    }
}

/* A failure before the run has begun: result zeroed, labels untouched. */
static void expect_refused(int code, const roomseg_config *c, const roomseg_grid *grid)
{
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(code, roomseg_run(c, grid, labels, label_stride, &result, arena.memory,
                                            arena.size));
    expect_result_zeroed(0, 0);
    expect_labels(UNTOUCHED);
}

/* After whatever went wrong, the same arena and labels serve a good run. */
static void expect_good_run(void)
{
    roomseg_config good = roomseg_config_default();
    good.clutter_mm = 0;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&good, &s.grid, labels, label_stride, &result,
                                                  arena.memory, arena.size));
    TEST_ASSERT_EQUAL_UINT(2, result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, result.doorway_count);
    TEST_ASSERT_EQUAL_HEX16(UNTOUCHED, labels[s.grid.width]);
}

static void test_null_pointers(void)
{
    expect_refused(ROOMSEG_ERR_NULL, NULL, &s.grid);
    expect_refused(ROOMSEG_ERR_NULL, &config, NULL);
    roomseg_grid grid = s.grid;
    grid.cells = NULL;
    expect_refused(ROOMSEG_ERR_NULL, &config, &grid);
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL,
                          roomseg_run(&config, &s.grid, NULL, label_stride, &result,
                                      arena.memory, arena.size));
    expect_result_zeroed(0, 0);
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL, roomseg_run(&config, &s.grid, labels, label_stride,
                                                        &result, NULL, arena.size));
    expect_result_zeroed(0, 0);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL, roomseg_run(&config, &s.grid, labels, label_stride,
                                                        NULL, arena.memory, arena.size));
    expect_labels(UNTOUCHED);
    guard_check_untouched(&arena);
}

static void test_grid_size(void)
{
    roomseg_grid grid = s.grid;
    grid.width = 0;
    expect_refused(ROOMSEG_ERR_GRID_SIZE, &config, &grid);
    grid = s.grid;
    grid.height = 0;
    expect_refused(ROOMSEG_ERR_GRID_SIZE, &config, &grid);
    grid = s.grid;
    grid.height = ROOMSEG_MAX_SIDE + 1;
    expect_refused(ROOMSEG_ERR_GRID_SIZE, &config, &grid);
    grid = s.grid;
    grid.width = grid.stride = ROOMSEG_MAX_SIDE + 1;
    label_stride = grid.width; /* so that the width is the only thing wrong */
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE,
                          roomseg_run(&config, &grid, labels, label_stride, &result,
                                      arena.memory, arena.size));
    expect_result_zeroed(0, 0);
    guard_check_untouched(&arena);
}

static void test_strides(void)
{
    roomseg_grid grid = s.grid;
    grid.stride = grid.width - 1;
    expect_refused(ROOMSEG_ERR_STRIDE, &config, &grid);
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_STRIDE,
                          roomseg_run(&config, &s.grid, labels, s.grid.width - 1, &result,
                                      arena.memory, arena.size));
    expect_result_zeroed(0, 0);
    expect_labels(UNTOUCHED);
    guard_check_untouched(&arena);
}

static void test_resolution(void)
{
    roomseg_grid grid = s.grid;
    grid.resolution_mm = ROOMSEG_MIN_RESOLUTION_MM - 1;
    expect_refused(ROOMSEG_ERR_RESOLUTION, &config, &grid);
    grid.resolution_mm = ROOMSEG_MAX_RESOLUTION_MM + 1;
    expect_refused(ROOMSEG_ERR_RESOLUTION, &config, &grid);
    grid.resolution_mm = 0;
    expect_refused(ROOMSEG_ERR_RESOLUTION, &config, &grid);
    guard_check_untouched(&arena);
}

static void invalid_config(const roomseg_config *invalid, const char *field)
{
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT_MESSAGE(ROOMSEG_ERR_CONFIG,
                                  roomseg_run(invalid, &s.grid, labels, label_stride, &result,
                                              arena.memory, arena.size),
                                  field);
    expect_result_zeroed(0, 0);
}

static void test_config(void)
{
    config_each_invalid(invalid_config);
    config.max_regions = 3;
    config.max_rooms = 4;
    expect_refused(ROOMSEG_ERR_CONFIG, &config, &s.grid);
    guard_check_untouched(&arena);
}

static void test_arena_misaligned(void)
{
    guard_free(&arena);
    size_t need;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &need));
    for (size_t shift = 0; shift < 2 * ROOMSEG_ARENA_ALIGN; shift++) {
        arena = guard_make(need, shift);
        if (shift % ROOMSEG_ARENA_ALIGN != 0) {
            expect_refused(ROOMSEG_ERR_ARENA_ALIGN, &config, &s.grid);
            guard_check_untouched(&arena);
        } else {
            expect_good_run();
            guard_check(&arena);
            for (size_t i = 0; i < label_count; i++) {
                labels[i] = UNTOUCHED;
            }
        }
        guard_free(&arena);
    }
    arena = guard_make(need, 0);
}

static void test_arena_too_small(void)
{
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ARENA_SIZE,
                          roomseg_run(&config, &s.grid, labels, label_stride, &result,
                                      arena.memory, arena.size - 1));
    expect_result_zeroed(arena.size, 0);
    expect_labels(UNTOUCHED);
    expect_good_run();
}

static void test_too_many_regions(void)
{
    config.max_regions = 1;
    config.max_rooms = 1;
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS,
                          roomseg_run(&config, &s.grid, labels, label_stride, &result,
                                      arena.memory, arena.size));
    TEST_ASSERT_GREATER_THAN_UINT(config.max_regions, result.region_count);
    expect_result_zeroed(0, result.region_count);
    expect_labels(0);
    expect_good_run();
}

static void test_too_many_rooms(void)
{
    config.max_rooms = 1;
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ROOMS,
                          roomseg_run(&config, &s.grid, labels, label_stride, &result,
                                      arena.memory, arena.size));
    expect_result_zeroed(0, 0);
    expect_labels(0);
    expect_good_run();
}

static int cancel(void *user, roomseg_stage stage, unsigned permille)
{
    (void)user;
    (void)stage;
    (void)permille;
    return 1;
}

static void test_cancelled(void)
{
    config.progress = cancel;
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                          roomseg_run(&config, &s.grid, labels, label_stride, &result,
                                      arena.memory, arena.size));
    expect_result_zeroed(0, 0);
    expect_labels(0);
    expect_good_run();
}

/* A grid without a free cell is no failure, and needs no arena. */
static void test_nothing_free_is_no_failure(void)
{
    memset(s.memory, 255, (size_t)s.grid.stride * s.grid.height);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&config, &s.grid, labels, label_stride, &result,
                                                  NULL, 0));
    expect_result_zeroed(0, 0);
    expect_labels(0);
    guard_check_untouched(&arena);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_null_pointers);
    RUN_TEST(test_grid_size);
    RUN_TEST(test_strides);
    RUN_TEST(test_resolution);
    RUN_TEST(test_config);
    RUN_TEST(test_arena_misaligned);
    RUN_TEST(test_arena_too_small);
    RUN_TEST(test_too_many_regions);
    RUN_TEST(test_too_many_rooms);
    RUN_TEST(test_cancelled);
    RUN_TEST(test_nothing_free_is_no_failure);
    return UNITY_END();
}
