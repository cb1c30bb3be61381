/* The watershed against what its header promises, on random surfaces and with rings of any size. */
#include <stdlib.h>
#include <string.h>

#include "flood.h"
#include "random.h"
#include "unity.h"

enum { UNTOUCHED = 0xFFFD };

static uint32_t count;
static uint32_t state = 7;

static uint32_t next_random(uint32_t range)
{
    return random_next(&state) % range;
}

static void prepare(uint32_t width, uint32_t height)
{
    flood_prepare(width, height);
    for (uint32_t i = 0; i < width * height; i++) {
        labels.cells[i] = UNTOUCHED;
    }
}

static uint8_t *at(uint32_t x, uint32_t y)
{
    return &surface[rs_frame_index(&frame, x, y)];
}

static int run(uint32_t capacity, uint32_t max_regions, rs_ticker *ticker)
{
    rs_ring ring = {stage_scratch(capacity, sizeof *ring.cells), capacity, 0, 0};
    int status = rs_watershed_run(&frame, surface, max_regions, &labels, &count, &ring, ticker);
    free(ring.cells);
    return status;
}

/* Marks the cells that are reached from (x, y) over neighbours for which `same` holds. */
static void mark(uint8_t *seen, uint32_t x, uint32_t y, bool by_label)
{
    uint32_t *stack = stage_scratch((size_t)frame.width * frame.height + 1u, sizeof *stack);
    uint32_t depth = 0;
    stack[depth++] = rs_cell_pack(x, y);
    seen[rs_frame_index(&frame, x, y)] = 1;
    while (depth > 0) {
        uint32_t cell = stack[--depth], cx = rs_cell_x(cell), cy = rs_cell_y(cell);
        for (uint32_t k = 0; k < 4; k++) {
            uint32_t nx = cx + (k == 0) - (k == 1), ny = cy + (k == 2) - (k == 3);
            if (nx >= frame.width || ny >= frame.height ||
                seen[rs_frame_index(&frame, nx, ny)] != 0) {
                continue;
            }
            if (by_label ? *label_at(nx, ny) == *label_at(cx, cy) : *at(nx, ny) == *at(cx, cy)) {
                seen[rs_frame_index(&frame, nx, ny)] = 1;
                stack[depth++] = rs_cell_pack(nx, ny);
            }
        }
    }
    free(stack);
}

static uint8_t highest_beside(uint32_t x, uint32_t y)
{
    uint8_t highest = *at(x - 1u, y);
    highest = *at(x + 1u, y) > highest ? *at(x + 1u, y) : highest;
    highest = *at(x, y - 1u) > highest ? *at(x, y - 1u) : highest;
    return *at(x, y + 1u) > highest ? *at(x, y + 1u) : highest;
}

/* Plateaus without a higher neighbour. */
static uint32_t count_maxima(void)
{
    uint8_t *seen = stage_buffer(&frame);
    uint32_t maxima = 0;
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            if (*at(x, y) == 0 || seen[rs_frame_index(&frame, x, y)] != 0) {
                continue;
            }
            uint8_t *plateau = stage_buffer(&frame);
            bool maximum = true;
            mark(plateau, x, y, false);
            for (uint32_t i = 0; i < frame.width * frame.height; i++) {
                uint32_t px = i % frame.width, py = i / frame.width;
                if (plateau[rs_frame_index(&frame, px, py)] != 0) {
                    seen[rs_frame_index(&frame, px, py)] = 1;
                    maximum = maximum && highest_beside(px, py) <= *at(px, py);
                }
            }
            maxima += maximum;
            free(plateau);
        }
    }
    free(seen);
    return maxima;
}

/* A cell with higher neighbours belongs to one of the highest. */
static bool goes_up(uint32_t x, uint32_t y)
{
    uint8_t highest = highest_beside(x, y);
    bool found = highest <= *at(x, y);
    for (uint32_t k = 0; k < 4 && !found; k++) {
        uint32_t nx = x + (k == 0) - (k == 1), ny = y + (k == 2) - (k == 3);
        found = nx < frame.width && ny < frame.height && *at(nx, ny) == highest &&
                *label_at(nx, ny) == *label_at(x, y);
    }
    return found;
}

static void check_labels(void)
{
    uint8_t *seen = stage_buffer(&frame);
    uint32_t regions = 0;
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint16_t label = *label_at(x, y);
            if (*at(x, y) == 0) {
                TEST_ASSERT_EQUAL_UINT16(UNTOUCHED, label);
                continue;
            }
            TEST_ASSERT_TRUE(goes_up(x, y));
            if (seen[rs_frame_index(&frame, x, y)] == 0) {
                regions++; /* so no region comes in two pieces, and they are in order */
                TEST_ASSERT_EQUAL_UINT16(regions, label);
                mark(seen, x, y, true);
            }
        }
    }
    free(seen);
    TEST_ASSERT_EQUAL_UINT32(regions, count);
    TEST_ASSERT_EQUAL_UINT32(count_maxima(), count);
}

static void draw_random(uint32_t heights)
{
    prepare(1 + next_random(24), 1 + next_random(24));
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            *at(x, y) = (uint8_t)next_random(heights + 1u);
        }
    }
}

static void test_random_surfaces(void)
{
    const uint32_t capacities[] = {1, 2, 5, 1000};
    for (uint32_t i = 0; i < 600; i++) {
        rs_ticker ticker = {0};
        draw_random(1 + next_random(6));
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(capacities[i % 4], ROOMSEG_MAX_REGIONS, &ticker));
        check_labels();
    }
}

/* One plateau that all fronts of the ring cannot hold. */
static void test_wide_plateaus_and_a_small_ring(void)
{
    const uint32_t capacities[] = {1, 3, 64, 4096};
    for (uint32_t i = 0; i < 4; i++) {
        rs_ticker ticker = {0};
        prepare(60, 45);
        for (uint32_t y = 0; y < frame.height; y++) {
            memset(at(0, y), y == 20 ? 9 : 5, frame.width);
        }
        *at(30, 20) = 0;
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(capacities[i], 10, &ticker));
        TEST_ASSERT_EQUAL_UINT32(2, count);
        check_labels();
    }
}

/* Up a slope askew to the axes the ways go straight: a ridge's two ends share its side evenly. */
static void test_ways_do_not_drift(void)
{
    enum { SIDE = 41, MIDDLE = SIDE - 1 };
    rs_ticker ticker = {0};
    prepare(SIDE, SIDE);
    for (uint32_t y = 0; y < SIDE; y++) {
        for (uint32_t x = 0; x < SIDE; x++) {
            /* The height grows towards one diagonal, which has a dip in its middle. */
            uint32_t off = x > y ? x - y : y - x;
            *at(x, y) = (uint8_t)(100 - off - (x + y == MIDDLE ? 1 : 0));
        }
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(1000, 100, &ticker));
    uint32_t astray = 0;
    for (uint32_t y = 0; y < SIDE; y++) {
        for (uint32_t x = 0; x < SIDE; x++) {
            bool first_half = x + y < MIDDLE - 2u;
            bool second_half = x + y > MIDDLE + 2u;
            astray += first_half && *label_at(x, y) == *label_at(SIDE - 1, SIDE - 1);
            astray += second_half && *label_at(x, y) == *label_at(0, 0);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, astray);
}

static void test_too_many_regions(void)
{
    rs_ticker ticker = {0};
    prepare(9, 1);
    for (uint32_t x = 0; x < 9; x += 2) {
        *at(x, 0) = 3;
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, run(4, 5, &ticker));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS, run(4, 4, &ticker));
    TEST_ASSERT_EQUAL_UINT32(5, count);
}

/* Stops at whichever call the hook says no, on a way that is longer than what lies between two
 * calls. */
static void test_the_hook_can_cancel(void)
{
    enum { SIDE = 600 };
    int status = ROOMSEG_ERR_CANCELLED;
    uint32_t calls = 0;
    for (; status == ROOMSEG_ERR_CANCELLED; calls++) {
        uint32_t left = calls;
        rs_ticker ticker = stage_canceller(&left);
        TEST_ASSERT_LESS_THAN_UINT32(200, calls);
        prepare(SIDE, SIDE);
        for (uint32_t y = 0; y < SIDE; y += 2) {
            memset(at(0, y), 7, SIDE);
            if (y + 1 < SIDE) {
                *at(y % 4 == 0 ? SIDE - 1 : 0, y + 1) = 7;
            }
        }
        *at(SIDE - 1, SIDE - 1) = 8;
        status = run(300, 10, &ticker);
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, status);
    /* Each cell is visited often enough for the hook to come at least so many times. */
    TEST_ASSERT_GREATER_THAN_UINT32(4u * SIDE * SIDE / 65536u, calls);
}

/* A ring of one cell, full all the time; whichever visit is the last before a call. */
static void test_cancelling_with_a_full_ring(void)
{
    int status = ROOMSEG_ERR_CANCELLED;
    for (uint32_t visits = RS_TICK_VISITS; status == ROOMSEG_ERR_CANCELLED; visits -= 3) {
        uint32_t left = 0;
        rs_ticker ticker = stage_canceller(&left);
        ticker.visits = visits;
        prepare(20, 15);
        for (uint32_t y = 0; y < 15; y++) {
            memset(at(0, y), y == 7 ? 9 : 5, 20);
        }
        status = run(1, 10, &ticker);
    }
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, status);
    check_labels();
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_random_surfaces);
    RUN_TEST(test_wide_plateaus_and_a_small_ring);
    RUN_TEST(test_ways_do_not_drift);
    RUN_TEST(test_too_many_regions);
    RUN_TEST(test_the_hook_can_cancel);
    RUN_TEST(test_cancelling_with_a_full_ring);
    return UNITY_END();
}
