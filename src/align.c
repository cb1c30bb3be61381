/* Alignment, second half: the profile on the turned grid, and the way back. */
#include "align.h"

#include <string.h>

#include "rotate.h"
#include "spread.h"

/* memory: ROOMSEG_PLAN_QUEUE_BYTES of a frame. */
static rs_queue make_queue(void *memory, uint32_t width, uint32_t height)
{
    rs_queue queue;

    rs_queue_init(&queue, memory,
                  (rs_queue_block *)(void *)((uint8_t *)memory + ROOMSEG_QUEUE_LISTS_BYTES),
                  (uint32_t)ROOMSEG_PLAN_QUEUE_BLOCKS(width, height));
    return queue;
}

static int run_profile(const roomseg_config *config, const roomseg_grid *grid,
                       const rs_frame *frame, const rs_labels *labels, roomseg_result *result,
                       void *arena, rs_ticker *ticker)
{
    rs_plan plan;

    config->profile->plan(config, frame->width, frame->height, grid->resolution_mm, &plan);
    return config->profile->run(config, grid, frame, &plan, labels, result, arena, ticker);
}

/* The profile on the turned grid. Its labels end in the arena, and of its rooms one cell
 * each, turned back: anchors, ROOM_LOST where that lies outside of the crop. */
#define ROOM_LOST UINT32_MAX

static int run_inner(const roomseg_config *config, const roomseg_grid *grid,
                     const rs_rotation *rotation, const rs_turn_buffers *b,
                     roomseg_result *result, rs_ticker *ticker)
{
    const rs_frame frame = {0, 0, rotation->width, rotation->height, rotation->width + 2u};
    uint32_t *anchors = b->anchors;
    uint8_t *cells = b->turned_cells;
    const rs_labels labels = {b->turned_labels, frame.width};
    const roomseg_grid turned = {cells + rs_frame_index(&frame, 0, 0), frame.width, frame.height,
                                 frame.stride, grid->resolution_mm};
    int status;

    /* What comes from outside of the grid is an obstacle, but not a certain one. */
    status = rs_rotate_grid(rotation, grid, config->free_max, (uint8_t)(config->free_max + 1u),
                            cells + rs_frame_index(&frame, 0, 0), frame.stride, ticker);
    if (status == ROOMSEG_OK) {
        memset(labels.cells, 0, (size_t)frame.width * frame.height * sizeof *labels.cells);
        status = run_profile(config, &turned, &frame, &labels, result,
                             b->turned_arena, ticker);
    }
    for (uint32_t i = 0; status == ROOMSEG_OK && i < result->room_count; i++) {
        uint32_t x, y;
        bool inside = rs_rotate_cell_back(rotation, result->rooms[i].interior_x,
                                          result->rooms[i].interior_y, &x, &y);
        anchors[i] = inside ? rs_cell_pack(x, y) : ROOM_LOST;
    }
    return status;
}

/* Whether turned cell (x, y) is next to a cell of a room. */
static bool touches_room(const rs_frame *frame, const rs_labels *labels, uint32_t x, uint32_t y)
{
    const uint16_t *cell = labels->cells + (size_t)y * labels->stride + x;
    const uint16_t none = RS_SPREAD_DROPPED;

    return (x > 0u && cell[-1] != 0u && cell[-1] != none) ||
           (x + 1u < frame->width && cell[1] != 0u && cell[1] != none) ||
           (y > 0u && *(cell - labels->stride) != 0u && *(cell - labels->stride) != none) ||
           (y + 1u < frame->height && cell[labels->stride] != 0u && cell[labels->stride] != none);
}

/* Free space that the profile dropped although it is open to a room gets a label of its own,
 * so that it is not taken for what was lost in turning. Turned cells become a surface. */
static int mark_dropped(const rs_rotation *rotation, uint8_t free_max, const rs_turn_buffers *b,
                        rs_ticker *ticker)
{
    const rs_frame frame = {0, 0, rotation->width, rotation->height, rotation->width + 2u};
    const rs_labels labels = {b->turned_labels, frame.width};
    uint8_t *surface = b->turned_cells;
    rs_queue queue;

    memset(surface, RS_SPREAD_WALL, frame.stride);
    for (uint32_t y = 0; y < frame.height; y++) {
        uint8_t *row = surface + rs_frame_index(&frame, 0, y);
        uint16_t *to = labels.cells + (size_t)y * labels.stride;

        if (rs_tick(ticker, frame.width, y, frame.height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        *(row - 1) = RS_SPREAD_WALL;
        row[frame.width] = RS_SPREAD_WALL;
        for (uint32_t x = 0; x < frame.width; x++) {
            bool open = row[x] <= free_max && to[x] == 0u;
            row[x] = open ? RS_SPREAD_OPEN : RS_SPREAD_WALL;
            if (open && touches_room(&frame, &labels, x, y)) {
                row[x] = RS_SPREAD_SETTLED;
                to[x] = RS_SPREAD_DROPPED;
            }
        }
    }
    memset(surface + rs_frame_index(&frame, 0, frame.height) - 1, RS_SPREAD_WALL, frame.stride);
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

        if (anchors[i] != ROOM_LOST && labels->cells[(size_t)y * labels->stride + x] == i + 1u) {
            surface[rs_frame_index(frame, x, y)] = RS_SPREAD_SETTLED;
        } else {
            anchors[i] = ROOM_LOST;
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
            } else if (label != 0u && anchors[label - 1u] == ROOM_LOST) {
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

/* Labels of the crop from those of the turned frame. */
static int carry_labels(const roomseg_config *config, const roomseg_grid *grid,
                        const rs_rotation *rotation, const rs_turn_buffers *b,
                        uint32_t room_count, const rs_labels *labels, rs_ticker *ticker)
{
    const rs_frame *frame = rotation->crop;
    rs_queue queue;
    int status;

    status = rs_align_mask(config, grid, frame, rs_components_limits(config, grid->resolution_mm),
                           b->surface, b->small_scratch, ticker);
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
    return status;
}

/* Rooms and doorways from the labels of the crop, as the default profile measures them. */
static int measure(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                   const rs_turn_buffers *b, const rs_labels *labels,
                   roomseg_result *result, rs_ticker *ticker)
{
    rs_graph graph = {b->regions, b->edges, result->room_count, 0};
    rs_room_records records = {b->rooms, b->room_sums,      b->doorways, b->links,
                               config->max_rooms, 0, 0};
    int status;

    status = rs_distance_run(frame, grid->resolution_mm, b->surface, &b->distance, ticker);
    if (status == ROOMSEG_OK) {
        status = rs_graph_build(frame, grid, config->occupied_min, b->surface, labels, &graph,
                                (uint32_t)ROOMSEG_PLAN_EDGES(config->max_rooms),
                                &b->graph_scratch, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = rs_rooms_number(&graph, &records, b->heap);
    }
    if (status == ROOMSEG_OK) {
        status = rs_rooms_label(frame, grid, config->occupied_min, &graph, labels, &records,
                                ticker);
    }
    if (status == ROOMSEG_OK) {
        status = rs_rooms_connect(frame, grid->resolution_mm, &graph, &records, b->heap);
    }
    result->rooms = records.rooms;
    result->doorways = records.doorways;
    result->links = records.links;
    result->room_count = records.room_count;
    result->doorway_count = records.doorway_count;
    return status;
}

static int run_turned(const roomseg_config *config, const roomseg_grid *grid,
                      const rs_frame *frame, int32_t angle, const rs_labels *labels,
                      roomseg_result *result, void *arena, rs_ticker *ticker)
{
    rs_rotation rotation;
    rs_turn_buffers b;
    int status;

    rs_align_place_turn(config, frame, grid->resolution_mm, arena, &b);
    status = rs_rotate_init(frame, grid, config->free_max, angle, &rotation, ticker);
    if (status == ROOMSEG_OK) {
        status = run_inner(config, grid, &rotation, &b, result, ticker);
    }
    STAGE(TURN_BACK, mark_dropped(&rotation, config->free_max, &b, ticker));
    if (status == ROOMSEG_OK) {
        status = carry_labels(config, grid, &rotation, &b, result->room_count,
                              labels, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = measure(config, grid, frame, &b, labels, result, ticker);
    }
    return status;
}

static int run(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
               const rs_labels *labels, roomseg_result *result, void *arena, rs_ticker *ticker)
{
    int status = ROOMSEG_OK;
    int32_t angle = 0;

    STAGE(ALIGN, rs_align_find(config, grid, frame, arena, &angle, ticker));
    if (status != ROOMSEG_OK) {
        return status;
    }
    result->wall_angle = angle;
    if (angle >= RS_ALIGN_LEAST || angle <= -RS_ALIGN_LEAST) {
        return run_turned(config, grid, frame, angle, labels, result, arena, ticker);
    }
    return run_profile(config, grid, frame, labels, result, arena, ticker);
}

const roomseg_aligner roomseg_aligner_on = {rs_align_plan, run};
