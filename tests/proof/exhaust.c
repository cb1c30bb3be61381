/* Proofs by trying all there is, for what a solver does not decide in time.
 *
 *   exhaust WORD     isqrt, tangent, crossing, queue or cluster
 *
 * Prints how many cases were tried. Exit code 1 and the case when one is wrong. */
#include <stdio.h>
#include <stdlib.h>

#include "../../src/base.c"
#include "../../src/cluster.c"
#include "../../src/distance.c"
#include "../../src/queue.c"
#include "../../src/shape.c"
#include "../../src/trig.c"

static uint64_t tried;

static void require(bool condition, const char *what, uint32_t a, uint32_t b)
{
    tried++;
    if (!condition) {
        printf("wrong: %s at %lu, %lu\n", what, (unsigned long)a, (unsigned long)b);
        exit(1);
    }
}

static void try_isqrt(void)
{
    uint64_t root = 0;
    for (uint64_t n = 0; n <= UINT32_MAX; n++) {
        root += n == (root + 1u) * (root + 1u) ? 1u : 0u;
        require(rs_isqrt((uint32_t)n) == root, "rs_isqrt", (uint32_t)n, 0);
    }
}

/* The tangent of an octant's angles grows with each step; so the search of octant_angle(), by
 * halves, ends at the greatest angle that is not too steep. */
static void try_tangent(void)
{
    for (uint32_t angle = 0; angle < QUADRANT / 2; angle++) {
        rs_direction a = first_octant(angle), b = first_octant(angle + 1u);
        require(a.sin >= 0 && a.cos > 0 && a.cos <= RS_TRIG_ONE && b.sin <= b.cos,
                "first_octant", angle, 0);
        require((uint64_t)b.sin * (uint64_t)a.cos > (uint64_t)a.sin * (uint64_t)b.cos,
                "tangent", angle, 0);
    }
}

static uint32_t height_at(const rs_basin *b, uint32_t x)
{
    uint32_t away = x < b->first ? b->first - x : x > b->last ? x - b->last : 0u;
    return b->height + away * away;
}

/* Where b first lies below a. Their difference never falls from left to right, so that two columns
 * decide. All heights, gaps up to beyond the farthest distance, and flat parts of some widths; a
 * stands at the left end, or so far from it that no crossing is cut off. */
static void try_crossing(uint32_t at)
{
    static const uint32_t widths[] = {0, 1, 6, 300};
    for (uint32_t i = 0; i < 256u * 256u * 16u; i++) {
        uint32_t ah = i & 255u, bh = i >> 8 & 255u;
        rs_basin a = {(uint16_t)at, (uint16_t)(at + widths[i >> 16 & 3u]), 0,
                      (uint16_t)(ah * ah)};
        for (uint32_t gap = 1; gap <= 300u; gap += gap < 40u ? 1u : 13u) {
            uint32_t first = a.last + gap;
            rs_basin b = {(uint16_t)first, (uint16_t)(first + widths[i >> 18]), 0,
                          (uint16_t)(bh * bh)};
            uint32_t x = crossing(&a, &b);
            require(height_at(&b, x) < height_at(&a, x), "crossing: too early", i, gap);
            require(x == 0u || height_at(&b, x - 1u) >= height_at(&a, x - 1u),
                    "crossing: too late", i, gap);
        }
    }
}

/* Any steps on two lists that share two blocks: each list gives back its own cells, the oldest
 * first, and a cell is refused only when no block is left. */
static void try_queue(void)
{
    enum { STEPS = 11, HELD = ROOMSEG_QUEUE_BLOCK_CELLS - 2 };
    static rs_queue_list lists[RS_QUEUE_LISTS];
    static rs_queue_block blocks[2];
    rs_queue queue;
    for (uint32_t steps = 0; steps < 1u << (2 * STEPS); steps++) {
        uint32_t cells[2][HELD + STEPS], put[2] = {0, 0}, taken[2] = {0, 0};
        queue = (rs_queue){lists, blocks, 2, RS_QUEUE_NONE, 0, 2};
        lists[0] = lists[1] = (rs_queue_list){RS_QUEUE_NONE, RS_QUEUE_NONE, 0, 0};
        for (uint32_t step = 0; step < HELD + STEPS; step++) {
            uint32_t word = step < HELD ? 0u : steps >> (2u * (step - HELD)) & 3u;
            uint32_t list = word & 1u, left = queue.left, cell = step;
            if (word < 2u) {
                bool pushed = rs_queue_push(&queue, list, cell);
                require(pushed || left == 0u, "queue: refused", steps, step);
                cells[list][put[list]] = cell;
                put[list] += pushed ? 1u : 0u;
            } else if (rs_queue_pop(&queue, list, &cell)) {
                require(taken[list] < put[list] && cells[list][taken[list]] == cell,
                        "queue: popped", steps, step);
                taken[list]++;
            } else {
                require(taken[list] == put[list], "queue: lost", steps, step);
            }
        }
    }
}

enum { REGIONS = 4, UNIONS = 4 };

/* One order of unions: 4 bits each, two regions. */
static void try_unions(uint32_t order, const uint32_t *area, const uint8_t *peak)
{
    rs_region regions[REGIONS] = {{0}};
    rs_graph graph = {0};
    uint32_t group[REGIONS];
    graph.regions = regions;
    for (uint32_t r = 0; r < REGIONS; r++) {
        regions[r].area = area[r];
        regions[r].peak = peak[r];
        regions[r].parent = (uint16_t)r;
        regions[r].first_half = RS_NO_HALF;
        group[r] = r;
    }
    for (uint32_t u = 0; u < UNIONS; u++) {
        uint32_t a = order >> (4u * u) & 3u, b = order >> (4u * u + 2u) & 3u;
        uint32_t from = group[a], to = group[b];
        uint16_t p = rs_cluster_root(regions, (uint16_t)a);
        uint16_t q = rs_cluster_root(regions, (uint16_t)b);
        if (p != q) {
            rs_cluster_unite(&graph, p, q);
        }
        for (uint32_t r = 0; r < REGIONS; r++) {
            group[r] = group[r] == from ? to : group[r];
        }
    }
    for (uint32_t i = 0; i < REGIONS; i++) {
        uint16_t root = rs_cluster_root(regions, (uint16_t)i);
        uint32_t sum = 0, highest = 0;
        for (uint32_t j = 0; j < REGIONS; j++) {
            bool same = group[i] == group[j];
            require((rs_cluster_root(regions, (uint16_t)j) == root) == same, "root", order, i);
            sum += same ? area[j] : 0u;
            highest = same ? rs_max_u32(highest, peak[j]) : highest;
        }
        require(regions[root].area == sum && regions[root].peak == highest, "sum", order, i);
    }
}

/* Any four unions of four regions with areas of 0..2 and peaks in any order of size. */
static void try_cluster(void)
{
    for (uint32_t numbers = 0; numbers < 81u; numbers++) {
        uint32_t area[REGIONS], rest = numbers;
        uint8_t peak[REGIONS];
        for (uint32_t r = 0; r < REGIONS; r++) {
            area[r] = rest % 3u;
            peak[r] = (uint8_t)(1u + (area[r] + numbers) % 3u);
            rest /= 3u;
        }
        for (uint32_t order = 0; order < 1u << (4 * UNIONS); order++) {
            try_unions(order, area, peak);
        }
    }
}

int main(int argc, char **argv)
{
    const char *word = argc == 2 ? argv[1] : "";
    if (strcmp(word, "isqrt") == 0) {
        try_isqrt();
    } else if (strcmp(word, "tangent") == 0) {
        try_tangent();
    } else if (strcmp(word, "crossing") == 0) {
        try_crossing(0);
        try_crossing(40000);
    } else if (strcmp(word, "queue") == 0) {
        try_queue();
    } else if (strcmp(word, "cluster") == 0) {
        try_cluster();
    } else {
        fputs("usage: exhaust isqrt|tangent|crossing|queue|cluster\n", stderr);
        return 2;
    }
    printf("%llu\n", (unsigned long long)tried);
    return 0;
}
