/* What is dropped as no room, on graphs made by hand. Regions 1 and 2 are the map; 3 is in
 * question. */
#include "cluster.h"
#include "drop.h"
#include "stage.h"
#include "unity.h"

enum { MAX_EDGES = 12 };

static rs_region regions[5];
static rs_edge edges[MAX_EDGES];
static rs_graph graph;
static rs_graph_builder builder;

static void set(uint16_t r, uint32_t area, uint32_t border, uint32_t walls)
{
    regions[r].area = area;
    regions[r].border = border;
    regions[r].walls = walls;
}

static void touch(uint16_t p, uint16_t q, uint16_t saddle)
{
    rs_graph_edge(&builder, p, q)->saddle = saddle;
}

/* Two rooms, nine tenths of whose border are walls, and a third of 100 faces that touches the
 * first. */
void setUp(void)
{
    graph = (rs_graph){regions, edges, NULL, 4, 0, 0};
    rs_graph_begin(&graph, MAX_EDGES, &builder);
    set(1, 10000, 1000, 900);
    set(2, 10000, 1000, 900);
    touch(1, 2, 9);
    touch(1, 3, 9);
}

void tearDown(void)
{
}

static bool stays(uint32_t isolated_cells, uint32_t unwalled_percent)
{
    rs_drop_run(isolated_cells, unwalled_percent, &graph);
    TEST_ASSERT_EQUAL_UINT32(10000, regions[1].area);
    return regions[3].area != 0;
}

/* walls / 100 below half of (1800 + walls) / 2100: up to 43. */
static void test_a_dead_end_with_few_walls(void)
{
    set(3, 100, 100, 43);
    TEST_ASSERT_FALSE(stays(0, 50));
    setUp();
    set(3, 100, 100, 44);
    TEST_ASSERT_TRUE(stays(0, 50));
    setUp();
    set(3, 100, 100, 0);
    TEST_ASSERT_TRUE(stays(0, 0));
}

/* What leads from one room to another needs half as many: 22. */
static void test_a_way_through_with_few_walls(void)
{
    set(3, 100, 100, 22);
    touch(2, 3, 1);
    TEST_ASSERT_TRUE(stays(0, 50));
    setUp();
    set(3, 100, 100, 21);
    touch(2, 3, 1);
    TEST_ASSERT_FALSE(stays(0, 50));
}

static void test_what_is_no_way_through(void)
{
    set(3, 100, 100, 43);
    touch(2, 3, 0); /* a wall in common */
    TEST_ASSERT_FALSE(stays(0, 50));
    setUp();
    set(3, 100, 100, 41);
    set(4, 100, 100, 0); /* seen through another window */
    touch(3, 4, 9);
    TEST_ASSERT_FALSE(stays(0, 50));
    setUp();
    set(3, 100, 100, 43);
    touch(2, 3, 9);
    rs_cluster_unite(&graph, 1, 2); /* two ways into one room */
    regions[1].area = 10000;
    TEST_ASSERT_FALSE(stays(0, 50));
}

/* A tenth of 20,000 cells and its own are 2222; a fifth, for what hardly has walls, 5000. */
static void test_a_large_one_stays(void)
{
    set(3, 2222, 100, 43);
    TEST_ASSERT_FALSE(stays(0, 50));
    setUp();
    set(3, 2223, 100, 43);
    TEST_ASSERT_TRUE(stays(0, 50));
    setUp();
    set(3, 4999, 100, 0);
    TEST_ASSERT_FALSE(stays(0, 50));
    setUp();
    set(3, 5000, 100, 0);
    TEST_ASSERT_TRUE(stays(0, 50));
}

/* 35 % of 2100 faces are 735. */
static void test_a_map_that_does_not_mark_walls(void)
{
    set(2, 10000, 1000, 735);
    set(1, 10000, 1000, 0);
    set(3, 100, 100, 0);
    TEST_ASSERT_FALSE(stays(0, 50));
    setUp();
    set(2, 10000, 1000, 734);
    set(1, 10000, 1000, 0);
    set(3, 100, 100, 0);
    TEST_ASSERT_TRUE(stays(0, 50));
}

/* Sums of 2^22 and more are scaled. */
static void test_a_very_long_border(void)
{
    for (uint32_t walls = 40; walls <= 60; walls += 20) {
        setUp();
        set(1, 10000, 1u << 22, 1u << 22);
        set(2, 10000, 1u << 21, 1u << 21);
        set(3, 100, 100, walls);
        TEST_ASSERT_EQUAL_INT(walls == 60, stays(0, 50));
    }
}

static void test_small_areas_apart(void)
{
    set(3, 99, 100, 100);
    set(4, 99, 100, 100);
    rs_drop_run(100, 50, &graph);
    TEST_ASSERT_EQUAL_UINT32(99, regions[3].area); /* touches a room */
    TEST_ASSERT_EQUAL_UINT32(0, regions[4].area);
    setUp();
    set(4, 99, 100, 100);
    touch(1, 4, 0); /* through a wall alone */
    rs_drop_run(100, 50, &graph);
    TEST_ASSERT_EQUAL_UINT32(0, regions[4].area);
    setUp();
    set(4, 100, 100, 100);
    rs_drop_run(100, 50, &graph);
    TEST_ASSERT_EQUAL_UINT32(100, regions[4].area);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_dead_end_with_few_walls);
    RUN_TEST(test_a_way_through_with_few_walls);
    RUN_TEST(test_what_is_no_way_through);
    RUN_TEST(test_a_large_one_stays);
    RUN_TEST(test_a_map_that_does_not_mark_walls);
    RUN_TEST(test_a_very_long_border);
    RUN_TEST(test_small_areas_apart);
    return UNITY_END();
}
