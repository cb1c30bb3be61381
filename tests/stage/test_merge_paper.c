/* The three merging rules, one by one, and on random graphs against a version that looks at
 * everything anew before each step. */
#include <stdlib.h>
#include <string.h>

#include "cluster.h"
#include "merge_paper.h"
#include "stage.h"
#include "unity.h"

enum { MAX_REGIONS = 60, MAX_EDGES = 3 * MAX_REGIONS };

static rs_region regions[MAX_REGIONS + 1];
static rs_edge edges[MAX_EDGES];
static rs_graph graph;
static rs_graph_builder builder;
static rs_heap_item heap[MAX_EDGES];
static uint32_t marks[MAX_REGIONS + 1];
static rs_merge_paper_rules rules;

void setUp(void)
{
    rules = (rs_merge_paper_rules){625, 10, 75};
}

void tearDown(void)
{
}

/* Regions of these areas, the list ending with 0. */
static void make_regions(const uint32_t *areas)
{
    graph = (rs_graph){regions, edges, NULL, 0, 0, 0};
    while (areas[graph.region_count] > 0) {
        graph.region_count++;
    }
    rs_graph_begin(&graph, MAX_EDGES, &builder);
    for (uint32_t r = 1; r <= graph.region_count; r++) {
        regions[r].area = areas[r - 1];
    }
}

static void share(uint16_t p, uint16_t q, uint32_t border)
{
    rs_graph_edge(&builder, p, q)->border = border;
}

/* The heap has the least room that it may have: it fills up, and is made anew. */
static void merge(void)
{
    rs_ticker ticker = {0};
    uint32_t room = graph.region_count > graph.edge_count ? graph.region_count : graph.edge_count;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_merge_paper_run(&rules, &graph, heap, room, marks,
                                                         &ticker));
}

static bool together(uint16_t p, uint16_t q)
{
    return rs_cluster_root(regions, p) == rs_cluster_root(regions, q);
}

static uint32_t area_of(uint16_t region)
{
    return regions[rs_cluster_root(regions, region)].area;
}

static void test_isolated_regions_go_below_a0_or_their_share(void)
{
    const uint32_t areas[] = {624, 625, 2000, 97375, 1000, 0};
    make_regions(areas); /* 1 % of the whole is 1016.24 */
    merge();
    TEST_ASSERT_EQUAL_UINT(0, area_of(1));
    TEST_ASSERT_EQUAL_UINT(0, area_of(2));
    TEST_ASSERT_EQUAL_UINT(2000, area_of(3));
    TEST_ASSERT_EQUAL_UINT(97375, area_of(4));
    TEST_ASSERT_EQUAL_UINT(0, area_of(5));
}

static void test_without_a_share_a0_alone_counts(void)
{
    const uint32_t areas[] = {624, 625, 97375, 0};
    rules.isolated_permille = 0;
    make_regions(areas);
    merge();
    TEST_ASSERT_EQUAL_UINT(0, area_of(1));
    TEST_ASSERT_EQUAL_UINT(625, area_of(2));
}

static void test_small_regions_join_the_longest_border(void)
{
    const uint32_t areas[] = {5000, 600, 5000, 625, 0};
    make_regions(areas);
    share(1, 2, 20);
    share(2, 3, 21);
    share(1, 4, 20); /* large enough to stay */
    merge();
    TEST_ASSERT_TRUE(together(2, 3));
    TEST_ASSERT_FALSE(together(1, 2));
    TEST_ASSERT_FALSE(together(1, 4));
    TEST_ASSERT_EQUAL_UINT(5600, area_of(2));
}

/* 2 has one neighbour, 3 has two: 2 goes first, into 3, which then is large enough. By area
 * 3 would go first, into 4. */
static void test_fewest_neighbours_first(void)
{
    const uint32_t areas[] = {5000, 400, 300, 5000, 0};
    make_regions(areas);
    share(2, 3, 10);
    share(3, 4, 30);
    share(1, 4, 10);
    merge();
    TEST_ASSERT_TRUE(together(2, 3));
    TEST_ASSERT_FALSE(together(3, 4));
}

/* A border of one face makes a neighbour: 2 has two of them, 3 has three. */
static void test_the_shortest_border_counts(void)
{
    const uint32_t areas[] = {5000, 400, 300, 5000, 0};
    make_regions(areas);
    share(1, 3, 1);
    share(1, 2, 5);
    share(2, 3, 10);
    share(3, 4, 30);
    merge();
    TEST_ASSERT_TRUE(together(2, 3));
    TEST_ASSERT_FALSE(together(3, 4));
}

/* Both have one neighbour; the smaller one goes first, and then the neighbour is large. */
static void test_then_the_smaller_one(void)
{
    const uint32_t areas[] = {500, 400, 300, 0};
    rules.smallest_cells = 650;
    make_regions(areas);
    share(1, 2, 10);
    share(2, 3, 10);
    merge();
    TEST_ASSERT_TRUE(together(2, 3));
    TEST_ASSERT_TRUE(together(1, 2));
    TEST_ASSERT_EQUAL_UINT(1200, area_of(1));
}

/* 3 merges into 1; its border with 2 is added to that of 1, which makes it longer than 4's. */
static void test_borders_with_common_neighbours_add_up(void)
{
    const uint32_t areas[] = {5000, 600, 300, 5000, 0};
    make_regions(areas);
    share(1, 3, 50);
    share(2, 3, 20);
    share(1, 2, 30);
    share(2, 4, 40);
    merge();
    TEST_ASSERT_TRUE(together(1, 3));
    TEST_ASSERT_TRUE(together(1, 2));
    TEST_ASSERT_FALSE(together(1, 4));
}

static void test_borders_beyond_l0_are_opened(void)
{
    const uint32_t areas[] = {5000, 6000, 7000, 0};
    make_regions(areas);
    share(1, 2, 75);
    share(2, 3, 76);
    merge();
    TEST_ASSERT_TRUE(together(2, 3));
    TEST_ASSERT_FALSE(together(1, 2));
}

/* Two borders of 40 become one of 80 when 2 and 3 merge. */
static void test_opening_makes_borders_longer(void)
{
    const uint32_t areas[] = {5000, 6000, 7000, 0};
    make_regions(areas);
    share(1, 2, 40);
    share(1, 3, 40);
    share(2, 3, 100);
    merge();
    TEST_ASSERT_TRUE(together(1, 2));
    TEST_ASSERT_TRUE(together(1, 3));
}

/* Two small regions with nobody else: they merge, and what comes out goes. */
static void test_an_isolated_pair_goes(void)
{
    const uint32_t areas[] = {300, 200, 90000, 0};
    make_regions(areas);
    share(1, 2, 10);
    merge();
    TEST_ASSERT_EQUAL_UINT(0, area_of(1));
    TEST_ASSERT_EQUAL_UINT(90000, area_of(3));
}

/* ---- the plain version: a matrix of borders */

static uint32_t plain_border[MAX_REGIONS + 1][MAX_REGIONS + 1];
static uint32_t plain_area[MAX_REGIONS + 1];
static uint16_t plain_root[MAX_REGIONS + 1]; /* 0: gone */

static uint32_t plain_degree(uint32_t r)
{
    uint32_t count = 0;
    for (uint32_t q = 1; q <= graph.region_count; q++) {
        count += plain_border[r][q] > 0;
    }
    return count;
}

static bool plain_stands(uint32_t r)
{
    return plain_root[r] == r;
}

static void plain_drop(void)
{
    uint32_t total = 0;
    for (uint32_t r = 1; r <= graph.region_count; r++) {
        total += plain_stands(r) ? plain_area[r] : 0;
    }
    for (uint32_t r = 1; r <= graph.region_count; r++) {
        if (plain_stands(r) && plain_degree(r) == 0 &&
            (plain_area[r] < rules.smallest_cells ||
             (uint64_t)plain_area[r] * 1000 < (uint64_t)total * rules.isolated_permille)) {
            for (uint32_t q = 1; q <= graph.region_count; q++) {
                plain_root[q] = plain_root[q] == r ? 0 : plain_root[q];
            }
        }
    }
}

static void plain_unite(uint32_t a, uint32_t b)
{
    plain_area[a] += plain_area[b];
    for (uint32_t q = 1; q <= graph.region_count; q++) {
        plain_root[q] = plain_root[q] == b ? (uint16_t)a : plain_root[q];
        if (q != a) {
            plain_border[a][q] += plain_border[b][q];
            plain_border[q][a] = plain_border[a][q];
        }
        plain_border[b][q] = 0;
        plain_border[q][b] = 0;
    }
    plain_border[a][a] = 0;
}

static bool plain_step(void)
{
    uint32_t best = 0, partner = 0;
    for (uint32_t r = 1; r <= graph.region_count; r++) {
        if (plain_stands(r) && plain_area[r] < rules.smallest_cells && plain_degree(r) > 0 &&
            (best == 0 || plain_degree(r) < plain_degree(best) ||
             (plain_degree(r) == plain_degree(best) && plain_area[r] < plain_area[best]))) {
            best = r;
        }
    }
    if (best == 0) {
        return false;
    }
    for (uint32_t q = 1; q <= graph.region_count; q++) {
        partner = plain_border[best][q] > plain_border[best][partner] ? q : partner;
    }
    plain_unite(best, partner);
    return true;
}

static void plain_merge(void)
{
    plain_drop();
    while (plain_step()) {
        plain_drop();
    }
    for (;;) {
        uint32_t a = 0, b = 0;
        for (uint32_t i = 1; i <= graph.region_count; i++) {
            for (uint32_t j = 1; j <= graph.region_count; j++) {
                if (plain_border[i][j] > plain_border[a][b]) {
                    a = i;
                    b = j;
                }
            }
        }
        if (plain_border[a][b] <= rules.longest_border) {
            return;
        }
        plain_unite(a, b);
    }
}

/* Areas and borders are drawn from ranges so wide that ties hardly occur. */
static uint32_t next_random(uint32_t *seed)
{
    *seed = *seed * 1664525 + 1013904223;
    return *seed >> 8;
}

static void make_random(uint32_t *seed)
{
    uint32_t areas[MAX_REGIONS + 1] = {0};
    uint32_t count = 2 + next_random(seed) % (MAX_REGIONS - 1);
    uint32_t span = 1 + next_random(seed) % 8;
    for (uint32_t r = 0; r < count; r++) {
        areas[r] = 10007 + next_random(seed) % 1000000;
    }
    make_regions(areas);
    memset(plain_border, 0, sizeof plain_border);
    for (uint16_t r = 1; r <= count; r++) {
        plain_area[r] = areas[r - 1];
        plain_root[r] = r;
        for (int k = 0; k < 2; k++) {
            uint16_t q = (uint16_t)(r + 1 + next_random(seed) % span);
            if (q <= count && plain_border[r][q] == 0) {
                plain_border[r][q] = 100003 + next_random(seed) % 10000000;
                plain_border[q][r] = plain_border[r][q];
                share(r, q, plain_border[r][q]);
            }
        }
    }
}

/* Each touches each: no graph of so few regions has more to queue again. */
static void make_complete(uint32_t *seed, uint16_t count)
{
    uint32_t areas[MAX_REGIONS + 1] = {0};
    for (uint32_t r = 0; r < count; r++) {
        areas[r] = 10007 + next_random(seed) % 1000000;
    }
    make_regions(areas);
    memset(plain_border, 0, sizeof plain_border);
    for (uint16_t r = 1; r <= count; r++) {
        plain_area[r] = areas[r - 1];
        plain_root[r] = r;
        for (uint16_t q = 1; q < r; q++) {
            plain_border[r][q] = 100003 + next_random(seed) % 10000000;
            plain_border[q][r] = plain_border[r][q];
            share(r, q, plain_border[r][q]);
        }
    }
}

static void expect_the_plain_result(void)
{
    plain_merge();
    merge();
    for (uint16_t p = 1; p <= graph.region_count; p++) {
        TEST_ASSERT_EQUAL(plain_root[p] == 0, area_of(p) == 0);
        for (uint16_t q = 1; q < p; q++) {
            if (plain_root[p] != 0 && plain_root[q] != 0) {
                TEST_ASSERT_EQUAL(plain_root[p] == plain_root[q], together(p, q));
            }
        }
    }
}

static void test_random_graphs(void)
{
    uint32_t seed = 11;
    for (int round = 0; round < 3000; round++) {
        make_random(&seed);
        rules.smallest_cells = 10000 + next_random(&seed) % 700000;
        rules.longest_border = 3000000 + next_random(&seed) % 20000000;
        rules.isolated_permille = next_random(&seed) % 50;
        expect_the_plain_result();
    }
}

/* The heap fills with old entries, and is made anew, in rule 2 and in rule 3. */
static void test_complete_graphs(void)
{
    uint32_t seed = 13;
    for (uint16_t count = 2; count <= 18; count++) {
        for (uint32_t round = 0; round < 50; round++) {
            make_complete(&seed, count);
            rules.smallest_cells = 100000 * (1 + round % 25);
            rules.longest_border = 20000000;
            expect_the_plain_result();
            make_complete(&seed, count);
            rules.smallest_cells = 1;
            rules.longest_border = 400000 * (round % 25);
            expect_the_plain_result();
        }
    }
}

/* As little heap as is allowed gives the same. */
static void test_a_small_heap(void)
{
    rs_ticker ticker = {0};
    uint32_t seed = 12;
    for (int round = 0; round < 300; round++) {
        uint16_t roots[MAX_REGIONS + 1];
        uint32_t before = seed;
        make_random(&seed);
        rules.smallest_cells = 400000;
        rules.longest_border = 6000000;
        merge();
        for (uint16_t r = 1; r <= graph.region_count; r++) {
            roots[r] = rs_cluster_root(regions, r);
        }
        seed = before;
        make_random(&seed);
        uint32_t least = rs_max_u32(graph.region_count, graph.edge_count);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, rs_merge_paper_run(&rules, &graph, heap, least, marks,
                                                             &ticker));
        for (uint16_t r = 1; r <= graph.region_count; r++) {
            TEST_ASSERT_EQUAL_UINT16(roots[r], rs_cluster_root(regions, r));
        }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_isolated_regions_go_below_a0_or_their_share);
    RUN_TEST(test_without_a_share_a0_alone_counts);
    RUN_TEST(test_small_regions_join_the_longest_border);
    RUN_TEST(test_fewest_neighbours_first);
    RUN_TEST(test_the_shortest_border_counts);
    RUN_TEST(test_then_the_smaller_one);
    RUN_TEST(test_borders_with_common_neighbours_add_up);
    RUN_TEST(test_borders_beyond_l0_are_opened);
    RUN_TEST(test_opening_makes_borders_longer);
    RUN_TEST(test_an_isolated_pair_goes);
    RUN_TEST(test_random_graphs);
    RUN_TEST(test_complete_graphs);
    RUN_TEST(test_a_small_heap);
    return UNITY_END();
}
