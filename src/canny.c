#include "canny.h"

#include <string.h>

#define TAPS (2u * RS_CANNY_RADIUS + 1u)

/* Marks in the mask between the crest and the end of the hysteresis. */
#define WEAK 1u
#define STRONG 2u

/* exp(-k^2 / 8), Q15; the 17 weights add up to 1. */
static const uint16_t kernel[RS_CANNY_RADIUS + 1u] = {6536, 5768, 3965, 2122, 885,
                                                      287,  73,   14,   2};

/* Rows in work, `length` elements each: element i belongs to column i - 2. The rows of a
 * kind follow each other round a ring. */
typedef struct window {
    const rs_frame *frame;
    uint8_t *mask;
    uint32_t length;
    uint32_t *sum;          /* one row of 32 bits */
    uint16_t *across[TAPS]; /* blurred along the row, Q15; [0] is the uppermost */
    uint16_t *smooth[3];    /* blurred both ways, Q14 */
    uint16_t *slope[3];     /* SLOPE_PARTS rows each */
} window;

/* What is kept of a row's gradient, Q14. The parts along x and y are below
 * 4 * 0.395 * 2^14 < 2^15, because cells two apart in the blurred mask differ by at most
 * 0.395. */
#define SLOPE_PARTS 3u

static uint16_t *magnitude_of(const window *w, uint32_t row)
{
    return w->slope[row];
}
static int16_t *gx_of(const window *w, uint32_t row)
{
    return (int16_t *)(w->slope[row] + w->length);
}
static int16_t *gy_of(const window *w, uint32_t row)
{
    return (int16_t *)(w->slope[row] + 2u * (size_t)w->length);
}

static void make_window(const rs_frame *frame, uint8_t *mask, uint16_t *rows, window *w)
{
    uint32_t length = frame->stride + 2u;

    w->frame = frame;
    w->mask = mask;
    w->length = length;
    memset(rows, 0, (size_t)length * ROOMSEG_CANNY_ROWS * sizeof *rows);
    w->sum = (uint32_t *)(void *)rows;
    rows += 2u * (size_t)length;
    for (uint32_t i = 0; i < TAPS; i++, rows += length) {
        w->across[i] = rows;
    }
    for (uint32_t i = 0; i < 3u; i++, rows += (1u + SLOPE_PARTS) * (size_t)length) {
        w->smooth[i] = rows;
        w->slope[i] = rows + length;
    }
}

/* The ring's first row becomes its last. */
static void rotate(uint16_t **ring, uint32_t count)
{
    uint16_t *first = ring[0];

    memmove(ring, ring + 1, (count - 1u) * sizeof *ring);
    ring[count - 1u] = first;
}

/* Adds the kernel around a step of the mask from column x - 1 to x; a row's running sum
 * then is the blurred mask. Up to 2^15 and modulo 2^16, so the order does not matter. */
static void add_step(uint16_t *out, uint32_t length, uint32_t x, bool up)
{
    for (uint32_t tap = 0; tap < TAPS; tap++) {
        uint32_t at = x + 2u + tap;
        uint32_t k = tap < RS_CANNY_RADIUS ? RS_CANNY_RADIUS - tap : tap - RS_CANNY_RADIUS;

        at = at < RS_CANNY_RADIUS ? 0u : at - RS_CANNY_RADIUS;
        if (at < length) {
            out[at] = (uint16_t)(up ? out[at] + kernel[k] : out[at] - kernel[k]);
        }
    }
}

/* Blurs crop row y along itself into the last row of the ring; rows outside are 0. */
static void blur_across(window *w, uint32_t y)
{
    uint16_t *out = w->across[TAPS - 1u];
    const uint8_t *row, *before;

    memset(out, 0, w->length * sizeof *out);
    if (y >= w->frame->height) {
        return;
    }
    row = w->mask + rs_frame_index(w->frame, 0, y);
    before = row - 1;
    for (uint32_t x = 0; x < w->frame->width; x++) {
        if (row[x] != before[x]) {
            add_step(out, w->length, x, row[x] != 0u);
        }
    }
    if (row[w->frame->width - 1u] != 0u) {
        add_step(out, w->length, w->frame->width, false);
    }
    for (uint32_t i = 1; i < w->length; i++) {
        out[i] = (uint16_t)(out[i] + out[i - 1u]);
    }
}

static void blur_down(window *w)
{
    const uint16_t *middle = w->across[RS_CANNY_RADIUS];
    uint32_t *sum = w->sum;

    for (uint32_t i = 0; i < w->length; i++) {
        sum[i] = (uint32_t)kernel[0] * middle[i];
    }
    for (uint32_t k = 1; k <= RS_CANNY_RADIUS; k++) {
        const uint16_t *above = w->across[RS_CANNY_RADIUS - k];
        const uint16_t *below = w->across[RS_CANNY_RADIUS + k];
        uint32_t weight = kernel[k];
        for (uint32_t i = 0; i < w->length; i++) {
            sum[i] += weight * ((uint32_t)above[i] + below[i]);
        }
    }
    for (uint32_t i = 0; i < w->length; i++) {
        w->smooth[2][i] = (uint16_t)((sum[i] + (1u << 15)) >> 16);
    }
}

/* Sobel's kernels around the middle one of the three smooth rows. */
static void take_gradient(window *w)
{
    const uint16_t *a = w->smooth[0], *b = w->smooth[1], *c = w->smooth[2];
    int16_t *gx = gx_of(w, 2), *gy = gy_of(w, 2);
    uint16_t *magnitude = magnitude_of(w, 2);

    for (uint32_t i = 1; i + 1u < w->length; i++) {
        int32_t dx = a[i + 1] + 2 * b[i + 1] + c[i + 1] - a[i - 1] - 2 * b[i - 1] - c[i - 1];
        int32_t dy = c[i - 1] + 2 * c[i] + c[i + 1] - a[i - 1] - 2 * a[i] - a[i + 1];
        gx[i] = (int16_t)dx;
        gy[i] = (int16_t)dy;
        magnitude[i] = dx == 0 && dy == 0
                           ? (uint16_t)0
                           : (uint16_t)rs_isqrt((uint32_t)(dx * dx) + (uint32_t)(dy * dy));
    }
}

/* Whether the magnitude at element i of the middle row is a crest along the gradient: above
 * the next value uphill on the blurred mask, that is towards the free side, and not below
 * the one downhill. Of two equal cells on both sides of an edge this is the free one. Values
 * between cells are interpolated. */
static bool is_crest(const window *w, uint32_t i)
{
    int32_t gx = gx_of(w, 1)[i], gy = gy_of(w, 1)[i];
    uint32_t ax = (uint32_t)(gx < 0 ? -gx : gx), ay = (uint32_t)(gy < 0 ? -gy : gy);
    const uint16_t *up = magnitude_of(w, gy < 0 ? 0u : 2u);
    const uint16_t *down = magnitude_of(w, gy < 0 ? 2u : 0u);
    const uint16_t *here = magnitude_of(w, 1);
    uint32_t forward = gx < 0 ? i - 1u : i + 1u, back = gx < 0 ? i + 1u : i - 1u;
    uint32_t uphill, downhill, limit; /* times the larger of ax and ay: below 2^31 */

    if (ax >= ay) {
        uphill = here[forward] * (ax - ay) + up[forward] * ay;
        downhill = here[back] * (ax - ay) + down[back] * ay;
        limit = here[i] * ax;
    } else {
        uphill = up[i] * (ay - ax) + up[forward] * ax;
        downhill = down[i] * (ay - ax) + down[back] * ax;
        limit = here[i] * ay;
    }
    return limit > uphill && limit >= downhill;
}

static void mark_crests(const window *w, uint32_t y)
{
    uint8_t *row = w->mask + rs_frame_index(w->frame, 0, y);

    for (uint32_t x = 0; x < w->frame->width; x++) {
        uint32_t magnitude = magnitude_of(w, 1)[x + 2u];
        row[x] = 0;
        if (magnitude >= RS_CANNY_WEAK && is_crest(w, x + 2u)) {
            row[x] = magnitude >= RS_CANNY_STRONG ? STRONG : WEAK;
        }
    }
}

/* One pass over the rows. What is read of a row is read RS_CANNY_RADIUS + 2 rows before its
 * marks are written, so the mask can be both. `step` s blurs row s - 2 of the crop. */
static int find_crests(window *w, rs_ticker *ticker)
{
    uint32_t height = w->frame->height;

    for (uint32_t y = 0; y < RS_CANNY_RADIUS - 2u; y++) {
        rotate(w->across, TAPS);
        blur_across(w, y);
    }
    for (uint32_t step = 0; step < height + 4u; step++) {
        if (rs_tick(ticker, w->frame->stride, step, 2u * (height + 4u))) {
            return ROOMSEG_ERR_CANCELLED;
        }
        rotate(w->across, TAPS);
        rotate(w->smooth, 3u);
        rotate(w->slope, 3u);
        blur_across(w, step + RS_CANNY_RADIUS - 2u);
        blur_down(w);
        if (step >= 2u) {
            take_gradient(w);
        }
        if (step >= 4u) {
            mark_crests(w, step - 4u);
        }
    }
    return ROOMSEG_OK;
}

/* Makes strong whatever weak cell is connected with a strong one, 8-connected. A cell enters
 * the stack once: `points` is long enough. */
static int connect_weak(const rs_frame *frame, uint8_t *mask, uint32_t *points, uint32_t depth,
                        rs_ticker *ticker)
{
    const uint32_t stride = frame->stride;
    const uint32_t step[8] = {0u - stride - 1u, 0u - stride, 0u - stride + 1u, 0u - 1u, 1u,
                              stride - 1u,      stride,      stride + 1u}; /* modulo 2^32 */

    while (depth > 0u) {
        uint32_t cell = points[--depth];

        if (rs_tick(ticker, 8u, frame->height / 2u, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t k = 0; k < 8u; k++) {
            uint32_t next = cell + step[k];
            if (mask[next] == WEAK) {
                mask[next] = STRONG;
                points[depth++] = next;
            }
        }
    }
    return ROOMSEG_OK;
}

/* Lists the strong cells: as bordered indices, or packed; then marks end as 0 and 1. */
static int list_strong(const rs_frame *frame, uint8_t *mask, bool packed, uint32_t *points,
                       uint32_t *point_count, rs_ticker *ticker)
{
    uint32_t count = 0;

    for (uint32_t y = 0; y < frame->height; y++) {
        uint32_t first = rs_frame_index(frame, 0, y);

        if (rs_tick(ticker, frame->width, frame->height + y, 2u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            if (mask[first + x] == STRONG) {
                points[count++] = packed ? rs_cell_pack(x, y) : first + x;
            }
            if (packed) {
                mask[first + x] = mask[first + x] == STRONG;
            }
        }
    }
    *point_count = count;
    return ROOMSEG_OK;
}

int rs_canny_run(const rs_frame *frame, uint8_t *mask, uint32_t *points, uint32_t *point_count,
                 uint16_t *rows, rs_ticker *ticker)
{
    window w;
    int status;

    make_window(frame, mask, rows, &w);
    status = find_crests(&w, ticker);
    if (status == ROOMSEG_OK) {
        status = list_strong(frame, mask, false, points, point_count, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = connect_weak(frame, mask, points, *point_count, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = list_strong(frame, mask, true, points, point_count, ticker);
    }
    return status;
}
