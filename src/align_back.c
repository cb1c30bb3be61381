/* Alignment, third part: the labels on their way back to the caller's frame. */
#include <string.h>

#include "align.h"
#include "spread.h"
#include "watershed_lines.h"

/* memory: ROOMSEG_PLAN_QUEUE_BYTES of a frame. */
static rs_queue make_queue(void *memory, uint32_t width, uint32_t height)
{
    rs_queue queue;

    rs_queue_init(&queue, memory,
                  (rs_queue_block *)(void *)((uint8_t *)memory + ROOMSEG_QUEUE_LISTS_BYTES),
                  (uint32_t)ROOMSEG_PLAN_QUEUE_BLOCKS(width, height));
    return queue;
}

/* What a turned cell without label is. */
typedef enum gap {
    GAP_NONE,    /* no room is near */
    GAP_DROPPED, /* open to a room that the profile did not give it to */
    GAP_LINE     /* between two rooms */
} gap;

/* lines: the profile draws lines, so that rooms are near at corners too. */
static gap find_gap(const rs_frame *frame, const rs_labels *labels, bool lines, uint32_t x,
                    uint32_t y)
{
    uint16_t room = 0;

    for (uint32_t k = 0; k < 9u; k++) {
        uint32_t nx = x + k % 3u - 1u, ny = y + k / 3u - 1u; /* modulo 2^32 */
        uint16_t label;

        if ((!lines && k % 2u == 0u) || nx >= frame->width || ny >= frame->height) {
            continue;
        }
        label = labels->cells[(size_t)ny * labels->stride + nx];
        if (label == 0u || label == RS_SPREAD_DROPPED) {
            continue;
        }
        if (room != 0u && room != label && lines) {
            return GAP_LINE;
        }
        room = label;
    }
    return room != 0u ? GAP_DROPPED : GAP_NONE;
}

/* One row of rs_align_mark_dropped. */
static void mark_row(const rs_frame *frame, const rs_labels *labels, const roomseg_config *config,
                     uint32_t y, uint8_t *row)
{
    uint16_t *to = labels->cells + (size_t)y * labels->stride;

    *(row - 1) = RS_SPREAD_WALL;
    row[frame->width] = RS_SPREAD_WALL;
    for (uint32_t x = 0; x < frame->width; x++) {
        gap what;

        if (row[x] > config->free_max || to[x] != 0u) {
            row[x] = RS_SPREAD_WALL;
            continue;
        }
        what = find_gap(frame, labels, config->profile->lines, x, y);
        row[x] = what == GAP_NONE ? RS_SPREAD_OPEN : RS_SPREAD_WALL;
        if (what == GAP_DROPPED) {
            row[x] = RS_SPREAD_SETTLED;
            to[x] = RS_SPREAD_DROPPED;
        }
    }
}

int rs_align_mark_dropped(const roomseg_config *config, const rs_rotation *rotation,
                          const rs_turn_buffers *b, rs_ticker *ticker)
{
    const rs_frame frame = {0, 0, rotation->width, rotation->height, rotation->width + 2u};
    const rs_labels labels = {b->turned_labels, frame.width};
    uint8_t *surface = b->turned_cells;
    rs_queue queue;

    rs_ticker_part(ticker, 0, 200);
    memset(surface, RS_SPREAD_WALL, frame.stride);
    memset(surface + (size_t)(frame.height + 1u) * frame.stride, RS_SPREAD_WALL, frame.stride);
    for (uint32_t y = 0; y < frame.height; y++) {
        if (rs_tick(ticker, frame.width, y, frame.height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        mark_row(&frame, &labels, config, y, surface + rs_frame_index(&frame, 0, y));
    }
    queue = make_queue(b->turned_queue, frame.width, frame.height);
    return rs_spread_run(&frame, surface, &labels, &queue, ticker);
}

/* Settles one cell of each room - its anchor, or else the room's first cell, if it has any -
 * and all dropped ones. */
static int settle_anchors(const rs_frame *frame, const rs_labels *labels, uint32_t *anchors,
                          uint32_t count, uint8_t *surface, rs_ticker *ticker)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t x = rs_cell_x(anchors[i]), y = rs_cell_y(anchors[i]);

        if (anchors[i] != RS_ALIGN_LOST &&
            labels->cells[(size_t)y * labels->stride + x] == i + 1u) {
            surface[rs_frame_index(frame, x, y)] = RS_SPREAD_SETTLED;
        } else {
            anchors[i] = RS_ALIGN_LOST;
        }
    }
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            uint16_t label = row[x];
            if (label == RS_SPREAD_DROPPED) {
                surface[rs_frame_index(frame, x, y)] = RS_SPREAD_SETTLED;
            } else if (label != 0u && anchors[label - 1u] == RS_ALIGN_LOST) {
                anchors[label - 1u] = rs_cell_pack(x, y);
                surface[rs_frame_index(frame, x, y)] = RS_SPREAD_SETTLED;
            }
        }
    }
    return ROOMSEG_OK;
}

static int clear_dropped(const rs_frame *frame, const rs_labels *labels, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            row[x] = row[x] == RS_SPREAD_DROPPED ? (uint16_t)0 : row[x];
        }
    }
    return ROOMSEG_OK;
}

/* Lines one cell wide where rooms touch, be it at corners: on the side of the larger room,
 * which has the smaller label. */
static int draw_lines(const rs_frame *frame, const rs_labels *labels, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            uint16_t label = row[x];

            for (uint32_t k = 0; k < 9u && label != 0u && row[x] != RS_LINE; k++) {
                uint32_t nx = x + k % 3u - 1u, ny = y + k / 3u - 1u; /* modulo 2^32 */
                uint16_t other = nx < frame->width && ny < frame->height
                                     ? labels->cells[(size_t)ny * labels->stride + nx]
                                     : (uint16_t)0;
                if (other > label && other != RS_LINE) {
                    row[x] = RS_LINE;
                }
            }
        }
    }
    return ROOMSEG_OK;
}

int rs_align_carry_labels(const roomseg_config *config, const roomseg_grid *grid,
                          const rs_rotation *rotation, const rs_turn_buffers *b,
                          uint32_t room_count, const rs_labels *labels, rs_ticker *ticker)
{
    const rs_frame *frame = rotation->crop;
    rs_component_limits limits = rs_components_limits(config, grid->resolution_mm);
    rs_queue queue;
    int status;

    limits.diagonal = true; /* a thin wall that lies askew is single cells for a 4-connected eye */
    status = rs_align_mask(config, grid, frame, limits, b->surface, b->small_scratch, ticker);
    if (status == ROOMSEG_OK) {
        status = rs_rotate_labels_back(rotation, b->turned_labels, b->surface, labels, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = settle_anchors(frame, labels, b->anchors, room_count, b->surface, ticker);
    }
    if (status == ROOMSEG_OK) {
        queue = make_queue(b->queue, frame->width, frame->height);
        status = rs_spread_run(frame, b->surface, labels, &queue, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = clear_dropped(frame, labels, ticker);
    }
    if (status == ROOMSEG_OK && config->profile->lines) {
        status = draw_lines(frame, labels, ticker);
    }
    return status;
}
