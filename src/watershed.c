#include "watershed.h"

/* Lists 0..255: labelled cells whose neighbours are to be reached, by height.
 * Lists 256..511: cells that may found a region, by height. */
#define SUMMITS 256u

/* A set of levels. */
typedef struct level_set {
    uint32_t bits[8];
} level_set;

static void add_level(level_set *set, uint32_t level)
{
    set->bits[level >> 5] |= 1u << (level & 31u);
}

static bool take_level(level_set *set, uint32_t level)
{
    uint32_t bit = 1u << (level & 31u);
    bool has = (set->bits[level >> 5] & bit) != 0u;

    set->bits[level >> 5] &= ~bit;
    return has;
}

typedef struct flood {
    const rs_frame *frame;
    const uint8_t *surface;
    const rs_labels *labels;
    rs_queue *queue;
    rs_ticker *ticker;
    uint32_t max_regions, region_count;
    uint32_t cells, cells_done;
    uint32_t level;   /* that is being flooded */
    uint32_t reserve; /* blocks of the queue that lower levels leave to this one */
    level_set lost;   /* levels with cells that were reached but not queued, see search() */
    level_set missed; /* levels with summits that were not queued, see found_missed() */
} flood;

/* A regional maximum has a cell that is higher than its left and upper neighbours and not
 * lower than the right and lower ones: its first in reading order. */
static bool is_summit(const uint8_t *cell, uint32_t stride)
{
    return *cell > *(cell - 1) && *cell > *(cell - stride) && *cell >= *(cell + 1) &&
           *cell >= *(cell + stride);
}

/* Queues the summits in reading order, until they take half of the queue. */
static int collect_summits(flood *f)
{
    const rs_frame *frame = f->frame;
    uint32_t limit = f->queue->block_count / 2u;

    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *row = f->surface + rs_frame_index(frame, 0, y);

        if (rs_tick(f->ticker, frame->width, y, 4u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            if (row[x] != 0u && is_summit(row + x, frame->stride) &&
                (f->queue->untouched >= limit ||
                 !rs_queue_push(f->queue, SUMMITS + row[x], rs_cell_pack(x, y)))) {
                add_level(&f->missed, row[x]);
            }
        }
    }
    return ROOMSEG_OK;
}

/* Gives a label to a cell, unless that is an obstacle or taken. A cell that finds no room
 * in the queue stays without label, so that search() can tell it from those reached. Lower
 * levels are searched once for all that they lost, but the level in work once a region, so
 * that it is the last to lose. */
static inline void reach(flood *f, uint16_t label, uint32_t x, uint32_t y)
{
    uint32_t height = f->surface[rs_frame_index(f->frame, x, y)];
    uint16_t *slot;

    if (height == 0u) {
        return;
    }
    slot = &f->labels->cells[(size_t)y * f->labels->stride + x];
    if (*slot != 0u) {
        return;
    }
    if ((f->queue->left > f->reserve || height == f->level) &&
        rs_queue_push(f->queue, height, rs_cell_pack(x, y))) {
        *slot = label;
    } else {
        add_level(&f->lost, height);
    }
}

/* Reaches out from a labelled cell. */
static inline int visit(flood *f, uint16_t label, uint32_t x, uint32_t y)
{
    if (rs_tick(f->ticker, 4u, f->cells_done, f->cells)) {
        return ROOMSEG_ERR_CANCELLED;
    }
    f->cells_done++;
    reach(f, label, x, y - 1u);
    reach(f, label, x - 1u, y);
    reach(f, label, x + 1u, y);
    reach(f, label, x, y + 1u);
    return ROOMSEG_OK;
}

/* Empties the list of the level, to which it may itself add. */
static int drain(flood *f)
{
    uint32_t cell;
    int status = ROOMSEG_OK;

    while (status == ROOMSEG_OK && rs_queue_pop(f->queue, f->level, &cell)) {
        uint32_t x = rs_cell_x(cell), y = rs_cell_y(cell);

        status = visit(f, f->labels->cells[(size_t)y * f->labels->stride + x], x, y);
    }
    return status;
}

/* Label of the first neighbour that is labelled and not lower than the level; 0: none. */
static uint16_t label_beside(const flood *f, uint32_t x, uint32_t y)
{
    const uint32_t dx[4] = {0, 0u - 1u, 1, 0}, dy[4] = {0u - 1u, 0, 0, 1};

    for (uint32_t k = 0; k < 4u; k++) {
        uint32_t nx = x + dx[k], ny = y + dy[k]; /* modulo 2^32 */
        if (f->surface[rs_frame_index(f->frame, nx, ny)] >= f->level) {
            uint16_t label = f->labels->cells[(size_t)ny * f->labels->stride + nx];
            if (label != 0u) {
                return label;
            }
        }
    }
    return 0;
}

/* Reads one row for the cells that the level has lost: those beside a labelled cell that is not
 * lower take its label, and the flood goes on from them. */
static int search_row(flood *f, uint32_t y)
{
    const uint8_t *row = f->surface + rs_frame_index(f->frame, 0, y);
    uint16_t *labels = f->labels->cells + (size_t)y * f->labels->stride;
    int status = ROOMSEG_OK;

    for (uint32_t x = 0; status == ROOMSEG_OK && x < f->frame->width; x++) {
        if (row[x] == f->level && labels[x] == 0u) {
            labels[x] = label_beside(f, x, y);
            if (labels[x] != 0u) {
                status = visit(f, labels[x], x, y);
            }
        }
    }
    return status;
}

/* Completes the level if it lost cells, reading the surface again while that loses others of the
 * same level. */
static int search(flood *f)
{
    int status = ROOMSEG_OK;

    while (status == ROOMSEG_OK && take_level(&f->lost, f->level)) {
        for (uint32_t y = 0; status == ROOMSEG_OK && y < f->frame->height; y++) {
            status = rs_tick(f->ticker, f->frame->width, f->cells_done, f->cells)
                         ? ROOMSEG_ERR_CANCELLED
                         : search_row(f, y);
        }
        if (status == ROOMSEG_OK) {
            status = drain(f);
        }
    }
    return status;
}

/* Labels the plateau around a cell that no region has reached. */
static int found_region(flood *f, uint32_t x, uint32_t y)
{
    uint16_t *label = &f->labels->cells[(size_t)y * f->labels->stride + x];
    int status;

    if (*label != 0u) {
        return ROOMSEG_OK;
    }
    f->region_count++;
    if (f->region_count > f->max_regions) {
        return ROOMSEG_ERR_REGIONS;
    }
    *label = (uint16_t)f->region_count;
    status = visit(f, *label, x, y);
    if (status == ROOMSEG_OK) {
        status = drain(f);
    }
    return status == ROOMSEG_OK ? search(f) : status;
}

/* The summits of the level that were not queued: what is still unlabelled, in reading order. */
static int found_missed(flood *f)
{
    int status = ROOMSEG_OK;

    for (uint32_t y = 0; status == ROOMSEG_OK && y < f->frame->height; y++) {
        const uint8_t *row = f->surface + rs_frame_index(f->frame, 0, y);
        const uint16_t *labels = f->labels->cells + (size_t)y * f->labels->stride;

        if (rs_tick(f->ticker, f->frame->width, f->cells_done, f->cells)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; status == ROOMSEG_OK && x < f->frame->width; x++) {
            if (row[x] == f->level && labels[x] == 0u) {
                status = found_region(f, x, y);
            }
        }
    }
    return status;
}

static int flood_level(flood *f)
{
    uint32_t cell;
    int status = drain(f);

    if (status == ROOMSEG_OK) {
        status = search(f);
    }
    while (status == ROOMSEG_OK && rs_queue_pop(f->queue, SUMMITS + f->level, &cell)) {
        status = found_region(f, rs_cell_x(cell), rs_cell_y(cell));
    }
    if (status == ROOMSEG_OK && take_level(&f->missed, f->level)) {
        status = found_missed(f);
    }
    return status;
}

int rs_watershed_run(const rs_frame *frame, const uint8_t *surface, uint32_t max_regions,
                     const rs_labels *labels, uint32_t *region_count, rs_queue *queue,
                     rs_ticker *ticker)
{
    flood f = {frame, surface, labels, queue, ticker, max_regions, 0, 0, 0, 0, 0, {{0}}, {{0}}};
    int status;

    f.cells = frame->width * frame->height;
    f.reserve = queue->block_count / 16u;
    status = collect_summits(&f);
    for (f.level = 255; status == ROOMSEG_OK && f.level > 0u; f.level--) {
        status = flood_level(&f);
    }
    *region_count = f.region_count;
    return status;
}
