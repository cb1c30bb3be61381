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

/* First column, at least 0, from which on parabola b lies below a: (x - ax)^2 + ah >
 * (x - bx)^2 + bh, ax < bx. With bx - ax < 2^16 and heights <= 255^2 all terms fit. */
static uint32_t cross(uint32_t ax, uint32_t ah, uint32_t bx, uint32_t bh)
{
    uint32_t gap = bx - ax;
    uint32_t forward = gap * gap + bh;
    uint32_t back;

    if (forward >= ah) {
        forward -= ah;
        /* Most candidates stand side by side: no division for them. */
        return ax + (gap == 1u ? forward / 2u : forward / (2u * gap)) + 1u;
    }
    back = ah - forward + 2u * gap - 1u;
    back = gap == 1u ? back / 2u : back / (2u * gap); /* rounded up */
    return back > ax ? 0u : ax + 1u - back;
}

/* The same for basins; b stands to the right of a. The difference of the two never falls from
 * left to right, so they cross once. */
static uint32_t crossing(const rs_basin *a, const rs_basin *b)
{
    uint32_t gap = (uint32_t)b->first - a->last;
    uint32_t reach;

    if (a->height + gap * gap <= b->height) {
        /* a reaches below b's flat part, but perhaps not to its end. */
        reach = (uint32_t)b->last - a->last;
        return (uint32_t)b->height - a->height < reach * reach
                   ? a->last + rs_isqrt((uint32_t)b->height - a->height) + 1u
                   : cross(a->last, a->height, b->last, b->height);
    }
    if (b->height + gap * gap < a->height) {
        reach = (uint32_t)b->first - a->first;
        return (uint32_t)a->height - b->height <= reach * reach
                   ? b->first - rs_isqrt((uint32_t)a->height - b->height - 1u)
                   : cross(a->first, a->height, b->first, b->height);
    }
    return cross(a->last, a->height, b->first, b->height);
}

/* Adds the columns first..last to the envelope, dropping what they hide. Returns the new count. */
static uint32_t push_basin(rs_basin *envelope, uint32_t count, uint32_t first, uint32_t last,
                           uint32_t vertical)
{
    rs_basin fresh = {(uint16_t)first, (uint16_t)last, 0, (uint16_t)(vertical * vertical)};
    uint32_t from = 0;

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

/* The level of a squared distance, starting from one that is near: neighbours differ by few. */
static uint32_t follow_level(const uint32_t *least, uint32_t level, uint32_t squared)
{
    while (level < RS_DISTANCE_MAX && squared >= least[level + 1u]) {
        level++;
    }
    while (level > 1u && squared < least[level]) {
        level--;
    }
    return level;
}

/* Writes the levels of columns x..end - 1, where a basin is the lowest. */
static uint32_t fill_basin(const rs_basin *basin, uint32_t x, uint32_t end, const uint32_t *least,
                           uint32_t level, uint8_t *row)
{
    uint32_t height = basin->height;

    for (; x < end && x < basin->first; x++) {
        level = follow_level(least, level, (basin->first - x) * (basin->first - x) + height);
        row[x] = (uint8_t)level;
    }
    if (x < end && x <= basin->last) {
        uint32_t flat_end = rs_min_u32(end, basin->last + 1u);

        level = follow_level(least, level, height);
        memset(row + x, (int)level, flat_end - x);
        x = flat_end;
    }
    for (; x < end; x++) {
        level = follow_level(least, level, (x - basin->last) * (x - basin->last) + height);
        row[x] = (uint8_t)level;
    }
    return level;
}

/* Replaces the vertical distances of the free run that begins at column `first` by Euclidean
 * ones. Returns the column behind it, `end` at most; that one and the one before `first` are
 * obstacles. */
static uint32_t transform_run(uint8_t *row, uint32_t first, uint32_t end,
                              const rs_distance_scratch *scratch)
{
    rs_basin *envelope = scratch->envelope;
    uint32_t level = 1, x = first, count;

    if (row[first + 1u] == 0u || row[first + 2u] == 0u) { /* all beside an obstacle */
        level = follow_level(scratch->least, level, 1);
        row[first] = (uint8_t)level;
        x = first + 1u;
        if (row[x] != 0u) {
            row[x++] = (uint8_t)level;
        }
        return x;
    }
    count = push_basin(envelope, 0, first - 1u, first - 1u, 0);
    while (row[x] != 0u) { /* the border ends it */
        uint32_t next = rs_skip(row, x + 1u, end, row[x]);

        count = push_basin(envelope, count, x, next - 1u, row[x]);
        x = next;
    }
    count = push_basin(envelope, count, x, x, 0);
    for (uint32_t k = 0; k < count; k++) {
        uint32_t from = rs_max_u32(envelope[k].from, first);
        uint32_t to = k + 1u < count ? rs_min_u32(envelope[k + 1u].from, x) : x;

        level = fill_basin(&envelope[k], from, to, scratch->least, level, row);
    }
    return x;
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
        x = rs_skip(row, x, frame->width + 1u, 0);
        while (x <= frame->width) {
            x = transform_run(row, x, frame->width + 1u, scratch);
            x = rs_skip(row, x, frame->width + 1u, 0);
        }
    }
    return status;
}
