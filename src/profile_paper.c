/* The paper profile: the system of Sharif, Mohan, Suvarna, "2D Floor Plan Segmentation Based
 * on Down-sampling", 2023. run_stages() is its table of contents, one call a stage. */
#include <string.h>

#include "components.h"
#include "distance.h"
#include "graph_lines.h"
#include "lifetime.h"
#include "merge_paper.h"
#include "morphology.h"
#include "plan_paper.h"
#include "profile.h"
#include "profile_paper.h"
#include "ridge.h"
#include "rooms.h"
#include "seeds.h"
#include "threshold.h"
#include "watershed_lines.h"

/* The blur goes on with half the resolution when sigma is three cells of it. By then the
 * lifetimes of one cell in ten thousand are off by more than one scale (tested). */
#define HALVE_SIGMA_Q4 (3u << 4)

/* All buffers of a run, placed in the arena by the plan. */
typedef struct paper_buffers {
    uint8_t *surface; /* free cells, then ridges, then free cells again, then distances */
    rs_component_scratch components;
    uint8_t *lifetime;
    uint8_t *background;
    uint8_t *columns;
    rs_lifetime_scratch blur;
    rs_ring seed_ring;
    uint8_t *births;
    rs_ridge_scratch ridge;
    rs_queue_list *line_lists;
    rs_queue_block *line_blocks;
    rs_distance_scratch distance;
    rs_graph graph;
    rs_heap_item *heap;
    uint32_t *marks;
    uint16_t *line_rows;
    rs_room_records records;
} paper_buffers;

/* The next `bytes` of a buffer that holds several arrays, those of the largest alignment
 * first. */
static void *take(uint8_t **memory, size_t bytes)
{
    uint8_t *first = *memory;

    *memory += bytes;
    return first;
}

static void place_components(const rs_frame *frame, uint8_t *memory, rs_component_scratch *c)
{
    size_t runs = 2u * ROOMSEG_PLAN_RUNS(frame->width);

    c->components = take(&memory, runs * sizeof *c->components);
    c->runs = take(&memory, runs * sizeof *c->runs);
    c->active = take(&memory, runs * sizeof *c->active);
    c->vacant = take(&memory, runs * sizeof *c->vacant);
    c->stack = (void *)memory; /* 4-aligned: the rows before it take 30 bytes per run, runs even */
}

static void place_blur(const rs_frame *frame, uint8_t *memory, rs_blur_scratch *blur)
{
    size_t width = ROOMSEG_PLAN_BLURRED(frame->width);

    blur->ring_rows = ROOMSEG_BLUR_ROWS;
    blur->sums = take(&memory, width * sizeof *blur->sums);
    blur->prefix = take(&memory, (width + 2u * ROOMSEG_BLUR_ROWS) * sizeof *blur->prefix);
    blur->ring = (void *)memory;
}

static void place_buffers(const rs_plan *plan, const rs_frame *frame,
                          const roomseg_config *config, void *arena, paper_buffers *b)
{
    uint8_t *base = arena;

    /* All offsets are multiples of 8 and the arena is aligned to 8. */
#define AT(name) ((void *)(base + plan->offset[RS_PAPER_##name]))
    memset(b, 0, sizeof *b);
    b->surface = AT(surface);
    place_components(frame, AT(small_scratch), &b->components);
    b->lifetime = AT(lifetime);
    b->background = AT(background);
    b->columns = AT(columns);
    b->blur.shares = AT(shares);
    place_blur(frame, AT(blur_rows), &b->blur.blur);
    b->seed_ring.cells = AT(seed_ring);
    b->seed_ring.capacity = (uint32_t)ROOMSEG_PLAN_RING(frame->width, frame->height);
    b->seed_ring.first = 0;
    b->seed_ring.count = 0;
    b->births = AT(births);
    b->ridge.rows = AT(ridge_rows);
    b->ridge.roots = AT(roots);
    b->line_lists = AT(line_lists);
    b->line_blocks = AT(line_blocks);
    b->distance.envelope = AT(envelope);
    b->distance.least = AT(levels);
    b->graph.regions = AT(regions);
    b->graph.edges = AT(edges);
    b->heap = AT(heap);
    b->graph.shapes = NULL;
    b->marks = AT(marks);
    b->line_rows = AT(line_rows);
    b->records.rooms = AT(rooms);
    b->records.sums = AT(room_sums);
    b->records.doorways = AT(doorways);
    b->records.links = AT(links);
    b->records.max_rooms = config->max_rooms;
#undef AT
}

/* Small islands of free cells go, then small obstacles. */
static int clear_small(const roomseg_config *config, const rs_frame *frame,
                       uint32_t resolution_mm, paper_buffers *b, rs_ticker *ticker)
{
    rs_component_limits limits = rs_components_limits(config, resolution_mm);
    int status;

    limits.diagonal = false;
    rs_ticker_part(ticker, 0, 600);
    status = rs_components_keep_large_free(frame, b->surface, &b->components, ticker);
    rs_ticker_part(ticker, 600, 1000);
    return status == ROOMSEG_OK ? rs_components_clear_small(frame, limits, b->surface,
                                                            &b->components, ticker)
                                : status;
}

/* Lengths in whole cells, rounded to the nearest. */
static uint32_t cells_across(uint32_t length_mm, uint32_t resolution_mm)
{
    return (length_mm + resolution_mm / 2u) / resolution_mm;
}

/* The obstacles grown by config->dilation_mm in b->lifetime; those shrunk again by
 * RS_BACKGROUND_EROSION_MM are the background's seed. */
static int grow_obstacles(const roomseg_config *config, const rs_frame *frame,
                          uint32_t resolution_mm, const rs_labels *labels, paper_buffers *b,
                          rs_ticker *ticker)
{
    size_t bytes = (size_t)frame->stride * (frame->height + 2u);
    uint32_t grown = cells_across(config->dilation_mm, resolution_mm);
    /* Never by more, so that all obstacles belong to the background. */
    uint32_t shrunk = rs_min_u32(cells_across(RS_BACKGROUND_EROSION_MM, resolution_mm), grown);
    int status;

    memcpy(b->lifetime, b->surface, bytes);
    rs_ticker_part(ticker, 0, 100);
    status = rs_morphology_grow_obstacles(frame, grown, b->lifetime, b->columns, ticker);
    if (status == ROOMSEG_OK) {
        memcpy(b->background, b->lifetime, bytes);
        rs_ticker_part(ticker, 100, 180);
        status = rs_morphology_shrink_obstacles(frame, shrunk, b->background, b->columns, ticker);
    }
    if (status == ROOMSEG_OK) {
        rs_ticker_part(ticker, 180, 200);
        status = rs_seeds_mark_obstacles(frame, b->background, RS_BACKGROUND, labels, ticker);
    }
    return status;
}

/* How long each cell stays free as the grown obstacles are blurred. */
static int find_lifetime(const roomseg_config *config, const rs_frame *frame,
                         uint32_t resolution_mm, const rs_labels *labels, paper_buffers *b,
                         rs_ticker *ticker)
{
    const rs_lifetime_rules rules = {resolution_mm,  RS_SIGMA_START_MM,
                                     RS_SIGMA_STEP_MM,  config->seed_obstacle_permille,
                                     HALVE_SIGMA_Q4, ROOMSEG_BLUR_MARGIN};
    int status = grow_obstacles(config, frame, resolution_mm, labels, b, ticker);

    rs_ticker_part(ticker, 200, 980);
    if (status == ROOMSEG_OK) {
        status = rs_lifetime_run(frame, &rules, b->lifetime, &b->blur, ticker);
    }
    rs_ticker_part(ticker, 980, 1000);
    return status == ROOMSEG_OK
               ? rs_seeds_leave_out(frame, RS_BACKGROUND, labels, b->lifetime, ticker)
               : status;
}

/* One leaf seed for each maximum of the lifetime, as it was at its birth. */
static int find_seeds(const roomseg_config *config, const rs_frame *frame,
                      const rs_labels *labels, paper_buffers *b, rs_ticker *ticker)
{
    int status;

    rs_ticker_part(ticker, 0, 700);
    status = rs_watershed_run(frame, b->lifetime, config->max_regions, labels,
                              &b->graph.region_count, &b->seed_ring, ticker);
    rs_ticker_part(ticker, 700, 1000);
    return status == ROOMSEG_OK ? rs_seeds_run(frame, b->lifetime, b->graph.region_count, labels,
                                               b->births, ticker)
                                : status;
}

/* Floods the ridges from the seeds and the background. */
static int flood_ridges(const rs_frame *frame, const rs_labels *labels, paper_buffers *b,
                        rs_ticker *ticker)
{
    rs_queue queue;

    rs_queue_init(&queue, b->line_lists, b->line_blocks,
                  (uint32_t)ROOMSEG_PLAN_LINE_BLOCKS(frame->width, frame->height));
    return rs_watershed_lines_run(frame, b->surface, labels, &queue, ticker);
}

/* The ridges give way to the free cells again, with obstacles all around the crop. */
static int restore_free_cells(const rs_frame *frame, uint8_t *surface, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        uint8_t *row = surface + rs_frame_index(frame, 0, y);

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            row[x] = row[x] != RS_RIDGE_OBSTACLE;
        }
    }
    return ROOMSEG_OK;
}

/* Regions and shared borders; distances, which the records need, take the place of ridges. */
static int build_graph(const roomseg_config *config, const roomseg_grid *grid,
                       const rs_frame *frame, const rs_labels *labels, paper_buffers *b,
                       rs_ticker *ticker)
{
    int status;

    rs_ticker_part(ticker, 0, 100);
    status = restore_free_cells(frame, b->surface, ticker);
    rs_ticker_part(ticker, 100, 500);
    if (status == ROOMSEG_OK) {
        status = rs_distance_run(frame, grid->resolution_mm, b->surface, &b->distance, ticker);
    }
    rs_ticker_part(ticker, 500, 1000);
    return status == ROOMSEG_OK
               ? rs_graph_lines_build(frame, grid, config->occupied_min, b->surface, labels,
                                      &b->graph, (uint32_t)ROOMSEG_PLAN_EDGES(config->max_regions),
                                      ticker)
               : status;
}

static int merge(const roomseg_config *config, uint32_t resolution_mm, paper_buffers *b,
                 rs_ticker *ticker)
{
    rs_merge_paper_rules rules;

    rules.smallest_cells = rs_cells_of_area(config->smallest_room_mm2, resolution_mm);
    rules.isolated_permille = config->isolated_permille;
    rules.longest_border = config->longest_border_mm / resolution_mm;
    return rs_merge_paper_run(&rules, &b->graph, b->heap,
                              (uint32_t)ROOMSEG_PLAN_EDGES(config->max_regions), b->marks, ticker);
}

/* Labels and records. */
static int write_rooms(const roomseg_config *config, const roomseg_grid *grid,
                       const rs_frame *frame, const rs_labels *labels, paper_buffers *b,
                       rs_ticker *ticker)
{
    int status;

    rs_ticker_part(ticker, 0, 500);
    status = rs_graph_lines_resolve(frame, grid, config->occupied_min, b->surface, labels,
                                    &b->graph, b->line_rows, ticker);
    rs_ticker_part(ticker, 500, 1000);
    return status == ROOMSEG_OK ? rs_rooms_run(frame, grid, config->occupied_min, labels,
                                               &b->graph, &b->records, b->heap, ticker)
                                : status;
}

/* Stages behind the crop, on placed buffers. */
static int run_stages(const roomseg_config *config, const roomseg_grid *grid,
                      const rs_frame *frame, const rs_labels *labels, paper_buffers *b,
                      rs_ticker *ticker)
{
    uint32_t mm = grid->resolution_mm;
    int status = rs_threshold_run(grid, config->free_max, frame, b->surface, ticker);

    STAGE(COMPONENTS, clear_small(config, frame, mm, b, ticker));
    STAGE(SURFACE, find_lifetime(config, frame, mm, labels, b, ticker));
    STAGE(SEEDS, find_seeds(config, frame, labels, b, ticker));
    STAGE(RIDGE, rs_ridge_run(frame, RS_RIDGE_SIGMA_MM, mm, b->surface, &b->ridge, ticker));
    STAGE(WATERSHED, flood_ridges(frame, labels, b, ticker));
    STAGE(GRAPH, build_graph(config, grid, frame, labels, b, ticker));
    STAGE(MERGE, merge(config, mm, b, ticker));
    STAGE(ROOMS, write_rooms(config, grid, frame, labels, b, ticker));
    return status;
}

static int run(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
               const rs_plan *plan, const rs_labels *labels, roomseg_result *result, void *arena,
               rs_ticker *ticker)
{
    paper_buffers b;
    int status;

    place_buffers(plan, frame, config, arena, &b);
    status = run_stages(config, grid, frame, labels, &b, ticker);
    rs_rooms_report(&b.records, result);
    result->region_count = b.graph.region_count;
    return status;
}

static int measure(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                   const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                   void *rows, rs_ticker *ticker)
{
    int status = rs_graph_lines_build(frame, grid, config->occupied_min, surface, labels, graph,
                                      (uint32_t)ROOMSEG_PLAN_EDGES(config->max_rooms), ticker);

    return status == ROOMSEG_OK
               ? rs_graph_lines_resolve(frame, grid, config->occupied_min, surface, labels, graph,
                                        rows, ticker)
               : status;
}

const roomseg_profile roomseg_profile_paper = {rs_plan_paper, run, true, true, measure};

roomseg_config roomseg_config_paper(void)
{
    roomseg_config config = roomseg_config_default();

    config.profile = ROOMSEG_PROFILE_PAPER;
    config.clutter_mm = 0;
    return config;
}
