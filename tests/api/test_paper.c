/* The paper profile as a black box: its configuration, drawn maps, errors and noise. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "config_fields.h"
#include "fail.h"
#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

static const char *const flat[] = {
    "############################",
    "#...........#..............#",
    "#...........#..............#",
    "#...........#..............#",
    "#..........................#",
    "#..........................#",
    "#...........#..............#",
    "#...........#..............#",
    "#...........#..............#",
    "############################",
    NULL,
};

static roomseg_config config;
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
    config = roomseg_config_paper();
    memset(&s, 0, sizeof s);
    calls = 0;
    stop_at = UINT32_MAX;
    stages_seen = 0;
}

void tearDown(void)
{
    sketch_free(&s);
}

/* What holds for this profile too. */
static void check_run(const run *r)
{
    size_t cells = (size_t)r->grid.width * r->grid.height;
    for (size_t i = 0; i < cells; i++) {
        uint8_t value = r->grid.cells[i / r->grid.width * r->grid.stride + i % r->grid.width];
        if (r->labels[i] > r->result.room_count ||
            (r->labels[i] != 0 && value >= r->config.occupied_min)) {
            fail_with("cell %u of value %u carries label %u of %u", (unsigned)i, value,
                      r->labels[i], (unsigned)r->result.room_count);
        }
    }
    check_rooms(r, NULL);
    check_doorways(r, NULL);
}

static void test_the_config_is_the_documented_one(void)
{
    roomseg_config other = roomseg_config_default();
    TEST_ASSERT_EQUAL_PTR(ROOMSEG_PROFILE_PAPER, config.profile);
    TEST_ASSERT_EQUAL_UINT(0, config.clutter_mm);
    TEST_ASSERT_EQUAL_UINT(120, config.dilation_mm);
    TEST_ASSERT_EQUAL_UINT(50, config.seed_obstacle_permille);
    TEST_ASSERT_EQUAL_UINT(3000, config.longest_border_mm);
    TEST_ASSERT_TRUE(config.align == NULL);
    for (size_t i = 0; i < config_field_count; i++) {
        const unsigned char *mine = (const unsigned char *)&config + config_fields[i].offset;
        const unsigned char *its = (const unsigned char *)&other + config_fields[i].offset;
        if (strcmp(config_fields[i].name, "clutter_mm") != 0) {
            TEST_ASSERT_EQUAL_INT_MESSAGE(0, memcmp(mine, its, config_fields[i].size),
                                          config_fields[i].name);
        }
    }
}

static void test_two_rooms_and_a_door(void)
{
    s = sketch_make(flat, 10, 0, 40);
    run r = run_unchecked(&config, &s.grid);
    check_run(&r);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, r.result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(2, run_label(&r, 60, 50));
    TEST_ASSERT_EQUAL_UINT(1, run_label(&r, 200, 50));
    const roomseg_doorway *d = r.result.doorways;
    TEST_ASSERT_UINT_WITHIN(12, 125, d->x);
    TEST_ASSERT_UINT_WITHIN(12, 50, d->y);
    /* Rooms end beside the walls, not far from them. */
    TEST_ASSERT_GREATER_THAN_UINT(8u * 11u * 100u * 3u / 4u, r.result.rooms[1].area_cells);
    run_free(&r);
}

static void test_nothing_free_and_next_to_nothing(void)
{
    s = sketch_blank(40, 30, 127, 50);
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(0, r.result.room_count);
    run_free(&r);
    for (uint32_t side = 1; side <= 9; side++) {
        sketch_fill(&s, 3, 4, side, side, 0);
        r = run_unchecked(&config, &s.grid);
        TEST_ASSERT_EQUAL_UINT(0, r.result.room_count); /* 0.2 m2 at most */
        run_free(&r);
    }
}

static void test_turned(void)
{
    sketch straight = sketch_make(flat, 10, 0, 40);
    s = sketch_turned(&straight, 25);
    config.align = ROOMSEG_ALIGN_ON;
    run r = run_unchecked(&config, &s.grid);
    check_run(&r);
    TEST_ASSERT_INT_WITHIN(100, 2500, r.result.wall_angle);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    run_free(&r);
    sketch_free(&straight);
}

static void test_stages(void)
{
    s = sketch_make(flat, 10, 0, 40);
    config.progress = hook;
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_HEX(((1u << ROOMSEG_STAGE_COUNT) - 1u) & ~(1u << ROOMSEG_STAGE_ALIGN) &
                              ~(1u << ROOMSEG_STAGE_TURN_BACK),
                          stages_seen);
    run_free(&r);
}

static void test_each_call_can_cancel(void)
{
    s = sketch_make(flat, 10, 0, 40);
    config.progress = hook;
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
    s = sketch_make(flat, 10, 0, 40);
    run fresh = run_unchecked(&config, &s.grid);
    guard arena = guard_make(fresh.arena_size, 0);
    uint16_t *labels = calloc((size_t)s.grid.width * s.grid.height, sizeof *labels);
    TEST_ASSERT_NOT_NULL(labels);
    for (size_t i = 0; i < 256; i++) {
        size_t size = i < 128 ? fresh.arena_size / 128 * i : fresh.arena_size - 256 + i;
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
    const uint32_t sides[] = {1, 2, 3, 10, 57, 100, 333, 1000, 2047, 4096};
    const uint32_t capacities[] = {1, 64, 1024, 4096};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            for (size_t c = 0; c < sizeof capacities / sizeof *capacities; c++) {
                size_t query;
                config.max_regions = capacities[c];
                config.max_rooms = capacities[c] / 2 + 1;
                TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, sides[i],
                                                                     sides[k], 50, &query));
                TEST_ASSERT_EQUAL_size_t(
                    query, ROOMSEG_ARENA_SIZE_PAPER(
                               sides[i], sides[k],
                               ROOMSEG_PLAN_SMALL(config.speck_mm2, config.clutter_mm, 50),
                               config.max_regions, config.max_rooms));
            }
        }
    }
    config = roomseg_config_paper();
    size_t query;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 300, 200, 40, &query));
    TEST_ASSERT_EQUAL_size_t(query, ROOMSEG_ARENA_SIZE_PAPER_DEFAULT(300, 200, 40));
}

static void test_capacities(void)
{
    s = sketch_rooms(3, 2, 80, 20, 40);
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
    roomseg_result result;
    const roomseg_config tight[] = {config, config};
    const int codes[] = {ROOMSEG_ERR_ROOMS, ROOMSEG_ERR_REGIONS};
    for (int i = 0; i < 2; i++) {
        roomseg_config c = tight[i];
        c.max_rooms = 5;
        c.max_regions = i == 0 ? 1024 : 5;
        TEST_ASSERT_EQUAL_INT(codes[i], roomseg_run(&c, &s.grid, r.labels, s.grid.width, &result,
                                                    r.arena, r.arena_size));
        TEST_ASSERT_EACH_EQUAL_UINT16(0, r.labels, (size_t)s.grid.width * s.grid.height);
    }
    run_free(&r);
}

/* Random dots and blocks, guarded memory; whatever comes is consistent. */
static void test_noise(void)
{
    uint32_t state = 7;
    for (int round = 0; round < 150; round++) {
        uint32_t side = 20 + (uint32_t)round;
        config = roomseg_config_paper();
        config.smallest_room_mm2 = round % 3 == 0 ? 0 : 1000000;
        config.speck_mm2 = round % 2 == 0 ? 96000 : 0;
        config.align = round % 5 == 0 ? ROOMSEG_ALIGN_ON : NULL;
        s = sketch_blank(side, side + 9, 0, 20 + (uint32_t)round);
        for (uint32_t i = 0; i < side * (side + 9); i++) {
            state = state * 1664525u + 1013904223u;
            s.memory[i] = (state >> 24) % 64 < (uint32_t)round % 32 ? 255 : 0;
        }
        run r = {0};
        r.config = config;
        r.grid = s.grid;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                              roomseg_arena_size_for_grid(&config, &s.grid, &r.arena_size));
        guard arena = guard_make(r.arena_size, 0);
        guard labels = guard_make((size_t)side * (side + 9) * sizeof(uint16_t), 0);
        r.labels = (uint16_t *)labels.memory;
        int rc = roomseg_run(&config, &s.grid, r.labels, side, &r.result, arena.memory,
                             arena.size);
        guard_check(&arena);
        guard_check(&labels);
        if (rc == ROOMSEG_OK) {
            check_run(&r);
        } else {
            TEST_ASSERT_TRUE(rc == ROOMSEG_ERR_REGIONS || rc == ROOMSEG_ERR_ROOMS);
        }
        guard_free(&labels);
        guard_free(&arena);
        sketch_free(&s);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_config_is_the_documented_one);
    RUN_TEST(test_two_rooms_and_a_door);
    RUN_TEST(test_nothing_free_and_next_to_nothing);
    RUN_TEST(test_turned);
    RUN_TEST(test_stages);
    RUN_TEST(test_each_call_can_cancel);
    RUN_TEST(test_arena_below_the_need);
    RUN_TEST(test_macro_and_query_agree);
    RUN_TEST(test_capacities);
    RUN_TEST(test_noise);
    return UNITY_END();
}
