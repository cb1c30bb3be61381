#include "distance.h"

/* Vertical distance to the nearest obstacle, saturating; one pass down, one up. */
static int vertical_distances(const rs_frame *frame, uint8_t *surface, rs_ticker *ticker)
{
    uint32_t stride = frame->stride, rows = frame->height;

    for (uint32_t y = 1; y <= rows; y++) {
        uint8_t *row = surface + (size_t)y * stride;
        const uint8_t *above = row - stride;

        if (rs_tick(ticker, frame->width, y, 4u * rows)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < stride; x++) {
            uint8_t farther = (uint8_t)(above[x] + (above[x] < RS_DISTANCE_MAX));
            row[x] = row[x] == 0u ? 0u : farther;
        }
    }
    for (uint32_t y = rows; y >= 1u; y--) {
        uint8_t *row = surface + (size_t)y * stride;
        const uint8_t *below = row + stride;

        if (rs_tick(ticker, frame->width, 2u * rows - y, 4u * rows)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < stride; x++) {
            uint8_t farther = (uint8_t)(below[x] + (below[x] < RS_DISTANCE_MAX));
            row[x] = row[x] < farther ? row[x] : farther;
        }
    }
    return ROOMSEG_OK;
}

/* First column from which on parabola b lies below a; b stands to the right of a. May be 0
 * or any column, also one beyond the row. Solves (x - a.x)^2 + a.height >
 * (x - b.x)^2 + b.height for x. With gap < 2^16 and heights <= 255^2 all terms fit. */
static uint32_t crossing(const rs_parabola *a, const rs_parabola *b)
{
    uint32_t gap = (uint32_t)b->x - a->x;
    uint32_t forward = gap * gap + b->height;
    uint32_t back;

    if (forward >= a->height) {
        forward -= a->height;
        /* Most parabolas stand side by side: no division for them. */
        return a->x + (gap == 1u ? forward / 2u : forward / (2u * gap)) + 1u;
    }
    back = a->height - forward + 2u * gap - 1u;
    back = gap == 1u ? back / 2u : back / (2u * gap); /* rounded up */
    return back > a->x ? 0u : a->x + 1u - back;
}

/* Adds column x to the envelope, dropping what it hides. Returns the new count. */
static uint32_t push_parabola(rs_parabola *envelope, uint32_t count, uint32_t x,
                              uint32_t vertical)
{
    rs_parabola fresh;
    uint32_t from = 0;

    fresh.x = (uint16_t)x;
    fresh.height = vertical * vertical;
    while (count > 0u) {
        from = crossing(&envelope[count - 1u], &fresh);
        if (from > envelope[count - 1u].from) {
            break;
        }
        count--;
    }
    fresh.from = count > 0u ? (uint16_t)rs_min_u32(from, UINT16_MAX) : 0u;
    envelope[count] = fresh;
    return count + 1u;
}

/* Replaces the vertical distances of the free run first..last by Euclidean ones; the cells
 * before and behind it are obstacles. */
static void transform_run(uint8_t *row, uint32_t first, uint32_t last,
                          const rs_distance_scratch *scratch)
{
    rs_parabola *envelope = scratch->envelope;
    const uint32_t *least = scratch->least;
    uint32_t count = 0, k = 0, level = 1;

    for (uint32_t x = first - 1u; x <= last + 1u; x++) {
        count = push_parabola(envelope, count, x, row[x]);
    }
    for (uint32_t x = first; x <= last; x++) {
        uint32_t offset, squared;

        while (k + 1u < count && envelope[k + 1u].from <= x) {
            k++;
        }
        offset = x > envelope[k].x ? x - envelope[k].x : envelope[k].x - x;
        squared = offset * offset + envelope[k].height;
        /* Neighbours differ by a few levels at most, so the level is followed. */
        while (level < RS_DISTANCE_MAX && squared >= least[level + 1u]) {
            level++;
        }
        while (level > 1u && squared < least[level]) {
            level--;
        }
        row[x] = (uint8_t)level;
    }
}

/* least[level] = smallest squared distance [cells^2] of that level, rounded up. */
static void make_levels(uint32_t resolution_mm, uint32_t *least)
{
    uint32_t divisor = resolution_mm * resolution_mm; /* <= 40,000 */

    for (uint32_t level = 0; level <= RS_DISTANCE_MAX; level++) {
        uint32_t distance_mm = level * RS_DISTANCE_UNIT_MM; /* <= 10,200 */
        least[level] = (distance_mm * distance_mm + divisor - 1u) / divisor;
    }
}

int rs_distance_run(const rs_frame *frame, uint32_t resolution_mm, uint8_t *surface,
                    const rs_distance_scratch *scratch, rs_ticker *ticker)
{
    int status = vertical_distances(frame, surface, ticker);

    make_levels(resolution_mm, scratch->least);

    for (uint32_t y = 1; status == ROOMSEG_OK && y <= frame->height; y++) {
        uint8_t *row = surface + (size_t)y * frame->stride;
        uint32_t x = 1;

        if (rs_tick(ticker, frame->width, frame->height + y, 2u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        while (x <= frame->width) {
            uint32_t first;
            while (x <= frame->width && row[x] == 0u) {
                x++;
            }
            first = x;
            while (row[x] != 0u) { /* the border ends it */
                x++;
            }
            if (x > first) {
                transform_run(row, first, x - 1u, scratch);
            }
        }
    }
    return status;
}
