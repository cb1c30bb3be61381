/* The progress hook: what it is told, and that it can stop a run wherever it is called. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

/* What a hook saw, and where it is to stop the run. */
typedef struct witness {
    uint32_t calls;
    uint32_t stop_at;   /* returns `answer` at this call, counted from 0; UINT32_MAX: never */
    int answer;
    int stage;          /* of the last call */
    unsigned permille;
    unsigned stages_seen; /* bit by stage */
    uint32_t stage_calls[ROOMSEG_STAGE_COUNT];
} witness;

/* Bit by stage. */
#define PAPER_STAGES (1u << ROOMSEG_STAGE_SEEDS | 1u << ROOMSEG_STAGE_RIDGE)
#define ALIGNMENT_STAGES (1u << ROOMSEG_STAGE_ALIGN | 1u << ROOMSEG_STAGE_TURN_BACK)
#define STAGES_WITHOUT_ALIGNMENT \
    (((1u << ROOMSEG_STAGE_COUNT) - 1u) & ~ALIGNMENT_STAGES & ~PAPER_STAGES)

static roomseg_config config;
static sketch s;
static witness seen;

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    witness *w = user;
    TEST_ASSERT_EQUAL_PTR(&seen, w);
    TEST_ASSERT_TRUE((int)stage >= 0 && (int)stage < ROOMSEG_STAGE_COUNT);
    TEST_ASSERT_LESS_OR_EQUAL_UINT(1000, permille);
    if ((int)stage == w->stage) {
        TEST_ASSERT_GREATER_OR_EQUAL_UINT(w->permille, permille);
    } else {
        TEST_ASSERT_GREATER_THAN_INT(w->stage, (int)stage);
        TEST_ASSERT_EQUAL_UINT(0, permille);
    }
    w->stage = (int)stage;
    w->permille = permille;
    w->stages_seen |= 1u << stage;
    w->stage_calls[stage]++;
    return w->calls++ == w->stop_at ? w->answer : 0;
}

void setUp(void)
{
    config = roomseg_config_default();
    config.progress = hook;
    config.progress_user = &seen;
    seen = (witness){0, UINT32_MAX, 0, -1, 0, 0, {0}};
}

void tearDown(void)
{
    sketch_free(&s);
}

static void test_stages_come_in_order(void)
{
    s = sketch_rooms(3, 2, 50, 12, 50);
    run r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_HEX(STAGES_WITHOUT_ALIGNMENT, seen.stages_seen);
    run_free(&r);
}

static void test_the_hook_changes_nothing(void)
{
    s = sketch_rooms(3, 2, 50, 12, 50);
    run with = run_checked(&config, &s.grid);
    config.progress = NULL;
    run without = run_checked(&config, &s.grid);
    run_assert_same(&with, &without);
    run_free(&with);
    run_free(&without);
}

/* Each of a million cells is visited at least once in all stages but the merging of regions. */
static void test_calls_grow_with_the_map(void)
{
    config.max_rooms = 256;
    s = sketch_rooms(16, 16, 62, 14, 50);
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(256, r.result.room_count);
    for (int stage = 0; stage < ROOMSEG_STAGE_COUNT; stage++) {
        bool by_cell = (STAGES_WITHOUT_ALIGNMENT >> stage & 1u) != 0 &&
                       stage != ROOMSEG_STAGE_MERGE;
        if (by_cell) {
            TEST_ASSERT_GREATER_OR_EQUAL_UINT_MESSAGE(1008 * 1008 / 65536,
                                                      seen.stage_calls[stage],
                                                      roomseg_stage_name(stage));
        }
    }
    run_free(&r);
}

static void expect_cancelled(uint32_t call, int answer, uint16_t *labels, const guard *arena)
{
    size_t cells = (size_t)s.grid.width * s.grid.height;
    roomseg_result result;
    seen = (witness){0, call, answer, -1, 0, 0, {0}};
    memset(labels, 0xEE, cells * sizeof *labels);
    memset(&result, 0xEE, sizeof result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                          roomseg_run(&config, &s.grid, labels, s.grid.width, &result,
                                      arena->memory, arena->size));
    TEST_ASSERT_EQUAL_UINT_MESSAGE(call + 1, seen.calls, "called again after it had cancelled");
    TEST_ASSERT_EACH_EQUAL_UINT16(0, labels, cells);
    TEST_ASSERT_EQUAL_UINT(0, result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, result.region_count);
    TEST_ASSERT_EQUAL_size_t(0, result.arena_used);
    TEST_ASSERT_NULL(result.rooms);
    guard_check(arena);
}

/* Stops at each call in turn, in one arena that is never prepared; then a whole run in the
 * same arena gives what a fresh one does. */
static void cancel_at_each_call(int answer)
{
    run fresh = run_unchecked(&config, &s.grid);
    uint32_t calls = seen.calls;
    TEST_ASSERT_GREATER_OR_EQUAL_UINT(ROOMSEG_STAGE_COUNT - 4, calls);
    guard arena = guard_make(fresh.arena_size, 0);
    run again = fresh;
    again.labels = malloc((size_t)s.grid.width * s.grid.height * sizeof *again.labels);
    TEST_ASSERT_NOT_NULL(again.labels);
    for (uint32_t call = 0; call < calls; call++) {
        expect_cancelled(call, answer, again.labels, &arena);
    }
    seen = (witness){0, UINT32_MAX, 0, -1, 0, 0, {0}};
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_run(&config, &s.grid, again.labels, s.grid.width,
                                      &again.result, arena.memory, arena.size));
    run_assert_same(&fresh, &again);
    guard_check(&arena);
    free(again.labels);
    guard_free(&arena);
    run_free(&fresh);
}

static void test_each_call_can_cancel(void)
{
    s = sketch_rooms(3, 2, 50, 12, 50);
    cancel_at_each_call(1);
}

/* Any value but 0; and on a map large enough for calls in the middle of stages. */
static void test_each_call_can_cancel_a_larger_run(void)
{
    s = sketch_rooms(6, 6, 80, 16, 50);
    cancel_at_each_call(-1);
}

/* A size query reads the whole grid, but it is no run: nobody is asked. */
static void test_the_size_query_does_not_call(void)
{
    size_t bytes;
    s = sketch_rooms(6, 6, 80, 16, 50);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &bytes));
    TEST_ASSERT_EQUAL_UINT(0, seen.calls);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_stages_come_in_order);
    RUN_TEST(test_the_hook_changes_nothing);
    RUN_TEST(test_calls_grow_with_the_map);
    RUN_TEST(test_each_call_can_cancel);
    RUN_TEST(test_each_call_can_cancel_a_larger_run);
    RUN_TEST(test_the_size_query_does_not_call);
    return UNITY_END();
}
