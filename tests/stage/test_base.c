/* Small arithmetic, the ticker's shares, heap and queue, clusters, directions: what the stages
 * stand on. */
#include <stdlib.h>
#include <string.h>

#include "cluster.h"
#include "direction.h"
#include "heap.h"
#include "queue.h"
#include "rooms.h"
#include "stage.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_isqrt(void)
{
    for (uint32_t root = 0; root <= 65535; root++) {
        TEST_ASSERT_EQUAL_UINT32(root, rs_isqrt(root * root));
        if (root > 0) {
            TEST_ASSERT_EQUAL_UINT32(root - 1, rs_isqrt(root * root - 1));
        }
    }
    TEST_ASSERT_EQUAL_UINT32(65535, rs_isqrt(UINT32_MAX));
}

static void test_divide_q8(void)
{
    const uint32_t divisors[] = {1, 2, 3, 255, 256, 257, 65535, 25600, 1u << 28, UINT32_MAX};
    for (size_t i = 0; i < sizeof divisors / sizeof *divisors; i++) {
        uint64_t most = ((uint64_t)UINT32_MAX * divisors[i] + divisors[i] - 1) >> 8;
        for (uint64_t n = 0; n <= most; n = n * 5 / 2 + 1) {
            /* n * 256 / d without a product beyond 64 bits */
            uint64_t wanted = n / divisors[i] * 256 + n % divisors[i] * 256 / divisors[i];
            TEST_ASSERT_EQUAL_UINT64(wanted, rs_divide_q8(n, divisors[i]));
        }
        TEST_ASSERT_EQUAL_UINT32(0, rs_divide_q8(0, divisors[i]));
    }
}

typedef struct heard {
    unsigned permille;
    uint32_t calls;
} heard;

static int listen(void *user, roomseg_stage stage, unsigned permille)
{
    heard *h = user;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_STAGE_GRAPH, stage);
    h->permille = permille;
    h->calls++;
    return 0;
}

static void test_shares_done(void)
{
    const uint32_t totals[] = {1, 2, 1000, (1u << 22) - 1, 1u << 22, (1u << 29) - 1};
    heard h = {0, 0};
    for (size_t i = 0; i < sizeof totals / sizeof *totals; i++) {
        rs_ticker ticker = {listen, &h, ROOMSEG_STAGE_GRAPH, 0, 0, 0, 0};
        TEST_ASSERT_FALSE(rs_ticker_enter(&ticker, ROOMSEG_STAGE_GRAPH));
        TEST_ASSERT_EQUAL_UINT(0, h.permille);
        rs_ticker_call(&ticker, totals[i] / 2, totals[i]);
        TEST_ASSERT_UINT_WITHIN(1, (unsigned)(totals[i] / 2 * 1000ull / totals[i]), h.permille);
        rs_ticker_call(&ticker, totals[i], totals[i]);
        TEST_ASSERT_EQUAL_UINT(1000, h.permille);
        rs_ticker_call(&ticker, 0, totals[i]);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(1000, h.permille, "the share fell");
    }
    rs_ticker ticker = {listen, &h, ROOMSEG_STAGE_GRAPH, 0, 0, 0, 0};
    rs_ticker_part(&ticker, 200, 700);
    rs_ticker_call(&ticker, 1, 2);
    TEST_ASSERT_EQUAL_UINT(450, h.permille);
    rs_ticker_call(&ticker, 0, 0);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(700, h.permille, "no steps are all steps");
}

/* The hook is called when the visits would exceed the limit, not before. */
static void test_ticks(void)
{
    heard h = {0, 0};
    rs_ticker ticker = {listen, &h, ROOMSEG_STAGE_GRAPH, 0, 0, 0, 0};
    TEST_ASSERT_FALSE(rs_tick(&ticker, RS_TICK_VISITS, 0, 1));
    TEST_ASSERT_EQUAL_UINT(0, h.calls);
    TEST_ASSERT_FALSE(rs_tick(&ticker, 1, 0, 1));
    TEST_ASSERT_EQUAL_UINT(1, h.calls);
    TEST_ASSERT_FALSE(rs_tick(&ticker, RS_TICK_VISITS - 1, 0, 1));
    TEST_ASSERT_EQUAL_UINT(1, h.calls);
}

static void test_heap(void)
{
    enum { COUNT = 500 };
    static rs_heap_item items[COUNT];
    rs_heap heap = {items, 0};
    uint32_t random = 3;
    for (uint32_t i = 0; i < COUNT; i++) {
        random = random * 1664525u + 1013904223u;
        rs_heap_push(&heap, random >> 26, i);
    }
    rs_heap_item before = {UINT32_MAX, 0};
    while (heap.count > 0) {
        rs_heap_item next = rs_heap_pop(&heap);
        TEST_ASSERT_TRUE(next.key < before.key ||
                         (next.key == before.key && next.item > before.item));
        before = next;
    }
}

/* First in, first out in each list, and every block used: against a plain count. */
static void test_queue(void)
{
    enum { BLOCKS = 3 };
    rs_queue_list lists[RS_QUEUE_LISTS];
    rs_queue_block blocks[BLOCKS];
    rs_queue queue;
    uint32_t pushed[2] = {0, 0};
    uint32_t popped[2] = {0, 0};
    uint32_t random = 11;
    uint32_t cell;
    rs_queue_init(&queue, lists, blocks, BLOCKS);
    for (int step = 0; step < 20000; step++) {
        random = random * 1664525u + 1013904223u;
        uint32_t list = random >> 31;
        if ((random >> 30 & 1u) != 0) {
            bool fits = rs_queue_push(&queue, list, pushed[list]);
            TEST_ASSERT_TRUE(fits || queue.left == 0);
            pushed[list] += fits;
        } else if (rs_queue_pop(&queue, list, &cell)) {
            TEST_ASSERT_EQUAL_UINT32(popped[list], cell);
            popped[list]++;
        } else {
            TEST_ASSERT_EQUAL_UINT32(pushed[list], popped[list]);
        }
    }
    for (uint32_t list = 0; list < 2; list++) {
        while (rs_queue_pop(&queue, list, &cell)) {
            TEST_ASSERT_EQUAL_UINT32(popped[list]++, cell);
        }
        TEST_ASSERT_EQUAL_UINT32(pushed[list], popped[list]);
    }
    TEST_ASSERT_EQUAL_UINT32(BLOCKS, queue.left);
}

enum { REGIONS = 5, EDGES = 8 };
static rs_region regions[REGIONS + 1];
static rs_edge edges[EDGES];

/* Regions of 10, 20, ... cells, each first met at cell 100 - its number. */
static rs_graph make_graph(rs_graph_builder *builder, uint32_t max_edges)
{
    rs_graph graph = {regions, edges, NULL, REGIONS, 0, 0};
    return (rs_graph_begin(&graph, max_edges, builder), graph);
}

static void number_regions(void)
{
    for (uint32_t r = 1; r <= REGIONS; r++) {
        regions[r].area = 10 * r;
        regions[r].first_cell = 100 - r;
        regions[r].peak = (uint16_t)(r == 2 ? 9 : r);
        regions[r].peak_x = (uint16_t)r;
        regions[r].border = r;
        regions[r].walls = 1;
    }
}

static void test_clusters(void)
{
    rs_graph_builder builder;
    rs_graph graph = make_graph(&builder, EDGES);
    builder.graph = &graph;
    number_regions();
    rs_graph_edge(&builder, 3, 4);
    /* Without edges of their own: the larger remains, and has none afterwards either. */
    TEST_ASSERT_EQUAL_UINT16(2, rs_cluster_unite(&graph, 1, 2));
    TEST_ASSERT_EQUAL_UINT32(RS_NO_HALF, rs_cluster_first(&graph, 2));
    TEST_ASSERT_EQUAL_UINT32(30, regions[2].area);
    TEST_ASSERT_EQUAL_UINT32(98, regions[2].first_cell);
    TEST_ASSERT_EQUAL_UINT16(9, regions[2].peak);
    TEST_ASSERT_EQUAL_UINT32(3, regions[2].border);
    TEST_ASSERT_EQUAL_UINT32(2, regions[2].walls);
    /* The larger has no edge: it takes over those of the other. */
    TEST_ASSERT_EQUAL_UINT16(5, rs_cluster_unite(&graph, 5, 3));
    TEST_ASSERT_EQUAL_UINT16(4, rs_graph_other_end(&graph, rs_cluster_first(&graph, 5)));
    /* Of equal areas the lower number remains. */
    regions[4].area = regions[5].area;
    TEST_ASSERT_EQUAL_UINT16(4, rs_cluster_unite(&graph, 5, 4));
    TEST_ASSERT_EQUAL_UINT32(RS_NO_HALF, rs_cluster_first(&graph, 4));
    TEST_ASSERT_EQUAL_UINT16(4, rs_cluster_root(regions, 3));
    /* A region without cells does not hand down its first cell. */
    regions[2].area = 0;
    regions[2].first_cell = 1;
    TEST_ASSERT_EQUAL_UINT16(4, rs_cluster_unite(&graph, 2, 4));
    TEST_ASSERT_EQUAL_UINT32(95, regions[4].first_cell);
}

/* A region in the middle touches, or faces through a wall, as many as there are edges for. */
static void test_a_graph_without_room(void)
{
    const char *const rows[] = {"112", "132", "442"};
    const char *const walled[] = {"1.2", "...", "3.4"};
    for (int drawing = 0; drawing < 2; drawing++) {
        const char *const *map = drawing == 0 ? rows : walled;
        rs_frame frame = stage_frame(3, 3);
        uint8_t *surface = stage_buffer(&frame);
        rs_labels labels = stage_labels(&frame);
        uint8_t cells[9];
        rs_column columns[3];
        const roomseg_grid grid = {cells, 3, 3, 3, 50};
        uint32_t needed = EDGES;
        for (uint32_t i = 0; i < 9; i++) {
            bool wall = map[i / 3][i % 3] == '.';
            cells[i] = wall ? 255 : 0;
            labels.cells[i] = wall ? (uint16_t)0 : (uint16_t)(map[i / 3][i % 3] - '0');
            surface[rs_frame_index(&frame, i % 3, i / 3)] = !wall;
        }
        for (uint32_t room = EDGES + 1; room-- > 0;) {
            rs_graph graph = {regions, edges, NULL, 4, 0, 0};
            rs_ticker ticker = {0};
            int status = rs_graph_build(&frame, &grid, 204, surface, &labels, &graph, room,
                                        columns, &ticker);
            needed = status == ROOMSEG_OK ? graph.edge_count : needed;
            TEST_ASSERT_EQUAL_INT(room >= needed ? ROOMSEG_OK : ROOMSEG_ERR_REGIONS, status);
        }
        TEST_ASSERT_GREATER_THAN_UINT32(2, needed);
        free(labels.cells);
        free(surface);
    }
}

/* More pairs of rooms than a plane map can have, as if max_rooms were smaller. */
static void test_doorways_without_room(void)
{
    enum { MOST = 12 };
    rs_graph_builder builder;
    rs_graph graph = make_graph(&builder, EDGES);
    static roomseg_room rooms[REGIONS];
    static rs_room_sum sums[REGIONS];
    static roomseg_doorway doorways[MOST];
    static uint16_t links[2 * MOST];
    static rs_heap_item heap[MOST];
    rs_frame frame = stage_frame(3, 3);
    rs_room_records records = {rooms, sums, doorways, links, 1, REGIONS, 0};
    builder.graph = &graph;
    number_regions();
    TEST_ASSERT_LESS_OR_EQUAL_size_t(MOST, ROOMSEG_PLAN_EDGES(1));
    for (uint16_t a = 1; a <= REGIONS; a++) {
        regions[a].room = a;
        for (uint16_t b = (uint16_t)(a + 1); b <= REGIONS && graph.edge_count < EDGES; b++) {
            rs_graph_edge(&builder, a, b)->saddle = 3;
        }
    }
    int wanted = graph.edge_count > ROOMSEG_PLAN_EDGES(1) ? ROOMSEG_ERR_ROOMS : ROOMSEG_OK;
    TEST_ASSERT_EQUAL_INT(wanted, rs_rooms_connect(&frame, 50, &graph, &records, heap));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(ROOMSEG_PLAN_EDGES(1), records.doorway_count);
}

/* Segments longer than 15 bits are halved before they are squared. */
static void test_long_segments(void)
{
    const rs_line lines[] = {{0, 0, 65532, 0}, {0, 0, 0, 65532}, {65532, 0, 0, 65532}};
    const int32_t angles[] = {0, 0, -4500};
    const uint32_t lengths[] = {65532, 65532, 92676};
    for (int i = 0; i < 3; i++) {
        rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
        uint32_t sum = 0;
        rs_direction_clear(bins);
        rs_direction_add(bins, &lines[i]);
        for (uint32_t k = 0; k < ROOMSEG_DIRECTION_BINS; k++) {
            sum += bins[k].length;
        }
        TEST_ASSERT_UINT32_WITHIN(6, lengths[i], sum);
        TEST_ASSERT_EQUAL_INT32(angles[i], rs_direction_find(bins));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_isqrt);
    RUN_TEST(test_divide_q8);
    RUN_TEST(test_shares_done);
    RUN_TEST(test_ticks);
    RUN_TEST(test_heap);
    RUN_TEST(test_queue);
    RUN_TEST(test_clusters);
    RUN_TEST(test_a_graph_without_room);
    RUN_TEST(test_doorways_without_room);
    RUN_TEST(test_long_segments);
    return UNITY_END();
}
