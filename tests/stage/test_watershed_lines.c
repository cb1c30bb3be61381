/* Flooding with lines between the basins. Markers are drawn with one character a cell: a
 * letter is a region, '#' the background, ' ' to be flooded; in results '*' is a line. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "flood.h"
#include "unity.h"
#include "watershed_lines.h"

/* heights: rows of digits, or NULL: flat. */
static void draw(const char *const *markers, const char *const *heights, uint32_t height)
{
    flood_prepare((uint32_t)strlen(markers[0]), height);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            *label_at(x, y) = flood_letter(markers[y][x]);
            if (heights != NULL) {
                surface[rs_frame_index(&frame, x, y)] = (uint8_t)(heights[y][x] - '0');
            }
        }
    }
}

static int flood(uint32_t blocks, rs_ticker *ticker)
{
    rs_queue queue;
    rs_queue_list *lists = stage_scratch(RS_QUEUE_LISTS, sizeof *lists);
    rs_queue_block *pool = stage_scratch(blocks + 1, sizeof *pool);
    rs_queue_init(&queue, lists, pool, blocks);
    int status = rs_watershed_lines_run(&frame, surface, &labels, &queue, ticker);
    free(lists);
    free(pool);
    return status;
}

static void check(const char *const *markers, const char *const *heights,
                  const char *const *wanted, uint32_t height)
{
    rs_ticker ticker = {0};
    draw(markers, heights, height);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, flood(2048, &ticker));
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            TEST_ASSERT_EQUAL_HEX16(flood_letter(wanted[y][x]), *label_at(x, y));
        }
    }
}

/* Where nothing is higher than anything else two basins meet half-way, with a line of one
 * cell between them. Heights keep the background out. */
static void test_half_way(void)
{
    const char *const markers[] = {"#############", "#a         b#", "#a         b#",
                                   "#a         b#", "#############"};
    const char *const heights[] = {"0000000000000", "0999999999990", "0000000000000",
                                   "0999999999990", "0000000000000"};
    const char *const wanted[] = {"#############", "#a*********b#", "#aaaaa*bbbbb#",
                                  "#a*********b#", "#############"};
    check(markers, heights, wanted, 5);
}

/* The line lies where the surface is highest, however far from the middle. */
static void test_the_line_follows_the_crest(void)
{
    const char *const closed[] = {"###########", "#a       b#", "#a       b#", "#a       b#",
                                  "###########"};
    const char *const steep[] = {"00000000000", "09999999990", "00000009000", "09999999990",
                                 "00000000000"};
    const char *const middle[] = {"###########", "#a*******b#", "#aaaaaa*bb#", "#a*******b#",
                                  "###########"};
    check(closed, steep, middle, 5);
}

/* What lies outside of the crop is background. The cell below the marker is settled before the
 * last row is. */
static void test_the_border_is_background(void)
{
    const char *const markers[] = {"     ", "     ", "  a  ", "     ", "     "};
    const char *const wanted[] = {"#####", "#***#", "#*a*#", "#*a*#", "#***#"};
    check(markers, NULL, wanted, 5);
}

/* A pit beyond a pass is flooded from its bottom, though the pass is higher. */
static void test_pits_fill_first(void)
{
    const char *const markers[] = {"###########", "#         #", "#a       b#", "#         #",
                                   "###########"};
    const char *const heights[] = {"99999999999", "99999999999", "01511111320", "99999999999",
                                   "99999999999"};
    rs_ticker ticker = {0};
    draw(markers, heights, 5);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, flood(512, &ticker));
    /* b passes its crest of 3 before a passes that of 5, and runs through the pit. */
    for (uint32_t x = 4; x < 8; x++) {
        TEST_ASSERT_EQUAL_UINT16(flood_letter('b'), *label_at(x, 2));
    }
    TEST_ASSERT_EQUAL_HEX16(RS_LINE, *label_at(2, 2));
}

static bool is_basin(uint16_t label)
{
    return label != RS_LINE;
}

/* What must hold for every result: no two basins touch, not even at a corner; a line cell has
 * two basins around it or is cut off; markers stay; every basin is 8-connected to its marker. */
static void check_lines(const uint16_t *markers)
{
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint16_t here = *label_at(x, y);
            bool placed = markers[(size_t)y * frame.width + x] != 0;
            TEST_ASSERT_TRUE(here != 0 && here != RS_WAITING);
            if (placed) {
                TEST_ASSERT_EQUAL_HEX16(markers[(size_t)y * frame.width + x], here);
            }
            for (uint32_t k = 0; k < 9; k++) {
                uint32_t nx = x + k % 3 - 1, ny = y + k / 3 - 1;
                if (nx >= frame.width || ny >= frame.height) {
                    continue;
                }
                uint16_t other = *label_at(nx, ny);
                bool both_placed = placed && markers[(size_t)ny * frame.width + nx] != 0;
                if (!both_placed && is_basin(here) && is_basin(other)) {
                    TEST_ASSERT_EQUAL_HEX16(here, other);
                }
            }
        }
    }
}

static uint16_t *draw_random(uint32_t width, uint32_t height, uint32_t *seed)
{
    uint16_t *markers = stage_scratch((size_t)width * height, sizeof *markers);
    flood_prepare(width, height);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            *seed = *seed * 1664525 + 1013904223;
            surface[rs_frame_index(&frame, x, y)] = (uint8_t)(*seed >> 24);
            *label_at(x, y) = (*seed >> 8) % 29 == 0 ? (uint16_t)((*seed >> 14) % 9 + 1) : 0;
            if ((*seed >> 3) % 53 == 0) {
                *label_at(x, y) = RS_BACKGROUND;
            }
            markers[(size_t)y * width + x] = *label_at(x, y);
        }
    }
    return markers;
}

/* With plenty of queue, hardly any, and none at all. */
static void test_random_maps(void)
{
    const uint32_t blocks[] = {4096, 40, 3, 0};
    uint32_t seed = 3;
    for (uint32_t round = 0; round < 200; round++) {
        rs_ticker ticker = {0};
        uint16_t *markers = draw_random(1 + round % 41, 1 + round % 23, &seed);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, flood(blocks[round % 4], &ticker));
        check_lines(markers);
        free(markers);
    }
}

static void test_cancelling(void)
{
    for (uint32_t calls = 0; calls < 5; calls++) {
        uint32_t left = calls;
        rs_ticker ticker = stage_canceller(&left);
        flood_prepare(400, 400);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED, flood(20000, &ticker));
    }
}

/* With hardly any queue cells are searched for; whichever visit is the last before a call. */
static void test_cancelling_a_search(void)
{
    int status = ROOMSEG_ERR_CANCELLED;
    for (uint32_t visits = RS_TICK_VISITS; status == ROOMSEG_ERR_CANCELLED; visits -= 7) {
        uint32_t left = 0, seed = 5;
        rs_ticker ticker = stage_canceller(&left);
        ticker.visits = visits;
        uint16_t *markers = draw_random(12, 9, &seed);
        status = flood(1, &ticker);
        if (status == ROOMSEG_OK) {
            check_lines(markers);
        }
        free(markers);
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, status);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_half_way);
    RUN_TEST(test_the_line_follows_the_crest);
    RUN_TEST(test_the_border_is_background);
    RUN_TEST(test_pits_fill_first);
    RUN_TEST(test_random_maps);
    RUN_TEST(test_cancelling);
    RUN_TEST(test_cancelling_a_search);
    return UNITY_END();
}
