/* Dilation and erosion of the obstacles by a square. */
#ifndef RS_MORPHOLOGY_H
#define RS_MORPHOLOGY_H

#include "base.h"

/* cells: bordered, 0 = obstacle, 1 = free, the border 0: what lies outside of the crop is an
 * obstacle. The square has 2 * radius + 1 cells a side, radius 0..RS_MORPHOLOGY_MAX_RADIUS.
 * columns: frame->stride elements of scratch. */
#define RS_MORPHOLOGY_MAX_RADIUS 255u

/* Dilation: every free cell within the square around an obstacle becomes one. */
int rs_morphology_grow_obstacles(const rs_frame *frame, uint32_t radius, uint8_t *cells,
                                 uint8_t *columns, rs_ticker *ticker);

/* Erosion: every obstacle within the square around a free cell becomes free. */
int rs_morphology_shrink_obstacles(const rs_frame *frame, uint32_t radius, uint8_t *cells,
                                   uint8_t *columns, rs_ticker *ticker);

#endif
