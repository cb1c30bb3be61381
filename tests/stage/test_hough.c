/* Lines among drawn edge cells, and the direction of most of them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "direction.h"
#include "hough.h"
#include "stage.h"
#include "trig.h"
#include "unity.h"

#define MAX_LINES 64

static rs_frame frame;
static uint8_t *edges;
static rs_line lines[MAX_LINES];
static uint32_t line_count;
static int32_t angle;

void setUp(void)
{
    frame = stage_frame(200, 150);
    edges = stage_buffer(&frame);
}

void tearDown(void)
{
    free(edges);
}

/* Edge cells from (x, y) on in a direction, `step` cells from one to the next. */
static void draw(double x, double y, double degrees, double length, double step)
{
    double radians = degrees * acos(-1.0) / 180.0;
    for (double at = 0; at <= length; at += step) {
        uint32_t column = (uint32_t)floor(x + at * cos(radians) + 0.5);
        uint32_t row = (uint32_t)floor(y + at * sin(radians) + 0.5);
        TEST_ASSERT_TRUE(column < frame.width && row < frame.height);
        edges[rs_frame_index(&frame, column, row)] = 1;
    }
}

static uint32_t *list_edges(uint32_t *count)
{
    uint32_t *points = stage_scratch((size_t)frame.width * frame.height, sizeof *points);
    *count = 0;
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            if (edges[rs_frame_index(&frame, x, y)] != 0) {
                points[(*count)++] = rs_cell_pack(x, y);
            }
        }
    }
    return points;
}

/* All segments end in `lines`, their common direction in `angle`. Returns the status. */
static int find_lines(rs_ticker *ticker)
{
    rs_hough hough;
    rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
    size_t distances = ROOMSEG_PLAN_DISTANCES(frame.width, frame.height);
    uint16_t *votes = stage_scratch(ROOMSEG_HOUGH_ANGLES * distances, sizeof *votes);
    rs_normal *normals = stage_scratch(ROOMSEG_HOUGH_ANGLES, sizeof *normals);
    uint32_t count;
    uint32_t *points = list_edges(&count);
    bool found = true;
    int status = ROOMSEG_OK;
    line_count = 0;
    rs_direction_clear(bins);
    rs_hough_init(&hough, &frame, edges, points, count, votes, normals);
    while (status == ROOMSEG_OK && found) {
        rs_line line;
        status = rs_hough_next(&hough, &line, &found, ticker);
        if (status == ROOMSEG_OK && found) {
            TEST_ASSERT_LESS_THAN_UINT(MAX_LINES, line_count);
            lines[line_count++] = line;
            rs_direction_add(bins, &line);
        }
    }
    angle = rs_direction_find(bins);
    free(votes);
    free(normals);
    free(points);
    return status;
}

static void find_all(void)
{
    rs_ticker ticker = {0};
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, find_lines(&ticker));
}

static double length_of(const rs_line *line)
{
    return hypot((double)line->x1 - line->x0, (double)line->y1 - line->y0);
}

static void test_a_horizontal_line(void)
{
    draw(20, 70, 0, 120, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(1, line_count);
    TEST_ASSERT_EQUAL_UINT(70, lines[0].y0);
    TEST_ASSERT_EQUAL_UINT(70, lines[0].y1);
    TEST_ASSERT_EQUAL_UINT(120, abs(lines[0].x1 - lines[0].x0));
    TEST_ASSERT_EQUAL_INT32(0, angle);
}

static void test_a_vertical_line(void)
{
    draw(33, 10, 90, 100, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(1, line_count);
    TEST_ASSERT_EQUAL_UINT(33, lines[0].x0);
    TEST_ASSERT_EQUAL_UINT(100, abs(lines[0].y1 - lines[0].y0));
    TEST_ASSERT_EQUAL_INT32(0, angle);
}

/* Lines in all directions: most of each is found, and the direction is right. */
static void test_every_direction(void)
{
    for (int degrees = 0; degrees < 180; degrees += 7) {
        double radians = degrees * acos(-1.0) / 180.0;
        draw(100 - 60 * cos(radians), 75 - 60 * sin(radians), degrees, 120, 0.5);
        find_all();
        double total = 0.0;
        for (uint32_t i = 0; i < line_count; i++) {
            total += length_of(&lines[i]);
        }
        TEST_ASSERT_TRUE(total > 80.0);
        TEST_ASSERT_TRUE(fabs(remainder(angle / 100.0 - degrees, 90.0)) <= 1.0);
        memset(edges, 0, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
    }
}

/* 18 cells are too few votes, 40 cells are enough. */
static void test_a_line_needs_votes(void)
{
    draw(20, 70, 0, 17, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(0, line_count);
    draw(20, 70, 0, 39, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(1, line_count);
}

/* Holes of four cells are crossed, holes of six end a segment. */
static void test_gaps(void)
{
    draw(10, 40, 0, 30, 1);
    draw(45, 40, 0, 30, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(1, line_count);
    TEST_ASSERT_EQUAL_UINT(65, abs(lines[0].x1 - lines[0].x0));
    memset(edges, 0, ROOMSEG_PLAN_CELLS(frame.width, frame.height));
    draw(10, 40, 0, 30, 1);
    draw(47, 40, 0, 30, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(2, line_count);
    TEST_ASSERT_EQUAL_UINT(30, abs(lines[0].x1 - lines[0].x0));
    TEST_ASSERT_EQUAL_UINT(30, abs(lines[1].x1 - lines[1].x0));
}

/* Many short pieces on one straight line give votes but no segment. */
static void test_short_pieces_are_no_segments(void)
{
    for (uint32_t i = 0; i < 12; i++) {
        draw(5.0 + 15.0 * i, 60, 0, 4, 1);
    }
    find_all();
    TEST_ASSERT_EQUAL_UINT(0, line_count);
}

/* The cells of a segment are taken away, all edges in the end. */
static void test_edges_are_used_up(void)
{
    draw(10, 40, 0, 100, 1);
    draw(50, 10, 90, 100, 1);
    find_all();
    TEST_ASSERT_EQUAL_UINT(2, line_count);
    for (uint32_t x = 10; x <= 110; x++) {
        TEST_ASSERT_EQUAL_UINT8(0, edges[rs_frame_index(&frame, x, 40)]);
    }
}

static void test_two_runs_are_alike(void)
{
    for (uint32_t i = 0; i < 10; i++) {
        draw(20.0 + i * 3.0, 10.0 + 2.0 * i, 17.0 * i, 20 + 3.0 * i > 45 ? 45 : 20 + 3.0 * i, 0.7);
    }
    uint8_t *copy = stage_buffer(&frame);
    size_t bytes = ROOMSEG_PLAN_CELLS(frame.width, frame.height);
    memcpy(copy, edges, bytes);
    find_all();
    rs_line first[MAX_LINES];
    uint32_t first_count = line_count;
    memcpy(first, lines, sizeof first);
    memcpy(edges, copy, bytes);
    find_all();
    TEST_ASSERT_EQUAL_UINT(first_count, line_count);
    TEST_ASSERT_EQUAL_INT(0, memcmp(first, lines, line_count * sizeof *lines));
    free(copy);
}

static void test_cancelling(void)
{
    for (uint32_t y = 0; y < 150; y += 2) {
        draw(0, y, 0, 199, 1);
    }
    uint32_t left = 3;
    rs_ticker ticker = stage_canceller(&left);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED, find_lines(&ticker));
}

static rs_line make_line(double degrees, double length)
{
    double radians = degrees * acos(-1.0) / 180.0;
    rs_line line = {30000, 30000, (uint16_t)lround(30000 + length * cos(radians)),
                    (uint16_t)lround(30000 + length * sin(radians))};
    return line;
}

/* The histogram's window takes what lies around 0 and around 90 degrees together. */
static void test_the_window_goes_round(void)
{
    rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
    const double degrees[4] = {-1.5, 0.5, 89.5, 91.5};
    rs_direction_clear(bins);
    TEST_ASSERT_EQUAL_INT32(0, rs_direction_find(bins));
    for (int i = 0; i < 4; i++) {
        rs_line line = make_line(degrees[i], 1000);
        rs_direction_add(bins, &line);
    }
    rs_line other = make_line(40, 2500);
    rs_direction_add(bins, &other);
    TEST_ASSERT_INT_WITHIN(10, 0, rs_direction_find(bins));
}

/* Length counts, not number. */
static void test_long_lines_outweigh_many_short_ones(void)
{
    rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
    rs_direction_clear(bins);
    for (int i = 0; i < 30; i++) {
        rs_line line = make_line(70, 20);
        rs_direction_add(bins, &line);
    }
    rs_line line = make_line(-33.3, 20000);
    rs_direction_add(bins, &line);
    TEST_ASSERT_INT_WITHIN(2, -3330, rs_direction_find(bins));
}

/* Within the window a segment's weight is the cube of its length: what n short ones say off by
 * a degree and a half moves the mean by little. */
static void test_long_lines_are_more_precise(void)
{
    rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
    rs_direction_clear(bins);
    for (int i = 0; i < 30; i++) {
        rs_line line = make_line(21.5, 40);
        rs_direction_add(bins, &line);
    }
    rs_line line = make_line(20.0, 400);
    rs_direction_add(bins, &line);
    TEST_ASSERT_INT_WITHIN(8, 2000, rs_direction_find(bins));
}

static void test_directions_between_the_bins(void)
{
    for (int tenths = -450; tenths < 450; tenths += 3) {
        rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
        rs_line line = make_line(tenths / 10.0, 25000);
        rs_direction_clear(bins);
        rs_direction_add(bins, &line);
        double off = remainder(rs_direction_find(bins) / 100.0 - tenths / 10.0, 90.0);
        TEST_ASSERT_TRUE(fabs(off) < 0.02);
        TEST_ASSERT_TRUE(rs_direction_find(bins) >= -4500 && rs_direction_find(bins) < 4500);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_horizontal_line);
    RUN_TEST(test_a_vertical_line);
    RUN_TEST(test_every_direction);
    RUN_TEST(test_a_line_needs_votes);
    RUN_TEST(test_gaps);
    RUN_TEST(test_short_pieces_are_no_segments);
    RUN_TEST(test_edges_are_used_up);
    RUN_TEST(test_two_runs_are_alike);
    RUN_TEST(test_cancelling);
    RUN_TEST(test_the_window_goes_round);
    RUN_TEST(test_long_lines_outweigh_many_short_ones);
    RUN_TEST(test_long_lines_are_more_precise);
    RUN_TEST(test_directions_between_the_bins);
    return UNITY_END();
}
