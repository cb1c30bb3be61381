/* The lifetime map: how long each cell stays inside the free space while that is blurred.
 *
 * The free space is blurred with a Gaussian of growing sigma: start, start + step, ... A cell
 * belongs to the seed map S_i while the i-th blur leaves it at most a given share of
 * obstacles. The lifetime T is the number of the last scale, counted from 1, at which the
 * cell is still in S_i; 0: in none. So S_i = {T >= i} as far as the seed maps are nested, and
 * none of them is stored. */
#ifndef RS_LIFETIME_H
#define RS_LIFETIME_H

#include "base.h"
#include "blur.h"

#define RS_LIFETIME_MAX 254u

/* Levels of decimation, the full resolution included. */
#define RS_LIFETIME_LEVELS 8u

typedef struct rs_lifetime_rules {
    uint32_t resolution_mm;
    uint32_t start_mm, step_mm; /* of sigma */
    uint32_t occupied_permille; /* share of obstacles up to which a cell is a seed, 0..499 */
    /* From this sigma on [sixteenths of a cell of the coarser grid] the grid is halved;
     * UINT32_MAX: never. */
    uint32_t halve_sigma_q4;
    /* Cells around each grid in which the blur is followed, even. What leaves them is lost,
     * which shows at the crop's edge when sigma grows beyond the margin. */
    uint32_t margin;
} rs_lifetime_rules;

typedef struct rs_lifetime_scratch {
    uint16_t *shares;     /* (width + 2 * margin) * (height + 2 * margin) of the frame */
    rs_blur_scratch blur; /* for width + 2 * margin */
} rs_lifetime_scratch;

/* Rows that scratch.blur.ring must have for these rules and any map. */
uint32_t rs_lifetime_ring_rows(const rs_lifetime_rules *rules);

/* cells: bordered, 0 = obstacle, 1 = free; they become the lifetime, saturating at
 * RS_LIFETIME_MAX. The border is not read and not written; what lies outside of the crop is
 * an obstacle.
 * One box blur an axis and scale takes the map from one scale to the next (three for the
 * first scale). Where the grid was halved, lifetimes are interpolated. */
int rs_lifetime_run(const rs_frame *frame, const rs_lifetime_rules *rules, uint8_t *cells,
                    const rs_lifetime_scratch *scratch, rs_ticker *ticker);

#endif
