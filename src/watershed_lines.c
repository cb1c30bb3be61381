#include "watershed_lines.h"

typedef struct flood {
    const rs_frame *frame;
    const uint8_t *surface;
    const rs_labels *labels;
    rs_queue *queue;
    rs_ticker *ticker;
    uint32_t level;      /* no list below it holds a cell */
    uint32_t cells_done;
    bool lossy;          /* the queue refused a cell: from now on levels are searched */
} flood;

/* The neighbours of a cell in reading order; modulo 2^32. */
static const uint32_t step_x[8] = {0u - 1u, 0, 1, 0u - 1u, 1, 0u - 1u, 0, 1};
static const uint32_t step_y[8] = {0u - 1u, 0u - 1u, 0u - 1u, 0, 0, 1, 1, 1};

static inline uint16_t *label_at(const flood *f, uint32_t x, uint32_t y)
{
    return &f->labels->cells[(size_t)y * f->labels->stride + x];
}

static inline bool is_outside(const flood *f, uint32_t x, uint32_t y)
{
    return x >= f->frame->width || y >= f->frame->height;
}

/* The one label that the basins around a cell have; 0: none around; RS_LINE: several. */
static uint16_t basin_around(const flood *f, uint32_t x, uint32_t y)
{
    uint16_t basin = 0;

    for (uint32_t k = 0; k < 8u; k++) {
        uint32_t nx = x + step_x[k], ny = y + step_y[k];
        uint16_t label = is_outside(f, nx, ny) ? (uint16_t)RS_BACKGROUND : *label_at(f, nx, ny);

        if (label == 0u || label == RS_WAITING || label == RS_LINE) {
            continue;
        }
        if (basin != 0u && basin != label) {
            return RS_LINE;
        }
        basin = label;
    }
    return basin;
}

/* A cell that finds no room in the queue stays without label, so that search() can tell it
 * from those that wait. */
static void enqueue(flood *f, uint32_t x, uint32_t y)
{
    uint32_t height = f->surface[rs_frame_index(f->frame, x, y)];

    if (!rs_queue_push(f->queue, height, rs_cell_pack(x, y))) {
        f->lossy = true;
        return;
    }
    *label_at(f, x, y) = RS_WAITING;
    f->level = rs_min_u32(f->level, height);
}

/* Decides what a reached cell is; a basin goes on to its neighbours. */
static void settle(flood *f, uint32_t x, uint32_t y)
{
    uint16_t basin = basin_around(f, x, y);

    *label_at(f, x, y) = basin;
    if (basin == RS_LINE) {
        return;
    }
    for (uint32_t k = 0; k < 8u; k++) {
        uint32_t nx = x + step_x[k], ny = y + step_y[k];

        if (!is_outside(f, nx, ny) && *label_at(f, nx, ny) == 0u) {
            enqueue(f, nx, ny);
        }
    }
}

/* Puts all cells beside a marker into the queue. */
static int start(flood *f)
{
    for (uint32_t y = 0; y < f->frame->height; y++) {
        if (rs_tick(f->ticker, f->frame->width, y, 4u * f->frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < f->frame->width; x++) {
            if (*label_at(f, x, y) == 0u && basin_around(f, x, y) != 0u) {
                enqueue(f, x, y);
            }
        }
    }
    return ROOMSEG_OK;
}

static int drain(flood *f)
{
    while (f->level <= UINT8_MAX) {
        uint32_t cell;

        if (!rs_queue_pop(f->queue, f->level, &cell)) {
            if (f->lossy) {
                return ROOMSEG_OK; /* cells of this level may have been lost */
            }
            f->level++;
            continue;
        }
        if (rs_tick(f->ticker, 8u, f->cells_done / f->frame->width, f->frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        f->cells_done++;
        settle(f, rs_cell_x(cell), rs_cell_y(cell));
    }
    return ROOMSEG_OK;
}

/* Settles the cells up to the present level that the queue lost. *found: there were some. */
static int search(flood *f, bool *found)
{
    uint32_t level = f->level;

    *found = false;
    for (uint32_t y = 0; y < f->frame->height; y++) {
        const uint8_t *row = f->surface + rs_frame_index(f->frame, 0, y);

        if (rs_tick(f->ticker, f->frame->width, f->cells_done / f->frame->width,
                    f->frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < f->frame->width; x++) {
            if (row[x] <= level && *label_at(f, x, y) == 0u && basin_around(f, x, y) != 0u) {
                settle(f, x, y);
                *found = true;
            }
        }
    }
    return ROOMSEG_OK;
}

/* Cells that lines cut off from all markers belong to the lines. */
static int close_gaps(const flood *f)
{
    for (uint32_t y = 0; y < f->frame->height; y++) {
        uint16_t *row = label_at(f, 0, y);

        if (rs_tick(f->ticker, f->frame->width, 1, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < f->frame->width; x++) {
            row[x] = row[x] == 0u ? (uint16_t)RS_LINE : row[x];
        }
    }
    return ROOMSEG_OK;
}

int rs_watershed_lines_run(const rs_frame *frame, const uint8_t *surface,
                           const rs_labels *labels, rs_queue *queue, rs_ticker *ticker)
{
    flood f = {frame, surface, labels, queue, ticker, UINT8_MAX, 0, false};
    int status = start(&f);

    while (status == ROOMSEG_OK && f.level <= UINT8_MAX) {
        status = drain(&f);
        if (status == ROOMSEG_OK && f.lossy && f.level <= UINT8_MAX) {
            bool found;

            status = search(&f, &found);
            f.level += found ? 0u : 1u;
        }
    }
    return status == ROOMSEG_OK ? close_gaps(&f) : status;
}
