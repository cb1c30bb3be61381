#include "direction.h"

#include <string.h>

#include "trig.h"

#define BINS ROOMSEG_DIRECTION_BINS
#define QUARTER_TURN (90 * RS_DEGREE)
#define WINDOW (2u * RS_DIRECTION_HALF_WINDOW + 1u)

RS_STATIC_ASSERT(BINS * RS_DEGREE == QUARTER_TURN, one_bin_a_degree);

void rs_direction_clear(rs_direction_bin *bins)
{
    memset(bins, 0, BINS * sizeof *bins);
}

void rs_direction_add(rs_direction_bin *bins, const rs_line *line)
{
    int32_t dx = (int32_t)line->x1 - line->x0, dy = (int32_t)line->y1 - line->y0;
    uint32_t angle = (uint32_t)(rs_trig_angle(dx, dy) + 2 * QUARTER_TURN) % QUARTER_TURN;
    uint32_t length, capped;
    uint64_t weight;

    /* Down to 15 bits each, so that the squares' sum fits in 32. */
    for (length = 0; dx > INT16_MAX || -dx > INT16_MAX || dy > INT16_MAX || -dy > INT16_MAX;
         length++) {
        dx /= 2;
        dy /= 2;
    }
    length = rs_isqrt((uint32_t)(dx * dx) + (uint32_t)(dy * dy)) << length;
    capped = rs_min_u32(length, RS_DIRECTION_LONG);
    weight = (uint64_t)length * (capped * capped);
    bins[angle / RS_DEGREE].length += length;
    bins[angle / RS_DEGREE].weight += weight;
    bins[angle / RS_DEGREE].excess += weight * (angle % RS_DEGREE);
}

static uint32_t window_length(const rs_direction_bin *bins, uint32_t first)
{
    uint32_t length = 0;

    for (uint32_t i = 0; i < WINDOW; i++) {
        length += bins[(first + i) % BINS].length;
    }
    return length;
}

int32_t rs_direction_find(const rs_direction_bin *bins)
{
    uint32_t best = 0, most = 0;
    uint64_t weight = 0, excess = 0; /* excess: over the lower end of the window; below 2^61 */
    int32_t angle;

    for (uint32_t first = 0; first < BINS; first++) {
        uint32_t length = window_length(bins, first);
        if (length > most) {
            most = length;
            best = first;
        }
    }
    if (most == 0u) {
        return 0;
    }
    for (uint32_t i = 0; i < WINDOW; i++) {
        const rs_direction_bin *bin = &bins[(best + i) % BINS];
        weight += bin->weight;
        excess += bin->excess + bin->weight * (i * RS_DEGREE);
    }
    while (weight > UINT32_MAX) {
        weight >>= 1;
        excess >>= 1;
    }
    angle = (int32_t)(best * RS_DEGREE +
                      ((rs_divide_q8(excess, (uint32_t)weight) + 128u) >> 8));
    while (angle >= QUARTER_TURN / 2) {
        angle -= QUARTER_TURN;
    }
    return angle;
}
