/* max_regions and max_rooms at what a map needs and one below; thin and large grids. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "fail.h"
#include "reference.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

static roomseg_config config;
static sketch s;

void setUp(void)
{
    config = roomseg_config_default();
    memset(&s, 0, sizeof s);
}

void tearDown(void)
{
    sketch_free(&s);
}

/* Runs in an arena for `config` and returns the status; labels must be all 0 on failure. */
static int try_run(roomseg_result *result)
{
    size_t cells = (size_t)s.grid.width * s.grid.height;
    size_t need;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, &s.grid, &need));
    void *arena = malloc(need);
    uint16_t *labels = malloc(cells * sizeof *labels);
    TEST_ASSERT_TRUE(arena != NULL && labels != NULL);
    memset(labels, 0xEE, cells * sizeof *labels);
    int rc = roomseg_run(&config, &s.grid, labels, s.grid.width, result, arena, need);
    if (rc != ROOMSEG_OK) {
        TEST_ASSERT_EACH_EQUAL_UINT16(0, labels, cells);
        TEST_ASSERT_EQUAL_UINT(0, result->room_count);
    }
    free(labels);
    free(arena);
    return rc;
}

static void test_rooms_at_the_limit(void)
{
    roomseg_result result;
    s = sketch_rooms(5, 4, 40, 10, 50);
    config.max_rooms = 20;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, try_run(&result));
    TEST_ASSERT_EQUAL_UINT(20, result.room_count);
    for (uint32_t rooms = 1; rooms < 20; rooms++) {
        config.max_rooms = rooms;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ROOMS, try_run(&result));
    }
}

static void test_regions_at_the_limit(void)
{
    roomseg_result result;
    s = sketch_rooms(5, 4, 40, 10, 50);
    run all = run_checked(&config, &s.grid);
    uint32_t regions = all.result.region_count;
    TEST_ASSERT_GREATER_OR_EQUAL_UINT(20, regions);
    config.max_rooms = 20;
    config.max_regions = regions;
    run exact = run_checked(&config, &s.grid);
    run_assert_same(&all, &exact);
    for (config.max_regions = 1; config.max_regions < regions; config.max_regions++) {
        config.max_rooms = config.max_regions < 20 ? config.max_regions : 20;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS, try_run(&result));
        TEST_ASSERT_GREATER_THAN_UINT(config.max_regions, result.region_count);
    }
    run_free(&exact);
    run_free(&all);
}

/* One region a character and every border that a plane allows: the graph's capacity, which
 * follows from max_regions, is always enough. */
static void test_dense_graphs_fit(void)
{
    const uint32_t sides[] = {2, 3, 4, 6, 10};
    config.smallest_room_mm2 = 0;
    config.isolated_permille = 0;
    config.room_opening_percent = 100;
    config.passage_opening_percent = 100;
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        for (uint32_t door = 1; door <= 3; door++) {
            config.max_regions = 1024;
            config.max_rooms = 255;
            s = sketch_rooms(sides[i], sides[i], 5, door, 200);
            run all = run_checked(&config, &s.grid);
            config.max_regions = all.result.region_count;
            config.max_rooms = all.result.room_count;
            run exact = run_checked(&config, &s.grid);
            run_assert_same(&all, &exact);
            run_free(&exact);
            run_free(&all);
            sketch_free(&s);
        }
    }
}

/* A chequered grid: half of the cells found a region each, twice as many as the flood queue
 * holds at once. */
static void test_more_peaks_than_the_queue_holds(void)
{
    enum { SIDE = 180, COUNT = SIDE * SIDE / 2 };
    config.smallest_room_mm2 = 0;
    config.isolated_permille = 0;
    config.unwalled_percent = 0;
    config.speck_mm2 = 0;
    config.clutter_mm = 0;
    config.max_regions = COUNT;
    config.max_rooms = COUNT;
    s = sketch_blank(SIDE, SIDE, 255, 100);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        s.memory[i] = (i % SIDE + i / SIDE) % 2 == 0 ? 0 : 255;
    }
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(COUNT, r.result.room_count);
    uint16_t next = 1;
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        TEST_ASSERT_EQUAL_UINT(s.memory[i] == 0 ? next++ : 0, r.labels[i]);
    }
    run_free(&r);
}

/* One corridor five cells wide in many bends: when its middle is flooded, a third of all cells
 * wait in the queue, more than it holds. */
static void test_more_cells_wait_than_the_queue_holds(void)
{
    enum { SIDE = 401 };
    config.speck_mm2 = 0;
    config.clutter_mm = 0;
    s = sketch_blank(SIDE, SIDE, 255, 100);
    for (uint32_t y = 1; y + 5 < SIDE; y += 6) {
        sketch_fill(&s, 1, y, SIDE - 2, 5, 0);
        if (y + 6 + 5 < SIDE) {
            sketch_fill(&s, y % 12 == 1 ? SIDE - 6 : 1, y + 5, 5, 1, 0);
        }
    }
    run r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    run_free(&r);
}

static void test_thin_grids(void)
{
    for (int turned = 0; turned < 2; turned++) {
        uint32_t width = turned ? 1 : ROOMSEG_MAX_SIDE;
        uint32_t height = turned ? ROOMSEG_MAX_SIDE : 1;
        s = sketch_blank(width, height, 0, 50);
        run r = run_checked(&config, &s.grid);
        TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(ROOMSEG_MAX_SIDE, r.result.rooms[0].area_cells);
        TEST_ASSERT_EQUAL_UINT(256u * (ROOMSEG_MAX_SIDE - 1u) / 2u,
                               turned ? r.result.rooms[0].centroid_y_q8
                                      : r.result.rooms[0].centroid_x_q8);
        run_free(&r);
        sketch_free(&s);
    }
}

/* The last column and row of the largest sides. */
static void test_the_far_corner(void)
{
    s = sketch_blank(ROOMSEG_MAX_SIDE, 70, 127, 50);
    sketch_fill(&s, ROOMSEG_MAX_SIDE - 50, 30, 50, 40, 0);
    run r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(ROOMSEG_MAX_SIDE - 1, r.result.rooms[0].max_x);
    TEST_ASSERT_EQUAL_UINT(69, r.result.rooms[0].max_y);
    TEST_ASSERT_EQUAL_UINT(ROOMSEG_MAX_SIDE - 50, r.result.crop_x);
    run_free(&r);
}

static void check_large(const run *r)
{
    uint8_t *kinds = reference_kinds(&r->config, &r->grid);
    check_labels(r, kinds);
    check_dropped(r, kinds);
    check_doorways(r, kinds);
    free(kinds);
}

/* 4096 x 4096 cells full of rooms. */
static void test_a_large_grid_of_rooms(void)
{
    config.max_regions = 4096;
    config.max_rooms = 1024;
    config.unwalled_percent = 0; /* what lies beyond the grid is not known to be wall */
    s = sketch_rooms(32, 32, 127, 20, 50);
    TEST_ASSERT_EQUAL_UINT(4097, s.grid.width);
    s.grid.width = s.grid.height = 4096; /* without the last wall: the grid's edge is one */
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1024, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(2 * 32 * 31, r.result.doorway_count);
    check_large(&r);
    run_free(&r);
}

/* 4096 x 4096 free cells: distances beyond the largest that is stored. */
static void test_a_large_grid_without_walls(void)
{
    s = sketch_blank(4096, 4096, 0, 50);
    run r = run_unchecked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(4096u * 4096u, r.result.rooms[0].area_cells);
    TEST_ASSERT_EQUAL_UINT(4096u * 4096u / 4u * 100u, r.result.rooms[0].area_cm2);
    TEST_ASSERT_EQUAL_UINT(256u * 4095u / 2u, r.result.rooms[0].centroid_x_q8);
    TEST_ASSERT_EACH_EQUAL_UINT16(1, r.labels, 4096u * 4096u);
    run_free(&r);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_rooms_at_the_limit);
    RUN_TEST(test_regions_at_the_limit);
    RUN_TEST(test_dense_graphs_fit);
    RUN_TEST(test_more_peaks_than_the_queue_holds);
    RUN_TEST(test_more_cells_wait_than_the_queue_holds);
    RUN_TEST(test_thin_grids);
    RUN_TEST(test_the_far_corner);
    RUN_TEST(test_a_large_grid_of_rooms);
    RUN_TEST(test_a_large_grid_without_walls);
    return UNITY_END();
}
