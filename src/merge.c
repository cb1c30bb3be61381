#include "merge.h"

#include "cluster.h"

/* One sweep over all edges, best first. Keys can only fall while a sweep goes on, but for
 * passages that come into being, so an edge whose key fell goes back into the heap, and
 * sweeps are repeated until one merges nothing. */
static int sweep(const rs_join_rules *rules, rs_graph *graph, rs_heap *heap, uint32_t *merged,
                 rs_ticker *ticker)
{
    heap->count = 0;
    *merged = 0;
    for (uint32_t e = 0; e < graph->edge_count; e++) {
        uint32_t key = rs_join_key(rules, graph, e, true);
        if (key > 0u) {
            rs_heap_push(heap, key, e);
        }
    }
    while (heap->count > 0u) {
        rs_heap_item best = rs_heap_pop(heap);
        uint32_t key = rs_join_key(rules, graph, best.item, false);

        if (rs_tick(ticker, 1, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (key > 0u && key < best.key) {
            rs_heap_push(heap, key, best.item);
        } else if (key > 0u) {
            const rs_edge *edge = &graph->edges[best.item];
            rs_cluster_unite(graph, rs_cluster_root(graph->regions, edge->a),
                  rs_cluster_root(graph->regions, edge->b));
            ++*merged;
        }
    }
    return ROOMSEG_OK;
}

/* The half-edge of `root` with the widest opening; equal ones: the longer border, then the
 * earlier edge. RS_NO_HALF: no neighbour. */
static uint32_t widest_half(rs_graph *graph, uint16_t root)
{
    uint32_t best = RS_NO_HALF;
    uint32_t start, half;

    start = rs_cluster_first(graph, root);
    for (half = start; half != RS_NO_HALF;) {
        const rs_edge *edge = &graph->edges[half >> 1];
        const rs_edge *champion = &graph->edges[best == RS_NO_HALF ? 0u : best >> 1];

        if (edge->saddle > 0u &&
            (best == RS_NO_HALF || edge->saddle > champion->saddle ||
             (edge->saddle == champion->saddle &&
              (edge->border > champion->border ||
               (edge->border == champion->border && half < best))))) {
            best = half;
        }
        half = rs_cluster_next(graph, root, half);
        if (half == start) {
            break;
        }
    }
    return best;
}

/* Lets every root below the smallest room join a neighbour, the smallest root first. */
static int absorb_small(const rs_join_rules *rules, rs_graph *graph, rs_heap *heap,
                        rs_ticker *ticker)
{
    heap->count = 0;
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        const rs_region *region = &graph->regions[r];
        if (region->parent == r && region->area < rules->smallest_cells) {
            rs_heap_push(heap, UINT32_MAX - region->area, r);
        }
    }
    while (heap->count > 0u) {
        rs_heap_item smallest = rs_heap_pop(heap);
        uint16_t root = (uint16_t)smallest.item;
        uint32_t half;

        if (rs_tick(ticker, 1, 1, 2)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (graph->regions[root].parent != root ||
            graph->regions[root].area != UINT32_MAX - smallest.key) {
            continue; /* merged meanwhile; as a part of another it was queued again */
        }
        half = widest_half(graph, root);
        if (half != RS_NO_HALF) {
            uint16_t other = rs_cluster_root(graph->regions, rs_graph_other_end(graph, half));
            uint16_t joined = rs_cluster_unite(graph, root, other);
            if (graph->regions[joined].area < rules->smallest_cells) {
                rs_heap_push(heap, UINT32_MAX - graph->regions[joined].area, joined);
            }
        }
    }
    return ROOMSEG_OK;
}

int rs_merge_run(const rs_join_rules *rules, rs_graph *graph, rs_heap_item *heap_items,
                 rs_ticker *ticker)
{
    rs_heap heap = {heap_items, 0};
    uint32_t merged = 1;
    int status = ROOMSEG_OK;

    while (status == ROOMSEG_OK && merged > 0u) {
        status = sweep(rules, graph, &heap, &merged, ticker);
    }
    return status == ROOMSEG_OK ? absorb_small(rules, graph, &heap, ticker) : status;
}
