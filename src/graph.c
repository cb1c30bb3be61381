#include "graph.h"

#include <string.h>

#define NO_EDGE UINT32_MAX

static uint32_t add_edge(rs_graph *graph, uint16_t a, uint16_t b)
{
    uint32_t e = graph->edge_count++;
    rs_edge *edge = &graph->edges[e];
    const uint16_t ends[2] = {a, b};

    memset(edge, 0, sizeof *edge);
    edge->a = a;
    edge->b = b;
    for (uint32_t side = 0; side < 2u; side++) {
        rs_region *region = &graph->regions[ends[side]];
        uint32_t half = 2u * e + side;

        if (region->first_half == RS_NO_HALF) {
            edge->next[side] = half;
            region->first_half = half;
        } else {
            uint32_t head = region->first_half;
            edge->next[side] = graph->edges[head >> 1].next[head & 1u];
            graph->edges[head >> 1].next[head & 1u] = half;
        }
    }
    return e;
}

/* The edge between two regions that both have edges. Their lists are walked side by side, so
 * that the shorter one decides how long it takes. NO_EDGE: there is none. */
static uint32_t find_edge(const rs_graph *graph, uint16_t p, uint16_t q)
{
    uint32_t first_p = graph->regions[p].first_half, first_q = graph->regions[q].first_half;
    uint32_t half_p = first_p, half_q = first_q;

    do {
        if (rs_graph_other_end(graph, half_p) == q) {
            return half_p >> 1;
        }
        if (rs_graph_other_end(graph, half_q) == p) {
            return half_q >> 1;
        }
        half_p = rs_graph_next_half(graph, half_p);
        half_q = rs_graph_next_half(graph, half_q);
    } while (half_p != first_p && half_q != first_q);
    return NO_EDGE;
}

rs_edge *rs_graph_edge(rs_graph_builder *builder, uint16_t p, uint16_t q)
{
    rs_graph *graph = builder->graph;
    uint16_t a = p < q ? p : q, b = p < q ? q : p;
    uint32_t e = builder->latest;

    if (e != NO_EDGE && graph->edges[e].a == a && graph->edges[e].b == b) {
        return &graph->edges[e];
    }
    e = NO_EDGE;
    if (graph->regions[a].first_half != RS_NO_HALF &&
        graph->regions[b].first_half != RS_NO_HALF) {
        e = find_edge(graph, a, b);
    }
    if (e != NO_EDGE) {
        /* The first in both lists from now on: two halls with thousands of closets between them
         * come back to it again and again. */
        graph->regions[a].first_half = 2u * e;
        graph->regions[b].first_half = 2u * e + 1u;
    } else if (graph->edge_count == builder->max_edges) {
        return NULL;
    } else {
        e = add_edge(graph, a, b);
    }
    builder->latest = e;
    return &graph->edges[e];
}

/* Notes that cell (x, y) of height h and label p touches a cell of height g and label q. */
static bool touch(rs_graph_builder *builder, uint16_t p, uint16_t q, uint32_t h, uint32_t g,
                  uint32_t x, uint32_t y)
{
    rs_edge *edge = rs_graph_edge(builder, p, q);
    uint32_t lower = rs_min_u32(h, g);

    if (edge == NULL) {
        return false;
    }
    edge->border++;
    if (lower > edge->saddle) {
        edge->saddle = (uint16_t)lower;
        edge->x = (uint16_t)x;
        edge->y = (uint16_t)y;
    }
    return true;
}

void rs_graph_add_cell(rs_region *region, uint32_t height, uint32_t index, uint32_t x, uint32_t y)
{
    if (region->area == 0u) {
        region->first_cell = index;
    }
    region->area++;
    if (height > region->peak) {
        region->peak = (uint16_t)height;
        region->peak_x = (uint16_t)x;
        region->peak_y = (uint16_t)y;
    }
}

/* What the passes over the cells read. */
typedef struct source {
    const rs_frame *frame;
    const roomseg_grid *grid;
    uint32_t occupied_min;
    uint32_t wall_cells; /* thickest shared wall */
} source;

/* The walls in work: what lies before the obstacles of a row and of each column. */
typedef struct wall_scan {
    rs_column *columns;
    uint32_t row_x;     /* last labelled cell of the row */
    uint16_t row_label; /* its label; 0: none yet */
    uint32_t certain;   /* certain obstacles within regions that end the row so far */
} wall_scan;

/* Whether the obstacle at crop position (x, y), which may lie one cell outside of the crop and of
 * the grid, is certain. */
static bool is_certain(const source *from, uint32_t x, uint32_t y)
{
    uint32_t grid_x = from->frame->x + x, grid_y = from->frame->y + y; /* modulo 2^32 */

    return grid_x < from->grid->width && grid_y < from->grid->height &&
           from->grid->cells[(size_t)grid_y * from->grid->stride + grid_x] >= from->occupied_min;
}

/* Notes a face between a cell of a region and an obstacle. */
static void add_face(rs_region *region, bool certain)
{
    region->border++;
    region->walls += certain;
}

void rs_graph_begin(rs_graph *graph, uint32_t max_edges, rs_graph_builder *builder)
{
    builder->graph = graph;
    builder->max_edges = max_edges;
    builder->latest = NO_EDGE;

    graph->edge_count = 0;
    graph->clutter = 0;
    memset(graph->regions, 0, (graph->region_count + 1u) * sizeof *graph->regions);
    for (uint32_t r = 0; r <= graph->region_count; r++) {
        graph->regions[r].parent = (uint16_t)r;
        graph->regions[r].first_half = RS_NO_HALF;
    }
}

/* A row of the crop; arrays by column. */
typedef struct row_view {
    const uint16_t *labels, *below; /* below: NULL behind the last row */
    const uint8_t *heights, *cells; /* of the surface, of the grid */
    uint32_t y, width;
    uint32_t index; /* bordered index of its first cell */
} row_view;

/* Measures the faces of cell x of a row and of its right and lower neighbours towards each
 * other; here, right and lower are their labels. */
static void measure_faces(const source *from, rs_region *regions, const row_view *row,
                          uint16_t here, uint16_t right, uint16_t lower, uint32_t x)
{
    if (here == 0u) {
        bool certain = row->cells[x] >= from->occupied_min;

        if (right != 0u) {
            add_face(&regions[right], certain);
        }
        if (lower != 0u) {
            add_face(&regions[lower], certain);
        }
        return;
    }
    if (right == 0u) {
        add_face(&regions[here], x + 1u < row->width
                                     ? row->cells[x + 1u] >= from->occupied_min
                                     : is_certain(from, x + 1u, row->y));
    }
    if (lower == 0u) {
        add_face(&regions[here], row->below != NULL
                                     ? row->cells[from->grid->stride + x] >= from->occupied_min
                                     : is_certain(from, x, row->y + 1u));
    }
    if (x == 0u) {
        add_face(&regions[here], is_certain(from, 0u - 1u, row->y));
    }
    if (row->y == 0u) {
        add_face(&regions[here], is_certain(from, x, 0u - 1u));
    }
}

static bool add_wall(rs_graph_builder *builder, uint16_t p, uint16_t q)
{
    rs_edge *edge;

    if (p == 0u || p == q) {
        return true;
    }
    edge = rs_graph_edge(builder, p, q);
    if (edge != NULL && edge->wall < RS_GRAPH_LONGEST_WALL) {
        edge->wall++;
    }
    return edge != NULL;
}

/* Where a run of obstacles ends, to the right or below: does a thin wall end with it? */
static bool measure_walls(const source *from, rs_graph_builder *builder, wall_scan *scan,
                          uint16_t here, uint16_t right, uint16_t lower, uint32_t x, uint32_t y)
{
    rs_column *column = &scan->columns[x];
    bool stored = true;

    if (here != 0u) {
        if (right == 0u) {
            scan->row_x = x;
            scan->row_label = here;
        }
        if (lower == 0u) {
            column->y = (uint16_t)y;
            column->label = here;
        }
        return true;
    }
    if (right != 0u && x - scan->row_x <= from->wall_cells) {
        stored = add_wall(builder, scan->row_label, right);
    }
    if (lower != 0u && y - column->y <= from->wall_cells) {
        stored = stored && add_wall(builder, column->label, lower);
    }
    return stored;
}

/* The first of the cells x..end whose right and lower neighbours are not both labelled like cell
 * x; end < width. Reads a machine word at a time. */
static uint32_t skip_alike(const uint16_t *labels, const uint16_t *below, uint32_t x, uint32_t end)
{
    enum { CELLS = sizeof(size_t) / sizeof(uint16_t) };
    uint16_t here = labels[x];
    const size_t pattern = SIZE_MAX / 0xFFFFu * here;
    size_t right, lower;

    if (x == end || labels[x + 1u] != here || below[x] != here) {
        return x;
    }
    while (end - x >= CELLS) {
        memcpy(&right, labels + x + 1u, sizeof right);
        memcpy(&lower, below + x, sizeof lower);
        if (right != pattern || lower != pattern) {
            break;
        }
        x += CELLS;
    }
    while (x < end && labels[x + 1u] == here && below[x] == here) {
        x++;
    }
    return x;
}

/* Counts the next cell of a region in a row. */
static void add_cell(const source *from, rs_graph *graph, wall_scan *scan, const row_view *row,
                     uint32_t x)
{
    if (row->cells[x] >= from->occupied_min) {
        scan->certain++;
        graph->clutter += scan->certain == 2u ? 2u : scan->certain > 2u;
        return;
    }
    scan->certain = 0;
    rs_graph_add_cell(&graph->regions[row->labels[x]], row->heights[x], row->index + x, x,
                      row->y);
}

/* Counts the cells x..end - 1 of a region. */
static void add_run(const source *from, rs_graph *graph, wall_scan *scan, const row_view *row,
                    uint32_t x, uint32_t end)
{
    rs_region *region = &graph->regions[row->labels[x]];
    uint8_t highest = rs_highest(row->heights + x, end - x);

    if (rs_highest(row->cells + x, end - x) >= from->occupied_min) {
        for (; x < end; x++) {
            add_cell(from, graph, scan, row, x);
        }
        return;
    }
    scan->certain = 0;
    rs_graph_add_cell(region, row->heights[x], row->index + x, x, row->y);
    region->area += end - x - 1u;
    if (highest > region->peak) {
        while (row->heights[x] != highest) {
            x++;
        }
        region->peak = highest;
        region->peak_x = (uint16_t)x;
        region->peak_y = (uint16_t)row->y;
    }
}

/* Counts and measures one cell, whatever lies beside and below it. */
static bool read_cell(const source *from, rs_graph_builder *builder, wall_scan *scan,
                      const row_view *row, uint32_t x)
{
    const uint8_t *height = row->heights + x;
    uint16_t here = row->labels[x];
    uint16_t right = x + 1u < row->width ? row->labels[x + 1u] : (uint16_t)0;
    uint16_t lower = row->below != NULL ? row->below[x] : (uint16_t)0;

    if (here == 0u || right == 0u || lower == 0u || x == 0u || row->y == 0u) {
        measure_faces(from, builder->graph->regions, row, here, right, lower, x);
        if (!measure_walls(from, builder, scan, here, right, lower, x, row->y)) {
            return false;
        }
    }
    if (here == 0u) {
        scan->certain = 0;
        return true;
    }
    add_cell(from, builder->graph, scan, row, x);
    if (right != here && right != 0u &&
        !touch(builder, here, right, *height, height[1], x, row->y)) {
        return false;
    }
    return lower == here || lower == 0u ||
           touch(builder, here, lower, *height, height[from->frame->stride], x, row->y);
}

/* One row, left to right: what lies within one region, or within obstacles, in runs. */
static bool read_row(const source *from, rs_graph_builder *builder, wall_scan *scan,
                     const row_view *row)
{
    bool inside = row->below != NULL && row->y > 0u;

    for (uint32_t x = 0; x < row->width; x++) {
        if (inside && x > 0u) {
            uint32_t end = skip_alike(row->labels, row->below, x, row->width - 1u);

            if (row->labels[x] != 0u && end > x) {
                add_run(from, builder->graph, scan, row, x, end);
            }
            x = end;
        }
        if (!read_cell(from, builder, scan, row, x)) {
            return false;
        }
    }
    return true;
}

int rs_graph_build(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                   const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                   uint32_t max_edges, rs_column *columns, rs_ticker *ticker)
{
    rs_graph_builder builder;
    source from = {frame, grid, occupied_min, RS_GRAPH_WALL_MM / grid->resolution_mm};
    wall_scan scan = {columns, 0, 0, 0};

    rs_graph_begin(graph, max_edges, &builder);
    memset(scan.columns, 0, frame->width * sizeof *scan.columns);
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint16_t *label_row = labels->cells + (size_t)y * labels->stride;
        uint32_t index = rs_frame_index(frame, 0, y);
        const row_view row = {
            label_row,
            y + 1u < frame->height ? label_row + labels->stride : NULL,
            surface + index,
            grid->cells + (size_t)(frame->y + y) * grid->stride + frame->x,
            y,
            frame->width,
            index,
        };

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        scan.row_label = 0;
        scan.certain = 0;
        if (!read_row(&from, &builder, &scan, &row)) {
            return ROOMSEG_ERR_REGIONS;
        }
    }
    return ROOMSEG_OK;
}
