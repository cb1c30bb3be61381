#include "watershed.h"

/* Until a cell has its label, it holds the way up: one of four pointers to a neighbour, all
 * above the greatest label. The opposite of direction d is d ^ 1. */
enum { UP = 0, DOWN, LEFT, RIGHT, DIRECTIONS };
#define POINTER 0xFFFCu

/* Cells of plateaus enter the ring so many steps from the slope, see point_cells. */
#define RING_HOPS 3u

RS_STATIC_ASSERT(ROOMSEG_MAX_REGIONS < POINTER, pointers_are_no_labels);

typedef struct flood {
    const rs_frame *frame;
    const uint8_t *surface;
    const rs_labels *labels;
    rs_ring *ring; /* cells of plateaus whose neighbours are to be reached */
    rs_ticker *ticker;
    ptrdiff_t surface_step[DIRECTIONS], label_step[DIRECTIONS];
    uint32_t max_regions, region_count;
    uint32_t row;      /* in work, of `rows` in all passes */
    uint32_t rows;
    uint32_t steps;    /* since the last tick, see follow() */
    bool reached;      /* a reading found cells of plateaus beside a way up */
    bool lost;         /* cells of plateaus were not reached for want of room in the ring */
} flood;

/* What (x, y) + step is for packed cells. */
static const uint32_t cell_step[DIRECTIONS] = {0u - (1u << 16), 1u << 16, 0u - 1u, 1u};

static bool tick(flood *f, uint32_t visits)
{
    return rs_tick(f->ticker, visits, f->row, f->rows);
}

static uint16_t *label_at(const flood *f, uint32_t x, uint32_t y)
{
    return f->labels->cells + (size_t)y * f->labels->stride + x;
}

static uint8_t higher(uint8_t a, uint8_t b)
{
    return a > b ? a : b;
}

/* Of two equally steep ways one is upright in every other cell, as on a chessboard, and sideways
 * in those between: up a slope askew to the axes they go straight, in steps. */
static uint32_t is_odd(uint32_t x, uint32_t y)
{
    return (x ^ y) & 1u;
}

/* Points every cell of row y that has a higher neighbour to the highest; others become 0.
 * Without branches, so that compilers vectorise it. */
static void point_row(const uint8_t *restrict row, uint32_t stride, uint32_t width, uint32_t y,
                      uint16_t *restrict labels)
{
    const uint8_t *above = row - stride, *left = row - 1, *right = row + 1, *below = row + stride;

    for (uint32_t x = 0; x < width; x++) {
        uint8_t upright = higher(above[x], below[x]), sideways = higher(left[x], right[x]);
        uint8_t vertical = above[x] == upright ? UP : DOWN;
        uint8_t horizontal = left[x] == sideways ? LEFT : RIGHT;
        uint8_t favour = (uint8_t)is_odd(x, y) & (upright == sideways);
        uint8_t way = (upright < sideways) | favour ? horizontal : vertical;

        uint8_t highest = higher(upright, sideways);
        uint16_t label = highest > row[x] ? (uint16_t)(POINTER + way) : (uint16_t)0;

        labels[x] = row[x] != 0u ? label : labels[x];
    }
}

/* Cells on the plateaus of those in the ring point towards them, the nearest first. */
static int spread(flood *f)
{
    while (f->ring->count > 0u) {
        uint32_t cell = rs_ring_pop(f->ring);
        uint32_t x = rs_cell_x(cell), y = rs_cell_y(cell);
        const uint8_t *height = f->surface + rs_frame_index(f->frame, x, y);
        uint16_t *label = label_at(f, x, y);
        uint8_t level = *height;

        if (tick(f, DIRECTIONS)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t d = 0; d < DIRECTIONS; d++) {
            if (height[f->surface_step[d]] != level || label[f->label_step[d]] != 0u) {
                continue;
            }
            if (rs_ring_push(f->ring, cell + cell_step[d])) {
                label[f->label_step[d]] = (uint16_t)(POINTER + (d ^ 1u));
            } else {
                f->lost = true;
            }
        }
    }
    return ROOMSEG_OK;
}

/* Whether a cell of a plateau may point to a neighbour of equal height: one from which `hops` steps
 * up lead off the plateau, or with ANY, that has a way up or a label. */
#define ANY 0u

static bool leads_up(const flood *f, const uint8_t *height, const uint16_t *label, uint32_t hops)
{
    uint8_t level = *height;

    if (hops == ANY) {
        return *label != 0u;
    }
    while (hops > 0u && *height == level && *label >= POINTER) {
        height += f->surface_step[*label - POINTER];
        label += f->label_step[*label - POINTER];
        hops--;
    }
    return hops == 0u && *height > level;
}

/* Points a cell of a plateau to a neighbour that leads up. False: there is none. */
static bool point_cell(const flood *f, const uint8_t *height, uint16_t *label, bool odd,
                       uint32_t hops)
{
    uint32_t flip = odd ? 2u : 0u;
    uint8_t level = *height;

    for (uint32_t k = 0; k < DIRECTIONS; k++) {
        uint32_t d = k ^ flip;

        if (height[f->surface_step[d]] == level &&
            leads_up(f, height + f->surface_step[d], label + f->label_step[d], hops)) {
            *label = (uint16_t)(POINTER + d);
            return true;
        }
    }
    return false;
}

/* Whether a machine word of labels tells that all its cells have a way up, or one of heights, that
 * all are obstacles. */
enum { WORD_LABELS = sizeof(size_t) / sizeof(uint16_t) };

static bool is_settled(const uint8_t *row, const uint16_t *labels)
{
    const size_t pointers = SIZE_MAX / 0xFFFFu * 0x8000u; /* the highest bit of each */
    size_t word, heights = 0;

    memcpy(&word, labels, sizeof word);
    memcpy(&heights, row, WORD_LABELS);
    return (word & pointers) == pointers || heights == 0u;
}

/* The first of the cells x..end without a way up and without a label. */
static uint32_t find_open(const uint8_t *row, const uint16_t *labels, uint32_t x, uint32_t end)
{
    while (x < end) {
        uint32_t stop = rs_min_u32(x + WORD_LABELS, end);

        for (; x < stop; x++) {
            if (labels[x] == 0u && row[x] != 0u) {
                return x;
            }
        }
        while (end - x >= WORD_LABELS && is_settled(row + x, labels + x)) {
            x += WORD_LABELS;
        }
    }
    return end;
}

/* Cells of plateaus in row y that are beside a way up, see leads_up, point to it. With `enter`
 * they enter the ring. */
static int reach_row(flood *f, uint32_t y, uint32_t hops, bool enter)
{
    const uint8_t *row = f->surface + rs_frame_index(f->frame, 0, y);
    uint16_t *labels = label_at(f, 0, y);
    uint32_t width = f->frame->width;

    if (tick(f, width)) {
        return ROOMSEG_ERR_CANCELLED;
    }
    for (uint32_t x = find_open(row, labels, 0, width); x < width;
         x = find_open(row, labels, x + 1u, width)) {
        if (!point_cell(f, row + x, labels + x, is_odd(x, y) != 0u, hops)) {
            continue;
        }
        f->reached = true;
        if (!enter) {
            continue;
        }
        if (f->ring->count == f->ring->capacity && spread(f) != ROOMSEG_OK) {
            return ROOMSEG_ERR_CANCELLED;
        }
        rs_ring_push(f->ring, rs_cell_pack(x, y));
    }
    return ROOMSEG_OK;
}

/* Gives every cell but those of regional maxima its way up. On a plateau the cells beside a slope
 * come first, without the ring, then those beside these: in most maps a level is a cell or two
 * wide, and the ring holds what is left. */
static int point_cells(flood *f)
{
    const rs_frame *frame = f->frame;
    int status = ROOMSEG_OK;

    for (uint32_t y = 0; y < frame->height; y++, f->row++) {
        if (tick(f, frame->width)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        point_row(f->surface + rs_frame_index(frame, 0, y), frame->stride, frame->width, y,
                  label_at(f, 0, y));
    }
    for (uint32_t hops = 1; hops <= RING_HOPS && f->reached; hops++) {
        f->reached = false; /* then there are none that are a step farther */
        for (uint32_t y = 0; status == ROOMSEG_OK && y < frame->height; y++, f->row++) {
            status = reach_row(f, y, hops, hops == RING_HOPS);
        }
    }
    return status == ROOMSEG_OK ? spread(f) : status;
}

/* Reads the crop again while spread() loses cells. */
static int find_lost(flood *f)
{
    int status = ROOMSEG_OK;

    while (status == ROOMSEG_OK && f->lost) {
        f->lost = false;
        for (uint32_t y = 0; status == ROOMSEG_OK && y < f->frame->height; y++) {
            status = reach_row(f, y, ANY, true);
        }
        if (status == ROOMSEG_OK) {
            status = spread(f);
        }
    }
    return status;
}

/* A region for the regional maximum around a cell: its other cells point there. */
static int found_region(flood *f, uint16_t *label)
{
    size_t index = (size_t)(label - f->labels->cells);
    uint32_t y = (uint32_t)(index / f->labels->stride);
    uint32_t x = (uint32_t)(index % f->labels->stride);
    int status;

    f->region_count++;
    if (f->region_count > f->max_regions) {
        return ROOMSEG_ERR_REGIONS;
    }
    *label = (uint16_t)f->region_count;
    rs_ring_push(f->ring, rs_cell_pack(x, y));
    status = spread(f);
    return status == ROOMSEG_OK ? find_lost(f) : status;
}

/* The cell at the end of the way up: one with a label, or of a regional maximum without one.
 * NULL: cancelled. */
static uint16_t *follow(flood *f, uint16_t *label)
{
    while (*label >= POINTER) {
        label += f->label_step[*label - POINTER];
        f->steps++;
        if (f->steps == RS_TICK_VISITS / 4u) {
            f->steps = 0;
            if (tick(f, RS_TICK_VISITS / 2u)) { /* each step is made twice */
                return NULL;
            }
        }
    }
    return label;
}

/* Labels a cell and all on its way up. */
static int settle(flood *f, uint16_t *label)
{
    uint16_t *end = follow(f, label);
    int status = ROOMSEG_OK;

    if (end == NULL) {
        return ROOMSEG_ERR_CANCELLED;
    }
    if (*end == 0u) {
        status = found_region(f, end);
    }
    while (label != end) {
        uint16_t *next = label + f->label_step[*label - POINTER];

        *label = *end;
        label = next;
    }
    return status;
}

static int settle_row(flood *f, uint32_t y)
{
    const uint8_t *row = f->surface + rs_frame_index(f->frame, 0, y);
    uint16_t *labels = label_at(f, 0, y);
    uint32_t width = f->frame->width;
    int status = tick(f, width) ? ROOMSEG_ERR_CANCELLED : ROOMSEG_OK;

    for (uint32_t x = rs_skip(row, 0, width, 0); x < width && status == ROOMSEG_OK;
         x = rs_skip(row, x, width, 0)) {
        for (; row[x] != 0u && status == ROOMSEG_OK; x++) { /* the border ends it */
            uint32_t label = labels[x];

            if (label >= POINTER) {
                uint16_t next = labels[(ptrdiff_t)x + f->label_step[label - POINTER]];

                if (next != 0u && next < POINTER) {
                    labels[x] = next; /* the commonest case: no way to follow */
                } else {
                    status = settle(f, labels + x);
                }
            } else if (label == 0u) {
                status = found_region(f, labels + x);
            }
        }
    }
    return status;
}

static int settle_cells(flood *f)
{
    int status = ROOMSEG_OK;

    for (uint32_t y = 0; status == ROOMSEG_OK && y < f->frame->height; y++, f->row++) {
        status = settle_row(f, y);
    }
    return status;
}

int rs_watershed_run(const rs_frame *frame, const uint8_t *surface, uint32_t max_regions,
                     const rs_labels *labels, uint32_t *region_count, rs_ring *ring,
                     rs_ticker *ticker)
{
    flood f = {frame, surface, labels, ring, ticker, {0}, {0}, max_regions, 0, 0, 0, 0, true,
               false};
    int status;

    f.rows = (2u + RING_HOPS) * frame->height;
    f.surface_step[UP] = -(ptrdiff_t)frame->stride;
    f.label_step[UP] = -(ptrdiff_t)labels->stride;
    f.surface_step[LEFT] = f.label_step[LEFT] = -1;
    f.surface_step[RIGHT] = f.label_step[RIGHT] = 1;
    f.surface_step[DOWN] = (ptrdiff_t)frame->stride;
    f.label_step[DOWN] = (ptrdiff_t)labels->stride;
    status = point_cells(&f);
    if (status == ROOMSEG_OK) {
        status = find_lost(&f);
    }
    if (status == ROOMSEG_OK) {
        status = settle_cells(&f);
    }
    *region_count = f.region_count;
    return status;
}
