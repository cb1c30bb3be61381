/* The smallest grids, all of them; the largest; both profiles, with alignment and without. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

enum { CONFIGS = 4 };

void setUp(void)
{
}

void tearDown(void)
{
}

static roomseg_config config_at(int index)
{
    roomseg_config config = index % 2 == 0 ? roomseg_config_default() : roomseg_config_paper();
    config.align = index >= 2 ? ROOMSEG_ALIGN_ON : NULL;
    return config;
}

static void run_and_check(const roomseg_config *config, const roomseg_grid *grid)
{
    run r = run_unchecked(config, grid);
    if (config->profile == ROOMSEG_PROFILE_DEFAULT) {
        check_everything(&r);
    } else {
        check_rooms(&r, NULL);
        check_doorways(&r, NULL);
    }
    run_free(&r);
}

/* Every pattern of free and occupied cells on every grid of up to twelve cells. Nothing is too
 * small to be a room, nothing is noise. */
static void test_all_tiny_grids(void)
{
    for (uint32_t width = 1; width <= 4; width++) {
        for (uint32_t height = 1; height * width <= (width == 1 ? 5 : 12); height++) {
            for (uint32_t pattern = 0; pattern < 1u << width * height; pattern++) {
                uint8_t cells[12];
                for (uint32_t i = 0; i < width * height; i++) {
                    cells[i] = (pattern >> i & 1u) != 0 ? 255 : 0;
                }
                const roomseg_grid grid = {cells, width, height, width, 200};
                roomseg_config config = config_at((int)(pattern % CONFIGS));
                config.speck_mm2 = 0;
                config.clutter_mm = pattern % 3 * 400;
                config.smallest_room_mm2 = 0;
                config.isolated_permille = 0;
                config.unwalled_percent = 0;
                config.dilation_mm = 0;
                config.max_regions = 12;
                config.max_rooms = 12;
                run_and_check(&config, &grid);
            }
        }
    }
}

/* One value all over, at both ends of the resolution. */
static void test_grids_of_one_value(void)
{
    const uint8_t values[] = {0, 51, 52, 127, 203, 204, 255};
    const uint32_t sides[] = {1, 2, 3, 40};
    for (int c = 0; c < CONFIGS; c++) {
        const roomseg_config config = config_at(c);
        for (uint32_t k = 0; k < sizeof values * 16 * 2; k++) {
            uint8_t value = values[k % sizeof values];
            uint32_t shape = k / sizeof values % 16;
            sketch s = sketch_blank(sides[shape % 4], sides[shape / 4], value,
                                    k / sizeof values < 16 ? ROOMSEG_MIN_RESOLUTION_MM
                                                           : ROOMSEG_MAX_RESOLUTION_MM);
            run_and_check(&config, &s.grid);
            run r = run_unchecked(&config, &s.grid);
            TEST_ASSERT_EQUAL_UINT(value <= 51 ? s.grid.width : 0, r.result.crop_width);
            run_free(&r);
            sketch_free(&s);
        }
    }
}

/* Strips as long as a grid may be; alignment cannot turn them. */
static void test_the_longest_strips(void)
{
    for (int c = 0; c < CONFIGS; c++) {
        roomseg_config config = config_at(c);
        for (uint32_t thick = 1; thick <= 2; thick++) {
            for (int upright = 0; upright < 2; upright++) {
                uint32_t width = upright != 0 ? thick : ROOMSEG_MAX_SIDE;
                uint32_t height = upright != 0 ? ROOMSEG_MAX_SIDE : thick;
                sketch s = sketch_blank(width, height, 0, 20);
                size_t need;
                config.smallest_room_mm2 = 0;
                int status = roomseg_arena_size_for_grid(&config, &s.grid, &need);
                if (config.align != NULL) {
                    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE, status);
                    TEST_ASSERT_EQUAL_size_t(0, need);
                } else {
                    run r = run_unchecked(&config, &s.grid);
                    check_rooms(&r, NULL);
                    run_free(&r);
                }
                sketch_free(&s);
            }
        }
    }
}

/* Refused before a label is written or the arena looked at. */
static void expect_too_large(const roomseg_config *config, const roomseg_grid *grid)
{
    uint16_t label = 0xEEEE;
    uint64_t arena = 0;
    size_t need = 1;
    roomseg_result result;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE, roomseg_arena_size_for_grid(config, grid, &need));
    TEST_ASSERT_EQUAL_size_t(0, need);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_GRID_SIZE, roomseg_run(config, grid, &label, grid->width,
                                                             &result, &arena, sizeof arena));
    TEST_ASSERT_EQUAL_HEX16(0xEEEE, label);
}

static void test_crops_that_are_too_large(void)
{
    roomseg_config config = roomseg_config_default();
    uint32_t height = (uint32_t)(ROOMSEG_MAX_CROP_CELLS / ROOMSEG_MAX_SIDE) + 1;
    uint8_t *cells = calloc((size_t)ROOMSEG_MAX_SIDE * height, 1);
    TEST_ASSERT_NOT_NULL(cells);
    roomseg_grid grid = {cells, ROOMSEG_MAX_SIDE, height, ROOMSEG_MAX_SIDE, 50};
    expect_too_large(&config, &grid);
    grid.width = 30000;
    grid.height = 1;
    config.align = ROOMSEG_ALIGN_ON;
    expect_too_large(&config, &grid);
    free(cells);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_all_tiny_grids);
    RUN_TEST(test_grids_of_one_value);
    RUN_TEST(test_the_longest_strips);
    RUN_TEST(test_crops_that_are_too_large);
    return UNITY_END();
}
