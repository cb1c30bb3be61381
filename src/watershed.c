#include "watershed.h"

/* Lists 0..255: labelled cells whose neighbours are to be reached, by height.
 * Lists 256..511: cells that may found a region, by height. */
#define SUMMITS 256u

typedef struct flood {
    const rs_frame *frame;
    const uint8_t *surface;
    const rs_labels *labels;
    rs_queue *queue;
    rs_ticker *ticker;
    uint32_t max_regions, region_count;
    uint32_t cells_done;
    bool lossy; /* the queue refused a cell: from now on levels are searched, see search() */
} flood;

/* A regional maximum has a cell that is higher than its left and upper neighbours and not
 * lower than the right and lower ones: its first in reading order. */
static bool is_summit(const uint8_t *cell, uint32_t stride)
{
    return *cell > *(cell - 1) && *cell > *(cell - stride) && *cell >= *(cell + 1) &&
           *cell >= *(cell + stride);
}

static bool push(flood *f, uint32_t list, uint32_t x, uint32_t y)
{
    bool pushed = rs_queue_push(f->queue, list, rs_cell_pack(x, y));

    f->lossy = f->lossy || !pushed;
    return pushed;
}

static int collect_summits(flood *f)
{
    const rs_frame *frame = f->frame;

    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *row = f->surface + rs_frame_index(frame, 0, y);

        if (rs_tick(f->ticker, frame->width, y, 4u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            if (row[x] != 0u && is_summit(row + x, frame->stride)) {
                push(f, SUMMITS + row[x], x, y);
            }
        }
    }
    return ROOMSEG_OK;
}

/* Gives a label to a cell, unless that is an obstacle or taken. A cell that finds no room
 * in the queue stays without label, so that search() can tell it from those reached. */
static inline void reach(flood *f, uint16_t label, uint32_t x, uint32_t y)
{
    uint32_t height = f->surface[rs_frame_index(f->frame, x, y)];
    uint16_t *slot;

    if (height == 0u) {
        return;
    }
    slot = &f->labels->cells[(size_t)y * f->labels->stride + x];
    if (*slot == 0u && push(f, height, x, y)) {
        *slot = label;
    }
}

/* Empties the list of one level, to which it may itself add. */
static int drain(flood *f, uint32_t level)
{
    uint32_t cell;

    while (rs_queue_pop(f->queue, level, &cell)) {
        uint32_t x = rs_cell_x(cell), y = rs_cell_y(cell);
        uint16_t label = f->labels->cells[(size_t)y * f->labels->stride + x];

        if (rs_tick(f->ticker, 4u, f->cells_done / f->frame->width, f->frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        f->cells_done++;
        reach(f, label, x, y - 1u);
        reach(f, label, x - 1u, y);
        reach(f, label, x + 1u, y);
        reach(f, label, x, y + 1u);
    }
    return ROOMSEG_OK;
}

static int found_region(flood *f, uint32_t level, uint32_t x, uint32_t y)
{
    uint16_t *label = &f->labels->cells[(size_t)y * f->labels->stride + x];

    if (*label != 0u) {
        return ROOMSEG_OK;
    }
    f->region_count++;
    if (f->region_count > f->max_regions) {
        return ROOMSEG_ERR_REGIONS;
    }
    *label = (uint16_t)f->region_count;
    push(f, level, x, y);
    return drain(f, level);
}

/* Label of the first neighbour that is labelled and not lower; 0: there is none. */
static uint16_t label_beside(const flood *f, uint32_t level, uint32_t x, uint32_t y)
{
    const uint32_t dx[4] = {0, 0u - 1u, 1, 0}, dy[4] = {0u - 1u, 0, 0, 1};

    for (uint32_t k = 0; k < 4u; k++) {
        uint32_t nx = x + dx[k], ny = y + dy[k]; /* modulo 2^32 */
        if (f->surface[rs_frame_index(f->frame, nx, ny)] >= level) {
            uint16_t label = f->labels->cells[(size_t)ny * f->labels->stride + nx];
            if (label != 0u) {
                return label;
            }
        }
    }
    return 0;
}

/* One reading of the whole surface for cells of this level that the queue lost: those
 * beside a labelled cell take its label. *spare: an unlabelled cell that remains. */
static int search_once(flood *f, uint32_t level, uint32_t *found, uint32_t *spare)
{
    for (uint32_t y = 0; y < f->frame->height; y++) {
        const uint8_t *row = f->surface + rs_frame_index(f->frame, 0, y);
        uint16_t *labels = f->labels->cells + (size_t)y * f->labels->stride;

        if (rs_tick(f->ticker, f->frame->width, f->cells_done / f->frame->width,
                    f->frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < f->frame->width; x++) {
            if (row[x] == level && labels[x] == 0u) {
                labels[x] = label_beside(f, level, x, y);
                *found += labels[x] != 0u;
                *spare = labels[x] == 0u ? rs_cell_pack(x, y) : *spare;
            }
        }
    }
    return ROOMSEG_OK;
}

/* Completes one level after the queue was full. Whatever the search labels is not queued:
 * its lower neighbours are searched for in their turn. */
static int search(flood *f, uint32_t level)
{
    int status = ROOMSEG_OK;

    while (status == ROOMSEG_OK) {
        uint32_t found = 0, spare = RS_QUEUE_NONE;

        status = search_once(f, level, &found, &spare);
        if (status == ROOMSEG_OK && found == 0u) {
            if (spare == RS_QUEUE_NONE) {
                break;
            }
            status = found_region(f, level, rs_cell_x(spare), rs_cell_y(spare));
        }
    }
    return status;
}

int rs_watershed_run(const rs_frame *frame, const uint8_t *surface, uint32_t max_regions,
                     const rs_labels *labels, uint32_t *region_count, rs_queue *queue,
                     rs_ticker *ticker)
{
    flood f = {frame, surface, labels, queue, ticker, max_regions, 0, 0, false};
    int status = collect_summits(&f);

    for (uint32_t level = 255; status == ROOMSEG_OK && level > 0u; level--) {
        uint32_t cell;

        status = drain(&f, level);
        if (status == ROOMSEG_OK && f.lossy) {
            status = search(&f, level);
        }
        while (status == ROOMSEG_OK && rs_queue_pop(queue, SUMMITS + level, &cell)) {
            status = found_region(&f, level, rs_cell_x(cell), rs_cell_y(cell));
            if (status == ROOMSEG_OK && f.lossy) {
                status = search(&f, level);
            }
        }
    }
    *region_count = f.region_count;
    return status;
}
