#include "threshold.h"

#include <string.h>

/* Without an early exit, so that compilers vectorise it: most rows hold no free cell, and most
 * others none beside the box that was found so far. */
static bool has_free(const uint8_t *cells, uint32_t count, uint8_t free_max)
{
    uint8_t lowest = 255;

    for (uint32_t i = 0; i < count; i++) {
        lowest = cells[i] < lowest ? cells[i] : lowest;
    }
    return lowest <= free_max;
}

int rs_threshold_crop(const roomseg_grid *grid, uint8_t free_max, rs_frame *frame,
                      rs_ticker *ticker)
{
    uint32_t top = 0, bottom = grid->height, left = grid->width, right = 0;
    const uint8_t *row = grid->cells;

    memset(frame, 0, sizeof *frame);
    for (; top < bottom; top++, row += grid->stride) {
        if (rs_tick(ticker, grid->width, top, grid->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (has_free(row, grid->width, free_max)) {
            break;
        }
    }
    for (row = grid->cells + (size_t)(bottom - 1u) * grid->stride; bottom > top;
         bottom--, row -= grid->stride) {
        if (rs_tick(ticker, grid->width, top, grid->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (has_free(row, grid->width, free_max)) {
            break;
        }
    }
    if (top == bottom) {
        return ROOMSEG_OK;
    }
    /* Between them only what lies left or right of the box so far can widen it. */
    row = grid->cells + (size_t)top * grid->stride;
    for (uint32_t y = top; y < bottom; y++, row += grid->stride) {
        if (rs_tick(ticker, grid->width, y, grid->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (has_free(row, left, free_max)) {
            for (left = 0; row[left] > free_max;) {
                left++;
            }
        }
        if (has_free(row + right, grid->width - right, free_max)) {
            for (right = grid->width; row[right - 1u] > free_max;) {
                right--;
            }
        }
    }
    frame->x = left;
    frame->y = top;
    frame->width = right - left;
    frame->height = bottom - top;
    frame->stride = frame->width + 2u;
    return ROOMSEG_OK;
}

/* A function of its own, so that compilers know that the rows do not overlap. */
static void compare_row(const uint8_t *restrict from, uint32_t width, uint8_t free_max,
                        uint8_t *restrict to)
{
    for (uint32_t x = 0; x < width; x++) {
        to[x] = from[x] <= free_max;
    }
}

int rs_threshold_run(const roomseg_grid *grid, uint8_t free_max, const rs_frame *frame,
                     uint8_t *surface, rs_ticker *ticker)
{
    const uint8_t *from = grid->cells + (size_t)frame->y * grid->stride + frame->x;
    uint8_t *to = surface + rs_frame_index(frame, 0, 0);

    memset(surface, 0, frame->stride);
    memset(surface + (size_t)(frame->height + 1u) * frame->stride, 0, frame->stride);
    for (uint32_t y = 0; y < frame->height; y++) {
        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        *(to - 1) = 0;
        to[frame->width] = 0;
        compare_row(from, frame->width, free_max, to);
        from += grid->stride;
        to += frame->stride;
    }
    return ROOMSEG_OK;
}
