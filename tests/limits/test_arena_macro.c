/* ROOMSEG_ARENA_SIZE at compile time, roomseg_arena_size at run time and what a run uses are
 * the same number. */
#include <string.h>

#include "config_fields.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

/* Integer constant expressions: file-scope arrays would not compile otherwise. */
static uint64_t roomy_arena[ROOMSEG_ARENA_SIZE_DEFAULT(120, 90, 50) / 8];
static uint64_t tight_arena[ROOMSEG_ARENA_SIZE(61, 61, ROOMSEG_PLAN_SMALL(0, 0, 50), 8, 4) / 8];
static uint16_t labels[122 * 92];

static roomseg_config config;

void setUp(void)
{
    config = roomseg_config_default();
}

void tearDown(void)
{
}

static void expect_equal(uint32_t width, uint32_t height, uint32_t resolution_mm)
{
    size_t small = ROOMSEG_PLAN_SMALL(config.speck_mm2, config.clutter_mm, resolution_mm);
    size_t macro = ROOMSEG_ARENA_SIZE(width, height, small, config.max_regions, config.max_rooms);
    size_t query = 0;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_arena_size(&config, width, height, resolution_mm, &query));
    TEST_ASSERT_EQUAL_size_t(query, macro);
    TEST_ASSERT_EQUAL_size_t(0, macro % ROOMSEG_ARENA_ALIGN);
}

/* A static arena holds exactly the size, and serves a map of the size it is made for. */
static void run_in_static_arena(uint32_t width, uint32_t height, void *arena, size_t size)
{
    size_t query;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, width, height, 50, &query));
    TEST_ASSERT_EQUAL_size_t(query, size);
    sketch s = sketch_blank(width + 2, height + 2, 255, 50);
    sketch_fill(&s, 1, 1, width, height, 0);
    roomseg_result result;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&config, &s.grid, labels, s.grid.width,
                                                  &result, arena, size));
    TEST_ASSERT_EQUAL_UINT(1, result.room_count);
    sketch_free(&s);
}

static void test_constant_expressions(void)
{
    run_in_static_arena(120, 90, roomy_arena, sizeof roomy_arena);
    config.speck_mm2 = 0;
    config.clutter_mm = 0;
    config.max_regions = 8;
    config.max_rooms = 4;
    run_in_static_arena(61, 61, tight_arena, sizeof tight_arena);
}

static void test_widths_and_heights(void)
{
    const uint32_t sides[] = {1,   2,   3,    4,    5,    7,    8,     31,
                              64,  100, 255,  256,  500,  1001, 2000,  4096,
                              4097, 10007, 16384, 65532, 65533};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            if ((uint64_t)sides[i] * sides[k] <= ROOMSEG_MAX_CROP_CELLS) {
                expect_equal(sides[i], sides[k], 50);
            }
        }
    }
}

static void test_resolutions(void)
{
    for (uint32_t mm = ROOMSEG_MIN_RESOLUTION_MM; mm <= ROOMSEG_MAX_RESOLUTION_MM; mm++) {
        expect_equal(300, 200, mm);
        expect_equal(10, 10, mm);
    }
}

static void test_default_macro(void)
{
    for (uint32_t side = 1; side <= 4096; side = side * 3 + 1) {
        size_t query;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, side, side, 40, &query));
        TEST_ASSERT_EQUAL_size_t(query, ROOMSEG_ARENA_SIZE_DEFAULT(side, side, 40));
    }
}

static void one_config(const roomseg_config *extreme, const char *field)
{
    (void)field;
    config = *extreme;
    expect_equal(1, 1, 20);
    expect_equal(300, 200, 50);
    expect_equal(4096, 4096, 200);
}

static void test_each_field_at_its_ends(void)
{
    config_each_extreme(one_config);
}

static void test_capacities(void)
{
    for (uint32_t regions = 1; regions <= 4096; regions = regions * 2 + 1) {
        for (uint32_t rooms = 1; rooms <= regions; rooms = rooms * 3 + 1) {
            config.max_regions = regions;
            config.max_rooms = rooms;
            expect_equal(37, 900, 50);
            expect_equal(3, 5, 100);
        }
    }
}

/* What ROOMSEG_ARENA_SIZE_USUAL is for: a config of the usual capacities, which are in range. */
static void test_usual_capacities(void)
{
    for (uint32_t side = 1; side <= 16384; side = side * 3 + 1) {
        for (uint32_t mm = ROOMSEG_MIN_RESOLUTION_MM; mm <= ROOMSEG_MAX_RESOLUTION_MM; mm += 30) {
            size_t query;
            config.max_regions = ROOMSEG_USUAL_REGIONS(side, side, mm);
            config.max_rooms = ROOMSEG_USUAL_ROOMS(side, side, mm);
            TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, side, side, mm, &query));
            TEST_ASSERT_EQUAL_size_t(query, ROOMSEG_ARENA_SIZE_USUAL(side, side, mm));
        }
    }
}

/* A run needs what the macro says for its crop. */
static void test_a_run_uses_that_much(void)
{
    for (uint32_t rooms = 1; rooms <= 5; rooms++) {
        sketch s = sketch_rooms(rooms, 2, 33, 8, 100);
        run r = run_unchecked(&config, &s.grid);
        TEST_ASSERT_EQUAL_size_t(
            ROOMSEG_ARENA_SIZE_DEFAULT(s.grid.width - 2, s.grid.height - 2, 100),
            r.result.arena_used);
        run_free(&r);
        sketch_free(&s);
    }
}

/* The formula in README.md, right to 1 %. */
static void test_the_readme_formula(void)
{
    const uint32_t sides[] = {1, 50, 128, 300, 700, 1500, 4096};
    const uint32_t regions[] = {64, 256, 1024, 4096};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (size_t k = 0; k < sizeof regions / sizeof *regions; k++) {
            config.max_regions = regions[k];
            config.max_rooms = regions[k] / 4;
            size_t exact;
            TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                                  roomseg_arena_size(&config, sides[i], sides[i], 50, &exact));
            double cells = (sides[i] + 2.0) * (sides[i] + 2.0);
            double by_graph = cells + 105.0 * config.max_regions + 4.0 * sides[i];
            double by_runs = cells + 30.0 * sides[i] + 3700.0;
            double by_ring = 1.125 * cells + 1000.0;
            double by_rooms = 128.0 * config.max_regions + 100.0 * config.max_rooms;
            double formula = by_graph > by_ring ? by_graph : by_ring;
            formula = formula > by_runs ? formula : by_runs;
            double by_shapes = 160.0 * config.max_regions;
            formula = formula > by_rooms ? formula : by_rooms;
            formula = formula > by_shapes ? formula : by_shapes;
            TEST_ASSERT_DOUBLE_WITHIN(0.01 * (double)exact, formula, (double)exact);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_constant_expressions);
    RUN_TEST(test_widths_and_heights);
    RUN_TEST(test_resolutions);
    RUN_TEST(test_default_macro);
    RUN_TEST(test_each_field_at_its_ends);
    RUN_TEST(test_capacities);
    RUN_TEST(test_usual_capacities);
    RUN_TEST(test_a_run_uses_that_much);
    RUN_TEST(test_the_readme_formula);
    return UNITY_END();
}
