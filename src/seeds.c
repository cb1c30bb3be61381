#include "seeds.h"

#include <string.h>

/* Two cells that touch: their regions are one seed at the scales up to the lower T. */
static void meet(uint16_t p, uint16_t q, uint8_t t, uint8_t u, uint8_t *births)
{
    uint8_t saddle = t < u ? t : u;

    if (saddle > 0u && p != q) {
        births[p] = births[p] > saddle ? births[p] : (uint8_t)(saddle + 1u);
        births[q] = births[q] > saddle ? births[q] : (uint8_t)(saddle + 1u);
    }
}

static int find_births(const rs_frame *frame, const uint8_t *lifetime, const rs_labels *labels,
                       uint8_t *births, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *t = lifetime + rs_frame_index(frame, 0, y);
        const uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, y, 2u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            /* The border of the lifetime map is 0, so labels outside are not read. */
            if (t[x] != 0u && t[x + 1u] != 0u) {
                meet(row[x], row[x + 1u], t[x], t[x + 1u], births);
            }
            if (t[x] != 0u && t[x + frame->stride] != 0u) {
                meet(row[x], row[x + labels->stride], t[x], t[x + frame->stride], births);
            }
        }
    }
    return ROOMSEG_OK;
}

int rs_seeds_run(const rs_frame *frame, const uint8_t *lifetime, uint32_t region_count,
                 const rs_labels *labels, uint8_t *births, rs_ticker *ticker)
{
    int status;

    memset(births, 1, (size_t)region_count + 1u);
    status = find_births(frame, lifetime, labels, births, ticker);
    for (uint32_t y = 0; status == ROOMSEG_OK && y < frame->height; y++) {
        const uint8_t *t = lifetime + rs_frame_index(frame, 0, y);
        uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, frame->height + y, 2u * frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            if (t[x] != 0u && t[x] < births[row[x]]) {
                row[x] = 0;
            }
        }
    }
    return status;
}

int rs_seeds_mark_obstacles(const rs_frame *frame, const uint8_t *cells, uint16_t label,
                            const rs_labels *labels, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *from = cells + rs_frame_index(frame, 0, y);
        uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            row[x] = from[x] == 0u ? label : row[x];
        }
    }
    return ROOMSEG_OK;
}

int rs_seeds_leave_out(const rs_frame *frame, uint16_t label, const rs_labels *labels,
                       uint8_t *lifetime, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        uint8_t *t = lifetime + rs_frame_index(frame, 0, y);
        const uint16_t *row = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < frame->width; x++) {
            t[x] = row[x] == label ? 0u : t[x];
        }
    }
    return ROOMSEG_OK;
}
