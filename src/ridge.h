/* Ridge map: how much each cell lies in a narrow between obstacles.
 *
 * Meijering et al., "Design and validation of a tool for neurite tracing and analysis in
 * fluorescence microscopy images", Cytometry 58A, 2004: with the eigenvalues p and q of the
 * Hessian of the obstacle map blurred by a Gaussian, the value is the larger in magnitude of
 * p + alpha q and q + alpha p, alpha = 1/3, negative values clipped to 0. */
#ifndef RS_RIDGE_H
#define RS_RIDGE_H

#include "base.h"

/* Half the taps of the Gaussian, 4.5 sigma at most. */
#define RS_RIDGE_MAX_RADIUS ROOMSEG_RIDGE_MAX_RADIUS

/* Largest ridge value, and what obstacles have instead of one. */
#define RS_RIDGE_MAX 254u
#define RS_RIDGE_OBSTACLE 255u

typedef struct rs_ridge_scratch {
    uint16_t *roots; /* width * height */
    uint32_t *rows;  /* ROOMSEG_RIDGE_ROWS * (width + 2) */
} rs_ridge_scratch;

/* sigma_mm: of the Gaussian; at least one and at most four cells are taken.
 * cells: bordered, 0 = obstacle, 1 = free; what lies outside of the crop is an obstacle. Free
 * cells become RS_RIDGE_MAX * sqrt(value / greatest value of the map), rounded; obstacles
 * RS_RIDGE_OBSTACLE. The square root keeps the order, which is all that a watershed uses,
 * and spends the steps where they are needed: the floor of a doorway is flat. */
int rs_ridge_run(const rs_frame *frame, uint32_t sigma_mm, uint32_t resolution_mm,
                 uint8_t *cells, const rs_ridge_scratch *scratch, rs_ticker *ticker);

#endif
