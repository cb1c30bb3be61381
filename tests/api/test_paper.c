/* The paper profile as a caller sees it: memory, progress, records. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "config_fields.h"
#include "guard.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

/* An integer constant expression: a file-scope array would not compile otherwise. */
static uint64_t static_arena[ROOMSEG_ARENA_SIZE_PAPER_DEFAULT(120, 90, 50) / 8];
static uint16_t static_labels[120 * 90];

static roomseg_config config;
static sketch s;

void setUp(void)
{
    config = roomseg_config_paper();
    memset(&s, 0, sizeof s);
}

void tearDown(void)
{
    sketch_free(&s);
}

static void test_the_config_is_the_documented_one(void)
{
    roomseg_config other = roomseg_config_default();
    TEST_ASSERT_EQUAL_PTR(ROOMSEG_PROFILE_PAPER, config.profile);
    TEST_ASSERT_NULL(config.align);
    TEST_ASSERT_EQUAL_UINT(51, config.free_max);
    TEST_ASSERT_EQUAL_UINT(96000, config.speck_mm2);
    TEST_ASSERT_EQUAL_UINT(0, config.clutter_mm);
    TEST_ASSERT_EQUAL_UINT(1000000, config.smallest_room_mm2);
    TEST_ASSERT_EQUAL_UINT(10, config.isolated_permille);
    TEST_ASSERT_EQUAL_UINT(120, config.dilation_mm);
    TEST_ASSERT_EQUAL_UINT(50, config.seed_obstacle_permille);
    TEST_ASSERT_EQUAL_UINT(3000, config.longest_border_mm);
    TEST_ASSERT_EQUAL_UINT(other.dilation_mm, config.dilation_mm);
    TEST_ASSERT_EQUAL_UINT(other.max_regions, config.max_regions);
    TEST_ASSERT_EQUAL_UINT(other.max_rooms, config.max_rooms);
}

static void test_the_config_for_homes(void)
{
    roomseg_config home = roomseg_config_paper_home();
    TEST_ASSERT_EQUAL_PTR(ROOMSEG_PROFILE_PAPER, home.profile);
    TEST_ASSERT_EQUAL_PTR(ROOMSEG_ALIGN_ON, home.align);
    TEST_ASSERT_EQUAL_UINT(4000000, home.speck_mm2);
    home.speck_mm2 = config.speck_mm2;
    for (size_t i = 0; i < config_field_count; i++) {
        const config_field *field = &config_fields[i];
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE((const char *)&config + field->offset,
                                         (const char *)&home + field->offset, field->size,
                                         field->name);
    }
    for (uint32_t mm = ROOMSEG_MIN_RESOLUTION_MM; mm <= ROOMSEG_MAX_RESOLUTION_MM; mm += 9) {
        size_t query;
        config = roomseg_config_paper_home();
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 300, 200, mm, &query));
        TEST_ASSERT_EQUAL_size_t(query, ROOMSEG_ARENA_SIZE_PAPER_HOME(300, 200, mm));
    }
}

/* A cupboard of 3.2 m2 in the middle of a room that would part it. */
static void test_furniture_parts_no_room_of_a_home(void)
{
    s = sketch_blank(220, 110, 255, 50);
    sketch_fill(&s, 10, 10, 200, 90, 0);
    sketch_fill(&s, 102, 14, 16, 80, 255);
    run apart = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, apart.result.room_count);
    run_free(&apart);
    config = roomseg_config_paper_home();
    run whole = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, whole.result.room_count);
    run_free(&whole);
}

/* ---- memory */

static void expect_equal(uint32_t width, uint32_t height, uint32_t resolution_mm)
{
    size_t small = ROOMSEG_PLAN_SMALL(config.speck_mm2, config.clutter_mm, resolution_mm);
    size_t macro = ROOMSEG_ARENA_SIZE_PAPER(width, height, small, config.max_regions,
                                            config.max_rooms);
    size_t query = 0;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_arena_size(&config, width, height, resolution_mm, &query));
    TEST_ASSERT_EQUAL_size_t(query, macro);
}

static void one_config(const roomseg_config *extreme, const char *field)
{
    (void)field;
    config = *extreme;
    config.profile = ROOMSEG_PROFILE_PAPER;
    expect_equal(1, 1, 20);
    expect_equal(300, 200, 50);
    expect_equal(4096, 4096, 200);
}

static void test_macro_and_query_agree(void)
{
    const uint32_t sides[] = {1, 2, 3, 7, 31, 100, 255, 500, 2000, 4097, 16384, 65533};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            if ((uint64_t)sides[i] * sides[k] <= ROOMSEG_MAX_CROP_CELLS) {
                expect_equal(sides[i], sides[k], 40);
            }
        }
    }
    for (uint32_t regions = 1; regions <= 4096; regions = regions * 2 + 1) {
        config.max_regions = regions;
        config.max_rooms = (regions + 2) / 3;
        expect_equal(37, 900, 50);
        expect_equal(3, 5, 100);
    }
    config_each_extreme(one_config);
}

static void test_six_bytes_a_cell(void)
{
    size_t bytes;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 400, 300, 40, &bytes));
    TEST_ASSERT_LESS_THAN_size_t(6u * 400u * 300u, bytes);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, 2000, 2000, 40, &bytes));
    TEST_ASSERT_LESS_THAN_size_t(17u * 1000u * 1000u, bytes);
}

static void test_a_static_arena(void)
{
    roomseg_result result;
    s = sketch_blank(120, 90, 0, 50);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&config, &s.grid, static_labels, 120, &result,
                                                  static_arena, sizeof static_arena));
    TEST_ASSERT_EQUAL_UINT(1, result.room_count);
    TEST_ASSERT_EQUAL_size_t(sizeof static_arena, result.arena_used);
}

/* Every size below the need is refused; at the need nothing outside is written, and the same
 * comes out whatever the arena held before. */
static void test_an_arena_that_is_too_small(void)
{
    config.max_regions = 64;
    config.max_rooms = 16;
    s = sketch_rooms(2, 2, 40, 10, 50);
    run expected = run_unchecked(&config, &s.grid);
    guard arena = guard_make(expected.arena_size, 0);
    run again = expected;
    again.labels = malloc((size_t)s.grid.width * s.grid.height * sizeof *again.labels);
    for (size_t size = 0; size < expected.arena_size; size += 1 + size / 97) {
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ARENA_SIZE,
                              roomseg_run(&config, &s.grid, again.labels, s.grid.width,
                                          &again.result, arena.memory, size));
    }
    guard_check_untouched(&arena);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_run(&config, &s.grid, again.labels, s.grid.width, &again.result,
                                      arena.memory, expected.arena_size));
    guard_check(&arena);
    run_assert_same(&expected, &again);
    free(again.labels);
    guard_free(&arena);
    run_free(&expected);
}

static void test_too_many_regions_and_rooms(void)
{
    roomseg_result result;
    s = sketch_rooms(3, 2, 40, 10, 50);
    run r = run_unchecked(&config, &s.grid);
    config.max_regions = r.result.region_count - 1;
    config.max_rooms = 1;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS,
                          roomseg_run(&config, &s.grid, r.labels, s.grid.width, &result, r.arena,
                                      r.arena_size));
    config.max_regions = r.result.region_count;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ROOMS,
                          roomseg_run(&config, &s.grid, r.labels, s.grid.width, &result, r.arena,
                                      r.arena_size));
    TEST_ASSERT_EACH_EQUAL_UINT16(0, r.labels, (size_t)s.grid.width * s.grid.height);
    run_free(&r);
}

/* ---- progress */

typedef struct witness {
    uint32_t calls, stop_at;
    int stage;
    unsigned permille, stages_seen;
} witness;

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    witness *w = user;
    TEST_ASSERT_LESS_OR_EQUAL_UINT(1000, permille);
    TEST_ASSERT_TRUE((int)stage > w->stage || ((int)stage == w->stage && permille >= w->permille));
    w->stage = (int)stage;
    w->permille = permille;
    w->stages_seen |= 1u << stage;
    return w->calls++ == w->stop_at;
}

static void test_progress_and_cancelling(void)
{
    witness seen = {0, UINT32_MAX, -1, 0, 0};
    unsigned not_run = 1u << ROOMSEG_STAGE_ALIGN | 1u << ROOMSEG_STAGE_TURN_BACK;
    s = sketch_rooms(5, 4, 60, 14, 50);
    config.progress = hook;
    config.progress_user = &seen;
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_HEX(((1u << ROOMSEG_STAGE_COUNT) - 1u) & ~not_run, seen.stages_seen);
    uint32_t calls = seen.calls;
    TEST_ASSERT_GREATER_THAN_UINT(12, calls);
    for (uint32_t stop = 0; stop < calls; stop++) {
        roomseg_result result;
        seen = (witness){0, stop, -1, 0, 0};
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                              roomseg_run(&config, &s.grid, r.labels, s.grid.width, &result,
                                          r.arena, r.arena_size));
        TEST_ASSERT_EQUAL_UINT(stop + 1, seen.calls);
        TEST_ASSERT_EACH_EQUAL_UINT16(0, r.labels, (size_t)s.grid.width * s.grid.height);
    }
    run_free(&r);
}

/* ---- rooms */

static bool touches(const run *r, uint16_t label, uint32_t x, uint32_t y)
{
    for (uint32_t k = 0; k < 9; k++) {
        uint32_t nx = x + k % 3 - 1, ny = y + k / 3 - 1;
        if (nx < r->grid.width && ny < r->grid.height && run_label(r, nx, ny) == label) {
            return true;
        }
    }
    return false;
}

/* A doorway lies on a cell without label that both rooms touch; links and doorways agree. */
static void check_openings(const run *r)
{
    uint32_t links = 0;
    for (uint32_t d = 0; d < r->result.doorway_count; d++) {
        const roomseg_doorway *door = &r->result.doorways[d];
        TEST_ASSERT_TRUE(door->room_a < door->room_b);
        TEST_ASSERT_EQUAL_UINT16(0, run_label(r, door->x, door->y));
        TEST_ASSERT_TRUE(touches(r, door->room_a, door->x, door->y));
        TEST_ASSERT_TRUE(touches(r, door->room_b, door->x, door->y));
        TEST_ASSERT_GREATER_THAN_UINT(0, door->border_cells);
        TEST_ASSERT_GREATER_THAN_UINT(0, door->width_mm);
    }
    for (uint32_t i = 0; i < r->result.room_count; i++) {
        const roomseg_room *room = &r->result.rooms[i];
        for (uint32_t k = 0; k < room->link_count; k++) {
            const roomseg_doorway *door =
                &r->result.doorways[r->result.links[room->link_first + k]];
            TEST_ASSERT_TRUE(door->room_a == room->label || door->room_b == room->label);
        }
        links += room->link_count;
    }
    TEST_ASSERT_EQUAL_UINT(2 * r->result.doorway_count, links);
}

static void check_obstacles(const run *r)
{
    for (uint32_t y = 0; y < r->grid.height; y++) {
        for (uint32_t x = 0; x < r->grid.width; x++) {
            if (r->grid.cells[(size_t)y * r->grid.stride + x] >= r->config.occupied_min) {
                TEST_ASSERT_EQUAL_UINT16(0, run_label(r, x, y));
            }
            TEST_ASSERT_LESS_OR_EQUAL_UINT16(r->result.room_count, run_label(r, x, y));
        }
    }
}

static run run_and_check(void)
{
    run r = run_unchecked(&config, &s.grid);
    check_rooms(&r, NULL);
    check_openings(&r);
    check_obstacles(&r);
    return r;
}

/* Six rooms of 60 cells with doors of 14 between all neighbours, at every resolution. */
static void test_a_plan_of_rooms(void)
{
    const uint32_t resolutions[] = {30, 40, 50, 63, 80};
    for (size_t i = 0; i < sizeof resolutions / sizeof *resolutions; i++) {
        uint32_t side = 3000 / resolutions[i], door = 700 / resolutions[i];
        sketch_free(&s);
        s = sketch_rooms(3, 2, side, door, resolutions[i]);
        run r = run_and_check();
        TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(7, r.result.doorway_count);
        for (uint32_t d = 0; d < 7; d++) {
            TEST_ASSERT_UINT_WITHIN(150, 700, r.result.doorways[d].width_mm);
        }
        run_free(&r);
    }
}

/* Two rooms whose opening is longer than L0 are one. */
static void test_a_wide_opening(void)
{
    s = sketch_rooms(2, 1, 150, 100, 40);
    run r = run_and_check();
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    run_free(&r);
    config.longest_border_mm = 5000;
    r = run_and_check();
    TEST_ASSERT_EQUAL_UINT(r.result.region_count, r.result.room_count);
    run_free(&r);
}

static void test_small_and_empty_grids(void)
{
    for (uint32_t side = 1; side < 30; side++) {
        const uint8_t values[] = {0, 127, 255};
        for (int k = 0; k < 3; k++) {
            sketch_free(&s);
            s = sketch_blank(side, 30 - side, values[k], 20 + 6 * side);
            run r = run_and_check();
            TEST_ASSERT_LESS_OR_EQUAL_UINT(1, r.result.room_count);
            run_free(&r);
        }
    }
}

/* In a wide space the blur leaves a pillar's own cells as if they were free. None of them is a
 * seed all the same: a seed there would stand on the background's label. */
static void test_a_pillar_in_a_hall(void)
{
    config.speck_mm2 = 0;
    config.max_regions = 4;
    config.max_rooms = 4;
    for (uint32_t grown = 0; grown <= 40; grown += 40) {
        config.dilation_mm = grown;
        config.seed_obstacle_permille = 400;
        sketch_free(&s);
        s = sketch_blank(61, 53, 0, 40);
        sketch_fill(&s, 30, 26, 2, 2, 255);
        run r = run_and_check();
        TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
        run_free(&r);
    }
}

static void test_noise(void)
{
    static const uint8_t values[] = {0, 0, 0, 0, 0, 0, 51, 127, 203, 204, 255};
    uint32_t seed = 21;
    config.max_regions = 4096;
    config.smallest_room_mm2 = 100000;
    for (uint32_t round = 0; round < 60; round++) {
        sketch_free(&s);
        s = sketch_blank(20 + round * 3, 90 - round, 0, 20 + round * 3);
        for (uint32_t blobs = 0; blobs < 25; blobs++) {
            seed = seed * 1664525 + 1013904223;
            uint32_t x = (seed >> 8) % s.grid.width, y = (seed >> 16) % s.grid.height;
            uint32_t width = 1 + (seed >> 5) % 16, height = 1 + (seed >> 21) % 16;
            width = width < s.grid.width - x ? width : s.grid.width - x;
            height = height < s.grid.height - y ? height : s.grid.height - y;
            sketch_fill(&s, x, y, width, height, values[(seed >> 12) % sizeof values]);
        }
        run r = run_and_check();
        run_free(&r);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_config_is_the_documented_one);
    RUN_TEST(test_the_config_for_homes);
    RUN_TEST(test_furniture_parts_no_room_of_a_home);
    RUN_TEST(test_macro_and_query_agree);
    RUN_TEST(test_six_bytes_a_cell);
    RUN_TEST(test_a_static_arena);
    RUN_TEST(test_an_arena_that_is_too_small);
    RUN_TEST(test_too_many_regions_and_rooms);
    RUN_TEST(test_progress_and_cancelling);
    RUN_TEST(test_a_plan_of_rooms);
    RUN_TEST(test_a_wide_opening);
    RUN_TEST(test_small_and_empty_grids);
    RUN_TEST(test_a_pillar_in_a_hall);
    RUN_TEST(test_noise);
    return UNITY_END();
}
