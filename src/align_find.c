/* Alignment, first part: the direction of the walls. */
#include "align.h"
#include "canny.h"
#include "components.h"
#include "threshold.h"

int rs_align_mask(const roomseg_config *config, const roomseg_grid *grid,
                  const rs_frame *frame, rs_component_limits limits, uint8_t *mask, void *scratch,
                  rs_ticker *ticker)
{
    uint32_t runs = 2u * (uint32_t)ROOMSEG_PLAN_RUNS(frame->width);
    size_t small =
        ROOMSEG_PLAN_SMALL(config->speck_mm2, config->clutter_mm, grid->resolution_mm);
    rs_component_scratch parts;
    int status;

    parts.components = scratch;
    parts.stack = (uint32_t *)(void *)(parts.components + runs);
    parts.runs = (rs_run *)(void *)(parts.stack + small);
    parts.active = (uint16_t *)(void *)(parts.runs + runs);
    parts.vacant = parts.active + runs;
    status = rs_threshold_run(grid, config->free_max, frame, mask, ticker);
    if (status == ROOMSEG_OK) {
        status = rs_components_clear_small(frame, limits, mask, &parts, ticker);
    }
    return status;
}

/* Histogram of the directions of all segments among the edges. */
static int gather_directions(rs_hough *hough, rs_direction_bin *bins, rs_ticker *ticker)
{
    int status;
    bool found;

    rs_direction_clear(bins);
    do {
        rs_line line;
        status = rs_hough_next(hough, &line, &found, ticker);
        if (status == ROOMSEG_OK && found) {
            rs_direction_add(bins, &line);
        }
    } while (status == ROOMSEG_OK && found);
    return status;
}

int rs_align_find(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                  void *arena, int32_t *angle, rs_ticker *ticker)
{
    rs_component_limits limits = rs_components_limits(config, grid->resolution_mm);
    rs_find_buffers b;
    rs_hough hough;
    uint32_t point_count = 0;
    int status;

    rs_align_place_find(config, frame, grid->resolution_mm, arena, &b);
    rs_ticker_part(ticker, 0, 150);
    limits.clutter_cells = 0; /* pillars and short pieces of wall show the direction too */
    status = rs_align_mask(config, grid, frame, limits, b.mask, b.small_scratch, ticker);
    rs_ticker_part(ticker, 150, 500);
    if (status == ROOMSEG_OK) {
        status = rs_canny_run(frame, b.mask, b.points, &point_count, b.rows, ticker);
    }
    rs_ticker_part(ticker, 500, 900);
    if (status == ROOMSEG_OK) {
        rs_hough_init(&hough, frame, b.mask, b.points, point_count, b.votes, b.normals);
        status = gather_directions(&hough, b.bins, ticker);
    }
    *angle = status == ROOMSEG_OK ? rs_direction_find(b.bins) : 0;
    return status;
}
