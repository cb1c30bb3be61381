/* Small drawn maps and the rooms that they must give. One character is 0.4 m. */
#include "fixture.h"
#include "unity.h"

/* Room r of the result has about this area: `characters` of it, 5 % more or less. */
static void expect_area(uint16_t label, uint32_t characters)
{
    uint32_t cells = characters * SCALE * SCALE;
    TEST_ASSERT_TRUE(label >= 1 && label <= r.result.room_count);
    TEST_ASSERT_UINT32_WITHIN(cells / 20, cells, r.result.rooms[label - 1].area_cells);
}

static void test_one_room(void)
{
    const char *const rows[] = {
        "???????????",
        "?#########?",
        "?#.......#?",
        "?#.......#?",
        "?#.......#?",
        "?#.......#?",
        "?#########?",
        "???????????",
        NULL,
    };
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.doorway_count);
    const roomseg_room *room = r.result.rooms;
    TEST_ASSERT_EQUAL_UINT(28 * SCALE * SCALE, room->area_cells);
    TEST_ASSERT_EQUAL_UINT(28u * 1600u, room->area_cm2);
    TEST_ASSERT_EQUAL_UINT(2 * SCALE, room->min_x);
    TEST_ASSERT_EQUAL_UINT(9 * SCALE - 1, room->max_x);
    TEST_ASSERT_EQUAL_UINT(2 * SCALE, room->min_y);
    TEST_ASSERT_EQUAL_UINT(6 * SCALE - 1, room->max_y);
    TEST_ASSERT_EQUAL_UINT(256 * (2 * SCALE + 9 * SCALE - 1) / 2, room->centroid_x_q8);
    TEST_ASSERT_EQUAL_UINT(256 * (2 * SCALE + 6 * SCALE - 1) / 2, room->centroid_y_q8);
    /* Half of the shorter side, 1.6 m, to one cell. */
    TEST_ASSERT_UINT_WITHIN(RESOLUTION_MM, 800, room->inscribed_radius_mm);
}

static void test_two_rooms_and_a_door(void)
{
    const char *const rows[] = {
        "####################",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "#..................#",
        "#..................#",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "####################",
        NULL,
    };
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(1, r.result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(2, at(2, 2));
    TEST_ASSERT_EQUAL_UINT(1, at(17, 7));
    for (uint32_t row = 1; row <= 8; row++) {
        TEST_ASSERT_EQUAL_UINT(2, at(7, row));
        TEST_ASSERT_EQUAL_UINT(1, at(11, row));
    }
    expect_area(1, 72);
    expect_area(2, 64);
}

static void test_an_l_shape_is_one_room(void)
{
    const char *const rows[] = {
        "##################",
        "#........#########",
        "#........#########",
        "#........#########",
        "#........#########",
        "#................#",
        "#................#",
        "#................#",
        "#................#",
        "#................#",
        "#................#",
        "#................#",
        "##################",
        NULL,
    };
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT((4 * 8 + 7 * 16) * SCALE * SCALE, r.result.rooms[0].area_cells);
}

static void test_a_corridor_with_four_rooms(void)
{
    const char *const rows[] = {
        "####################",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "####..########..####",
        "#..................#",
        "#..................#",
        "#..................#",
        "####..########..####",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "#........#.........#",
        "####################",
        NULL,
    };
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(5, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(4, r.result.doorway_count);
    uint16_t corridor = at(10, 8);
    TEST_ASSERT_EQUAL_UINT(corridor, at(1, 8));
    TEST_ASSERT_EQUAL_UINT(corridor, at(18, 8));
    TEST_ASSERT_EQUAL_UINT(4, r.result.rooms[corridor - 1].link_count);
    /* Largest first: 54 characters and parts of the doors, 54, 48, 45, 40. */
    TEST_ASSERT_EQUAL_UINT(1, corridor);
    TEST_ASSERT_EQUAL_UINT(2, at(15, 13));
    TEST_ASSERT_EQUAL_UINT(3, at(3, 13));
    TEST_ASSERT_EQUAL_UINT(4, at(15, 3));
    TEST_ASSERT_EQUAL_UINT(5, at(3, 3));
    for (uint32_t i = 0; i < r.result.doorway_count; i++) {
        const roomseg_doorway *d = &r.result.doorways[i];
        TEST_ASSERT_TRUE(d->room_a == corridor || d->room_b == corridor);
    }
}

/* An opening nearly as wide as the rooms makes them one; the same plan with a door does not. */
static void test_a_wide_opening_joins(void)
{
    const char *const rows[] = {
        "#################",
        "#.......#.......#",
        "#...............#",
        "#...............#",
        "#...............#",
        "#...............#",
        "#...............#",
        "#...............#",
        "#...............#",
        "#################",
        NULL,
    };
    segment(rows);
    TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.doorway_count);
    run_free(&r);
    sketch_fill(&s, 8 * SCALE, 2 * SCALE, SCALE, 5 * SCALE, 255);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
}

static void test_four_rooms_apart_keep_reading_order(void)
{
    s = sketch_rooms(2, 2, 60, 0, RESOLUTION_MM);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(4, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(1, run_label(&r, 30, 30));
    TEST_ASSERT_EQUAL_UINT(2, run_label(&r, 90, 30));
    TEST_ASSERT_EQUAL_UINT(3, run_label(&r, 30, 90));
    TEST_ASSERT_EQUAL_UINT(4, run_label(&r, 90, 90));
}

/* The same flat at three resolutions gives the same rooms in the same order. */
static void test_the_resolution_does_not_matter(void)
{
    const char *const rows[] = {
        "########################",
        "#........#.............#",
        "#........#.............#",
        "#........#.............#",
        "#......................#",
        "#......................#",
        "#........#.............#",
        "####..####.............#",
        "#........#.............#",
        "#........#####..########",
        "#........#.............#",
        "#........#.............#",
        "#........#.............#",
        "########################",
        NULL,
    };
    const uint32_t scales[] = {4, 8, 16};
    for (uint32_t i = 0; i < 3; i++) {
        sketch drawn = sketch_make(rows, scales[i], 0, 400 / scales[i]);
        run other = run_checked(&config, &drawn.grid);
        TEST_ASSERT_EQUAL_UINT(4, other.result.room_count);
        TEST_ASSERT_EQUAL_UINT(3, other.result.doorway_count);
        const uint32_t middles[4][2] = {{16, 4}, {4, 3}, {4, 10}, {16, 11}};
        for (uint16_t label = 1; label <= 4; label++) {
            const uint32_t *middle = middles[label - 1];
            TEST_ASSERT_EQUAL_UINT(label, run_label(&other, middle[0] * scales[i],
                                                    middle[1] * scales[i]));
        }
        run_free(&other);
        sketch_free(&drawn);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_room);
    RUN_TEST(test_two_rooms_and_a_door);
    RUN_TEST(test_an_l_shape_is_one_room);
    RUN_TEST(test_a_corridor_with_four_rooms);
    RUN_TEST(test_a_wide_opening_joins);
    RUN_TEST(test_four_rooms_apart_keep_reading_order);
    RUN_TEST(test_the_resolution_does_not_matter);
    return UNITY_END();
}
