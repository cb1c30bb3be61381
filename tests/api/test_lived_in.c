/* Which regions become rooms where furniture stands about, and what tells such maps. One
 * character is 0.4 m; blocks of that thickness are no walls, being thicker than 350 mm. */
#include "fixture.h"
#include "unity.h"

enum { CELLS_PER_M = 1000 / RESOLUTION_MM };

/* A chair's leg, 2 x 2 cells, in the middle of a character: clutter by its size alone. */
static void put_leg(uint32_t column, uint32_t row)
{
    sketch_fill(&s, column * SCALE + 3, row * SCALE + 3, 2, 2, 255);
}

/* Runs the drawn map. */
static void expect_rooms(uint32_t count)
{
    run_free(&r);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(count, r.result.room_count);
}

/* The same when any clutter makes the map one that is lived in. */
static void expect_lived_in(uint32_t count)
{
    config.lived_in_permille = 0;
    expect_rooms(count);
}

/* Two rooms of 4.8 m with 2.8 m between them, 58 %, and no wall. */
static const char *const open_rows[] = {
    "############################",
    "#............##............#",
    "#............##............#",
    "#............##............#",
    "#..........................#",
    "#..........................#",
    "#..........................#",
    "#..........................#",
    "#..........................#",
    "#..........................#",
    "#..........................#",
    "#............##............#",
    "#............##............#",
    "############################",
    NULL,
};

static void test_rooms_without_a_wall_between_them(void)
{
    s = sketch_make(open_rows, SCALE, 0, RESOLUTION_MM);
    put_leg(3, 3);
    expect_lived_in(1);
    config.open_plan_percent = 70;
    config.passage_opening_percent = 70; /* the border is no door's, either */
    expect_lived_in(2);
}

/* 1 leg is 0.2 permille of this floor. */
static void test_clutter_tells_what_is_lived_in(void)
{
    s = sketch_make(open_rows, SCALE, 0, RESOLUTION_MM);
    config.lived_in_permille = 1;
    put_leg(3, 3);
    expect_rooms(2);
    for (uint32_t column = 2; column < 12; column += 2) {
        put_leg(column, 2);
        put_leg(column, 5);
    }
    expect_rooms(1);
    config.lived_in_permille = 1000;
    expect_rooms(2);
}

/* All cells of an obstacle count, from two in a row on: 1 permille of this floor is 19 cells. */
static void test_the_third_cell_of_a_row_counts(void)
{
    config.lived_in_permille = 1;
    for (uint32_t length = 2; length <= 3; length++) {
        sketch_free(&s);
        s = sketch_make(open_rows, SCALE, 0, RESOLUTION_MM);
        for (uint32_t i = 0; i < 8; i++) {
            sketch_fill(&s, (2 + i) * SCALE, 3 * SCALE, length, 1, 255);
        }
        expect_rooms(length == 2 ? 2 : 1);
    }
}

/* Single cells are noise: nobody lives by them. */
static void test_single_cells_are_no_clutter(void)
{
    s = sketch_make(open_rows, SCALE, 0, RESOLUTION_MM);
    for (uint32_t column = 2; column < 12; column++) {
        sketch_fill(&s, column * SCALE, 3 * SCALE, 1, 1, 255);
    }
    expect_lived_in(2);
}

/* Two rooms of 2.8 m behind one another, and a wall of 10 cm with an opening in its middle. */
static void draw_wall_with_opening(uint32_t opening_cells)
{
    static const char *const rows[] = {
        "########################",
        "#......................#",
        "#......................#",
        "#......................#",
        "#......................#",
        "#......................#",
        "#......................#",
        "#......................#",
        "########################",
        NULL,
    };
    uint32_t side = 7 * SCALE;
    sketch_free(&s);
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 12 * SCALE, SCALE, 2, side, 255);
    sketch_fill(&s, 12 * SCALE, SCALE + (side - opening_cells) / 2, 2, opening_cells, 0);
    put_leg(3, 3);
}

/* Wider than a door, with less wall than half of it. */
static void test_wide_openings_in_a_wall(void)
{
    draw_wall_with_opening(2 * CELLS_PER_M); /* 71 %, 0.8 m of wall */
    expect_lived_in(1);
    config.door_mm = 2200;
    expect_lived_in(2);
    config.door_mm = 950;
    config.passage_opening_percent = 80;
    expect_lived_in(2);
    config.passage_opening_percent = 41;
    config.shared_wall_mm = 3000;
    draw_wall_with_opening(8 * CELLS_PER_M / 5); /* 1.6 m, 1.2 m of wall: more than half */
    expect_lived_in(2);
}

/* 1.9 m2 behind a door that is wider than they are deep: a niche, but for its walls. */
static void test_a_door_parts_even_a_niche(void)
{
    static const char *const rows[] = {
        "################",
        "#..............#",
        "#..............#",
        "#..............#",
        "#..............#",
        "#..............#",
        "#..............#",
        "#..............#",
        "################",
        NULL,
    };
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 11 * SCALE, SCALE, 4 * SCALE, 7 * SCALE, 255);
    sketch_fill(&s, 11 * SCALE + 2, SCALE, 16, 6 * SCALE, 0); /* 2.4 m of wall, 10 cm thick ... */
    sketch_fill(&s, 11 * SCALE, 2 * SCALE + 6, 2, 19, 0);     /* ... with a door of 0.95 m */
    put_leg(3, 3);
    config.shared_wall_mm = 10000;
    expect_rooms(1);
    expect_lived_in(2);
    config.door_mm = 900;
    expect_lived_in(1);
}

/* A hall of 1.2 m with a cupboard in it that leaves 0.5 m, 42 %. */
static void draw_hall(void)
{
    static const char *const rows[] = {
        "########################",
        "########################",
        "#......................#",
        "#......................#",
        "#......................#",
        "########################",
        "########################",
        NULL,
    };
    sketch_free(&s);
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 11 * SCALE, 2 * SCALE, 2 * SCALE, 3 * SCALE - 10, 255);
    put_leg(5, 3);
}

static void test_a_hall_is_one_room(void)
{
    draw_hall();
    expect_lived_in(1);
    config.hall_mm = 1100;
    expect_lived_in(2);
    config.hall_mm = 1600;
    config.lived_in_permille = 1000;
    expect_rooms(2);
}

static void test_a_hall_in_any_direction(void)
{
    for (int degrees = 10; degrees < 90; degrees += 20) {
        draw_hall();
        sketch turned = sketch_turned(&s, degrees);
        sketch_free(&s);
        s = turned;
        config.hall_mm = 1600;
        expect_lived_in(1);
        config.hall_mm = 0;
        expect_lived_in(2);
    }
}

/* A door of 0.5 m in 0.7 m of wall is none of a hall's own. */
static void test_a_door_at_the_end_of_a_hall(void)
{
    draw_hall();
    sketch_fill(&s, 11 * SCALE, 2 * SCALE, 2 * SCALE, 3 * SCALE, 0);
    sketch_fill(&s, 11 * SCALE, 2 * SCALE, 2, 7, 255);
    sketch_fill(&s, 11 * SCALE, 2 * SCALE + 17, 2, 7, 255);
    expect_lived_in(2);
    sketch_fill(&s, 11 * SCALE, 2 * SCALE + 17, 2, 3, 0); /* 0.55 m of wall are a cupboard's */
    expect_lived_in(1);
}

/* A hall that opens on a room of 2.8 m between two jambs without a wall beside them. */
static void test_a_hall_does_not_join_a_room(void)
{
    static const char *const rows[] = {
        "##########################",
        "##################.......#",
        "##################.......#",
        "##################.......#",
        "#........................#",
        "#........................#",
        "#........................#",
        "##################.......#",
        "##################.......#",
        "##########################",
        NULL,
    };
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 17 * SCALE, 4 * SCALE, SCALE, 2, 255);
    sketch_fill(&s, 17 * SCALE, 7 * SCALE - 2, SCALE, 2, 255);
    put_leg(21, 5);
    expect_lived_in(2);
    config.hall_mm = 0;
    expect_lived_in(1);
    /* A bay that is as narrow, but short, does. */
    config.hall_mm = 1600;
    sketch_fill(&s, SCALE, SCALE, 12 * SCALE, 8 * SCALE, 255);
    expect_lived_in(1);
}

/* What was seen through a wide window has no walls, and joins nothing. */
static void test_a_fan_does_not_join_its_room(void)
{
    static const char *const rows[] = {
        "######################??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#?????...??",
        "#....................#???......?",
        "#..............................?",
        "#..............................?",
        "#..............................?",
        "#....................#???......?",
        "#....................#?????...??",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "#....................#??????????",
        "######################??????????",
        NULL,
    };
    s = sketch_make(rows, SCALE, 0, RESOLUTION_MM);
    sketch_fill(&s, 21 * SCALE, 8 * SCALE, 4 * SCALE, 5 * SCALE, 0); /* 2 m of window */
    put_leg(3, 3);
    expect_lived_in(1);
    TEST_ASSERT_EQUAL_UINT(0, at(28, 10));
    config.unwalled_percent = 0; /* then it is taken for a part of the room */
    expect_lived_in(1);
    TEST_ASSERT_EQUAL_UINT(1, at(28, 10));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_rooms_without_a_wall_between_them);
    RUN_TEST(test_clutter_tells_what_is_lived_in);
    RUN_TEST(test_the_third_cell_of_a_row_counts);
    RUN_TEST(test_single_cells_are_no_clutter);
    RUN_TEST(test_wide_openings_in_a_wall);
    RUN_TEST(test_a_door_parts_even_a_niche);
    RUN_TEST(test_a_hall_is_one_room);
    RUN_TEST(test_a_hall_in_any_direction);
    RUN_TEST(test_a_door_at_the_end_of_a_hall);
    RUN_TEST(test_a_hall_does_not_join_a_room);
    RUN_TEST(test_a_fan_does_not_join_its_room);
    return UNITY_END();
}
