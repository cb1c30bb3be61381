/* The pipeline: roomseg_run() is the table of contents, one call a stage. */
#include <string.h>

#include "components.h"
#include "config.h"
#include "distance.h"
#include "graph.h"
#include "merge.h"
#include "plan.h"
#include "rooms.h"
#include "threshold.h"
#include "watershed.h"

RS_STATIC_ASSERT(sizeof(rs_parabola) == 8u, envelope);

/* All buffers of a run, placed in the arena by the plan. */
typedef struct rs_buffers {
    uint8_t *surface;
    rs_component_scratch components;
    rs_parabola *envelope;
    rs_queue_list *queue_lists;
    rs_queue_block *queue_blocks;
    uint32_t queue_block_count;
    rs_graph graph;
    uint32_t max_edges;
    uint32_t *slots;
    rs_heap_item *heap;
    rs_room_records records;
} rs_buffers;

static void place_buffers(const rs_plan *plan, const rs_frame *frame,
                          const roomseg_config *config, void *arena, rs_buffers *b)
{
    uint8_t *base = arena;

    /* All offsets are multiples of 8 and the arena is aligned to 8. */
#define AT(name) ((void *)(base + plan->offset[RS_BUFFER_##name]))
    b->surface = AT(surface);
    b->components.runs = AT(runs);
    b->components.components = AT(components);
    b->components.active = AT(active);
    b->components.vacant = AT(vacant);
    b->components.stack = AT(stack);
    b->envelope = AT(envelope);
    b->queue_lists = AT(queue_lists);
    b->queue_blocks = AT(queue_blocks);
    b->queue_block_count = (uint32_t)ROOMSEG_PLAN_QUEUE_BLOCKS(frame->width, frame->height);
    b->graph.regions = AT(regions);
    b->graph.edges = AT(edges);
    b->graph.region_count = 0;
    b->graph.edge_count = 0;
    b->max_edges = (uint32_t)ROOMSEG_PLAN_EDGES(config->max_regions);
    b->slots = AT(slots);
    b->heap = AT(heap);
    b->records.rooms = AT(rooms);
    b->records.sums = AT(room_sums);
    b->records.doorways = AT(doorways);
    b->records.links = AT(links);
    b->records.max_rooms = config->max_rooms;
    b->records.room_count = 0;
    b->records.doorway_count = 0;
#undef AT
}

/* The config's physical sizes in cells. */
static rs_component_limits component_limits(const roomseg_config *config, uint32_t resolution_mm)
{
    uint32_t cell_mm2 = resolution_mm * resolution_mm;
    rs_component_limits limits;

    limits.speck_cells = (config->speck_mm2 + cell_mm2 - 1u) / cell_mm2;
    limits.clutter_cells = config->clutter_mm / resolution_mm;
    return limits;
}

static rs_merge_rules merge_rules(const roomseg_config *config, uint32_t resolution_mm,
                                  const rs_graph *graph)
{
    uint32_t cell_mm2 = resolution_mm * resolution_mm;
    uint32_t total = 0;
    rs_merge_rules rules;

    for (uint32_t r = 1; r <= graph->region_count; r++) {
        total += graph->regions[r].area;
    }
    rules.smallest_cells = config->smallest_room_mm2 / cell_mm2 +
                           (config->smallest_room_mm2 % cell_mm2 != 0u);
    rules.isolated_cells = rs_max_u32(rules.smallest_cells,
                                      total / 1000u * config->isolated_permille);
    rules.room_opening_percent = config->room_opening_percent;
    rules.passage_opening_percent = config->passage_opening_percent;
    rules.passage_min_neighbours = config->passage_min_neighbours;
    return rules;
}

/* Evaluates a stage unless an earlier one failed or the hook cancels on entering it. */
#define STAGE(name, call)                                              \
    do {                                                               \
        if (status == ROOMSEG_OK) {                                    \
            status = rs_ticker_enter(ticker, ROOMSEG_STAGE_##name)     \
                         ? ROOMSEG_ERR_CANCELLED                       \
                         : (call);                                     \
        }                                                              \
    } while (0)

/* Stages behind the crop, on placed buffers. */
static int run_stages(const roomseg_config *config, const roomseg_grid *grid,
                      const rs_frame *frame, const rs_labels *labels, rs_buffers *b,
                      rs_ticker *ticker)
{
    uint32_t mm = grid->resolution_mm;
    rs_merge_rules rules;
    rs_queue queue;
    int status;

    status = rs_threshold_run(grid, config->free_max, frame, b->surface, ticker);
    STAGE(COMPONENTS, rs_components_clear_small(frame, component_limits(config, mm), b->surface,
                                                &b->components, ticker));
    STAGE(SURFACE, rs_distance_run(frame, b->surface, b->envelope, ticker));
    if (status == ROOMSEG_OK) {
        rs_queue_init(&queue, b->queue_lists, b->queue_blocks, b->queue_block_count);
    }
    STAGE(WATERSHED, rs_watershed_run(frame, b->surface, config->max_regions, labels,
                                      &b->graph.region_count, &queue, ticker));
    STAGE(GRAPH, rs_graph_build(frame, grid, config->occupied_min, b->surface, labels, &b->graph,
                                b->max_edges, b->slots, ticker));
    if (status == ROOMSEG_OK) {
        rules = merge_rules(config, mm, &b->graph);
    }
    STAGE(MERGE, rs_merge_run(&rules, &b->graph, b->heap, ticker));
    STAGE(ROOMS, rs_rooms_number(&b->graph, &b->records, b->heap));
    if (status == ROOMSEG_OK) {
        status = rs_rooms_label(frame, grid, config->occupied_min, &b->graph, labels, &b->records,
                                ticker);
    }
    if (status == ROOMSEG_OK) {
        status = rs_rooms_connect(frame, mm, &b->graph, &b->records, b->heap);
    }
    return status;
}

static void clear_labels(const roomseg_grid *grid, uint16_t *labels, uint32_t stride)
{
    for (uint32_t y = 0; y < grid->height; y++) {
        memset(labels + (size_t)y * stride, 0, grid->width * sizeof *labels);
    }
}

static void fill_result(const rs_frame *frame, const rs_buffers *b, size_t arena_used,
                        roomseg_result *result)
{
    result->rooms = b->records.rooms;
    result->doorways = b->records.doorways;
    result->links = b->records.links;
    result->room_count = b->records.room_count;
    result->doorway_count = b->records.doorway_count;
    result->region_count = b->graph.region_count;
    result->crop_x = (uint16_t)frame->x;
    result->crop_y = (uint16_t)frame->y;
    result->crop_width = (uint16_t)frame->width;
    result->crop_height = (uint16_t)frame->height;
    result->arena_used = arena_used;
}

static bool crop_too_large(uint32_t width, uint32_t height)
{
    return height != 0u && width > ROOMSEG_MAX_CROP_CELLS / height;
}

int roomseg_arena_size(const roomseg_config *config, uint32_t width, uint32_t height,
                       uint32_t resolution_mm, size_t *bytes)
{
    rs_plan plan;
    int status;

    if (bytes == NULL) {
        return ROOMSEG_ERR_NULL;
    }
    *bytes = 0;
    if (config == NULL) {
        return ROOMSEG_ERR_NULL;
    }
    if (width < 1u || width > ROOMSEG_MAX_SIDE || height < 1u || height > ROOMSEG_MAX_SIDE ||
        crop_too_large(width, height)) {
        return ROOMSEG_ERR_GRID_SIZE;
    }
    status = rs_config_check_resolution(resolution_mm);
    if (status == ROOMSEG_OK) {
        status = rs_config_check(config);
    }
    if (status == ROOMSEG_OK) {
        rs_plan_make(config, width, height, resolution_mm, &plan);
        *bytes = plan.size;
    }
    return status;
}

/* Checks what both entry points with a grid take. */
static int check_input(const roomseg_config *config, const roomseg_grid *grid)
{
    int status;

    if (config == NULL || grid == NULL) {
        return ROOMSEG_ERR_NULL;
    }
    status = rs_config_check_grid(grid);
    return status == ROOMSEG_OK ? rs_config_check(config) : status;
}

int roomseg_arena_size_for_grid(const roomseg_config *config, const roomseg_grid *grid,
                                size_t *bytes)
{
    rs_ticker ticker = {0};
    rs_frame frame;
    int status;

    if (bytes == NULL) {
        return ROOMSEG_ERR_NULL;
    }
    *bytes = 0;
    status = check_input(config, grid);
    if (status != ROOMSEG_OK) {
        return status;
    }
    status = rs_threshold_crop(grid, config->free_max, &frame, &ticker);
    if (status != ROOMSEG_OK || frame.width == 0u) {
        return status;
    }
    return roomseg_arena_size(config, frame.width, frame.height, grid->resolution_mm, bytes);
}

/* Everything behind the checks; *result is zeroed already. */
static int run_checked(const roomseg_config *config, const roomseg_grid *grid, uint16_t *labels,
                       uint32_t label_stride, roomseg_result *result, void *arena,
                       size_t arena_size)
{
    rs_ticker ticker = {config->progress, config->progress_user, ROOMSEG_STAGE_THRESHOLD, 0, 0};
    rs_frame frame;
    rs_plan plan;
    rs_buffers buffers;
    rs_labels crop_labels;
    int status;

    status = rs_ticker_enter(&ticker, ROOMSEG_STAGE_THRESHOLD)
                 ? ROOMSEG_ERR_CANCELLED
                 : rs_threshold_crop(grid, config->free_max, &frame, &ticker);
    if (status == ROOMSEG_OK && crop_too_large(frame.width, frame.height)) {
        return ROOMSEG_ERR_GRID_SIZE;
    }
    if (status == ROOMSEG_OK && frame.width > 0u) {
        rs_plan_make(config, frame.width, frame.height, grid->resolution_mm, &plan);
        if (arena == NULL && arena_size > 0u) {
            return ROOMSEG_ERR_NULL;
        }
        if (arena_size < plan.size) {
            result->arena_used = plan.size;
            return ROOMSEG_ERR_ARENA_SIZE;
        }
    }
    clear_labels(grid, labels, label_stride);
    if (status != ROOMSEG_OK || frame.width == 0u) {
        return status;
    }
    place_buffers(&plan, &frame, config, arena, &buffers);
    crop_labels.cells = labels + (size_t)frame.y * label_stride + frame.x;
    crop_labels.stride = label_stride;
    status = run_stages(config, grid, &frame, &crop_labels, &buffers, &ticker);
    if (status == ROOMSEG_OK) {
        fill_result(&frame, &buffers, plan.size, result);
    } else {
        clear_labels(grid, labels, label_stride);
        result->region_count = status == ROOMSEG_ERR_REGIONS ? buffers.graph.region_count : 0u;
    }
    return status;
}

int roomseg_run(const roomseg_config *config, const roomseg_grid *grid, uint16_t *labels,
                uint32_t label_stride, roomseg_result *result, void *arena, size_t arena_size)
{
    int status;

    if (result == NULL) {
        return ROOMSEG_ERR_NULL;
    }
    memset(result, 0, sizeof *result);
    status = check_input(config, grid);
    if (status != ROOMSEG_OK) {
        return status;
    }
    if (labels == NULL || (arena == NULL && arena_size > 0u)) {
        return ROOMSEG_ERR_NULL;
    }
    if (label_stride < grid->width) {
        return ROOMSEG_ERR_STRIDE;
    }
    if ((uintptr_t)arena % ROOMSEG_ARENA_ALIGN != 0u) {
        return ROOMSEG_ERR_ARENA_ALIGN;
    }
    return run_checked(config, grid, labels, label_stride, result, arena, arena_size);
}
