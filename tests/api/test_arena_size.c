/* roomseg_arena_size and roomseg_arena_size_for_grid: every documented failure. */
#include <string.h>

#include "config_fields.h"
#include "sketch.h"
#include "unity.h"

static roomseg_config config;
static size_t bytes;

void setUp(void)
{
    config = roomseg_config_default();
    bytes = 12345;
}

void tearDown(void)
{
}

/* Fails with the code and leaves *bytes 0. */
static void expect_size(int code, uint32_t width, uint32_t height, uint32_t resolution_mm)
{
    bytes = 12345;
    TEST_ASSERT_EQUAL_INT(code, roomseg_arena_size(&config, width, height, resolution_mm, &bytes));
    if (code == ROOMSEG_OK) {
        TEST_ASSERT_GREATER_THAN_size_t(0, bytes);
    } else {
        TEST_ASSERT_EQUAL_size_t(0, bytes);
    }
}

static void expect_grid(int code, const roomseg_grid *grid)
{
    bytes = 12345;
    TEST_ASSERT_EQUAL_INT(code, roomseg_arena_size_for_grid(&config, grid, &bytes));
    TEST_ASSERT_EQUAL_size_t(0, bytes);
}

static void test_size_null(void)
{
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL, roomseg_arena_size(NULL, 10, 10, 50, &bytes));
    TEST_ASSERT_EQUAL_size_t(0, bytes);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL, roomseg_arena_size(&config, 10, 10, 50, NULL));
}

static void test_size_grid_size(void)
{
    expect_size(ROOMSEG_ERR_GRID_SIZE, 0, 10, 50);
    expect_size(ROOMSEG_ERR_GRID_SIZE, 10, 0, 50);
    expect_size(ROOMSEG_ERR_GRID_SIZE, ROOMSEG_MAX_SIDE + 1, 1, 50);
    expect_size(ROOMSEG_ERR_GRID_SIZE, 1, ROOMSEG_MAX_SIDE + 1, 50);
    expect_size(ROOMSEG_ERR_GRID_SIZE, UINT32_MAX, UINT32_MAX, 50);
    expect_size(ROOMSEG_ERR_GRID_SIZE, 16385, 16384, 50);
    expect_size(ROOMSEG_ERR_GRID_SIZE, ROOMSEG_MAX_SIDE, ROOMSEG_MAX_SIDE, 50);
    expect_size(ROOMSEG_OK, 1, 1, 50);
    expect_size(ROOMSEG_OK, ROOMSEG_MAX_SIDE, 1, 50);
    expect_size(ROOMSEG_OK, 1, ROOMSEG_MAX_SIDE, 50);
    expect_size(ROOMSEG_OK, 16384, 16384, 50);
}

static void test_size_resolution(void)
{
    expect_size(ROOMSEG_ERR_RESOLUTION, 10, 10, 0);
    expect_size(ROOMSEG_ERR_RESOLUTION, 10, 10, ROOMSEG_MIN_RESOLUTION_MM - 1);
    expect_size(ROOMSEG_ERR_RESOLUTION, 10, 10, ROOMSEG_MAX_RESOLUTION_MM + 1);
    expect_size(ROOMSEG_ERR_RESOLUTION, 10, 10, UINT32_MAX);
    expect_size(ROOMSEG_OK, 10, 10, ROOMSEG_MIN_RESOLUTION_MM);
    expect_size(ROOMSEG_OK, 10, 10, ROOMSEG_MAX_RESOLUTION_MM);
}

static void invalid_for_size(const roomseg_config *invalid, const char *field)
{
    bytes = 12345;
    TEST_ASSERT_EQUAL_INT_MESSAGE(ROOMSEG_ERR_CONFIG,
                                  roomseg_arena_size(invalid, 10, 10, 50, &bytes), field);
    TEST_ASSERT_EQUAL_size_t(0, bytes);
}

static void extreme_for_size(const roomseg_config *extreme, const char *field)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(ROOMSEG_OK, roomseg_arena_size(extreme, 10, 10, 50, &bytes),
                                  field);
}

static void test_size_config(void)
{
    config_each_invalid(invalid_for_size);
    config_each_extreme(extreme_for_size);
}

/* max_rooms has two upper ends. */
static void test_size_more_rooms_than_regions(void)
{
    config.max_regions = 7;
    config.max_rooms = 7;
    expect_size(ROOMSEG_OK, 10, 10, 50);
    config.max_rooms = 8;
    expect_size(ROOMSEG_ERR_CONFIG, 10, 10, 50);
    config.max_regions = ROOMSEG_MAX_REGIONS;
    config.max_rooms = ROOMSEG_MAX_ROOMS;
    expect_size(ROOMSEG_OK, 10, 10, 50);
    config.max_rooms = ROOMSEG_MAX_ROOMS + 1;
    expect_size(ROOMSEG_ERR_CONFIG, 10, 10, 50);
}

static void test_grid_null(void)
{
    sketch s = sketch_blank(4, 4, 0, 50);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL, roomseg_arena_size_for_grid(NULL, &s.grid, &bytes));
    TEST_ASSERT_EQUAL_size_t(0, bytes);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_NULL, roomseg_arena_size_for_grid(&config, &s.grid, NULL));
    expect_grid(ROOMSEG_ERR_NULL, NULL);
    roomseg_grid grid = s.grid;
    grid.cells = NULL;
    expect_grid(ROOMSEG_ERR_NULL, &grid);
    sketch_free(&s);
}

static void test_grid_invalid(void)
{
    sketch s = sketch_blank(4, 4, 0, 50);
    roomseg_grid grid = s.grid;
    grid.width = 0;
    expect_grid(ROOMSEG_ERR_GRID_SIZE, &grid);
    grid = s.grid;
    grid.height = 0;
    expect_grid(ROOMSEG_ERR_GRID_SIZE, &grid);
    grid = s.grid;
    grid.width = grid.stride = ROOMSEG_MAX_SIDE + 1;
    expect_grid(ROOMSEG_ERR_GRID_SIZE, &grid);
    grid = s.grid;
    grid.height = ROOMSEG_MAX_SIDE + 1;
    expect_grid(ROOMSEG_ERR_GRID_SIZE, &grid);
    grid = s.grid;
    grid.stride = 3;
    expect_grid(ROOMSEG_ERR_STRIDE, &grid);
    grid.stride = 0;
    expect_grid(ROOMSEG_ERR_STRIDE, &grid);
    grid = s.grid;
    grid.resolution_mm = ROOMSEG_MIN_RESOLUTION_MM - 1;
    expect_grid(ROOMSEG_ERR_RESOLUTION, &grid);
    grid.resolution_mm = ROOMSEG_MAX_RESOLUTION_MM + 1;
    expect_grid(ROOMSEG_ERR_RESOLUTION, &grid);
    sketch_free(&s);
}

static void invalid_for_grid(const roomseg_config *invalid, const char *field)
{
    sketch s = sketch_blank(4, 4, 0, 50);
    bytes = 12345;
    TEST_ASSERT_EQUAL_INT_MESSAGE(ROOMSEG_ERR_CONFIG,
                                  roomseg_arena_size_for_grid(invalid, &s.grid, &bytes), field);
    TEST_ASSERT_EQUAL_size_t(0, bytes);
    sketch_free(&s);
}

static void test_grid_config(void)
{
    config_each_invalid(invalid_for_grid);
}

static void test_grid_without_a_free_cell_needs_nothing(void)
{
    const uint8_t values[] = {52, 127, 128, 255};
    for (size_t i = 0; i < sizeof values; i++) {
        sketch s = sketch_blank(9, 5, values[i], 50);
        bytes = 12345;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &bytes));
        TEST_ASSERT_EQUAL_size_t(0, bytes);
        sketch_free(&s);
    }
}

/* Only the box of the free cells is paid for, not the grid. */
static void test_grid_needs_what_its_crop_needs(void)
{
    sketch s = sketch_blank(600, 500, 127, 50);
    sketch_fill(&s, 17, 400, 30, 1, 0);
    sketch_fill(&s, 200, 380, 1, 90, 0);
    size_t expected;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_arena_size(&config, 200 - 17 + 1, 90, 50, &expected));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &bytes));
    TEST_ASSERT_EQUAL_size_t(expected, bytes);
    sketch_free(&s);
}

/* The threshold decides what is free. */
static void test_grid_looks_at_free_max(void)
{
    sketch s = sketch_blank(20, 20, 100, 50);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &bytes));
    TEST_ASSERT_EQUAL_size_t(0, bytes);
    config.free_max = 100;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &bytes));
    TEST_ASSERT_GREATER_THAN_size_t(400, bytes);
    sketch_free(&s);
}

/* What a box needs is enough for each smaller one: an arena for the largest map serves all. */
static void test_size_never_falls_as_the_map_grows(void)
{
    size_t before = 0;
    for (uint32_t side = 1; side < 400; side++) {
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, side, side, 50, &bytes));
        TEST_ASSERT_TRUE(bytes >= before);
        before = bytes;
        size_t wide;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                              roomseg_arena_size(&config, side + 1, side, 50, &wide));
        TEST_ASSERT_TRUE(wide >= bytes);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                              roomseg_arena_size(&config, side, side + 1, 50, &wide));
        TEST_ASSERT_TRUE(wide >= bytes);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_size_null);
    RUN_TEST(test_size_grid_size);
    RUN_TEST(test_size_resolution);
    RUN_TEST(test_size_config);
    RUN_TEST(test_size_more_rooms_than_regions);
    RUN_TEST(test_grid_null);
    RUN_TEST(test_grid_invalid);
    RUN_TEST(test_grid_config);
    RUN_TEST(test_grid_without_a_free_cell_needs_nothing);
    RUN_TEST(test_grid_needs_what_its_crop_needs);
    RUN_TEST(test_grid_looks_at_free_max);
    RUN_TEST(test_size_never_falls_as_the_map_grows);
    return UNITY_END();
}
