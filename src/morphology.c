#include "morphology.h"

#include <string.h>

/* Reached by the value that spreads, but must not spread it further. */
#define REACHED 2u

/* Spreads `value` by `radius` cells to both sides of each of its cells in one row. `row` is
 * the bordered row's first crop cell; `outside`: steps that the value reaches into the crop
 * from beyond it. */
static void spread_along(uint8_t *row, uint32_t width, uint8_t value, uint32_t radius,
                         uint32_t outside)
{
    uint32_t left = outside; /* steps that the value still reaches */

    for (uint32_t x = 0; x < width; x++) {
        if (row[x] == value) {
            left = radius;
        } else if (left > 0u) {
            left--;
            row[x] = REACHED;
        }
    }
    left = outside;
    for (uint32_t x = width; x-- > 0u;) {
        if (row[x] == value) {
            left = radius;
        } else if (left > 0u) {
            left--;
            row[x] = value;
        } else if (row[x] == REACHED) {
            row[x] = value;
        }
    }
}

/* The same step for one row of all columns at once; left[x] as above. */
static void spread_down(uint8_t *row, uint32_t width, uint8_t value, uint8_t radius,
                        uint8_t mark, uint8_t *left)
{
    for (uint32_t x = 0; x < width; x++) {
        uint8_t here = row[x];
        uint8_t fewer = (uint8_t)(left[x] - (left[x] > 0u));

        row[x] = here != value && left[x] > 0u ? mark : here;
        left[x] = here == value ? radius : fewer;
    }
}

static int spread(const rs_frame *frame, uint8_t value, uint32_t radius, uint8_t *cells,
                  uint8_t *columns, rs_ticker *ticker)
{
    uint32_t outside = value == 0u ? radius : 0u;
    uint32_t rows = frame->height;

    for (uint32_t y = 0; y < rows; y++) {
        if (rs_tick(ticker, frame->width, y, 3u * rows)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        spread_along(cells + rs_frame_index(frame, 0, y), frame->width, value, radius, outside);
    }
    memset(columns, (int)outside, frame->width);
    for (uint32_t y = 0; y < rows; y++) {
        if (rs_tick(ticker, frame->width, rows + y, 3u * rows)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        spread_down(cells + rs_frame_index(frame, 0, y), frame->width, value, (uint8_t)radius,
                    REACHED, columns);
    }
    memset(columns, (int)outside, frame->width);
    for (uint32_t y = rows; y-- > 0u;) {
        uint8_t *row = cells + rs_frame_index(frame, 0, y);

        if (rs_tick(ticker, frame->width, 3u * rows - 1u - y, 3u * rows)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        spread_down(row, frame->width, value, (uint8_t)radius, REACHED, columns);
        for (uint32_t x = 0; x < frame->width; x++) {
            row[x] = row[x] == REACHED ? value : row[x];
        }
    }
    return ROOMSEG_OK;
}

int rs_morphology_grow_obstacles(const rs_frame *frame, uint32_t radius, uint8_t *cells,
                                 uint8_t *columns, rs_ticker *ticker)
{
    return spread(frame, 0, radius, cells, columns, ticker);
}

int rs_morphology_shrink_obstacles(const rs_frame *frame, uint32_t radius, uint8_t *cells,
                                   uint8_t *columns, rs_ticker *ticker)
{
    return spread(frame, 1, radius, cells, columns, ticker);
}
