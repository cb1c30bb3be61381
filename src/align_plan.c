/* The aligner's part of the memory plan. */
#include "align.h"

#include "components.h"

#define FIND_NAME(S, name, element, count, first, last) FIND_##name,
enum find_buffer { ROOMSEG_PLAN_FIND_TABLE(FIND_NAME, , 0, 0, 0) FIND_COUNT };
#undef FIND_NAME
#define TURN_NAME(S, name, element, count, first, last) TURN_##name,
enum turn_buffer { ROOMSEG_PLAN_TURN_TABLE(TURN_NAME, , 0, 0, 0, 0, 0, 0, 0) TURN_COUNT };
#undef TURN_NAME

RS_STATIC_ASSERT((int)FIND_COUNT <= (int)RS_PLAN_MAX_BUFFERS, find_buffers);
RS_STATIC_ASSERT((int)TURN_COUNT <= (int)RS_PLAN_MAX_BUFFERS, turn_buffers);

#define ROW(S, name, element, count, first, last) {(element) * (count), first, last},
#define AT(buffer) ((void *)((uint8_t *)arena + plan.offset[buffer]))

static size_t small_cells(const roomseg_config *config, uint32_t resolution_mm)
{
    return ROOMSEG_PLAN_SMALL(config->speck_mm2, config->clutter_mm, resolution_mm);
}

static void plan_find(const roomseg_config *config, uint32_t width, uint32_t height,
                      uint32_t resolution_mm, rs_plan *plan)
{
    size_t small = small_cells(config, resolution_mm);
    const rs_plan_row rows[FIND_COUNT] = {ROOMSEG_PLAN_FIND_TABLE(ROW, , width, height, small)};

    rs_plan_place(rows, FIND_COUNT, plan);
}

static void plan_turn(const roomseg_config *config, uint32_t width, uint32_t height,
                      uint32_t resolution_mm, rs_plan *plan)
{
    uint32_t wide = (uint32_t)ROOMSEG_PLAN_TURNED_WIDTH(width, height);
    uint32_t high = (uint32_t)ROOMSEG_PLAN_TURNED_HEIGHT(width, height);
    size_t small = small_cells(config, resolution_mm);

    config->profile->plan(config, wide, high, resolution_mm, plan); /* for its size alone */
    {
        const rs_plan_row rows[TURN_COUNT] = {ROOMSEG_PLAN_TURN_TABLE(
            ROW, , width, height, wide, high, small, config->max_rooms, plan->size)};

        rs_plan_place(rows, TURN_COUNT, plan);
    }
}

int rs_align_plan(const roomseg_config *config, uint32_t width, uint32_t height,
                  uint32_t resolution_mm, size_t *bytes)
{
    uint32_t wide = (uint32_t)ROOMSEG_PLAN_TURNED_WIDTH(width, height);
    uint32_t high = (uint32_t)ROOMSEG_PLAN_TURNED_HEIGHT(width, height);
    rs_plan plan;

    if (wide > ROOMSEG_MAX_SIDE || wide > ROOMSEG_MAX_CROP_CELLS / high) {
        return ROOMSEG_ERR_GRID_SIZE;
    }
    plan_find(config, width, height, resolution_mm, &plan);
    *bytes = plan.size;
    plan_turn(config, width, height, resolution_mm, &plan);
    *bytes = ROOMSEG_PLAN_MAX(*bytes, plan.size);
    return ROOMSEG_OK;
}

void rs_align_place_find(const roomseg_config *config, const rs_frame *frame,
                         uint32_t resolution_mm, void *arena, rs_find_buffers *b)
{
    rs_plan plan;

    plan_find(config, frame->width, frame->height, resolution_mm, &plan);
    b->mask = AT(FIND_mask);
    b->points = AT(FIND_points);
    b->small_scratch = AT(FIND_small_scratch);
    b->rows = AT(FIND_rows);
    b->votes = AT(FIND_votes);
    b->normals = AT(FIND_normals);
    b->bins = AT(FIND_bins);
}

void rs_align_place_turn(const roomseg_config *config, const rs_frame *frame,
                         uint32_t resolution_mm, void *arena, rs_turn_buffers *b)
{
    rs_plan plan;

    plan_turn(config, frame->width, frame->height, resolution_mm, &plan);
    b->turned_labels = AT(TURN_turned_labels);
    b->anchors = AT(TURN_anchors);
    b->turned_cells = AT(TURN_turned_cells);
    b->turned_arena = AT(TURN_turned_arena);
    b->turned_queue = AT(TURN_turned_queue);
    b->surface = AT(TURN_surface);
    b->small_scratch = AT(TURN_small_scratch);
    b->queue = AT(TURN_queue);
    b->distance.envelope = AT(TURN_envelope);
    b->distance.least = AT(TURN_levels);
    b->regions = AT(TURN_regions);
    b->edges = AT(TURN_edges);
    b->measure_rows = AT(TURN_measure_rows);
    b->heap = AT(TURN_heap);
    b->rooms = AT(TURN_rooms);
    b->room_sums = AT(TURN_room_sums);
    b->doorways = AT(TURN_doorways);
    b->links = AT(TURN_links);
}
