/* The lifetime map, against Gaussians in floating point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "coarsen.h"
#include "lifetime.h"
#include "stage.h"
#include "unity.h"

#define NEVER UINT32_MAX
#define PROFILE_HALVING (3u << 4)

static sketch s;
static rs_frame frame;
static uint8_t *cells, *exact;
static double *along, *both;

void setUp(void)
{
    memset(&s, 0, sizeof s);
    cells = NULL;
    exact = NULL;
    along = NULL;
    both = NULL;
}

void tearDown(void)
{
    sketch_free(&s);
    free(cells);
    free(exact);
    free(along);
    free(both);
}

static rs_lifetime_rules rules_of(uint32_t resolution_mm, uint32_t halve)
{
    rs_lifetime_rules rules = {resolution_mm, 40, 20, 50, halve,
                               halve == NEVER ? 64 : ROOMSEG_BLUR_MARGIN};
    return rules;
}

/* The lifetime of the sketch's free cells, in `cells`. */
static void run_lifetime(const rs_lifetime_rules *rules)
{
    rs_ticker ticker = {0};
    rs_lifetime_scratch scratch;
    frame = stage_frame(s.grid.width, s.grid.height);
    free(cells);
    cells = stage_mask(&frame, &s);
    uint32_t width = frame.width + 2 * rules->margin, height = frame.height + 2 * rules->margin;
    uint32_t rows = rs_lifetime_ring_rows(rules);
    scratch.shares = stage_scratch((size_t)width * height, sizeof *scratch.shares);
    scratch.blur.sums = stage_scratch(width, sizeof *scratch.blur.sums);
    scratch.blur.prefix = stage_scratch(width + 2 * rows, sizeof *scratch.blur.prefix);
    scratch.blur.ring = stage_scratch((size_t)rows * width, sizeof *scratch.blur.ring);
    scratch.blur.ring_rows = rows;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_lifetime_run(&frame, rules, cells, &scratch, &ticker));
    free(scratch.shares);
    free(scratch.blur.sums);
    free(scratch.blur.prefix);
    free(scratch.blur.ring);
}

static uint8_t life_at(uint32_t x, uint32_t y)
{
    return cells[rs_frame_index(&frame, x, y)];
}

static double free_at(int x, int y)
{
    bool inside = x >= 0 && y >= 0 && x < (int)s.grid.width && y < (int)s.grid.height;
    return inside && s.memory[(size_t)y * s.grid.stride + (size_t)x] == 0;
}

/* Free share after a Gaussian, in `both`, outside counting as obstacle. */
static void blur_exactly(double sigma)
{
    int reach = (int)ceil(4 * sigma), w = (int)s.grid.width, h = (int)s.grid.height;
    double weights[400], sum = 0;
    for (int k = -reach; k <= reach; k++) {
        weights[k + reach] = exp(-k * k / (2 * sigma * sigma));
        sum += weights[k + reach];
    }
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            along[y * w + x] = 0;
            for (int k = -reach; k <= reach; k++) {
                along[y * w + x] += weights[k + reach] / sum * free_at(x + k, y);
            }
        }
    }
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            both[y * w + x] = 0;
            for (int k = -reach; k <= reach; k++) {
                both[y * w + x] +=
                    y + k >= 0 && y + k < h ? weights[k + reach] / sum * along[(y + k) * w + x] : 0;
            }
        }
    }
}

static void find_exact_lifetimes(double start, double step)
{
    size_t count = (size_t)s.grid.width * s.grid.height;
    exact = calloc(count, 1);
    along = stage_scratch(count, sizeof *along);
    both = stage_scratch(count, sizeof *both);
    bool alive = true;
    for (uint8_t scale = 1; alive; scale++) {
        alive = false;
        blur_exactly(start + (scale - 1) * step);
        for (size_t i = 0; i < count; i++) {
            if (both[i] >= 0.95) {
                exact[i] = scale;
                alive = true;
            }
        }
    }
}

/* Shares of the cells with a lifetime that are off at all, and by more than one scale. */
static void measure(double *off, double *far_off)
{
    uint32_t count = 0, any = 0, far = 0;
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            int wanted = exact[y * frame.width + x], found = life_at(x, y);
            count += wanted > 0 || found > 0;
            any += wanted != found;
            far += abs(wanted - found) > 1;
        }
    }
    *off = (double)any / count;
    *far_off = (double)far / count;
}

/* Rooms, a corridor, a table and a pillar. */
static const char *const flat[] = {
    "##############################", "#............#...............#",
    "#............#...............#", "#............#.......##......#",
    "#..###.......#.......##......#", "#..###.......................#",
    "#............................#", "#............#...............#",
    "#######..#####...............#", "#......................#######",
    "#......................#.....#", "##########..############.....#",
    "#............#...............#", "#............#.........#.....#",
    "#..............#.............#", "##############################", NULL,
};

static void expect_close(uint32_t resolution_mm, uint32_t scale, uint32_t halve, double most_off)
{
    double off, far_off, cell = resolution_mm;
    rs_lifetime_rules rules = rules_of(resolution_mm, halve);
    tearDown();
    setUp();
    s = sketch_make(flat, scale, 0, resolution_mm);
    find_exact_lifetimes(40 / cell, 20 / cell);
    run_lifetime(&rules);
    measure(&off, &far_off);
    TEST_ASSERT_TRUE(off < most_off);
    TEST_ASSERT_TRUE(far_off <= 0.001);
}

static void test_one_scale_off_at_most(void)
{
    expect_close(40, 8, NEVER, 0.05);
    expect_close(50, 6, NEVER, 0.06);
    expect_close(20, 9, NEVER, 0.10);
}

static void test_one_scale_off_at_most_where_the_grid_is_halved(void)
{
    expect_close(40, 8, PROFILE_HALVING, 0.15);
    expect_close(50, 6, PROFILE_HALVING, 0.15);
    expect_close(20, 9, PROFILE_HALVING, 0.20);
}

/* In a square room the lifetime is the same from all sides and greatest in the middle, and
 * falls to 0 towards the walls. */
static void test_a_square_room(void)
{
    const uint32_t halve[] = {NEVER, PROFILE_HALVING};
    for (int k = 0; k < 2; k++) {
        rs_lifetime_rules rules = rules_of(40, halve[k]);
        sketch_free(&s);
        s = sketch_blank(64, 64, 255, 40);
        sketch_fill(&s, 2, 2, 60, 60, 0);
        run_lifetime(&rules);
        for (uint32_t y = 0; y < 64; y++) {
            for (uint32_t x = 0; x < 64; x++) {
                TEST_ASSERT_EQUAL_UINT8(life_at(x, y), life_at(y, x));
                TEST_ASSERT_EQUAL_UINT8(life_at(x, y), life_at(63 - x, y));
                TEST_ASSERT_LESS_OR_EQUAL_UINT8(life_at(31, 31), life_at(x, y));
            }
        }
        for (uint32_t x = 1; x < 32; x++) {
            TEST_ASSERT_LESS_OR_EQUAL_UINT8(life_at(x, 31), life_at(x - 1, 31));
        }
        TEST_ASSERT_EQUAL_UINT8(0, life_at(2, 31));
        /* Free share in the middle: (2 Phi(30 / sigma) - 1)^2 = 0.95 at sigma = 13.41. */
        TEST_ASSERT_EQUAL_UINT8(25, life_at(31, 31));
    }
}

static void test_nothing_free_and_all_free(void)
{
    rs_lifetime_rules rules = rules_of(40, PROFILE_HALVING);
    s = sketch_blank(20, 10, 255, 40);
    run_lifetime(&rules);
    for (uint32_t i = 0; i < 22 * 12; i++) {
        TEST_ASSERT_EQUAL_UINT8(0, cells[i]);
    }
    sketch_free(&s);
    s = sketch_blank(1, 1, 0, 200);
    rules = rules_of(200, PROFILE_HALVING);
    run_lifetime(&rules);
    TEST_ASSERT_LESS_OR_EQUAL_UINT8(1, life_at(0, 0));
}

/* A hall whose middle is still a seed at the last scale. */
static void test_saturation(void)
{
    rs_lifetime_rules rules = rules_of(200, PROFILE_HALVING);
    s = sketch_blank(150, 150, 0, 200);
    run_lifetime(&rules);
    TEST_ASSERT_EQUAL_UINT8(RS_LIFETIME_MAX, life_at(75, 75));
    TEST_ASSERT_LESS_THAN_UINT8(5, life_at(0, 75));
}

static void test_the_plan_holds_the_ring(void)
{
    for (uint32_t mm = ROOMSEG_MIN_RESOLUTION_MM; mm <= ROOMSEG_MAX_RESOLUTION_MM; mm++) {
        rs_lifetime_rules rules = rules_of(mm, PROFILE_HALVING);
        TEST_ASSERT_LESS_OR_EQUAL_UINT(ROOMSEG_BLUR_ROWS, rs_lifetime_ring_rows(&rules));
    }
}

/* What rs_coarsen_place promises: all levels fit into the shares of level 0. */
static void test_the_levels_fit(void)
{
    uint32_t margin = ROOMSEG_BLUR_MARGIN;
    for (uint32_t width = RS_COARSEN_MIN_SIDE; width < 2000; width += width / 9 + 1) {
        for (uint32_t height = RS_COARSEN_MIN_SIDE; height < 2000; height += height / 9 + 1) {
            rs_level levels[RS_LIFETIME_LEVELS] = {{width, height, 0, NULL}};
            size_t room = ROOMSEG_PLAN_BLURRED(width) * ROOMSEG_PLAN_BLURRED(height);
            uint16_t *shares = stage_scratch(room, sizeof *shares);
            uint32_t k = 0;
            while (k + 1 < RS_LIFETIME_LEVELS && levels[k].width >= RS_COARSEN_MIN_SIDE &&
                   levels[k].height >= RS_COARSEN_MIN_SIDE) {
                k++;
                rs_coarsen_place(levels, k, margin, shares);
                TEST_ASSERT_LESS_OR_EQUAL_size_t(
                    room, (size_t)(levels[k].lives - shares) +
                              (size_t)levels[k].width * levels[k].height);
            }
            free(shares);
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_one_scale_off_at_most);
    RUN_TEST(test_one_scale_off_at_most_where_the_grid_is_halved);
    RUN_TEST(test_a_square_room);
    RUN_TEST(test_nothing_free_and_all_free);
    RUN_TEST(test_saturation);
    RUN_TEST(test_the_plan_holds_the_ring);
    RUN_TEST(test_the_levels_fit);
    return UNITY_END();
}
