/* The default profile: distance map, one region a peak, merging by the width of openings.
 * run_stages() is its table of contents, one call a stage. */
#include <string.h>

#include "components.h"
#include "distance.h"
#include "drop.h"
#include "graph.h"
#include "merge.h"
#include "plan.h"
#include "profile.h"
#include "rooms.h"
#include "shape.h"
#include "threshold.h"
#include "watershed.h"

/* All buffers of a run, placed in the arena by the plan. */
typedef struct rs_buffers {
    uint8_t *surface;
    rs_component_scratch components;
    rs_distance_scratch distance;
    rs_ring ring;
    rs_graph graph;
    uint32_t max_edges;
    rs_column *columns;
    rs_shape *shapes;
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
    b->distance.envelope = AT(envelope);
    b->distance.least = AT(levels);
    b->ring.cells = AT(ring);
    b->ring.capacity = (uint32_t)ROOMSEG_PLAN_RING(frame->width, frame->height);
    b->ring.first = 0;
    b->ring.count = 0;
    b->graph.regions = AT(regions);
    b->graph.edges = AT(edges);
    b->graph.shapes = NULL;
    b->graph.region_count = 0;
    b->graph.edge_count = 0;
    b->max_edges = (uint32_t)ROOMSEG_PLAN_EDGES(config->max_regions);
    b->columns = AT(columns);
    b->shapes = AT(shapes);
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

/* Shared wall up to this length is a trick of the raster: a corner, a door frame ... */
#define NO_WALL_MM 60u
/* ... or, along a corridor that lies askew, the teeth of its walls. */
#define TEETH_MM 200u
/* A door hangs in a wall of at least this length, both sides together. */
#define STUB_MM 300u

static rs_join_rules join_rules(const roomseg_config *config, uint32_t resolution_mm)
{
    rs_join_rules rules;

    rules.smallest_cells = rs_cells_of_area(config->smallest_room_mm2, resolution_mm);
    rules.niche_cells = rs_cells_of_area(config->niche_mm2, resolution_mm);
    rules.room_opening_percent = config->room_opening_percent;
    rules.passage_opening_percent = config->passage_opening_percent;
    rules.shared_wall_cells =
        rs_min_u32(config->shared_wall_mm / resolution_mm, RS_GRAPH_LONGEST_WALL);
    rules.passage_min_neighbours = config->passage_min_neighbours;
    rules.lived_in = false; /* only the graph tells */
    rules.open_plan_percent = config->open_plan_percent;
    rules.no_wall_cells = NO_WALL_MM / resolution_mm;
    rules.teeth_cells = TEETH_MM / resolution_mm;
    rules.stub_cells = rs_max_u32(1u, STUB_MM / resolution_mm);
    rules.door_cells = config->door_mm / resolution_mm;
    rules.hall_cells = config->hall_mm / resolution_mm;
    rules.unwalled_permille = config->unwalled_percent * 10u;
    rules.map_border = (rs_map_border){0, 0}; /* only the graph tells */
    return rules;
}

/* share/1000 of a number of cells, rounded down, without a product above 32 bits. */
static uint32_t permille_of(uint32_t cells, uint32_t share)
{
    return cells / 1000u * share + cells % 1000u * share / 1000u;
}

static uint32_t total_area(const rs_graph *graph)
{
    uint32_t total = 0;

    for (uint32_t r = 1; r <= graph->region_count; r++) {
        total += graph->regions[r].area;
    }
    return total;
}

/* Noise and clutter become free; free islands that could only be dropped in the end go at once,
 * so that noise does not take regions: those smaller than a room, as far as the scratch for
 * obstacles suffices. */
static int clear_small(const roomseg_config *config, const rs_frame *frame, uint32_t resolution_mm,
                       uint32_t smallest_cells, rs_buffers *b, rs_ticker *ticker)
{
    uint32_t small = (uint32_t)ROOMSEG_PLAN_SMALL(config->speck_mm2, config->clutter_mm,
                                                  resolution_mm);
    uint32_t islands = rs_min_u32(smallest_cells, small);
    int status;

    rs_ticker_part(ticker, 0, 500);
    status = rs_components_clear_small(frame, rs_components_limits(config, resolution_mm),
                                       b->surface, &b->components, ticker);
    rs_ticker_part(ticker, 500, 1000);
    return status == ROOMSEG_OK && islands > 1u
               ? rs_components_drop_islands(frame, islands, b->surface, &b->components, ticker)
               : status;
}

/* Regions become rooms; where people live, their shapes tell halls. */
static int merge(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                 const rs_labels *labels, rs_buffers *b, rs_ticker *ticker)
{
    rs_join_rules rules = join_rules(config, grid->resolution_mm);
    uint32_t floor = total_area(&b->graph);
    int status = ROOMSEG_OK;

    rules.lived_in = b->graph.clutter > permille_of(floor, config->lived_in_permille);
    rules.map_border = rs_walls_of_map(&b->graph);
    if (rules.lived_in) {
        b->graph.shapes = b->shapes;
        rs_ticker_part(ticker, 0, 500);
        status = rs_shape_measure(frame, grid, config->occupied_min, labels, &b->graph, ticker);
        rs_ticker_part(ticker, 500, 1000);
    }
    if (status == ROOMSEG_OK) {
        status = rs_merge_run(&rules, &b->graph, b->heap, ticker);
    }
    if (status == ROOMSEG_OK) {
        uint32_t isolated = permille_of(floor, config->isolated_permille);
        rs_drop_run(rs_max_u32(rules.smallest_cells, isolated), config->unwalled_percent,
                    &b->graph);
    }
    return status;
}

/* Stages behind the crop, on placed buffers. */
static int run_stages(const roomseg_config *config, const roomseg_grid *grid,
                      const rs_frame *frame, const rs_labels *labels, rs_buffers *b,
                      rs_ticker *ticker)
{
    uint32_t mm = grid->resolution_mm;
    uint32_t smallest_cells = rs_cells_of_area(config->smallest_room_mm2, mm);
    int status;

    status = rs_threshold_run(grid, config->free_max, frame, b->surface, ticker);
    STAGE(COMPONENTS, clear_small(config, frame, mm, smallest_cells, b, ticker));
    STAGE(SURFACE, rs_distance_run(frame, mm, b->surface, &b->distance, ticker));
    STAGE(WATERSHED, rs_watershed_run(frame, b->surface, config->max_regions, labels,
                                      &b->graph.region_count, &b->ring, ticker));
    STAGE(GRAPH, rs_graph_build(frame, grid, config->occupied_min, b->surface, labels, &b->graph,
                                b->max_edges, b->columns, ticker));
    STAGE(MERGE, merge(config, grid, frame, labels, b, ticker));
    STAGE(ROOMS, rs_rooms_run(frame, grid, config->occupied_min, labels, &b->graph, &b->records,
                              b->heap, ticker));
    return status;
}

static int run(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
               const rs_plan *plan, const rs_labels *labels, roomseg_result *result, void *arena,
               rs_ticker *ticker)
{
    rs_buffers buffers;
    int status;

    place_buffers(plan, frame, config, arena, &buffers);
    status = run_stages(config, grid, frame, labels, &buffers, ticker);
    rs_rooms_report(&buffers.records, result);
    result->region_count = buffers.graph.region_count;
    return status;
}

static int measure(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                   const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                   void *rows, rs_ticker *ticker)
{
    return rs_graph_build(frame, grid, config->occupied_min, surface, labels, graph,
                          (uint32_t)ROOMSEG_PLAN_EDGES(config->max_rooms), rows, ticker);
}

const roomseg_profile roomseg_profile_default = {rs_plan_default, run, false, false, measure};
