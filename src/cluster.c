#include "cluster.h"

#include "shape.h"

uint16_t rs_cluster_root(rs_region *regions, uint16_t region)
{
    while (regions[region].parent != region) {
        regions[region].parent = regions[regions[region].parent].parent;
        region = regions[region].parent;
    }
    return region;
}

static void splice_lists(rs_graph *graph, uint32_t a, uint32_t b)
{
    uint32_t *next_a, *next_b, swap;

    if (a == RS_NO_HALF || b == RS_NO_HALF) {
        return;
    }
    next_a = &graph->edges[a >> 1].next[a & 1u];
    next_b = &graph->edges[b >> 1].next[b & 1u];
    swap = *next_a;
    *next_a = *next_b;
    *next_b = swap;
}

uint16_t rs_cluster_unite(rs_graph *graph, uint16_t p, uint16_t q)
{
    rs_region *regions = graph->regions;
    bool keep_p = regions[p].area > regions[q].area ||
                  (regions[p].area == regions[q].area && p < q);
    uint16_t root = keep_p ? p : q;
    rs_region *into = &regions[root];
    const rs_region *from = &regions[keep_p ? q : p];

    if (graph->shapes != NULL) {
        const rs_region *peak = from->peak > into->peak ? from : into;
        rs_shape_unite(graph, root, keep_p ? q : p, peak->peak_x, peak->peak_y);
    }
    splice_lists(graph, into->first_half, from->first_half);
    if (into->first_half == RS_NO_HALF) {
        into->first_half = from->first_half;
    }
    if (from->area > 0u && (into->area == 0u || from->first_cell < into->first_cell)) {
        into->first_cell = from->first_cell;
    }
    if (from->peak > into->peak) {
        into->peak = from->peak;
        into->peak_x = from->peak_x;
        into->peak_y = from->peak_y;
    }
    into->area += from->area;
    into->border += from->border;
    into->walls += from->walls;
    regions[keep_p ? q : p].parent = root;
    return root;
}

uint32_t rs_cluster_next(rs_graph *graph, uint16_t root, uint32_t half)
{
    rs_region *region = &graph->regions[root];

    for (;;) {
        uint32_t *link = &graph->edges[half >> 1].next[half & 1u];
        uint32_t next = *link;

        if (rs_cluster_root(graph->regions, rs_graph_other_end(graph, next)) != root) {
            return next;
        }
        if (next == half) {
            region->first_half = RS_NO_HALF;
            return RS_NO_HALF;
        }
        *link = rs_graph_next_half(graph, next);
        if (region->first_half == next) {
            region->first_half = half;
        }
    }
}

uint32_t rs_cluster_first(rs_graph *graph, uint16_t root)
{
    uint32_t half = graph->regions[root].first_half;

    return half == RS_NO_HALF ? RS_NO_HALF : rs_cluster_next(graph, root, half);
}
