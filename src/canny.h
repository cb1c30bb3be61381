/* Alignment, step 1: edges of the free space.
 * J. Canny, "A computational approach to edge detection", 1986: Gaussian, gradient, the
 * crest of its magnitude, hysteresis between two thresholds. */
#ifndef RS_CANNY_H
#define RS_CANNY_H

#include "base.h"

/* Gaussian of 2 cells, cut off at 4 of them. */
#define RS_CANNY_RADIUS 8u

/* Thresholds of the gradient's magnitude, Q14: 0.1 and 0.2 for Sobel's unnormalised
 * kernels on cells of 0 and 1. The middle of a long straight edge has about 1.55. */
#define RS_CANNY_WEAK 1638u
#define RS_CANNY_STRONG 3277u

/* mask: bordered, 0 = obstacle, 1 = free; the border must be 0, and so counts all that lies
 * beyond it. Becomes 1 on edge cells and 0 on all others, the border too. An edge between
 * two cells lies on the free one.
 * points: width * height elements; the edge cells, packed, in reading order.
 * rows: scratch, ROOMSEG_CANNY_ROWS * (frame->stride + 2) elements, aligned to 4 bytes.
 * Fails iff cancelled. */
int rs_canny_run(const rs_frame *frame, uint8_t *mask, uint32_t *points, uint32_t *point_count,
                 uint16_t *rows, rs_ticker *ticker);

#endif
