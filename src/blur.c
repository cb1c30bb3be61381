#include "blur.h"

#include <string.h>

/* With V the variance and r the radius, weights that sum to 1 give
 * V = centre * r(r+1)(2r+1)/3 + 2 end (r+1)^2, so that
 * 2 end = (3V - r(r+1)) / ((r+1)(2r+3)), which is at least 0 for r(r+1)/3 <= V. */
rs_box rs_box_of_variance(uint32_t variance)
{
    uint32_t three = 3u * rs_min_u32(variance, UINT32_MAX / 3u);
    uint32_t r = 0, ends;
    rs_box box;

    while (r < RS_BLUR_MAX_RADIUS && ((r + 1u) * (r + 2u)) << 16 <= three) {
        r++;
    }
    ends = rs_min_u32((three - (r * (r + 1u) << 16)) / ((r + 1u) * (2u * r + 3u)), 1u << 16);
    box.radius = r;
    /* Even and rounded down: the ends share what remains without a rest. */
    box.centre = ((1u << 16) - ends) / (2u * (2u * r + 1u)) * 2u;
    box.end = ((1u << 16) - (2u * r + 1u) * box.centre) / 2u;
    return box;
}

uint32_t rs_box_variance(const rs_box *box)
{
    uint32_t r = box->radius;

    return box->centre * (r * (r + 1u) * (2u * r + 1u) / 3u) +
           2u * box->end * (r + 1u) * (r + 1u);
}

/* Rows of the ring: [0] is always 0, the others hold rows of the plane as they were before
 * they were blurred down the columns, row y in place 1 + y modulo (ring_rows - 1). */
static uint16_t *ring_row(const rs_blur *blur, uint32_t y)
{
    return blur->scratch.ring + (size_t)(1u + y % (blur->scratch.ring_rows - 1u)) * blur->width;
}

/* Row y of the plane, not yet blurred down the columns; y up to 2^31 beyond either end. */
static const uint16_t *row_below(const rs_blur *blur, uint32_t y)
{
    return y < blur->height ? blur->cells + (size_t)y * blur->width : blur->scratch.ring;
}

static void blur_along(const rs_blur *blur, uint32_t y)
{
    const rs_box *box = &blur->box;
    uint32_t width = blur->width, pad = box->radius + 1u;
    uint16_t *row;
    /* prefix[pad + x] = sum of the cells before x. Sums are below 65535 * 65535. */
    uint32_t *prefix = blur->scratch.prefix;
    uint32_t sum = 0, inner_weight = box->centre - box->end, end = box->end;
    const uint32_t *a, *b, *c, *d;

    if (y >= blur->height) {
        return;
    }
    row = blur->cells + (size_t)y * width;
    memset(prefix, 0, pad * sizeof *prefix);
    for (uint32_t x = 0; x < width; x++) {
        prefix[pad + x] = sum;
        sum += row[x];
    }
    for (uint32_t x = 0; x <= pad; x++) {
        prefix[pad + width + x] = sum;
    }
    a = prefix;
    b = prefix + 1;
    c = prefix + 2u * pad;
    d = c + 1;
    for (uint32_t x = 0; x < width; x++) {
        /* centre * inner + end * (outer - inner), at most 65535 * 2^16 */
        uint32_t weighed = inner_weight * (c[x] - b[x]) + end * (d[x] - a[x]);
        row[x] = (uint16_t)((weighed + (1u << 15)) >> 16);
    }
}

void rs_blur_begin(rs_blur *blur)
{
    uint32_t width = blur->width;

    memset(blur->scratch.ring, 0, (size_t)width * sizeof *blur->scratch.ring);
    memset(blur->scratch.sums, 0, (size_t)width * sizeof *blur->scratch.sums);
    for (uint32_t y = 0; y <= blur->box.radius; y++) {
        blur_along(blur, y);
        if (y < blur->box.radius) {
            const uint16_t *row = row_below(blur, y);
            for (uint32_t x = 0; x < width; x++) {
                blur->scratch.sums[x] += row[x];
            }
        }
    }
}

/* out = the blurred row; sums: of the 2 * radius + 1 rows in the middle; first and last: the
 * rows that count in part. */
static void weigh(const rs_box *box, const uint32_t *sums, const uint16_t *first,
                  const uint16_t *last, uint32_t width, uint16_t *restrict out)
{
    uint32_t centre = box->centre, end = box->end;

    for (uint32_t x = 0; x < width; x++) {
        uint32_t weighed = centre * sums[x] + end * ((uint32_t)first[x] + last[x]);
        out[x] = (uint16_t)((weighed + (1u << 15)) >> 16);
    }
}

const uint16_t *rs_blur_row(rs_blur *blur, uint32_t y)
{
    uint32_t r = blur->box.radius, width = blur->width;
    uint32_t *sums = blur->scratch.sums;
    uint16_t *row = blur->cells + (size_t)y * width;
    const uint16_t *enter, *leave;

    blur_along(blur, y + r + 1u);
    enter = row_below(blur, y + r);
    leave = y > r ? ring_row(blur, y - r - 1u) : blur->scratch.ring;
    for (uint32_t x = 0; x < width; x++) {
        sums[x] += (uint32_t)enter[x] - leave[x];
    }
    memcpy(ring_row(blur, y), row, (size_t)width * sizeof *row);
    weigh(&blur->box, sums, leave, row_below(blur, y + r + 1u), width, row);
    return row;
}
