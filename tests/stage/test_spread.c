/* Labels that came back in pieces are made whole. Maps are drawn with one character a cell:
 * '#' wall, ' ' open without label, a letter: open with that label proposed; capital letters
 * are settled. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "flood.h"
#include "spread.h"
#include "unity.h"

static uint16_t label_of(char character)
{
    if (character == 'x' || character == 'X') {
        return RS_SPREAD_DROPPED;
    }
    return isalpha((unsigned char)character)
               ? (uint16_t)(tolower((unsigned char)character) - 'a' + 1)
               : (uint16_t)0;
}

static void draw(const char *const *rows, uint32_t height)
{
    flood_prepare((uint32_t)strlen(rows[0]), height);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            char c = rows[y][x];
            surface[rs_frame_index(&frame, x, y)] =
                c == '#' ? RS_SPREAD_WALL
                         : (isupper((unsigned char)c) ? RS_SPREAD_SETTLED : RS_SPREAD_OPEN);
            *label_at(x, y) = label_of(c);
        }
    }
}

static int spread(uint32_t blocks, rs_ticker *ticker)
{
    rs_queue queue;
    rs_queue_list *lists = stage_scratch(RS_QUEUE_LISTS, sizeof *lists);
    rs_queue_block *pool = stage_scratch(blocks, sizeof *pool);
    rs_queue_init(&queue, lists, pool, blocks);
    int status = rs_spread_run(&frame, surface, &labels, &queue, ticker);
    free(lists);
    free(pool);
    return status;
}

static void expect(const char *const *rows)
{
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            TEST_ASSERT_EQUAL_UINT16(label_of(rows[y][x]), *label_at(x, y));
        }
    }
}

static void check(const char *const *before, const char *const *after, uint32_t height)
{
    rs_ticker ticker = {0};
    draw(before, height);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, spread(8, &ticker));
    expect(after);
}

static void test_gaps_are_filled_from_the_nearest(void)
{
    const char *const before[] = {"Aaa  bbB", "aaa  bbb"};
    const char *const after[] = {"aaaabbbb", "aaaabbbb"};
    check(before, after, 2);
}

/* A torn-off cell of a in b becomes b's; the room itself stays. */
static void test_torn_off_cells_change_hands(void)
{
    const char *const before[] = {"Aaabbbbb", "aaabbabB", "aaabbbbb"};
    const char *const after[] = {"aaabbbbb", "aaabbbbb", "aaabbbbb"};
    check(before, after, 3);
}

/* A room's other half behind lost cells is still its own. */
static void test_a_room_is_found_again_behind_a_gap(void)
{
    const char *const before[] = {"Aaaa aaaa", "####b####", "bbbbbbbbB"};
    const char *const after[] = {"aaaaaaaaa", "####b####", "bbbbbbbbb"};
    check(before, after, 3);
}

static void test_what_no_room_reaches_has_no_label(void)
{
    const char *const before[] = {"Aa#cc", "aa#c "};
    const char *const after[] = {"aa#  ", "aa#  "};
    check(before, after, 2);
}

/* Dropped space holds its ground like a room. */
static void test_dropped_space_stays_dropped(void)
{
    const char *const before[] = {"Aaa  XXXX"};
    const char *const after[] = {"aaaaxxxxx"};
    check(before, after, 1);
}

/* Labels on walls are not touched. */
static void test_walls_keep_their_labels(void)
{
    rs_ticker ticker = {0};
    const char *const rows[] = {"Aa#aa"};
    draw(rows, 1);
    labels.cells[2] = 77;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, spread(8, &ticker));
    TEST_ASSERT_EQUAL_UINT16(77, labels.cells[2]);
}

/* A queue of one block for a large field: slower, and still everything is reached. */
static void test_a_full_queue_loses_nothing(void)
{
    for (uint32_t blocks = 1; blocks <= 3; blocks++) {
        rs_ticker ticker = {0};
        flood_prepare(150, 150);
        for (uint32_t y = 0; y < 150; y++) {
            for (uint32_t x = 0; x < 150; x++) {
                surface[rs_frame_index(&frame, x, y)] = RS_SPREAD_OPEN;
                labels.cells[(size_t)y * 150 + x] = (uint16_t)(x < 60 ? 1 : (x < 90 ? 0 : 2));
            }
        }
        surface[rs_frame_index(&frame, 30, 75)] = RS_SPREAD_SETTLED;
        surface[rs_frame_index(&frame, 120, 75)] = RS_SPREAD_SETTLED;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, spread(blocks, &ticker));
        for (uint32_t y = 0; y < 150; y++) {
            for (uint32_t x = 0; x < 150; x++) {
                uint16_t label = labels.cells[(size_t)y * 150 + x];
                TEST_ASSERT_TRUE(label == 1 || label == 2);
                TEST_ASSERT_FALSE((x < 60 && label != 1) || (x >= 90 && label != 2));
            }
        }
    }
}

static void test_cancelling(void)
{
    flood_prepare(400, 400);
    for (uint32_t call = 0; call < 12; call++) {
        uint32_t left = call;
        rs_ticker ticker = stage_canceller(&left);
        for (uint32_t y = 0; y < 400; y++) {
            memset(surface + rs_frame_index(&frame, 0, y), RS_SPREAD_OPEN, 400);
        }
        memset(labels.cells, 0, (size_t)400 * 400 * sizeof *labels.cells);
        surface[rs_frame_index(&frame, 0, 0)] = RS_SPREAD_SETTLED;
        labels.cells[0] = 1;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED, spread(64, &ticker));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_gaps_are_filled_from_the_nearest);
    RUN_TEST(test_torn_off_cells_change_hands);
    RUN_TEST(test_a_room_is_found_again_behind_a_gap);
    RUN_TEST(test_what_no_room_reaches_has_no_label);
    RUN_TEST(test_dropped_space_stays_dropped);
    RUN_TEST(test_walls_keep_their_labels);
    RUN_TEST(test_a_full_queue_loses_nothing);
    RUN_TEST(test_cancelling);
    return UNITY_END();
}
