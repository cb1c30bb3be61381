#include "ridge.h"

#include <string.h>

/* Sum of the weights, and bits that are dropped after the second pass: the blurred map is
 * in Q28. */
#define WEIGHT_BITS 24u
#define DROPPED_BITS 20u

#define RING (2u * RS_RIDGE_MAX_RADIUS + 1u)

/* Rows in work, `length` = width + 2 elements each: element i belongs to column i - 1. */
typedef struct window {
    const rs_frame *frame;
    const uint8_t *cells;
    uint32_t length;
    uint32_t radius;
    uint32_t weights[RS_RIDGE_MAX_RADIUS + 1u];
    uint32_t *along;     /* RING rows, blurred along the row, Q24 */
    uint32_t *smooth[3]; /* blurred both ways, Q28; three consecutive rows */
    uint64_t *sums;      /* one row of 64 bits */
} window;

/* exp(-x), x in Q31 below 1, by its series. */
static uint32_t exp_minus(uint32_t x)
{
    uint32_t term = 1u << 31, sum = 0;

    for (uint32_t n = 1; term > 0u; n++) {
        sum = n % 2u != 0u ? sum + term : sum - term;
        term = (uint32_t)((uint64_t)term * x >> 31) / n;
    }
    return sum;
}

/* Weights of a Gaussian with sigma^2 = variance [Q16 cells^2, 5/6 to 16]: from one to the
 * next by w(k) = w(k-1) * u^(2k-1) with u = exp(-1 / (2 sigma^2)). */
static void make_kernel(window *w, uint32_t variance)
{
    uint32_t step = exp_minus(rs_divide_q8((uint64_t)1u << 38, variance)); /* 2^46 / variance */
    uint32_t square = (uint32_t)((uint64_t)step * step >> 31);
    uint32_t total = 1u << 28, rest = 1u << WEIGHT_BITS;

    w->radius = rs_min_u32(rs_isqrt(variance) * 9u / 512u + 1u, RS_RIDGE_MAX_RADIUS);
    w->weights[0] = total;
    for (uint32_t k = 1; k <= w->radius; k++) {
        w->weights[k] = (uint32_t)((uint64_t)w->weights[k - 1u] * step >> 31);
        step = (uint32_t)((uint64_t)step * square >> 31);
        total += 2u * w->weights[k];
    }
    for (uint32_t k = 1; k <= w->radius; k++) {
        w->weights[k] = rs_divide_q8((uint64_t)w->weights[k] << (WEIGHT_BITS - 8u), total);
        rest -= 2u * w->weights[k];
    }
    w->weights[0] = rest; /* all weights together are exactly 2^WEIGHT_BITS */
}

/* The blur's variance without what the differences add: a second difference acts like a
 * second derivative after a blur of variance 1/6 cell^2. */
static uint32_t variance_of(uint32_t sigma_mm, uint32_t resolution_mm)
{
    uint32_t sigma = rs_min_u32(rs_max_u32(sigma_mm, resolution_mm), 4u * resolution_mm);
    uint64_t squared = (uint64_t)sigma * sigma;

    return rs_divide_q8(squared << 8, resolution_mm * resolution_mm) - (1u << 16) / 6u;
}

static uint32_t *along_row(const window *w, uint32_t y)
{
    return w->along + (size_t)((y + RING) % RING) * w->length;
}

/* Adds the kernel around a step of the map between element i - 1 and i; the running sum of
 * the row then is the blurred map. Modulo 2^32, so the order does not matter. */
static void add_step(const window *w, uint32_t *out, uint32_t i, bool up)
{
    for (uint32_t tap = 0; tap <= 2u * w->radius; tap++) {
        uint32_t at = i + tap < w->radius ? 0u : i + tap - w->radius;
        uint32_t weight = w->weights[tap < w->radius ? w->radius - tap : tap - w->radius];

        if (at < w->length) {
            out[at] += up ? weight : 0u - weight;
        }
    }
}

/* Blurs crop row y, -1..height, along itself; rows outside of the crop are 0. */
static void blur_along(const window *w, uint32_t y)
{
    uint32_t *out = along_row(w, y);
    const uint8_t *row;
    uint32_t sum = 0;

    memset(out, 0, w->length * sizeof *out);
    if (y >= w->frame->height) {
        return;
    }
    row = w->cells + rs_frame_index(w->frame, 0u - 1u, y);
    for (uint32_t i = 1; i < w->length; i++) { /* the bordered row begins and ends with 0 */
        if (row[i] != row[i - 1u]) {
            add_step(w, out, i, row[i] != 0u);
        }
    }
    for (uint32_t i = 0; i < w->length; i++) {
        sum += out[i];
        out[i] = sum;
    }
}

/* Blurs row y down the columns; it becomes the last of the three smooth rows. */
static void blur_down(window *w, uint32_t y)
{
    uint32_t *out = w->smooth[0];
    const uint32_t *middle = along_row(w, y);

    w->smooth[0] = w->smooth[1];
    w->smooth[1] = w->smooth[2];
    w->smooth[2] = out;
    for (uint32_t i = 0; i < w->length; i++) {
        w->sums[i] = (uint64_t)w->weights[0] * middle[i];
    }
    for (uint32_t k = 1; k <= w->radius; k++) {
        const uint32_t *above = along_row(w, y - k), *below = along_row(w, y + k);
        uint32_t weight = w->weights[k];
        for (uint32_t i = 0; i < w->length; i++) {
            w->sums[i] += (uint64_t)weight * (above[i] + below[i]);
        }
    }
    for (uint32_t i = 0; i < w->length; i++) {
        out[i] = (uint32_t)((w->sums[i] + (1u << (DROPPED_BITS - 1u))) >> DROPPED_BITS);
    }
}

/* sqrt(a^2 + b^2) to 14 bits. */
static uint32_t hypotenuse(uint32_t a, uint32_t b)
{
    uint32_t shift = 0;

    while ((a | b) >> shift >= 1u << 15) {
        shift++;
    }
    a >>= shift;
    b >>= shift;
    return rs_isqrt(a * a + b * b) << shift;
}

/* Three times the ridge value at element i of the middle row. The map in work is the free
 * space, so signs are turned: with the Hessian's trace t and s = sqrt((Hxx - Hyy)^2 +
 * 4 Hxy^2) the eigenvalues are (t +- s) / 2; for alpha = 1/3 the larger one is the one of
 * t's sign, and the value is (2t + s) / 3. */
static uint32_t ridge_value(const window *w, uint32_t i)
{
    const uint32_t *a = w->smooth[0], *b = w->smooth[1], *c = w->smooth[2];
    /* All differences are below 2^28. */
    int32_t xx = (int32_t)(2u * b[i] - b[i - 1u] - b[i + 1u]);
    int32_t yy = (int32_t)(2u * b[i] - a[i] - c[i]);
    int32_t xy = (int32_t)(a[i - 1u] + c[i + 1u] - a[i + 1u] - c[i - 1u]) / 2; /* 2 Hxy */
    int32_t trace = xx + yy, difference = xx - yy;

    if (trace < 0 || (trace == 0 && difference == 0 && xy == 0)) {
        return 0;
    }
    return 2u * (uint32_t)trace + hypotenuse((uint32_t)(difference < 0 ? -difference : difference),
                                             (uint32_t)(xy < 0 ? -xy : xy));
}

/* The square roots of a row's values; returns the greatest. */
static uint32_t find_row(const window *w, const uint8_t *cells, uint16_t *roots)
{
    uint32_t greatest = 0;

    for (uint32_t x = 0; x < w->frame->width; x++) {
        uint32_t root = cells[x] != 0u ? rs_isqrt(ridge_value(w, x + 1u)) : 0u;
        roots[x] = (uint16_t)root;
        greatest = rs_max_u32(greatest, root);
    }
    return greatest;
}

/* The square roots of all values, and the greatest of them. */
static int find_roots(window *w, uint16_t *roots, uint32_t *greatest, rs_ticker *ticker)
{
    uint32_t height = w->frame->height;

    /* Row y of the ridge needs smooth rows up to y + 1, those need rows up to y + 1 + radius. */
    for (uint32_t step = 0; step < height + w->radius + 2u; step++) {
        uint32_t y = step - w->radius - 2u; /* modulo 2^32 */

        if (rs_tick(ticker, w->length, 2u * step, 3u * (height + RING))) {
            return ROOMSEG_ERR_CANCELLED;
        }
        blur_along(w, step - 1u);
        if (step >= w->radius) {
            blur_down(w, step - w->radius - 1u);
        }
        if (y < height) {
            uint32_t highest = find_row(w, w->cells + rs_frame_index(w->frame, 0, y),
                                        roots + (size_t)y * w->frame->width);
            *greatest = rs_max_u32(*greatest, highest);
        }
    }
    return ROOMSEG_OK;
}

static void make_window(const rs_frame *frame, const uint8_t *cells, uint32_t *rows, window *w)
{
    size_t length = frame->stride;

    w->frame = frame;
    w->cells = cells;
    w->length = frame->stride;
    memset(rows, 0, ROOMSEG_RIDGE_ROWS * length * sizeof *rows);
    w->sums = (uint64_t *)(void *)rows; /* first, for its alignment */
    rows += 2u * length;
    for (uint32_t i = 0; i < 3u; i++) {
        w->smooth[i] = rows + i * length;
    }
    w->along = rows + 3u * length;
}

RS_STATIC_ASSERT(ROOMSEG_RIDGE_ROWS == RING + 5u, ridge_rows);

int rs_ridge_run(const rs_frame *frame, uint32_t sigma_mm, uint32_t resolution_mm,
                 uint8_t *cells, const rs_ridge_scratch *scratch, rs_ticker *ticker)
{
    uint32_t greatest = 1;
    window w;
    int status;

    make_window(frame, cells, scratch->rows, &w);
    make_kernel(&w, variance_of(sigma_mm, resolution_mm));
    status = find_roots(&w, scratch->roots, &greatest, ticker);
    for (uint32_t y = 0; status == ROOMSEG_OK && y < frame->height; y++) {
        const uint16_t *roots = scratch->roots + (size_t)y * frame->width;
        uint8_t *row = cells + rs_frame_index(frame, 0, y);

        if (rs_tick(ticker, frame->width, 2u * frame->height + y, 3u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            uint32_t value = (roots[x] * RS_RIDGE_MAX + greatest / 2u) / greatest;
            row[x] = row[x] == 0u ? (uint8_t)RS_RIDGE_OBSTACLE : (uint8_t)value;
        }
    }
    return status;
}
