/* Alignment, second part: the profile on the turned grid, and the records. */
#include "align.h"

#include <string.h>

static int run_profile(const roomseg_config *config, const roomseg_grid *grid,
                       const rs_frame *frame, const rs_labels *labels, roomseg_result *result,
                       void *arena, rs_ticker *ticker)
{
    rs_plan plan;

    config->profile->plan(config, frame->width, frame->height, grid->resolution_mm, &plan);
    return config->profile->run(config, grid, frame, &plan, labels, result, arena, ticker);
}

rs_mixture rs_align_mixture(const roomseg_config *config)
{
    /* What comes from outside of the grid is an obstacle, but not a certain one. */
    rs_mixture mixture = {config->free_max, 0, (uint8_t)(config->free_max + 1u)};

    if (config->profile->halves_unknown) {
        mixture.whole_min = config->occupied_min;
    }
    return mixture;
}

/* The profile on the turned grid. Its labels end in the arena, and of its rooms one cell
 * each, turned back, in b->anchors. */
static int run_inner(const roomseg_config *config, const roomseg_grid *grid,
                     const rs_rotation *rotation, const rs_turn_buffers *b,
                     roomseg_result *result, rs_ticker *ticker)
{
    const rs_frame frame = {0, 0, rotation->width, rotation->height, rotation->width + 2u};
    uint8_t *cells = b->turned_cells;
    const rs_labels labels = {b->turned_labels, frame.width};
    const roomseg_grid turned = {cells + rs_frame_index(&frame, 0, 0), frame.width, frame.height,
                                 frame.stride, grid->resolution_mm};
    int status;

    status = rs_rotate_grid(rotation, grid, rs_align_mixture(config),
                            cells + rs_frame_index(&frame, 0, 0), frame.stride, ticker);
    if (status == ROOMSEG_OK) {
        rs_ticker_part(ticker, 1000, 1000); /* the profile's first steps are in no stage yet */
        memset(labels.cells, 0, (size_t)frame.width * frame.height * sizeof *labels.cells);
        status = run_profile(config, &turned, &frame, &labels, result, b->turned_arena, ticker);
    }
    for (uint32_t i = 0; status == ROOMSEG_OK && i < result->room_count; i++) {
        uint32_t x, y;
        bool inside = rs_rotate_cell_back(rotation, result->rooms[i].interior_x,
                                          result->rooms[i].interior_y, &x, &y);
        b->anchors[i] = inside ? rs_cell_pack(x, y) : RS_ALIGN_LOST;
    }
    return status;
}

/* Rooms and doorways from the labels of the crop. */
static int measure(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                   const rs_turn_buffers *b, const rs_labels *labels, roomseg_result *result,
                   rs_ticker *ticker)
{
    rs_graph graph = {b->regions, b->edges, NULL, result->room_count, 0, 0};
    rs_room_records records = {b->rooms, b->room_sums,      b->doorways, b->links,
                               config->max_rooms, 0, 0};
    int status;

    status = rs_distance_run(frame, grid->resolution_mm, b->surface, &b->distance, ticker);
    if (status == ROOMSEG_OK) {
        status = config->profile->measure(config, grid, frame, b->surface, labels, &graph,
                                          b->measure_rows, ticker);
    }
    if (status == ROOMSEG_OK) {
        status = rs_rooms_run(frame, grid, config->occupied_min, labels, &graph, &records,
                              b->heap, ticker);
    }
    rs_rooms_report(&records, result);
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
    rs_ticker_part(ticker, 900, 1000);
    status = rs_rotate_init(frame, grid, config->free_max, angle, &rotation, ticker);
    if (status == ROOMSEG_OK) {
        status = run_inner(config, grid, &rotation, &b, result, ticker);
    }
    STAGE(TURN_BACK, rs_align_mark_dropped(config, &rotation, &b, ticker));
    rs_ticker_part(ticker, 200, 600);
    if (status == ROOMSEG_OK) {
        status = rs_align_carry_labels(config, grid, &rotation, &b, result->room_count, labels,
                                       ticker);
    }
    rs_ticker_part(ticker, 600, 1000);
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
