/* Stage 1: grid -> free cells of the crop. */
#ifndef RS_THRESHOLD_H
#define RS_THRESHOLD_H

#include "base.h"

/* Bounding box of the grid's cells with a value of at most free_max. A grid without such
 * a cell gives a frame of width and height 0. Reads each cell at most twice. */
int rs_threshold_crop(const roomseg_grid *grid, uint8_t free_max, rs_frame *frame,
                      rs_ticker *ticker);

/* surface: bordered; free cells become 1, all others and the border 0. */
int rs_threshold_run(const roomseg_grid *grid, uint8_t free_max, const rs_frame *frame,
                     uint8_t *surface, rs_ticker *ticker);

#endif
