/* The entry points: checks, the crop, the arena; the stages are the profile's. */
#include <string.h>

#include "align.h"
#include "config.h"
#include "plan.h"
#include "profile.h"
#include "threshold.h"

static void clear_labels(const roomseg_grid *grid, uint16_t *labels, uint32_t stride)
{
    for (uint32_t y = 0; y < grid->height; y++) {
        memset(labels + (size_t)y * stride, 0, grid->width * sizeof *labels);
    }
}

static void set_crop(const rs_frame *frame, size_t arena_used, roomseg_result *result)
{
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

/* Arena bytes for a crop; all numbers are in range. */
static int arena_need(const roomseg_config *config, uint32_t width, uint32_t height,
                      uint32_t resolution_mm, size_t *bytes)
{
    rs_plan plan;

    if (config->align != NULL) {
        return config->align->plan(config, width, height, resolution_mm, bytes);
    }
    config->profile->plan(config, width, height, resolution_mm, &plan);
    *bytes = plan.size;
    return ROOMSEG_OK;
}

int roomseg_arena_size(const roomseg_config *config, uint32_t width, uint32_t height,
                       uint32_t resolution_mm, size_t *bytes)
{
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
        status = arena_need(config, width, height, resolution_mm, bytes);
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

/* All stages behind the crop. */
static int run_profile(const roomseg_config *config, const roomseg_grid *grid,
                       const rs_frame *frame, const rs_labels *labels, roomseg_result *result,
                       void *arena, rs_ticker *ticker)
{
    rs_plan plan;

    if (config->align != NULL) {
        return config->align->run(config, grid, frame, labels, result, arena, ticker);
    }
    config->profile->plan(config, frame->width, frame->height, grid->resolution_mm, &plan);
    return config->profile->run(config, grid, frame, &plan, labels, result, arena, ticker);
}

/* Everything behind the checks; *result is zeroed already. */
static int run_checked(const roomseg_config *config, const roomseg_grid *grid, uint16_t *labels,
                       uint32_t label_stride, roomseg_result *result, void *arena,
                       size_t arena_size)
{
    rs_ticker ticker = {config->progress, config->progress_user, ROOMSEG_STAGE_THRESHOLD,
                        0, 0, 0, 0};
    rs_frame frame;
    rs_labels crop_labels;
    size_t need = 0;
    int status;

    status = rs_ticker_enter(&ticker, ROOMSEG_STAGE_THRESHOLD)
                 ? ROOMSEG_ERR_CANCELLED
                 : rs_threshold_crop(grid, config->free_max, &frame, &ticker);
    if (status == ROOMSEG_OK && crop_too_large(frame.width, frame.height)) {
        return ROOMSEG_ERR_GRID_SIZE;
    }
    if (status == ROOMSEG_OK && frame.width > 0u) {
        status = arena_need(config, frame.width, frame.height, grid->resolution_mm, &need);
        if (status != ROOMSEG_OK) {
            return status;
        }
        if (arena_size < need) {
            result->arena_used = need;
            return ROOMSEG_ERR_ARENA_SIZE;
        }
    }
    clear_labels(grid, labels, label_stride);
    if (status != ROOMSEG_OK || frame.width == 0u) {
        return status;
    }
    crop_labels.cells = labels + (size_t)frame.y * label_stride + frame.x;
    crop_labels.stride = label_stride;
    status = run_profile(config, grid, &frame, &crop_labels, result, arena, &ticker);
    if (status == ROOMSEG_OK) {
        set_crop(&frame, need, result);
    } else {
        uint32_t regions = status == ROOMSEG_ERR_REGIONS ? result->region_count : 0u;
        memset(result, 0, sizeof *result);
        result->region_count = regions;
        clear_labels(grid, labels, label_stride);
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
