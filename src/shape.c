#include "shape.h"

/* Adds the cells first..end - 1 of row y. */
static void add_run(rs_shape *shape, uint32_t first, uint32_t end, uint32_t y)
{
    uint64_t n = end - first, twice_mid = (uint64_t)first + end - 1u;

    shape->cells += n;
    shape->x += twice_mid * n / 2u; /* one of the factors is even */
    shape->y += y * n;
    shape->xx += 3u * n * twice_mid * twice_mid + n * n * n;
    shape->xy += 6u * n * twice_mid * y;
    shape->yy += n * (12u * (uint64_t)y * y + 1u);
}

int rs_shape_measure(const rs_frame *frame, const rs_labels *labels, uint32_t label_count,
                     rs_shape *shapes, rs_ticker *ticker)
{
    memset(shapes, 0, (label_count + 1u) * sizeof *shapes);
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint16_t *row = labels->cells + (size_t)y * labels->stride;
        uint32_t x;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        x = rs_skip_label(row, 0, frame->width, 0);
        while (x < frame->width) {
            uint32_t end = rs_skip_label(row, x, frame->width, row[x]);

            add_run(&shapes[row[x]], x, end, y);
            x = rs_skip_label(row, end, frame->width, 0);
        }
    }
    return ROOMSEG_OK;
}

rs_shape rs_shape_join(const rs_shape *a, const rs_shape *b)
{
    rs_shape sum = *a;

    sum.x += b->x;
    sum.y += b->y;
    sum.xx += b->xx;
    sum.xy += b->xy;
    sum.yy += b->yy;
    sum.cells += b->cells;
    return sum;
}

/* Twelve times a sum of (u - u0) * (v - v0) from the sums of u, v and twelve times u * v. */
static int64_t recentred(uint64_t uv, uint64_t u, uint64_t v, uint32_t u0, uint32_t v0, uint64_t n)
{
    return (int64_t)(uv - 12u * (v0 * u + u0 * v - n * u0 * v0));
}

bool rs_shape_is_narrow(const rs_shape *shape, uint32_t x, uint32_t y, uint32_t width)
{
    const int64_t most = (int64_t)1 << 42;
    int64_t n = (int64_t)shape->cells;
    int64_t sx, sy, xx, xy, yy, limit, greatest;

    if (shape->cells == 0u || shape->cells >= 1u << 20) {
        return false;
    }
    sx = (int64_t)(shape->x - shape->cells * x);
    sy = (int64_t)(shape->y - shape->cells * y);
    xx = recentred(shape->xx, shape->x, shape->x, x, x, shape->cells);
    yy = recentred(shape->yy, shape->y, shape->y, y, y, shape->cells);
    xy = recentred(shape->xy, shape->x, shape->y, x, y, shape->cells);
    if (xx >= most || yy >= most) {
        return false;
    }
    /* n^2 times the squared widths along the axes: 12 times the variances. All products stay
     * below 2^62, for sx^2 <= n * sum of (u - u0)^2. */
    xx = n * xx - 12 * sx * sx;
    yy = n * yy - 12 * sy * sy;
    xy = n * xy - 12 * sx * sy;
    limit = n * n * (int64_t)(width * width);
    for (greatest = xx > yy ? xx : yy; greatest >= (int64_t)1 << 31; greatest /= 2) {
        xx /= 2;
        yy /= 2;
        xy /= 2;
        limit /= 2;
    }
    /* The smaller eigenvalue of ((xx, xy), (xy, yy)) is at most the limit. */
    return xx <= limit || yy <= limit || (xx - limit) * (yy - limit) <= xy * xy;
}
