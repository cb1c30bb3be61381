/* Leaf seeds at their births, against components counted scale by scale. */
#include <stdlib.h>
#include <string.h>

#include "seeds.h"
#include "stage.h"
#include "unity.h"

enum { MAX_SEEDS = 400 };

static rs_frame frame;
static uint8_t *lifetime, *births;
static rs_labels labels;
static uint32_t seed_count;
static uint32_t *stack;
static uint8_t *visited;

void setUp(void)
{
    lifetime = NULL;
    labels.cells = NULL;
    births = NULL;
    stack = NULL;
    visited = NULL;
}

void tearDown(void)
{
    free(lifetime);
    free(labels.cells);
    free(births);
    free(stack);
    free(visited);
}

static void prepare(uint32_t width, uint32_t height)
{
    tearDown();
    frame = stage_frame(width, height);
    lifetime = stage_buffer(&frame);
    visited = stage_buffer(&frame);
    labels = stage_labels(&frame);
    births = stage_scratch(MAX_SEEDS + 1, 1);
    stack = stage_scratch((size_t)width * height, sizeof *stack);
}

/* Rows of digits: the lifetime of each cell. */
static void draw(const char *const *rows, uint32_t height)
{
    prepare((uint32_t)strlen(rows[0]), height);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            lifetime[rs_frame_index(&frame, x, y)] = (uint8_t)(rows[y][x] - '0');
        }
    }
}

static void find_seeds(void)
{
    rs_ticker ticker = {0};
    rs_ring ring = {stage_scratch(4096, sizeof *ring.cells), 4096, 0, 0};
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_watershed_run(&frame, lifetime, MAX_SEEDS, &labels,
                                                       &seed_count, &ring, &ticker));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_seeds_run(&frame, lifetime, seed_count, &labels, births,
                                                   &ticker));
    free(ring.cells);
}

static uint16_t *label_at(uint32_t x, uint32_t y)
{
    return &labels.cells[(size_t)y * labels.stride + x];
}

/* Letters stand for seeds in the order of their appearance, ' ' for none. */
static void expect(const char *const *rows)
{
    uint16_t label_of[26] = {0};
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            char c = rows[y][x];
            if (c == ' ') {
                TEST_ASSERT_EQUAL_UINT16(0, *label_at(x, y));
                continue;
            }
            if (label_of[c - 'a'] == 0) {
                label_of[c - 'a'] = *label_at(x, y);
            }
            TEST_ASSERT_NOT_EQUAL_UINT16(0, *label_at(x, y));
            TEST_ASSERT_EQUAL_UINT16(label_of[c - 'a'], *label_at(x, y));
        }
    }
}

/* Two rooms and the door between them, where both are one up to scale 2. */
static void test_two_rooms_with_a_door(void)
{
    const char *const rows[] = {"00000000000", "01111001110", "01232112310", "01342113410",
                                "01232112310", "01111001110", "00000000000"};
    const char *const seeds[] = {"           ", "           ", "  aaa  bb  ", "  aaa  bb  ",
                                 "  aaa  bb  ", "           ", "           "};
    draw(rows, 7);
    find_seeds();
    TEST_ASSERT_EQUAL_UINT(2, seed_count);
    TEST_ASSERT_EQUAL_UINT8(2, births[1]);
    TEST_ASSERT_EQUAL_UINT8(2, births[2]);
    expect(seeds);
}

/* One seed that no other meets is born at the first scale. */
static void test_alone(void)
{
    const char *const rows[] = {"000000", "012210", "013310", "000000"};
    const char *const seeds[] = {"      ", " aaaa ", " aaaa ", "      "};
    draw(rows, 4);
    find_seeds();
    TEST_ASSERT_EQUAL_UINT(1, seed_count);
    TEST_ASSERT_EQUAL_UINT8(1, births[1]);
    expect(seeds);
}

/* The middle divides first; its halves are leaves, it is none. */
static void test_births_at_different_scales(void)
{
    const char *const rows[] = {"00000000000000", "03221122442350", "00000000000000"};
    const char *const seeds[] = {"              ", " aaa    bb cc ", "              "};
    draw(rows, 3);
    find_seeds();
    TEST_ASSERT_EQUAL_UINT(3, seed_count);
    expect(seeds);
}

/* Cells that touch at a corner only are two seeds. */
static void test_corners_do_not_connect(void)
{
    const char *const rows[] = {"0000", "0200", "0020", "0000"};
    const char *const seeds[] = {"    ", " a  ", "  b ", "    "};
    draw(rows, 4);
    find_seeds();
    expect(seeds);
}

/* Fills the component of cells of at least `scale` around a cell. Returns how many regional
 * maxima it has, counted by `marks`: one cell each is 1. */
static uint32_t fill_component(uint8_t scale, uint32_t cell, const uint8_t *marks)
{
    uint32_t depth = 0, count = 0;
    const uint32_t step[4] = {1, 0u - 1, frame.stride, 0u - frame.stride};
    memset(visited, 0, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
    visited[cell] = 1;
    stack[depth++] = cell;
    while (depth > 0) {
        uint32_t at = stack[--depth];
        count += marks[at];
        for (int k = 0; k < 4; k++) {
            uint32_t next = at + step[k];
            if (lifetime[next] >= scale && !visited[next]) {
                visited[next] = 1;
                stack[depth++] = next;
            }
        }
    }
    return count;
}

/* Marks one cell of each plateau that no higher cell touches. */
static uint8_t *mark_maxima(void)
{
    uint8_t *marks = stage_buffer(&frame);
    uint8_t *done = stage_buffer(&frame);
    for (uint32_t i = 0; i < ROOMSEG_PLAN_CELLS(frame.width, frame.height); i++) {
        bool highest = true;
        if (lifetime[i] == 0 || done[i]) {
            continue;
        }
        fill_component(lifetime[i], i, marks);
        for (uint32_t j = 0; j < ROOMSEG_PLAN_CELLS(frame.width, frame.height); j++) {
            highest = highest && !(visited[j] && lifetime[j] > lifetime[i]);
            done[j] |= visited[j] && lifetime[j] == lifetime[i];
        }
        marks[i] = highest;
    }
    free(done);
    return marks;
}

static void check_against_components(void)
{
    uint8_t *marks = mark_maxima();
    uint32_t total = 0;
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint32_t at = rs_frame_index(&frame, x, y);
            uint16_t label = *label_at(x, y);
            if (marks[at]) {
                uint8_t birth = lifetime[at];
                total++;
                while (birth > 1 && fill_component((uint8_t)(birth - 1), at, marks) == 1) {
                    birth--;
                }
                TEST_ASSERT_EQUAL_UINT8(birth, births[label]);
                TEST_ASSERT_EQUAL_UINT(1, fill_component(birth, at, marks));
                for (uint32_t j = 0; j < frame.width * frame.height; j++) {
                    uint32_t cx = j % frame.width, cy = j / frame.width;
                    TEST_ASSERT_EQUAL(visited[rs_frame_index(&frame, cx, cy)],
                                      *label_at(cx, cy) == label);
                }
            }
        }
    }
    TEST_ASSERT_EQUAL_UINT(seed_count, total);
    free(marks);
}

static void test_random_maps(void)
{
    uint32_t seed = 5;
    for (int round = 0; round < 40; round++) {
        prepare(5 + (uint32_t)round % 17, 4 + (uint32_t)round % 11);
        for (uint32_t y = 0; y < frame.height; y++) {
            for (uint32_t x = 0; x < frame.width; x++) {
                seed = seed * 1664525 + 1013904223;
                lifetime[rs_frame_index(&frame, x, y)] =
                    (uint8_t)((seed >> 16) % (3u + (uint32_t)round % 6));
            }
        }
        find_seeds();
        check_against_components();
    }
}

static void test_marking_obstacles(void)
{
    rs_ticker ticker = {0};
    const char *const rows[] = {"101", "011"};
    draw(rows, 2);
    *label_at(0, 0) = 7;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_seeds_mark_obstacles(&frame, lifetime, 900, &labels, &ticker));
    const uint16_t wanted[] = {7, 900, 0, 900, 0, 0};
    TEST_ASSERT_EQUAL_UINT16_ARRAY(wanted, labels.cells, 6);
}

static void test_leaving_out_a_label(void)
{
    rs_ticker ticker = {0};
    const char *const rows[] = {"123", "456"};
    draw(rows, 2);
    *label_at(1, 0) = 900;
    *label_at(0, 1) = 7;
    *label_at(2, 1) = 900;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_seeds_leave_out(&frame, 900, &labels, lifetime, &ticker));
    const uint8_t wanted[] = {1, 0, 3, 4, 5, 0};
    for (uint32_t i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL_UINT8(wanted[i], lifetime[rs_frame_index(&frame, i % 3, i / 3)]);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_two_rooms_with_a_door);
    RUN_TEST(test_alone);
    RUN_TEST(test_births_at_different_scales);
    RUN_TEST(test_corners_do_not_connect);
    RUN_TEST(test_random_maps);
    RUN_TEST(test_marking_obstacles);
    RUN_TEST(test_leaving_out_a_label);
    return UNITY_END();
}
