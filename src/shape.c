#include "shape.h"

/* No shape has as many cells, nor twelve times the sum of their squared distances: all
 * products stay below 2^62, since |sum of u|^2 <= cells * sum of u^2. */
#define MOST_CELLS (1u << 20)
#define MOST_SQUARES (1ULL << 42)

/* Nor does one reach farther from its peak along an axis, so that 32 bits hold a square. */
#define MOST_CELLS_AWAY 4096

/* Added to a sum that would be larger than MOST_SQUARES; all else makes less than 2^60. */
#define TOO_FAR (1ULL << 60)

static bool is_far(int32_t distance)
{
    return distance > MOST_CELLS_AWAY || distance < -MOST_CELLS_AWAY;
}

/* Adds the cells first..end - 1 of row y. */
static void add_run(const rs_region *region, rs_shape *shape, uint32_t first, uint32_t end,
                    uint32_t y)
{
    int32_t n = (int32_t)(end - first);
    int32_t u = (int32_t)first - region->peak_x, v = (int32_t)y - region->peak_y;
    int32_t twice_mid = 2 * u + n - 1;

    if (is_far(u) || is_far(u + n) || is_far(v)) {
        shape->xx |= TOO_FAR;
        return;
    }
    shape->x += (uint32_t)(twice_mid * n / 2); /* one of the factors is even */
    shape->y += (uint32_t)(v * n);
    shape->xx += (uint64_t)n * (uint32_t)(3 * twice_mid * twice_mid + n * n);
    shape->xy += (uint64_t)((int64_t)(6 * n) * (twice_mid * v));
    shape->yy += (uint64_t)n * (uint32_t)(12 * v * v + 1);
}

/* The cells first..end - 1 of a region but for certain obstacles. */
static void add_cells(const uint8_t *cells, uint8_t occupied_min, const rs_region *region,
                      rs_shape *shape, uint32_t first, uint32_t end, uint32_t y)
{
    bool whole = rs_highest(cells + first, end - first) < occupied_min;

    while (first < end) {
        uint32_t x = whole ? end : first;

        while (x < end && cells[x] < occupied_min) {
            x++;
        }
        if (x > first) {
            add_run(region, shape, first, x, y);
        }
        while (x < end && cells[x] >= occupied_min) {
            x++;
        }
        first = x;
    }
}

static bool is_vast(uint32_t cells, uint64_t xx, uint64_t yy)
{
    return cells >= MOST_CELLS || xx >= MOST_SQUARES || yy >= MOST_SQUARES;
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
        if (is_vast(graph->regions[r].area, graph->shapes[r].xx, graph->shapes[r].yy)) {
            graph->shapes[r].xx = RS_SHAPE_VAST;
        }
    }
    return ROOMSEG_OK;
}

/* The same sums around another place, with the number of cells. */
typedef struct moments {
    int32_t cells;
    int64_t x, y, xx, xy, yy;
} moments;

/* Adds a root's moments around (x, y). False: it is vast, or becomes so. */
static bool add_moments(const rs_graph *graph, uint16_t root, uint32_t x, uint32_t y, moments *sum)
{
    const rs_region *region = &graph->regions[root];
    const rs_shape *shape = &graph->shapes[root];
    int32_t n = (int32_t)region->area, u = (int32_t)shape->x, v = (int32_t)shape->y;
    int32_t dx = (int32_t)(region->peak_x - x), dy = (int32_t)(region->peak_y - y);
    int64_t n_dx = (int64_t)n * dx, n_dy = (int64_t)n * dy;

    if (shape->xx == RS_SHAPE_VAST) {
        return false;
    }
    sum->cells += n;
    sum->x += u + n_dx;
    sum->y += v + n_dy;
    sum->xx += (int64_t)shape->xx + 12 * dx * (u + u + n_dx);
    sum->xy += (int64_t)shape->xy + 12 * ((int64_t)dx * v + dy * (u + n_dx));
    sum->yy += (int64_t)shape->yy + 12 * dy * (v + v + n_dy);
    return !is_vast((uint32_t)sum->cells, (uint64_t)sum->xx, (uint64_t)sum->yy);
}

void rs_shape_unite(rs_graph *graph, uint16_t into, uint16_t from, uint32_t x, uint32_t y)
{
    moments sum = {0, 0, 0, 0, 0, 0};
    rs_shape *shape = &graph->shapes[into];
    bool good = add_moments(graph, into, x, y, &sum) && add_moments(graph, from, x, y, &sum);

    shape->x = (uint32_t)sum.x;
    shape->y = (uint32_t)sum.y;
    shape->xx = good ? (uint64_t)sum.xx : RS_SHAPE_VAST;
    shape->xy = (uint64_t)sum.xy;
    shape->yy = (uint64_t)sum.yy;
}

bool rs_shape_are_narrow(const rs_graph *graph, uint16_t a, uint16_t b, uint32_t width)
{
    moments m = {0, 0, 0, 0, 0, 0};
    uint32_t x = graph->regions[a].peak_x, y = graph->regions[a].peak_y;
    uint64_t xx, xy, yy, limit;

    if (!add_moments(graph, a, x, y, &m) || (a != b && !add_moments(graph, b, x, y, &m))) {
        return false;
    }
    /* cells^2 times the squared widths along the axes, which are 12 times the variances. */
    xx = (uint64_t)(m.cells * m.xx - 12 * m.x * m.x);
    yy = (uint64_t)(m.cells * m.yy - 12 * m.y * m.y);
    m.xy = m.cells * m.xy - 12 * m.x * m.y;
    xy = (uint64_t)(m.xy < 0 ? -m.xy : m.xy);
    limit = (uint64_t)m.cells * (uint32_t)m.cells * (width * width);
    while ((xx | yy) >> 31 != 0u) {
        xx >>= 1;
        xy >>= 1;
        yy >>= 1;
        limit >>= 1;
    }
    /* The smaller eigenvalue of ((xx, xy), (xy, yy)) is at most the limit. */
    return xx <= limit || yy <= limit || (xx - limit) * (yy - limit) <= xy * xy;
}
