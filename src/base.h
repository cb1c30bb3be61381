/* What every stage needs: the frame of the crop, the progress ticker, small arithmetic. */
#ifndef RS_BASE_H
#define RS_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "roomseg/roomseg.h"

/* Fails to compile when the condition does not hold (C99 has no static_assert). */
#define RS_STATIC_ASSERT(condition, name) typedef char rs_assert_##name[(condition) ? 1 : -1]

/* Sums and shifts of small types are taken to be of 32 bits. */
RS_STATIC_ASSERT(sizeof(int) >= 4u, int_of_32_bits);

/* The crop, and how its cells lie in a bordered buffer: one cell of border on every side,
 * so that the four neighbours of a crop cell always exist. */
typedef struct rs_frame {
    uint32_t x, y;          /* first cell of the crop in the caller's grid */
    uint32_t width, height; /* crop [cells]; 0 when no cell is free */
    uint32_t stride;        /* width + 2: one bordered row */
} rs_frame;

/* Index of crop cell (x, y) in a bordered buffer; x, y may be -1 or the size. */
static inline uint32_t rs_frame_index(const rs_frame *frame, uint32_t x, uint32_t y)
{
    return (y + 1u) * frame->stride + x + 1u;
}

/* Cells that cover an area, rounded up. */
static inline uint32_t rs_cells_of_area(uint32_t area_mm2, uint32_t resolution_mm)
{
    uint32_t cell_mm2 = resolution_mm * resolution_mm;

    return area_mm2 / cell_mm2 + (area_mm2 % cell_mm2 != 0u);
}

/* A cell position packed in 32 bits; both in crop coordinates, below 2^16. */
static inline uint32_t rs_cell_pack(uint32_t x, uint32_t y)
{
    return y << 16 | x;
}
static inline uint32_t rs_cell_x(uint32_t cell)
{
    return cell & 0xFFFFu;
}
static inline uint32_t rs_cell_y(uint32_t cell)
{
    return cell >> 16;
}

/* The progress hook with its bookkeeping. The hook must be called at least once in
 * RS_TICK_VISITS visits of a cell. Tests that cancel at every call lower it. */
#ifndef RS_TICK_VISITS
#define RS_TICK_VISITS 65536u
#endif

typedef struct rs_ticker {
    roomseg_progress_fn hook; /* may be NULL */
    void *user;
    roomseg_stage stage;
    uint32_t visits; /* since the last call of the hook, <= RS_TICK_VISITS */
    uint32_t permille; /* last value reported in this stage */
    uint32_t part_from;    /* the part of the stage that is in work [permille] begins here ... */
    uint32_t part_missing; /* ... and is shorter than the stage by this */
} rs_ticker;

/* Enters a stage and reports 0 per mille of it. True: the run is cancelled. */
bool rs_ticker_enter(rs_ticker *ticker, roomseg_stage stage);

/* Until the next stage, what is reported as done refers to this part of the stage [permille],
 * from <= to <= 1000. */
void rs_ticker_part(rs_ticker *ticker, uint32_t from, uint32_t to);

/* Calls the hook; `done` of `total` steps of the stage lie behind. */
bool rs_ticker_call(rs_ticker *ticker, uint32_t done, uint32_t total);

/* To be called BEFORE visiting `visits` (at most RS_TICK_VISITS) further cells.
 * True: the run is cancelled, the stage returns ROOMSEG_ERR_CANCELLED. */
static inline bool rs_tick(rs_ticker *ticker, uint32_t visits, uint32_t done, uint32_t total)
{
    if (ticker->visits + visits <= RS_TICK_VISITS) {
        ticker->visits += visits;
        return false;
    }
    ticker->visits = visits;
    return rs_ticker_call(ticker, done, total);
}

static inline uint32_t rs_min_u32(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}
static inline uint32_t rs_max_u32(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

/* The first of the cells x..end that is not `value`; end when there is none. x <= end. Reads a
 * machine word at a time, but for the first cell: in noise most runs are one cell long. */
static inline uint32_t rs_skip(const uint8_t *cells, uint32_t x, uint32_t end, uint8_t value)
{
    const size_t pattern = SIZE_MAX / 255u * value;
    const uint32_t words_end = end - rs_min_u32(end, (uint32_t)sizeof pattern - 1u);
    size_t word;
    uint32_t half;

    if (x < end && cells[x] != value) {
        return x;
    }
    while (x < words_end) { /* a whole word lies before `end` */
        memcpy(&word, cells + x, sizeof word);
        if (word != pattern) {
            /* It is one of this word's. */
            if (sizeof word > sizeof half) {
                memcpy(&half, cells + x, sizeof half);
                x += half == (uint32_t)pattern ? (uint32_t)sizeof half : 0u;
            }
            while (cells[x] == value) {
                x++;
            }
            return x;
        }
        x += (uint32_t)sizeof word;
    }
    while (x < end && cells[x] == value) {
        x++;
    }
    return x;
}

/* The same for labels. */
static inline uint32_t rs_skip_label(const uint16_t *labels, uint32_t x, uint32_t end,
                                     uint16_t label)
{
    const size_t pattern = SIZE_MAX / 0xFFFFu * label;
    const uint32_t words_end =
        end - rs_min_u32(end, (uint32_t)(sizeof pattern / sizeof *labels) - 1u);
    size_t word;

    if (x < end && labels[x] != label) {
        return x;
    }
    while (x < words_end) {
        memcpy(&word, labels + x, sizeof word);
        if (word != pattern) {
            break;
        }
        x += (uint32_t)(sizeof word / sizeof *labels);
    }
    while (x < end && labels[x] == label) {
        x++;
    }
    return x;
}

/* The greatest of some bytes, 0 of none. */
static inline uint8_t rs_highest(const uint8_t *values, uint32_t count)
{
    uint8_t highest = 0;

    for (uint32_t i = 0; i < count; i++) {
        highest = values[i] > highest ? values[i] : highest;
    }
    return highest;
}

/* floor(sqrt(n)), exact for every 32-bit n. */
uint32_t rs_isqrt(uint32_t n);

/* numerator * 256 / denominator, rounded down, without a 64-bit division.
 * Requires denominator >= 1 and a quotient below 2^32. */
uint32_t rs_divide_q8(uint64_t numerator, uint32_t denominator);

#endif
