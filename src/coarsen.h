/* Halving of the grid on which the lifetime map is computed, and the way back. */
#ifndef RS_COARSEN_H
#define RS_COARSEN_H

#include "base.h"

/* Grids with a shorter side are not halved. */
#define RS_COARSEN_MIN_SIDE 8u

/* Lifetimes of coarse cells are kept in fractions of a scale. */
#define RS_COARSEN_UNIT 128u

/* One grid of the pyramid; cell (X, Y) covers the cells (2X, 2Y) to (2X + 1, 2Y + 1) of the
 * one before. Level 0 is the frame itself and has no `lives`. */
typedef struct rs_level {
    uint32_t width, height;
    uint32_t last_scale; /* the last one that was computed on this grid */
    /* Of a cell that is no seed: its lifetime [1 / RS_COARSEN_UNIT]. Of a seed: its free
     * share [1/65535]. Shares of seeds are larger than any lifetime. */
    uint16_t *lives;
} rs_level;

/* Lays out level `level` (1 or more) behind the one before. shares: the array of level 0's
 * shares. Each level's shares lie at its beginning, with a margin of so many cells around
 * them; behind those of level 1 lie the lives of all levels. */
void rs_coarsen_place(rs_level *levels, uint32_t level, uint32_t margin, uint16_t *shares);

/* Makes level `level` of the one before. shares: in place. margin: even. limit: smallest share
 * of a seed, above 2^15. cells: lifetimes of level 0, bordered; whole numbers. */
int rs_coarsen_run(const rs_frame *frame, const rs_level *levels, uint32_t level,
                   uint32_t margin, uint32_t limit, const uint8_t *cells, uint16_t *shares,
                   rs_ticker *ticker);

/* Notes for one row what its shares at this scale are. Returns whether there is a seed. */
bool rs_coarsen_settle_row(uint16_t *lives, const uint16_t *shares, uint32_t width,
                           uint32_t limit, uint32_t scale);

/* Gives the cells of level - 1 that were still seeds when that was left the lifetimes of
 * `level`, interpolated linearly. */
int rs_coarsen_undo(const rs_frame *frame, const rs_level *levels, uint32_t level,
                    uint32_t limit, uint8_t *cells, rs_ticker *ticker);

#endif
