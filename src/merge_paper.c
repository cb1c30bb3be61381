#include "merge_paper.h"

#include <string.h>

#include "cluster.h"

typedef struct merging {
    const rs_merge_paper_rules *rules;
    rs_graph *graph;
    rs_heap heap;
    uint32_t capacity; /* of the heap */
    uint32_t *marks;   /* by root: 1 + the half-edge that leads there; 0 between walks */
    uint32_t total;    /* area of all regions that are left */
    bool opening;      /* rule 3 is at work */
} merging;

static uint16_t other_root(const merging *m, uint32_t half)
{
    return rs_cluster_root(m->graph->regions, rs_graph_other_end(m->graph, half));
}

/* The half-edge behind `half` in a walk round the list of `root`; RS_NO_HALF: it has ended. */
static uint32_t next_in_walk(const merging *m, uint16_t root, uint32_t start, uint32_t half)
{
    uint32_t next = rs_cluster_next(m->graph, root, half);

    return next == start ? RS_NO_HALF : next;
}

/* Number of neighbours of a root, borders gathered; *longest: the half-edge with the longest
 * border, equal ones the earlier neighbour. */
static uint32_t count_neighbours(const merging *m, uint16_t root, uint32_t *longest)
{
    uint32_t start = rs_cluster_first(m->graph, root);
    uint32_t count = 0, best = 0;

    *longest = RS_NO_HALF;
    for (uint32_t half = start; half != RS_NO_HALF; half = next_in_walk(m, root, start, half)) {
        uint32_t border = m->graph->edges[half >> 1].border;

        count += border > 0u;
        if (border > best || (border > 0u && border == best &&
                              other_root(m, half) < other_root(m, *longest))) {
            best = border;
            *longest = half;
        }
    }
    return count;
}

/* A root's place in rule 2: fewest neighbours, then least area, come out of the heap first.
 * Areas below A0 fit into 24 bits: at most 4e9 mm2 in cells of 400 mm2. */
static uint32_t urgency(const merging *m, uint16_t root)
{
    uint32_t longest;
    uint32_t degree = rs_min_u32(count_neighbours(m, root, &longest), 255u);

    return UINT32_MAX - (degree << 24 | m->graph->regions[root].area);
}

static bool is_small(const merging *m, uint32_t root)
{
    const rs_region *region = &m->graph->regions[root];

    return region->parent == root && region->area > 0u &&
           region->area < m->rules->smallest_cells;
}

/* The heap with nothing in it but each small root as it is now. */
static void refill(merging *m)
{
    m->heap.count = 0;
    for (uint32_t r = 1; r <= m->graph->region_count; r++) {
        if (is_small(m, r)) {
            rs_heap_push(&m->heap, urgency(m, (uint16_t)r), r);
        }
    }
}

/* Queues a small root anew. */
static void queue_root(merging *m, uint16_t root)
{
    if (!is_small(m, root)) {
        return;
    }
    if (m->heap.count == m->capacity) {
        refill(m);
    } else {
        rs_heap_push(&m->heap, urgency(m, root), root);
    }
}

/* The heap for rule 3 with nothing in it but each border that is too long as it is now. */
static void refill_borders(merging *m)
{
    m->heap.count = 0;
    for (uint32_t e = 0; e < m->graph->edge_count; e++) {
        if (m->graph->edges[e].border > m->rules->longest_border) {
            rs_heap_push(&m->heap, m->graph->edges[e].border, e);
        }
    }
}

/* Two edges of a root to one neighbour became one: rule 2 sees the neighbour anew, rule 3
 * the edge. */
static void note_gathered(merging *m, uint16_t neighbour, uint32_t e)
{
    uint32_t border = m->graph->edges[e].border;

    if (!m->opening) {
        queue_root(m, neighbour);
    } else if (border > m->rules->longest_border) {
        if (m->heap.count == m->capacity) {
            refill_borders(m);
        } else {
            rs_heap_push(&m->heap, border, e);
        }
    }
}

/* Moves the borders of parallel edges of a root to one of them. */
static void gather_borders(merging *m, uint16_t root)
{
    uint32_t start = rs_cluster_first(m->graph, root);
    uint32_t half = start;

    for (; half != RS_NO_HALF; half = next_in_walk(m, root, start, half)) {
        rs_edge *edge = &m->graph->edges[half >> 1];
        uint16_t neighbour = other_root(m, half);
        uint32_t mark = m->marks[neighbour];

        if (edge->border == 0u) {
            continue;
        }
        if (mark == 0u) {
            m->marks[neighbour] = half + 1u;
        } else {
            m->graph->edges[(mark - 1u) >> 1].border += edge->border;
            edge->border = 0;
            note_gathered(m, neighbour, (mark - 1u) >> 1);
        }
    }
    for (half = start; half != RS_NO_HALF; half = next_in_walk(m, root, start, half)) {
        m->marks[other_root(m, half)] = 0;
    }
}

/* Smallest region that may stand without a neighbour. */
static uint32_t isolated_limit(const merging *m)
{
    uint32_t permille = m->rules->isolated_permille;
    /* total * permille / 1000, rounded up, without a product above 32 bits */
    uint32_t share = m->total / 1000u * permille + (m->total % 1000u * permille + 999u) / 1000u;

    return rs_max_u32(m->rules->smallest_cells, share);
}

/* Rule 1 for one root. Returns the area that went. */
static uint32_t drop_if_isolated(merging *m, uint32_t root, uint32_t limit)
{
    rs_region *region = &m->graph->regions[root];
    uint32_t area = region->area, longest;

    if (region->parent != root || area >= limit ||
        count_neighbours(m, (uint16_t)root, &longest) > 0u) {
        return 0;
    }
    region->area = 0;
    return area;
}

/* Rules 1 and 2. */
static int merge_regions(merging *m, rs_ticker *ticker)
{
    uint32_t limit, dropped = 0;

    for (uint32_t r = 1; r <= m->graph->region_count; r++) {
        m->total += m->graph->regions[r].area;
    }
    limit = isolated_limit(m);
    for (uint32_t r = 1; r <= m->graph->region_count; r++) {
        dropped += drop_if_isolated(m, r, limit);
    }
    m->total -= dropped;
    refill(m);
    while (m->heap.count > 0u) {
        rs_heap_item next = rs_heap_pop(&m->heap);
        uint16_t root = (uint16_t)next.item;
        uint32_t longest;

        if (rs_tick(ticker, 64, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (!is_small(m, root) || urgency(m, root) != next.key ||
            count_neighbours(m, root, &longest) == 0u) {
            continue; /* an old entry; the root was queued again when it changed */
        }
        root = rs_cluster_unite(m->graph, root, other_root(m, longest));
        gather_borders(m, root);
        m->total -= drop_if_isolated(m, root, isolated_limit(m));
        queue_root(m, root);
    }
    return ROOMSEG_OK;
}

/* Rule 3. */
static int open_borders(merging *m, rs_ticker *ticker)
{
    m->opening = true;
    refill_borders(m);
    while (m->heap.count > 0u) {
        rs_heap_item next = rs_heap_pop(&m->heap);
        const rs_edge *edge = &m->graph->edges[next.item];
        uint16_t a = rs_cluster_root(m->graph->regions, edge->a);
        uint16_t b = rs_cluster_root(m->graph->regions, edge->b);

        if (rs_tick(ticker, 64, 1, 2)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (a != b && edge->border == next.key) {
            gather_borders(m, rs_cluster_unite(m->graph, a, b));
        }
    }
    return ROOMSEG_OK;
}

int rs_merge_paper_run(const rs_merge_paper_rules *rules, rs_graph *graph, rs_heap_item *heap,
                       uint32_t heap_items, uint32_t *marks, rs_ticker *ticker)
{
    merging m = {rules, graph, {heap, 0}, heap_items, marks, 0, false};
    int status;

    memset(marks, 0, (graph->region_count + 1u) * sizeof *marks);
    status = merge_regions(&m, ticker);
    return status == ROOMSEG_OK ? open_borders(&m, ticker) : status;
}
