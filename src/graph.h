/* Stage 5: the region adjacency graph. */
#ifndef RS_GRAPH_H
#define RS_GRAPH_H

#include "base.h"
#include "watershed.h"

/* How much of a region's border is walls. */
enum { RS_WALLED = 0, RS_POORLY_WALLED, RS_HARDLY_WALLED };

/* One region of the watershed; regions[label], regions[0] is unused. */
typedef struct rs_region {
    uint32_t area;           /* cells that may carry a label */
    uint32_t first_cell;     /* the first of them in reading order, bordered index */
    uint32_t first_half;     /* half-edge list, RS_NO_HALF: no neighbour */
    uint32_t border;         /* faces between its cells and obstacles */
    uint32_t walls;          /* those of them whose obstacle is certain */
    uint16_t peak_x, peak_y; /* the one of the greatest distance, crop coordinates */
    uint16_t parent;         /* region it was merged into; its own label: a root */
    uint16_t peak;           /* that greatest distance [RS_DISTANCE_UNIT_MM] */
    uint16_t room;           /* label of the room it belongs to; 0: none */
    uint16_t unwalled;       /* of a root: RS_WALLED and so on, set by rs_merge_run */
} rs_region;

/* Two regions that touch or lie on both sides of one thin wall. The half-edges 2e and 2e + 1 of
 * edge e stand in the circular lists of regions a and b. */
typedef struct rs_edge {
    uint16_t a, b;      /* labels, a < b */
    uint16_t x, y;      /* where the opening is widest, crop coordinates */
    uint16_t saddle;    /* greatest, over the shared border, of the smaller of the distances
                           on both sides [RS_DISTANCE_UNIT_MM]; 0: they do not touch */
    uint16_t wall;      /* shared wall: rows and columns that cross it [cells of length];
                           at most RS_GRAPH_LONGEST_WALL */
    uint32_t border;    /* shared border [pairs of 4-adjacent cells] */
    uint32_t next[2];   /* next half-edge in the lists of a and b */
} rs_edge;

/* Sums over the cells that make up a region's area, each taken as a square, around its peak;
 * modulo 2^32 and 2^64. xx, xy and yy are twelve times the sums, which makes them whole. */
typedef struct rs_shape {
    uint32_t x, y;
    uint64_t xx, xy, yy; /* xx = RS_SHAPE_VAST: the region is no hall, and nothing holds */
} rs_shape;

#define RS_SHAPE_VAST UINT64_MAX
#define RS_NO_HALF UINT32_MAX
#define RS_GRAPH_LONGEST_WALL UINT16_MAX /* walls beyond it count as this long */

RS_STATIC_ASSERT(sizeof(rs_region) == ROOMSEG_REGION_BYTES, region);
RS_STATIC_ASSERT(sizeof(rs_edge) == ROOMSEG_EDGE_BYTES, edge);
RS_STATIC_ASSERT(sizeof(rs_shape) == ROOMSEG_SHAPE_BYTES, shape);

/* The last labelled cell of a column on the way down. */
typedef struct rs_column {
    uint16_t label, y;
} rs_column;

RS_STATIC_ASSERT(sizeof(rs_column) == ROOMSEG_COLUMN_BYTES, column);

/* Obstacles of at most this thickness between two regions are a wall that they share. */
#define RS_GRAPH_WALL_MM 350u

typedef struct rs_graph {
    rs_region *regions;
    rs_edge *edges;
    rs_shape *shapes; /* of the regions, see shape.h; NULL: not measured */
    uint32_t region_count, edge_count;
    uint32_t clutter; /* certain obstacles within regions, but single cells of a row */
} rs_graph;

/* The region at the other end of a half-edge, as it was before merging. */
static inline uint16_t rs_graph_other_end(const rs_graph *graph, uint32_t half)
{
    const rs_edge *edge = &graph->edges[half >> 1];

    return (half & 1u) == 0u ? edge->b : edge->a;
}

static inline uint32_t rs_graph_next_half(const rs_graph *graph, uint32_t half)
{
    return graph->edges[half >> 1].next[half & 1u];
}

/* A graph that is being built. */
typedef struct rs_graph_builder {
    rs_graph *graph;
    uint32_t max_edges;
    uint32_t latest; /* the edge asked for last; borders repeat themselves */
} rs_graph_builder;

/* Empties the graph, but for region_count regions without cells. */
void rs_graph_begin(rs_graph *graph, uint32_t max_edges, rs_graph_builder *builder);

/* The edge between two regions, made when it is new; NULL when there is no room for it. Takes
 * as many steps as the region of the fewer neighbours has, which are few in a plane map. */
rs_edge *rs_graph_edge(rs_graph_builder *builder, uint16_t p, uint16_t q);

/* Counts a cell of a region; cells come in reading order. index: bordered. */
void rs_graph_add_cell(rs_region *region, uint32_t height, uint32_t index, uint32_t x,
                       uint32_t y);

/* Measures the regions and their openings in one reading of the labels.
 * graph: regions of region_count + 1 elements and edges of max_edges, to be filled.
 * columns: frame->width elements of scratch, no preparation needed.
 * Fails iff: cancelled, or more than max_edges pairs of regions touch or share a wall
 * (ROOMSEG_ERR_REGIONS; pairs that touch are fewer than 3 a region, as in every plane map). */
int rs_graph_build(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                   const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                   uint32_t max_edges, rs_column *columns, rs_ticker *ticker);

#endif
