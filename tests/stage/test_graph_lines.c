/* Borders between regions, and what becomes of them. Letters are regions, '*' lines, '#'
 * background; in results ' ' is no label. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "cluster.h"
#include "flood.h"
#include "graph_lines.h"
#include "unity.h"

enum { MAX_REGIONS = 8, MAX_EDGES = 24, MAX_CELLS = 128 };

static uint8_t cells[MAX_CELLS];
static roomseg_grid grid;
static rs_region regions[MAX_REGIONS + 1];
static rs_edge edges[MAX_EDGES];
static rs_graph graph;

static void draw(const char *const *rows, uint32_t height)
{
    flood_prepare((uint32_t)strlen(rows[0]), height);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(MAX_CELLS, frame.width * height);
    memset(cells, 0, sizeof cells);
    grid = (roomseg_grid){cells, frame.width, height, frame.width, 40};
    graph = (rs_graph){regions, edges, NULL, 0, 0, 0};
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint16_t label = flood_letter(rows[y][x]);
            *label_at(x, y) = label;
            surface[rs_frame_index(&frame, x, y)] = (uint8_t)(1 + x);
            if (label <= MAX_REGIONS && label > graph.region_count) {
                graph.region_count = label;
            }
        }
    }
}

static int build(uint32_t max_edges)
{
    rs_ticker ticker = {0};
    return rs_graph_lines_build(&frame, &grid, 204, surface, &labels, &graph, max_edges,
                                &ticker);
}

static const rs_edge *edge_of(char p, char q)
{
    for (uint32_t e = 0; e < graph.edge_count; e++) {
        if (edges[e].a == flood_letter(p) && edges[e].b == flood_letter(q)) {
            return &edges[e];
        }
    }
    return NULL;
}

static void resolve(void)
{
    rs_ticker ticker = {0};
    uint16_t *rows = stage_scratch(3u * (size_t)frame.width, sizeof *rows);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_graph_lines_resolve(&frame, &grid, 204, surface,
                                                             &labels, &graph, rows, &ticker));
    free(rows);
}

/* A capital letter stands for any region of the cluster of its small one. */
static void expect(const char *const *rows)
{
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            uint16_t found = *label_at(x, y);
            char c = rows[y][x];
            if (isupper((unsigned char)c)) {
                TEST_ASSERT_NOT_EQUAL_UINT16(0, found);
                TEST_ASSERT_EQUAL_UINT16(
                    rs_cluster_root(regions, flood_letter((char)tolower((unsigned char)c))),
                    rs_cluster_root(regions, found));
            } else {
                TEST_ASSERT_EQUAL_UINT16(flood_letter(c), found);
            }
        }
    }
}

static const char *const three[] = {
    "###########", "#****#****#", "#aaa***bbb#", "#aaaa*bbbb#",
    "#aaaa*bbbb#", "#*********#", "#ccccccccc#", "###########",
};

static void test_borders_and_areas(void)
{
    draw(three, 8);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, build(MAX_EDGES));
    TEST_ASSERT_EQUAL_UINT(3, graph.edge_count);
    TEST_ASSERT_EQUAL_UINT(11, regions[1].area);
    TEST_ASSERT_EQUAL_UINT(11, regions[2].area);
    TEST_ASSERT_EQUAL_UINT(9, regions[3].area);
    TEST_ASSERT_EQUAL_UINT(rs_frame_index(&frame, 1, 2), regions[1].first_cell);
    /* The cell that a, b and c meet at belongs to no border. */
    TEST_ASSERT_EQUAL_UINT(3, edge_of('a', 'b')->border);
    TEST_ASSERT_EQUAL_UINT(4, edge_of('a', 'c')->border);
    TEST_ASSERT_EQUAL_UINT(4, edge_of('b', 'c')->border);
    TEST_ASSERT_EQUAL_UINT(10, edge_of('b', 'c')->saddle);
    TEST_ASSERT_EQUAL_UINT(9, edge_of('b', 'c')->x);
    TEST_ASSERT_EQUAL_UINT(5, edge_of('b', 'c')->y);
    TEST_ASSERT_EQUAL_UINT(5, regions[1].peak);
    TEST_ASSERT_EQUAL_UINT(4, regions[1].peak_x);
}

static void test_occupied_cells_do_not_count(void)
{
    draw(three, 8);
    cells[2 * frame.width + 1] = 204;
    cells[2 * frame.width + 2] = 203;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, build(MAX_EDGES));
    TEST_ASSERT_EQUAL_UINT(10, regions[1].area);
    TEST_ASSERT_EQUAL_UINT(rs_frame_index(&frame, 2, 2), regions[1].first_cell);
}

static void test_too_many_borders(void)
{
    draw(three, 8);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_REGIONS, build(2));
}

static void test_nothing_merged(void)
{
    const char *const wanted[] = {
        "           ", "           ", " aaa   bbb ", " aaaa bbbb ",
        " aaaa bbbb ", "           ", " ccccccccc ", "           ",
    };
    draw(three, 8);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, build(MAX_EDGES));
    resolve();
    expect(wanted);
    TEST_ASSERT_EQUAL_UINT(11, regions[1].area);
}

/* The border between a and c becomes theirs but for its two ends. */
static void test_inner_borders(void)
{
    const char *const wanted[] = {
        "           ", "           ", " AAA   bbb ", " AAAA bbbb ",
        " AAAA bbbb ", "  AA       ", " AAAAAAAAA ", "           ",
    };
    draw(three, 8);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, build(MAX_EDGES));
    uint16_t root = rs_cluster_unite(&graph, 1, 3);
    resolve();
    expect(wanted);
    TEST_ASSERT_EQUAL_UINT(11 + 9 + 2, regions[root].area);
    TEST_ASSERT_EQUAL_UINT(rs_frame_index(&frame, 1, 2), regions[root].first_cell);
}

static void test_a_crossing_stays_without_label(void)
{
    draw(three, 8);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, build(MAX_EDGES));
    rs_cluster_unite(&graph, rs_cluster_unite(&graph, 1, 3), 2);
    resolve();
    TEST_ASSERT_EQUAL_UINT16(0, *label_at(5, 5));
    TEST_ASSERT_NOT_EQUAL_UINT16(0, *label_at(3, 5));
    TEST_ASSERT_NOT_EQUAL_UINT16(0, *label_at(5, 3));
    TEST_ASSERT_EQUAL_UINT(10, regions[rs_cluster_root(regions, 1)].peak);
}

static void test_one_row(void)
{
    const char *const rows[] = {"aa*bb*cc"};
    const char *const wanted[] = {"aaAbb cc"};
    draw(rows, 1);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, build(MAX_EDGES));
    TEST_ASSERT_EQUAL_UINT(1, edge_of('a', 'b')->border);
    rs_cluster_unite(&graph, 1, 2);
    resolve();
    expect(wanted);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_borders_and_areas);
    RUN_TEST(test_occupied_cells_do_not_count);
    RUN_TEST(test_too_many_borders);
    RUN_TEST(test_nothing_merged);
    RUN_TEST(test_inner_borders);
    RUN_TEST(test_a_crossing_stays_without_label);
    RUN_TEST(test_one_row);
    return UNITY_END();
}
