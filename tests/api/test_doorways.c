/* Doorway records against doors that are drawn where they are. */
#include "fixture.h"
#include "unity.h"

#define SIDE 64u /* a room's edge, 3.2 m */

/* Widths come from distances in steps of 40 mm on both sides, and a middle that may lie half a
 * cell off. */
#define WIDTH_TOLERANCE_MM (2u * 40u + RESOLUTION_MM)

/* Two rooms side by side behind a wall of `thickness` cells, no door yet. */
static void draw_pair(uint32_t thickness)
{
    s = sketch_blank(2 * SIDE + thickness + 2, SIDE + 2, 255, RESOLUTION_MM);
    sketch_fill(&s, 1, 1, SIDE, SIDE, 0);
    sketch_fill(&s, 1 + SIDE + thickness, 1, SIDE, SIDE, 0);
}

/* Opens the wall from row y on. */
static void cut_door(uint32_t thickness, uint32_t y, uint32_t cells)
{
    sketch_fill(&s, 1 + SIDE, y, thickness, cells, 0);
}

/* Turns rows into columns. */
static void transpose(void)
{
    sketch turned = sketch_blank(s.grid.height, s.grid.width, 255, s.grid.resolution_mm);
    for (uint32_t y = 0; y < s.grid.height; y++) {
        for (uint32_t x = 0; x < s.grid.width; x++) {
            turned.memory[x * turned.grid.stride + y] = s.memory[y * s.grid.stride + x];
        }
    }
    sketch_free(&s);
    s = turned;
}

static void expect_within(uint32_t low, uint32_t high, uint32_t value)
{
    TEST_ASSERT_GREATER_OR_EQUAL_UINT32(low, value);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(high, value);
}

/* Doors from 0.25 m to 1.45 m, in thin and in thick walls, both ways round: one
 * record, in the opening, its width right to the steps of distances. */
static void test_a_door_is_found_where_it_is(void)
{
    for (uint32_t thickness = 1; thickness <= 9; thickness += 4) {
        for (uint32_t cells = 5; cells <= 29; cells += 3) {
            for (int turned = 0; turned < 2; turned++) {
                uint32_t y = 10 + cells / 3;
                draw_pair(thickness);
                cut_door(thickness, y, cells);
                if (turned) {
                    transpose();
                }
                r = run_checked(&config, &s.grid);
                TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
                TEST_ASSERT_EQUAL_UINT(1, r.result.doorway_count);
                const roomseg_doorway *d = r.result.doorways;
                TEST_ASSERT_UINT32_WITHIN(WIDTH_TOLERANCE_MM, cells * RESOLUTION_MM, d->width_mm);
                uint32_t across = turned ? d->y : d->x;
                uint32_t along = turned ? d->x : d->y;
                expect_within(SIDE, 1 + SIDE + thickness, across);
                expect_within(y + cells / 2 - 1, y + cells / 2 + 1, along);
                run_free(&r);
                sketch_free(&s);
            }
        }
    }
}

/* Of two openings between the same rooms the wider one is reported, wherever it is. */
static void test_the_widest_of_two_openings(void)
{
    config.speck_mm2 = 0; /* the wall between the openings is short, and yet a wall */
    for (int first_is_wide = 0; first_is_wide < 2; first_is_wide++) {
        uint32_t upper = first_is_wide ? 18 : 10;
        uint32_t lower = first_is_wide ? 10 : 18;
        draw_pair(2);
        cut_door(2, 8, upper);
        cut_door(2, 42, lower);
        r = run_checked(&config, &s.grid);
        TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
        TEST_ASSERT_EQUAL_UINT(1, r.result.doorway_count);
        const roomseg_doorway *d = r.result.doorways;
        TEST_ASSERT_UINT32_WITHIN(WIDTH_TOLERANCE_MM, 18 * RESOLUTION_MM, d->width_mm);
        if (first_is_wide) {
            expect_within(8, 25, d->y);
        } else {
            expect_within(42, 59, d->y);
        }
        TEST_ASSERT_EQUAL_UINT(28, d->border_cells);
        run_free(&r);
        sketch_free(&s);
    }
}

/* The same where each room consists of two regions, of which either has an opening. */
static void test_the_widest_of_two_openings_of_merged_regions(void)
{
    const char *const rows[] = {
        "#####################",
        "#.........#.........#",
        "#.........#.........#",
        "#...................#",
        "#...................#",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "##........#........##",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "#...................#",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "#.........#.........#",
        "#####################",
        NULL,
    };
    config.speck_mm2 = 0;
    for (int upside_down = 0; upside_down < 2; upside_down++) {
        s = sketch_make(rows, 8, 0, RESOLUTION_MM);
        if (upside_down) {
            for (uint32_t y = 0; y < s.grid.height; y++) {
                uint32_t row = (s.grid.height - 1 - y) / 8;
                for (uint32_t x = 0; x < s.grid.width; x++) {
                    s.memory[y * s.grid.stride + x] = rows[row][x / 8] == '#' ? 255 : 0;
                }
            }
        }
        r = run_checked(&config, &s.grid);
        TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
        TEST_ASSERT_GREATER_OR_EQUAL_UINT(4, r.result.region_count);
        const roomseg_doorway *d = r.result.doorways;
        TEST_ASSERT_EQUAL_UINT(1, r.result.doorway_count);
        TEST_ASSERT_UINT32_WITHIN(WIDTH_TOLERANCE_MM, 800, d->width_mm);
        TEST_ASSERT_EQUAL_UINT(24, d->border_cells);
        uint32_t upper = upside_down ? 16 * 8 : 3 * 8;
        expect_within(upper, upper + 15, d->y);
        run_free(&r);
        sketch_free(&s);
    }
}

/* Nine rooms in a square: twelve doors, and each room links to those around it. */
static void test_links_of_nine_rooms(void)
{
    s = sketch_rooms(3, 3, 60, 16, RESOLUTION_MM);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(9, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(12, r.result.doorway_count);
    const uint32_t expected[3][3] = {{2, 3, 2}, {3, 4, 3}, {2, 3, 2}};
    for (uint32_t row = 0; row < 3; row++) {
        for (uint32_t column = 0; column < 3; column++) {
            uint16_t label = run_label(&r, 30 + 61 * column, 30 + 61 * row);
            TEST_ASSERT_EQUAL_UINT(expected[row][column],
                                   r.result.rooms[label - 1].link_count);
        }
    }
    for (uint32_t i = 0; i < r.result.doorway_count; i++) {
        TEST_ASSERT_UINT32_WITHIN(WIDTH_TOLERANCE_MM, 16 * RESOLUTION_MM,
                                  r.result.doorways[i].width_mm);
    }
}

/* Rooms whose doors have been closed do not touch. */
static void test_no_door_no_record(void)
{
    draw_pair(1);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.rooms[0].link_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.rooms[1].link_count);
}

/* Free cells that touch at a corner only are no opening. */
static void test_a_corner_is_no_door(void)
{
    s = sketch_blank(2 * SIDE + 2, 2 * SIDE + 2, 255, RESOLUTION_MM);
    sketch_fill(&s, 1, 1, SIDE, SIDE, 0);
    sketch_fill(&s, 1 + SIDE, 1 + SIDE, SIDE, SIDE, 0);
    r = run_checked(&config, &s.grid);
    TEST_ASSERT_EQUAL_UINT(2, r.result.room_count);
    TEST_ASSERT_EQUAL_UINT(0, r.result.doorway_count);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_door_is_found_where_it_is);
    RUN_TEST(test_the_widest_of_two_openings);
    RUN_TEST(test_the_widest_of_two_openings_of_merged_regions);
    RUN_TEST(test_links_of_nine_rooms);
    RUN_TEST(test_no_door_no_record);
    RUN_TEST(test_a_corner_is_no_door);
    return UNITY_END();
}
