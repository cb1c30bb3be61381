#include "shape.h"

/* No shape has as many cells, nor twelve times the sum of their squared distances: all
 * products stay below 2^62, since |sum of u|^2 <= cells * sum of u^2. */
#define MOST_CELLS (1u << 20)
#define MOST_SQUARES ((int64_t)1 << 42)

/* The same sums, signed, with the number of cells; cells = 0: vast. */
typedef struct moments {
    int64_t cells, x, y, xx, xy, yy;
} moments;

/* Adds the cells first..end - 1 of row y. */
static void add_run(const rs_region *region, rs_shape *shape, uint32_t first, uint32_t end,
                    uint32_t y)
{
    int64_t n = (int64_t)end - first;
    int64_t twice_u = (int64_t)first + end - 1 - 2 * (int64_t)region->peak_x;
    int64_t v = (int64_t)y - region->peak_y;

    shape->x += (uint32_t)(twice_u * n / 2); /* one of the factors is even */
    shape->y += (uint32_t)(v * n);
    shape->xx += (uint64_t)(3 * n * twice_u * twice_u + n * n * n);
    shape->xy += (uint64_t)(6 * n * twice_u * v);
    shape->yy += (uint64_t)(n * (12 * v * v + 1));
}

/* The cells first..end - 1 of a region but for certain obstacles. */
static void add_cells(const uint8_t *cells, uint8_t occupied_min, const rs_region *region,
                      rs_shape *shape, uint32_t first, uint32_t end, uint32_t y)
{
    if (rs_highest(cells + first, end - first) < occupied_min) {
        add_run(region, shape, first, end, y);
        return;
    }
    for (uint32_t x = first; x < end; x++) {
        if (cells[x] < occupied_min) {
            add_run(region, shape, x, x + 1u, y);
        }
    }
}

static bool is_vast(uint32_t area, const rs_shape *shape)
{
    return area >= MOST_CELLS || shape->xx >= (uint64_t)MOST_SQUARES ||
           shape->yy >= (uint64_t)MOST_SQUARES;
}

int rs_shape_measure(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                     const rs_labels *labels, rs_graph *graph, rs_ticker *ticker)
{
    memset(graph->shapes, 0, (graph->region_count + 1u) * sizeof *graph->shapes);
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *cells = grid->cells + (size_t)(frame->y + y) * grid->stride + frame->x;
        const uint16_t *row = labels->cells + (size_t)y * labels->stride;
        uint32_t x;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        x = rs_skip_label(row, 0, frame->width, 0);
        while (x < frame->width) {
            uint16_t label = row[x];
            uint32_t end = rs_skip_label(row, x, frame->width, label);

            add_cells(cells, occupied_min, &graph->regions[label], &graph->shapes[label], x, end,
                      y);
            x = rs_skip_label(row, end, frame->width, 0);
        }
    }
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        if (is_vast(graph->regions[r].area, &graph->shapes[r])) {
            graph->shapes[r].xx = RS_SHAPE_VAST;
        }
    }
    return ROOMSEG_OK;
}

/* A root's moments around (x, y). */
static moments around(const rs_graph *graph, uint16_t root, uint32_t x, uint32_t y)
{
    const rs_region *region = &graph->regions[root];
    const rs_shape *shape = &graph->shapes[root];
    int64_t n = region->area, u = (int32_t)shape->x, v = (int32_t)shape->y;
    int64_t dx = (int64_t)region->peak_x - x, dy = (int64_t)region->peak_y - y;

    if (shape->xx == RS_SHAPE_VAST) {
        return (moments){0, 0, 0, 0, 0, 0};
    }
    return (moments){n,
                     u + n * dx,
                     v + n * dy,
                     (int64_t)shape->xx + 12 * dx * (2 * u + n * dx),
                     (int64_t)shape->xy + 12 * (dx * v + dy * u + n * dx * dy),
                     (int64_t)shape->yy + 12 * dy * (2 * v + n * dy)};
}

static moments sum_of(const moments *a, const moments *b)
{
    moments sum = {a->cells + b->cells, a->x + b->x,   a->y + b->y,
                   a->xx + b->xx,       a->xy + b->xy, a->yy + b->yy};

    if (a->cells == 0 || b->cells == 0 || sum.cells >= MOST_CELLS || sum.xx >= MOST_SQUARES ||
        sum.yy >= MOST_SQUARES) {
        sum.cells = 0;
    }
    return sum;
}

void rs_shape_unite(rs_graph *graph, uint16_t into, uint16_t from, uint32_t x, uint32_t y)
{
    moments a = around(graph, into, x, y), b = around(graph, from, x, y);
    moments sum = sum_of(&a, &b);

    graph->shapes[into] = (rs_shape){(uint32_t)sum.x, (uint32_t)sum.y, (uint64_t)sum.xx,
                                     (uint64_t)sum.xy, (uint64_t)sum.yy};
    if (sum.cells == 0) {
        graph->shapes[into].xx = RS_SHAPE_VAST;
    }
}

bool rs_shape_are_narrow(const rs_graph *graph, uint16_t a, uint16_t b, uint32_t width)
{
    const rs_region *region = &graph->regions[a];
    moments m = around(graph, a, region->peak_x, region->peak_y);
    int64_t limit, greatest;

    if (a != b) {
        moments other = around(graph, b, region->peak_x, region->peak_y);
        m = sum_of(&m, &other);
    }
    if (m.cells == 0) {
        return false;
    }
    /* cells^2 times the squared widths along the axes, which are 12 times the variances. */
    m.xx = m.cells * m.xx - 12 * m.x * m.x;
    m.yy = m.cells * m.yy - 12 * m.y * m.y;
    m.xy = m.cells * m.xy - 12 * m.x * m.y;
    limit = m.cells * m.cells * (int64_t)(width * width);
    for (greatest = m.xx > m.yy ? m.xx : m.yy; greatest >= (int64_t)1 << 31; greatest /= 2) {
        m.xx /= 2;
        m.yy /= 2;
        m.xy /= 2;
        limit /= 2;
    }
    /* The smaller eigenvalue of ((xx, xy), (xy, yy)) is at most the limit. */
    return m.xx <= limit || m.yy <= limit || (m.xx - limit) * (m.yy - limit) <= m.xy * m.xy;
}
