/* Small components of free cells and of obstacles, against flood fills of a plain version. */
#include <stdlib.h>
#include <string.h>

#include "components.h"
#include "stage.h"
#include "unity.h"

static rs_frame frame;
static uint8_t *cells, *wanted, *seen;
static uint32_t *stack;

void setUp(void)
{
    cells = NULL;
    wanted = NULL;
    seen = NULL;
    stack = NULL;
}

void tearDown(void)
{
    free(cells);
    free(wanted);
    free(seen);
    free(stack);
}

static void prepare(uint32_t width, uint32_t height)
{
    tearDown();
    frame = stage_frame(width, height);
    cells = stage_buffer(&frame);
    wanted = stage_buffer(&frame);
    seen = stage_buffer(&frame);
    stack = stage_scratch(ROOMSEG_PLAN_CELLS(width, height), sizeof *stack);
}

/* '.' free, '#' obstacle */
static void draw(const char *const *rows, uint32_t height)
{
    prepare((uint32_t)strlen(rows[0]), height);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            cells[rs_frame_index(&frame, x, y)] = rows[y][x] == '.';
        }
    }
}

static rs_component_scratch make_scratch(void)
{
    size_t runs = 2 * ROOMSEG_PLAN_RUNS(frame.width);
    rs_component_scratch scratch;
    scratch.runs = stage_scratch(runs, sizeof *scratch.runs);
    scratch.components = stage_scratch(runs, sizeof *scratch.components);
    scratch.active = stage_scratch(runs, sizeof *scratch.active);
    scratch.vacant = stage_scratch(runs, sizeof *scratch.vacant);
    scratch.stack = stage_scratch((size_t)frame.width * frame.height / 2 + 1,
                                  sizeof *scratch.stack);
    return scratch;
}

static void free_scratch(rs_component_scratch *scratch)
{
    free(scratch->runs);
    free(scratch->components);
    free(scratch->active);
    free(scratch->vacant);
    free(scratch->stack);
}

static void keep_large_free(void)
{
    rs_ticker ticker = {0};
    rs_component_scratch scratch = make_scratch();
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_components_keep_large_free(&frame, cells, &scratch, &ticker));
    free_scratch(&scratch);
}

static void expect(const char *const *rows)
{
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            TEST_ASSERT_EQUAL_UINT8(rows[y][x] == '.', cells[rs_frame_index(&frame, x, y)]);
        }
    }
}

/* 9, 3 and 1 cells: the mean is 4 1/3. */
static void test_below_the_mean(void)
{
    const char *const rows[] = {"...###.#", "...#.###", "...##..#"};
    const char *const left[] = {"...#####", "...#####", "...#####"};
    draw(rows, 3);
    keep_large_free();
    expect(left);
}

/* Exactly the mean stays. */
static void test_equal_ones_stay(void)
{
    const char *const rows[] = {"#..#..#", "#######", "#..#..#"};
    draw(rows, 3);
    keep_large_free();
    expect(rows);
}

static void test_one_component_stays(void)
{
    const char *const rows[] = {".#", "#."}; /* joined at the corner */
    draw(rows, 2);
    keep_large_free();
    expect(rows);
}

static void test_nothing_free(void)
{
    const char *const rows[] = {"##", "##"};
    draw(rows, 2);
    keep_large_free();
    expect(rows);
}

/* Cells of the component of `cells` around a cell; they are marked as seen. */
static uint32_t fill(uint32_t cell, uint32_t neighbours)
{
    const uint32_t step[8] = {1, 0u - 1, frame.stride, 0u - frame.stride, frame.stride + 1,
                              frame.stride - 1, 1 - frame.stride, 0u - frame.stride - 1};
    uint32_t depth = 0, count = 0;
    seen[cell] = 1;
    stack[depth++] = cell;
    while (depth > 0) {
        uint32_t at = stack[--depth];
        count++;
        for (uint32_t k = 0; k < neighbours; k++) {
            uint32_t next = at + step[k];
            if (cells[next] == cells[cell] && !seen[next]) {
                seen[next] = 1;
                stack[depth++] = next;
            }
        }
    }
    return count;
}

static void find_wanted(void)
{
    size_t all = ROOMSEG_PLAN_CELLS(frame.width, frame.height);
    uint32_t count = 0, total = 0;
    for (uint32_t i = 0; i < all; i++) {
        if (cells[i] != 0 && !seen[i]) {
            count++;
            total += fill(i, 8);
        }
    }
    memcpy(wanted, cells, all);
    for (uint32_t i = 0; i < all; i++) {
        if (cells[i] != 0) {
            memset(seen, 0, all);
            wanted[i] = fill(i, 8) * count >= total;
        }
    }
}

static void test_random_maps(void)
{
    uint32_t seed = 9;
    for (uint32_t round = 0; round < 300; round++) {
        prepare(1 + round % 23, 1 + round % 19);
        for (uint32_t y = 0; y < frame.height; y++) {
            for (uint32_t x = 0; x < frame.width; x++) {
                seed = seed * 1664525 + 1013904223;
                cells[rs_frame_index(&frame, x, y)] = (seed >> 16) % 10 < 2 + round % 5;
            }
        }
        find_wanted();
        keep_large_free();
        TEST_ASSERT_EQUAL_MEMORY(wanted, cells, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
    }
}

static void clear_small(uint32_t speck_cells, bool diagonal)
{
    rs_ticker ticker = {0};
    rs_component_limits limits = {speck_cells, 0, diagonal};
    rs_component_scratch scratch = make_scratch();
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_components_clear_small(&frame, limits, cells, &scratch,
                                                                &ticker));
    free_scratch(&scratch);
}

/* Four cells in a diagonal are four obstacles or one. */
static void test_small_obstacles(void)
{
    const char *const rows[] = {"........", ".#......", "..#..##.", "...#.##.", "....#...",
                                "........"};
    const char *const left[] = {"........", "........", ".....##.", ".....##.", "........",
                                "........"};
    draw(rows, 6);
    clear_small(4, false);
    expect(left);
    draw(rows, 6);
    clear_small(4, true);
    expect(rows);
}

/* Clearing a large island calls the hook too. */
static void test_cancelling_while_an_island_is_cleared(void)
{
    uint32_t calls = 0, spent = 0;
    prepare(500, 900);
    for (uint32_t y = 0; y < 900; y++) {
        memset(cells + rs_frame_index(&frame, 0, y), y != 430, frame.width);
    }
    uint8_t *before = stage_buffer(&frame);
    memcpy(before, cells, ROOMSEG_PLAN_CELLS(500, 900));
    rs_component_scratch scratch = make_scratch();
    do {
        memcpy(cells, before, ROOMSEG_PLAN_CELLS(500, 900));
        uint32_t left = calls;
        rs_ticker ticker = stage_canceller(&left);
        spent = rs_components_keep_large_free(&frame, cells, &scratch, &ticker) ==
                ROOMSEG_ERR_CANCELLED;
        calls += spent;
    } while (spent != 0);
    /* Two readings of 450,000 cells, and 215,000 cells turned. */
    TEST_ASSERT_GREATER_OR_EQUAL_UINT((2 * 450000 + 215000) / 65536, calls);
    free(before);
    free_scratch(&scratch);
}

/* What touches the edge of the buffer may go on beyond it, small as it looks. */
static void test_at_the_edge_they_stay(void)
{
    rs_ticker ticker = {0};
    const rs_component_limits limits = {100, 100, true};
    prepare(6, 4);
    memset(cells, 1, ROOMSEG_PLAN_CELLS(6, 4));
    cells[2 * frame.stride] = 0;         /* the border's first column */
    cells[3 * frame.stride + 4] = 0;     /* inside */
    rs_component_scratch scratch = make_scratch();
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_components_clear_small(&frame, limits, cells, &scratch,
                                                                &ticker));
    free_scratch(&scratch);
    TEST_ASSERT_EQUAL_UINT8(0, cells[2 * frame.stride]);
    TEST_ASSERT_EQUAL_UINT8(1, cells[3 * frame.stride + 4]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_below_the_mean);
    RUN_TEST(test_equal_ones_stay);
    RUN_TEST(test_at_the_edge_they_stay);
    RUN_TEST(test_one_component_stays);
    RUN_TEST(test_nothing_free);
    RUN_TEST(test_random_maps);
    RUN_TEST(test_small_obstacles);
    RUN_TEST(test_cancelling_while_an_island_is_cleared);
    return UNITY_END();
}
