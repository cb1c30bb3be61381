/* Edges of drawn masks, against a plain version in floating point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "canny.h"
#include "stage.h"
#include "unity.h"

static rs_frame frame;
static uint8_t *mask;
static uint32_t *points;
static uint32_t point_count;
static sketch s;

void setUp(void)
{
    memset(&s, 0, sizeof s);
    mask = NULL;
    points = NULL;
}

void tearDown(void)
{
    sketch_free(&s);
    free(mask);
    free(points);
}

/* Edges of the sketch end in mask and points. */
static void run_canny(void)
{
    rs_ticker ticker = {0};
    frame = stage_frame(s.grid.width, s.grid.height);
    free(mask);
    free(points);
    mask = stage_mask(&frame, &s);
    points = stage_scratch((size_t)frame.width * frame.height, sizeof *points);
    uint16_t *rows = stage_scratch(ROOMSEG_CANNY_ROWS * (frame.stride + 2u), sizeof *rows);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_canny_run(&frame, mask, points, &point_count, rows, &ticker));
    free(rows);
}

static uint8_t edge_at(uint32_t x, uint32_t y)
{
    return mask[rs_frame_index(&frame, x, y)];
}

/* A room of 60 x 40: its edge runs along the free side of the wall, one cell thick. */
static void test_edges_lie_on_the_free_side(void)
{
    s = sketch_blank(100, 80, 255, 50);
    sketch_fill(&s, 20, 20, 60, 40, 0);
    run_canny();
    for (uint32_t x = 0; x < 100; x++) {
        uint8_t along = x >= 31 && x < 69;
        if (along || x < 20 || x >= 80) {
            TEST_ASSERT_EQUAL_UINT8(along, edge_at(x, 20));
            TEST_ASSERT_EQUAL_UINT8(0, edge_at(x, 19));
            TEST_ASSERT_EQUAL_UINT8(along, edge_at(x, 59));
            TEST_ASSERT_EQUAL_UINT8(0, edge_at(x, 60));
        }
    }
    for (uint32_t y = 31; y < 49; y++) {
        TEST_ASSERT_EQUAL_UINT8(1, edge_at(20, y));
        TEST_ASSERT_EQUAL_UINT8(1, edge_at(79, y));
    }
}

/* What lies beyond the crop is an obstacle: a free crop has an edge all around. */
static void test_the_border_is_an_edge(void)
{
    s = sketch_blank(50, 40, 0, 50);
    run_canny();
    for (uint32_t x = 11; x < 39; x++) {
        TEST_ASSERT_EQUAL_UINT8(1, edge_at(x, 0));
        TEST_ASSERT_EQUAL_UINT8(1, edge_at(x, 39));
    }
    for (uint32_t i = 0; i < frame.stride; i++) {
        TEST_ASSERT_EQUAL_UINT8(0, mask[i]);
        TEST_ASSERT_EQUAL_UINT8(0, mask[(size_t)(frame.height + 1u) * frame.stride + i]);
    }
}

static void test_no_edges_without_a_difference(void)
{
    s = sketch_blank(30, 30, 255, 50);
    run_canny();
    TEST_ASSERT_EQUAL_UINT(0, point_count);
}

/* Points: every edge cell once, in reading order. */
static void test_points_are_the_edges(void)
{
    s = sketch_rooms(2, 2, 40, 10, 50);
    run_canny();
    uint32_t next = 0;
    TEST_ASSERT_GREATER_THAN_UINT(400, point_count);
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            TEST_ASSERT_LESS_OR_EQUAL_UINT8(1, edge_at(x, y));
            if (edge_at(x, y) != 0) {
                TEST_ASSERT_EQUAL_HEX32(rs_cell_pack(x, y), points[next]);
                next++;
            }
        }
    }
    TEST_ASSERT_EQUAL_UINT(next, point_count);
}

static void test_every_small_size(void)
{
    for (uint32_t width = 1; width <= 24; width++) {
        for (uint32_t height = 1; height <= 24; height++) {
            s = sketch_blank(width, height, 0, 50);
            sketch_fill(&s, width / 2, height / 2, 1, 1, 255);
            run_canny();
            sketch_free(&s);
        }
    }
}

/* The plain version. */
static double *smooth(uint32_t width, uint32_t height)
{
    const int radius = (int)RS_CANNY_RADIUS;
    double total = 0.0;
    double weights[2 * RS_CANNY_RADIUS + 1];
    for (int k = -radius; k <= radius; k++) {
        weights[k + radius] = exp(-k * k / 8.0);
        total += weights[k + radius];
    }
    double *out = calloc((size_t)width * height, sizeof *out);
    double *half = calloc((size_t)width * height, sizeof *half);
    TEST_ASSERT_TRUE(out != NULL && half != NULL);
    for (int y = 0; y < (int)height; y++) {
        for (int x = 0; x < (int)width; x++) {
            for (int k = -radius; k <= radius; k++) {
                if (x + k >= 0 && x + k < (int)width &&
                    s.memory[(size_t)y * width + (size_t)(x + k)] == 0) {
                    half[(size_t)y * width + (size_t)x] += weights[k + radius] / total;
                }
            }
        }
    }
    for (int y = 0; y < (int)height; y++) {
        for (int x = 0; x < (int)width; x++) {
            for (int k = -radius; k <= radius; k++) {
                if (y + k >= 0 && y + k < (int)height) {
                    out[(size_t)y * width + (size_t)x] +=
                        half[(size_t)(y + k) * width + (size_t)x] * weights[k + radius] / total;
                }
            }
        }
    }
    free(half);
    return out;
}

static void gradient(const double *image, uint32_t width, size_t at, double *gx, double *gy)
{
    const double *above = image + at - width;
    const double *here = image + at;
    const double *below = image + at + width;
    *gx = above[1] + 2 * here[1] + below[1] - above[-1] - 2 * here[-1] - below[-1];
    *gy = below[-1] + 2 * below[0] + below[1] - above[-1] - 2 * above[0] - above[1];
}

static double magnitude(const double *image, uint32_t width, size_t at)
{
    double gx, gy;
    gradient(image, width, at, &gx, &gy);
    return hypot(gx, gy);
}

/* How clearly a cell is a crest: its lead over the interpolated values on both sides. */
static double lead(const double *image, uint32_t width, size_t at)
{
    double gx, gy;
    gradient(image, width, at, &gx, &gy);
    double longer = fmax(fabs(gx), fabs(gy));
    double share = fmin(fabs(gx), fabs(gy)) / longer;
    long along = fabs(gx) >= fabs(gy) ? (gx < 0 ? -1 : 1) : (gy < 0 ? -(long)width : (long)width);
    long diagonal = (gx < 0 ? -1 : 1) + (gy < 0 ? -(long)width : (long)width);
    size_t up = (size_t)((long)at + along), up_diagonal = (size_t)((long)at + diagonal);
    size_t down = (size_t)((long)at - along), down_diagonal = (size_t)((long)at - diagonal);
    double uphill = magnitude(image, width, up) * (1 - share) +
                    magnitude(image, width, up_diagonal) * share;
    double downhill = magnitude(image, width, down) * (1 - share) +
                      magnitude(image, width, down_diagonal) * share;
    return magnitude(image, width, at) - fmax(uphill, downhill);
}

/* Wherever the plain version is sure of a strong crest or sure that there is none, the stage
 * says the same. */
static void test_against_floating_point(void)
{
    const double unsure = 0.004;
    uint32_t random = 7, sure = 0;
    s = sketch_blank(160, 140, 0, 50);
    for (int i = 0; i < 25; i++) {
        random = random * 1664525u + 1013904223u;
        uint32_t x = random >> 8 & 127u, y = random >> 15 & 63u;
        sketch_fill(&s, 4 + x, 4 + y, 3 + (random >> 22 & 15u), 3 + (random >> 26 & 31u), 255);
    }
    run_canny();
    double *image = smooth(160, 140);
    for (uint32_t y = 3; y < 137; y++) {
        for (uint32_t x = 3; x < 157; x++) {
            size_t at = (size_t)y * 160 + x;
            double strength = magnitude(image, 160, at);
            if (strength > 0.2 + unsure && lead(image, 160, at) > unsure) {
                TEST_ASSERT_EQUAL_UINT8(1, edge_at(x, y));
                sure++;
            } else if (strength < 0.1 - unsure || lead(image, 160, at) < -unsure) {
                TEST_ASSERT_EQUAL_UINT8(0, edge_at(x, y));
            }
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT(300, sure);
    free(image);
}

/* A blob too faint for an edge of its own has one where a strong edge goes on in it. */
static void test_weak_edges_live_on_strong_ones_alone(void)
{
    s = sketch_blank(80, 40, 0, 50);
    sketch_fill(&s, 36, 20, 1, 2, 255);
    run_canny();
    TEST_ASSERT_EQUAL_UINT8(0, edge_at(34, 20));
    TEST_ASSERT_EQUAL_UINT8(0, edge_at(38, 20));
    sketch_fill(&s, 10, 20, 60, 1, 255);
    run_canny();
    uint32_t found = 0;
    for (uint32_t y = 14; y < 28; y++) {
        found += edge_at(40, y);
    }
    TEST_ASSERT_EQUAL_UINT(2, found);
}

static void test_cancelling(void)
{
    s = sketch_blank(600, 600, 0, 50);
    frame = stage_frame(600, 600);
    points = stage_scratch((size_t)600 * 600, sizeof *points);
    uint16_t *rows = stage_scratch(ROOMSEG_CANNY_ROWS * (frame.stride + 2u), sizeof *rows);
    for (uint32_t call = 0; call < 8; call++) {
        uint32_t left = call;
        rs_ticker ticker = stage_canceller(&left);
        free(mask);
        mask = stage_mask(&frame, &s);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED,
                              rs_canny_run(&frame, mask, points, &point_count, rows, &ticker));
    }
    free(rows);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_edges_lie_on_the_free_side);
    RUN_TEST(test_the_border_is_an_edge);
    RUN_TEST(test_no_edges_without_a_difference);
    RUN_TEST(test_points_are_the_edges);
    RUN_TEST(test_every_small_size);
    RUN_TEST(test_against_floating_point);
    RUN_TEST(test_weak_edges_live_on_strong_ones_alone);
    RUN_TEST(test_cancelling);
    return UNITY_END();
}
