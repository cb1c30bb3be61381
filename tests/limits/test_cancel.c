/* Cancelling at every single call of the hook, with the library compiled so that it is called at
 * almost every visit (RS_TICK_VISITS in src/base.h): each run ends at that call with labels of 0
 * and an empty result, and the arena serves the next run. */
#include <stdlib.h>
#include <string.h>

#include "sketch.h"
#include "unity.h"

static roomseg_config config;
static sketch s;

typedef struct caller {
    uint32_t calls, stop_at;
} caller;

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    caller *c = user;
    TEST_ASSERT_TRUE(stage < ROOMSEG_STAGE_COUNT && permille <= 1000);
    return ++c->calls == c->stop_at;
}

void setUp(void)
{
    memset(&s, 0, sizeof s);
}

void tearDown(void)
{
    sketch_free(&s);
}

/* Rooms of 9 cells with doors of 3, and corridors without a free cell above and below; noise. */
static void draw(uint32_t columns, uint32_t rows)
{
    sketch plan = sketch_rooms(columns, rows, 9, 3, 100);
    s = sketch_blank(plan.grid.width + 4, plan.grid.height + 6, 255, 100);
    for (uint32_t y = 0; y < plan.grid.height; y++) {
        memcpy(s.memory + (size_t)(y + 3) * s.grid.stride + 2,
               plan.memory + (size_t)y * plan.grid.stride, plan.grid.width);
    }
    sketch_fill(&s, 7, 8, 1, 1, 255);
    sketch_fill(&s, 9, 11, 1, 1, 130);
    sketch_free(&plan);
}

static void cancel_every(uint32_t step)
{
    size_t cells = (size_t)s.grid.width * s.grid.height;
    size_t need = 0;
    caller c = {0, 0};
    roomseg_result result;
    const roomseg_result nothing = {0};
    config.progress = hook;
    config.progress_user = &c;
    config.max_regions = 200;
    config.max_rooms = 100;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &need));
    void *arena = malloc(need);
    uint16_t *wanted = malloc(cells * sizeof *wanted);
    uint16_t *labels = malloc(cells * sizeof *labels);
    TEST_ASSERT_TRUE(arena != NULL && wanted != NULL && labels != NULL);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&config, &s.grid, wanted, s.grid.width, &result,
                                                  arena, need));
    TEST_ASSERT_GREATER_THAN_UINT(0, result.room_count);
    uint32_t calls = c.calls;
    TEST_ASSERT_GREATER_THAN_UINT(500, calls);
    for (uint32_t stop = 1; stop <= calls; stop += step) {
        c = (caller){0, stop};
        memset(labels, 0xEE, cells * sizeof *labels);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                              roomseg_run(&config, &s.grid, labels, s.grid.width, &result, arena,
                                          need));
        TEST_ASSERT_EQUAL_UINT(stop, c.calls);
        TEST_ASSERT_EACH_EQUAL_UINT16(0, labels, cells);
        TEST_ASSERT_EQUAL_MEMORY(&nothing, &result, sizeof result);
    }
    c = (caller){0, 0};
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&config, &s.grid, labels, s.grid.width, &result,
                                                  arena, need));
    TEST_ASSERT_EQUAL_UINT(calls, c.calls);
    TEST_ASSERT_EQUAL_MEMORY(wanted, labels, cells * sizeof *labels);
    free(labels);
    free(wanted);
    free(arena);
}

static void turn(double degrees)
{
    sketch straight = s;
    s = sketch_turned(&straight, degrees);
    sketch_free(&straight);
}

static void test_default_profile(void)
{
    config = roomseg_config_default();
    config.smallest_room_mm2 = 300000;
    config.room_opening_percent = 60; /* some rooms merge */
    draw(5, 3);
    cancel_every(1);
}

static void test_default_profile_aligned(void)
{
    config = roomseg_config_default();
    config.align = ROOMSEG_ALIGN_ON;
    config.smallest_room_mm2 = 300000;
    draw(4, 3);
    turn(20.0);
    cancel_every(1);
}

static void test_paper_profile(void)
{
    config = roomseg_config_paper();
    config.smallest_room_mm2 = 300000;
    config.dilation_mm = 0;
    config.longest_border_mm = 100;
    draw(4, 3);
    cancel_every(1);
}

/* A hall wide enough for the blur to halve its grid. */
static void test_paper_profile_in_a_hall(void)
{
    config = roomseg_config_paper();
    s = sketch_blank(150, 120, 0, 40);
    sketch_fill(&s, 0, 60, 130, 2, 255);
    cancel_every(23);
}

/* Many small rooms, each absorbed by the next. */
static void test_many_small_rooms(void)
{
    config = roomseg_config_default();
    config.room_opening_percent = 100;
    config.open_plan_percent = 100;
    config.passage_opening_percent = 100;
    config.smallest_room_mm2 = 3000000;
    config.niche_mm2 = 0;
    s = sketch_rooms(6, 4, 9, 2, 100);
    cancel_every(1);
}

static void test_paper_profile_aligned(void)
{
    config = roomseg_config_paper();
    config.align = ROOMSEG_ALIGN_ON;
    config.smallest_room_mm2 = 300000;
    config.dilation_mm = 0;
    draw(4, 3);
    turn(20.0);
    cancel_every(1);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_default_profile);
    RUN_TEST(test_default_profile_aligned);
    RUN_TEST(test_paper_profile);
    RUN_TEST(test_paper_profile_in_a_hall);
    RUN_TEST(test_many_small_rooms);
    RUN_TEST(test_paper_profile_aligned);
    return UNITY_END();
}
