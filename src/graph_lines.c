#include "graph_lines.h"

#include <string.h>

#include "cluster.h"

/* The two regions around a line cell; false unless there are exactly two. */
static bool find_pair(const rs_frame *frame, const rs_labels *labels, uint32_t x, uint32_t y,
                      uint16_t *p, uint16_t *q)
{
    uint32_t first_x = x > 0u ? x - 1u : 0u, last_x = rs_min_u32(x + 1u, frame->width - 1u);
    uint32_t first_y = y > 0u ? y - 1u : 0u, last_y = rs_min_u32(y + 1u, frame->height - 1u);

    *p = 0;
    *q = 0;
    for (uint32_t ny = first_y; ny <= last_y; ny++) {
        const uint16_t *row = labels->cells + (size_t)ny * labels->stride;
        for (uint32_t nx = first_x; nx <= last_x; nx++) {
            uint16_t label = row[nx];

            if (label == 0u || label > RS_LINES_MAX_REGIONS || label == *p || label == *q) {
                continue;
            }
            if (*q != 0u) {
                return false;
            }
            if (*p == 0u) {
                *p = label;
            } else {
                *q = label;
            }
        }
    }
    return *q != 0u;
}

static bool add_border_cell(rs_graph_builder *builder, uint16_t p, uint16_t q, uint32_t distance,
                            uint32_t x, uint32_t y)
{
    rs_edge *edge = rs_graph_edge(builder, p, q);

    if (edge == NULL) {
        return false;
    }
    edge->border++;
    if (distance > edge->saddle) {
        edge->saddle = (uint16_t)distance;
        edge->x = (uint16_t)x;
        edge->y = (uint16_t)y;
    }
    return true;
}

static const uint8_t *grid_row(const rs_frame *frame, const roomseg_grid *grid, uint32_t y)
{
    return grid->cells + (size_t)(frame->y + y) * grid->stride + frame->x;
}

int rs_graph_lines_build(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                         const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                         uint32_t max_edges, rs_ticker *ticker)
{
    rs_graph_builder builder;

    rs_graph_begin(graph, max_edges, &builder);
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *cells = grid_row(frame, grid, y);
        const uint16_t *row = labels->cells + (size_t)y * labels->stride;
        uint32_t index = rs_frame_index(frame, 0, y);

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            uint32_t distance = surface[index + x];
            uint16_t p, q;

            if (row[x] != 0u && row[x] <= RS_LINES_MAX_REGIONS && cells[x] < occupied_min) {
                rs_graph_add_cell(&graph->regions[row[x]], distance, index + x, x, y);
            }
            if (row[x] == RS_LINE && find_pair(frame, labels, x, y, &p, &q) &&
                !add_border_cell(&builder, p, q, distance, x, y)) {
                return ROOMSEG_ERR_REGIONS;
            }
        }
    }
    return ROOMSEG_OK;
}

/* inner[x] = a region of the room that the border cell (x, y) lies inside of; 0: no such
 * cell. Rows outside of the crop have none. */
static void find_inner(const rs_frame *frame, const rs_labels *labels, rs_region *regions,
                       uint32_t y, uint16_t *inner)
{
    const uint16_t *row = labels->cells + (size_t)y * labels->stride;

    memset(inner, 0, frame->width * sizeof *inner);
    for (uint32_t x = 0; y < frame->height && x < frame->width; x++) {
        uint16_t p, q;

        if (row[x] == RS_LINE && find_pair(frame, labels, x, y, &p, &q) &&
            rs_cluster_root(regions, p) == rs_cluster_root(regions, q)) {
            inner[x] = p;
        }
    }
}

/* Whether the inner border cell x of the middle row is an end. inner: three rows. */
static bool is_end(const rs_frame *frame, rs_region *regions, uint16_t *const inner[3],
                   uint32_t x)
{
    uint16_t root = rs_cluster_root(regions, inner[1][x]);
    uint16_t beside[4] = {inner[0][x], inner[2][x], 0, 0};
    uint32_t count = 0;

    beside[2] = x > 0u ? inner[1][x - 1u] : 0u;
    beside[3] = x + 1u < frame->width ? inner[1][x + 1u] : 0u;
    for (uint32_t k = 0; k < 4u; k++) {
        count += beside[k] != 0u && rs_cluster_root(regions, beside[k]) == root;
    }
    return count == 1u;
}

/* Counts a border cell as one of the cluster's. */
static void add_inner_cell(rs_region *root, uint32_t distance, uint32_t index, uint32_t x,
                           uint32_t y)
{
    uint32_t first = root->first_cell;

    rs_graph_add_cell(root, distance, index, x, y);
    root->first_cell = rs_min_u32(first, index);
}

/* Replaces what is no region in row y; inner: its own row and those above and below. */
static void resolve_row(const rs_frame *frame, const uint8_t *cells, uint8_t occupied_min,
                        const uint8_t *surface, rs_graph *graph, uint32_t y,
                        uint16_t *const inner[3], uint16_t *row)
{
    for (uint32_t x = 0; x < frame->width; x++) {
        uint16_t region = inner[1][x];
        rs_region *root;

        if (row[x] <= RS_LINES_MAX_REGIONS) {
            continue;
        }
        row[x] = 0;
        if (region == 0u || is_end(frame, graph->regions, inner, x)) {
            continue;
        }
        row[x] = region;
        root = &graph->regions[rs_cluster_root(graph->regions, region)];
        if (cells[x] < occupied_min && root->area > 0u) {
            add_inner_cell(root, surface[rs_frame_index(frame, x, y)],
                           rs_frame_index(frame, x, y), x, y);
        }
    }
}

int rs_graph_lines_resolve(const rs_frame *frame, const roomseg_grid *grid,
                           uint8_t occupied_min, const uint8_t *surface,
                           const rs_labels *labels, rs_graph *graph, uint16_t *rows,
                           rs_ticker *ticker)
{
    uint16_t *inner[3] = {rows, rows + frame->width, rows + 2u * (size_t)frame->width};

    memset(inner[1], 0, frame->width * sizeof *rows);
    find_inner(frame, labels, graph->regions, 0, inner[2]);
    for (uint32_t y = 0; y < frame->height; y++) {
        uint16_t *oldest = inner[0];

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        inner[0] = inner[1];
        inner[1] = inner[2];
        inner[2] = oldest;
        /* Row y + 1 is read from labels that are all as they were from row y on. */
        find_inner(frame, labels, graph->regions, y + 1u, inner[2]);
        resolve_row(frame, grid_row(frame, grid, y), occupied_min, surface, graph, y, inner,
                    labels->cells + (size_t)y * labels->stride);
    }
    return ROOMSEG_OK;
}
