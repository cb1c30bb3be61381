/* Which regions become rooms: small ones, niches, passages, what was seen through windows.
 * One character is 0.4 m. */
#include "fixture.h"
#include "unity.h"

/* 0.64 m2 never stand alone where there is a neighbour. */
static void test_a_niche_joins_its_neighbour(void)
{
    const char *const rows[] = {
        "############",
        "#......#####",
        "#......#...#",
        "#..........#",
        "#......#####",
        "#......#####",
        "############",
        NULL,
    };
    config.smallest_room_mm2 = 2000000;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, at(9, 2));
    run_free(&r);
    sketch_free(&s);
    config.smallest_room_mm2 = 100000;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
}

static void test_a_small_area_apart_is_dropped(void)
{
    const char *const rows[] = {
        "##############",
        "#..........###",
        "#..........#.#",
        "#..........#.#",
        "#..........###",
        "##############",
        NULL,
    };
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, at(12, 2));
    run_free(&r);
    sketch_free(&s);
    config.smallest_room_mm2 = 320000; /* exactly its area: not below */
    config.isolated_permille = 0;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(2, at(12, 2));
    run_free(&r);
    sketch_free(&s);
    config.smallest_room_mm2 = 320001;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    run_free(&r);
    sketch_free(&s);
    config.smallest_room_mm2 = 0;
    config.isolated_permille = 60; /* 2.5 of 42 characters would do */
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
}

/* What never becomes as large as a room is none, even in two connected pieces. */
static void test_two_tiny_pieces_are_no_room(void)
{
    const char *const rows[] = {
        "#########",
        "#...#...#",
        "#.......#",
        "#########",
        NULL,
    };
    config.smallest_room_mm2 = 3000000; /* all of it is 2.08 m2 */
    config.isolated_permille = 0;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(0, r.result.room_count);
    for (uint32_t column = 1; column < 8; column++) {
        TEST_ASSERT_EQUAL_UINT(0, at(column, 2));
    }
}

/* A room stands at exactly the smallest area, and joins its neighbour just below. */
static void test_the_smallest_room_is_exact(void)
{
    const char *const rows[] = {
        "####################",
        "#............#.....#",
        "#............#.....#",
        "#..................#",
        "#............#.....#",
        "#............#.....#",
        "####################",
        NULL,
    };
    config.smallest_room_mm2 = 0;
    config.niche_mm2 = 0;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    uint32_t area_mm2 = r.result.rooms[1].area_cells * RESOLUTION_MM * RESOLUTION_MM;
    config.smallest_room_mm2 = area_mm2;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    config.smallest_room_mm2 = area_mm2 + 1;
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
}

/* A corridor that narrows to half its width, with two rooms on either part. */
static const char *const passage_rows[] = {
    "##############################",
    "#......#......##......#......#",
    "#......#......##......#......#",
    "#......#......##......#......#",
    "#......#......##......#......#",
    "###..#####..########..####..##",
    "#............................#",
    "#.............##.............#",
    "#.............##.............#",
    "#.............##.............#",
    "##############################",
    NULL,
};

/* Two passages join at an opening that would part two rooms: each has the other and two rooms
 * for neighbours. */
static void test_passages_join_through_narrow_openings(void)
{
    config.passage_opening_percent = 20;
    segment(passage_rows);
    TEST_ASSERT_EQUAL_UINT(5, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(at(3, 8), at(26, 8));
    config.passage_min_neighbours = 4;
    segment(passage_rows);
    TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
    TEST_ASSERT_NOT_EQUAL_UINT(at(3, 8), at(26, 8));
    config.passage_min_neighbours = 3;
    config.passage_opening_percent = 60;
    segment(passage_rows);
    TEST_ASSERT_EQUAL_UINT(6, r.result.room_count);
}

/* One of them loses a room, and with it the standing of a passage. */
static void test_a_passage_needs_its_neighbours(void)
{
    config.passage_opening_percent = 20;
    s = sketch_make(passage_rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 26 * SCALE, 5 * SCALE, 2 * SCALE, SCALE, 255);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_NOT_EQUAL_UINT(at(3, 8), at(26, 8));
    run_free(&r);
    config.passage_min_neighbours = 2;
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(at(3, 8), at(26, 8));
}

/* A corridor of 1.6 m with a block of 0.8 m in it that leaves `opening` cells. */
static void draw_corridor(uint32_t opening)
{
    static const char *const rows[] = {
        "########################",
        "#......................#",
        "#......................#",
        "#......................#",
        "#......................#",
        "########################",
        NULL,
    };
    run_free(&r);
    sketch_free(&s);
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 11 * SCALE, SCALE, 2 * SCALE, 4 * SCALE - opening, 255);
}

/* Pieces of a corridor lie end to end, at an opening that would part two rooms by its width. */
static void test_pieces_of_a_corridor_join_end_to_end(void)
{
    draw_corridor(25); /* 78 % */
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    draw_corridor(24);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    draw_corridor(25); /* but not where a wall of 0.35 m is all that narrows it */
    sketch_fill(&s, 11 * SCALE, SCALE, 2 * SCALE, 4 * SCALE, 0);
    sketch_fill(&s, 12 * SCALE, SCALE, 2, 7, 255);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    draw_corridor(25); /* nor when the one is much wider than the other: 72 % of both is more */
    sketch_fill(&s, 13 * SCALE, 5 * SCALE, 10 * SCALE, SCALE - 1, 0);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
}

/* A room, and what its robot saw through a wide window: no walls there, only an end of sight. */
static const char *const window_rows[] = {
    "##############################??????????",
    "#.............#..............#??????????",
    "#.............#..............#??????????",
    "#.............#..............#??????????",
    "#............................#??????????",
    "#............................#?????...??",
    "#.............#..............#???......?",
    "#.............#........................?",
    "#.............#.........................",
    "#.............#........................?",
    "#.............#..............#???......?",
    "#.............#..............#?????...??",
    "#.............#..............#??????????",
    "#.............#..............#??????????",
    "#.............#..............#??????????",
    "#.............#..............#??????????",
    "#.............#..............#??????????",
    "##############################??????????",
    NULL,
};

static void test_what_was_seen_through_a_window_is_no_room(void)
{
    config.unwalled_percent = 0;
    segment(window_rows);
    TEST_ASSERT_EQUAL_UINT(3, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(3, at(34, 8));
    run_free(&r);
    sketch_free(&s);
    config.unwalled_percent = 50;
    segment(window_rows);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, r.result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(0, at(34, 8));
    TEST_ASSERT_EQUAL_UINT(1, at(20, 8));
}

/* A map that marks no walls at all loses nothing. */
static void test_a_map_without_walls_keeps_its_rooms(void)
{
    s = sketch_make(window_rows, SCALE, 0, RESOLUTION_MM);
    for (size_t i = 0; i < (size_t)s.grid.stride * s.grid.height; i++) {
        s.memory[i] = s.memory[i] == 255 ? 127 : s.memory[i];
    }
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(3, r.result.room_count);
}

/* Nor does a map on which little of the border is marked as wall. */
static void test_a_map_with_few_walls_keeps_its_rooms(void)
{
    s = sketch_make(window_rows, SCALE, 0, RESOLUTION_MM);
    for (uint32_t y = 3 * SCALE; y < s.grid.height; y++) {
        for (uint32_t x = 0; x < s.grid.width; x++) {
            uint8_t *cell = &s.memory[(size_t)y * s.grid.stride + x];
            *cell = *cell == 255 ? 127 : *cell;
        }
    }
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(3, r.result.room_count);
}

/* What hardly has walls is none up to a fifth of the map; what has few walls stays from a tenth on,
 * and so does an unwalled room beyond a fifth. */
static void test_a_large_unwalled_room_stays(void)
{
    s = sketch_make(window_rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 32 * SCALE, 2 * SCALE, 8 * SCALE, 14 * SCALE, 0);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(3, r.result.room_count);
    TEST_ASSERT_NOT_EQUAL_UINT(0, at(36, 8));
    run_free(&r);
    sketch_fill(&s, 37 * SCALE, 2 * SCALE, 3 * SCALE, 14 * SCALE, 127); /* 15 % are left */
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, at(36, 8));
    run_free(&r);
    sketch_fill(&s, 37 * SCALE, 2 * SCALE, SCALE, 14 * SCALE, 255); /* a wall at its far end */
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(3, r.result.room_count);
    TEST_ASSERT_NOT_EQUAL_UINT(0, at(36, 8));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_niche_joins_its_neighbour);
    RUN_TEST(test_a_small_area_apart_is_dropped);
    RUN_TEST(test_two_tiny_pieces_are_no_room);
    RUN_TEST(test_the_smallest_room_is_exact);
    RUN_TEST(test_passages_join_through_narrow_openings);
    RUN_TEST(test_a_passage_needs_its_neighbours);
    RUN_TEST(test_pieces_of_a_corridor_join_end_to_end);
    RUN_TEST(test_what_was_seen_through_a_window_is_no_room);
    RUN_TEST(test_a_map_without_walls_keeps_its_rooms);
    RUN_TEST(test_a_map_with_few_walls_keeps_its_rooms);
    RUN_TEST(test_a_large_unwalled_room_stays);
    return UNITY_END();
}
