/* Stage 4: one region for each peak of the surface. */
#ifndef RS_WATERSHED_H
#define RS_WATERSHED_H

#include "base.h"
#include "queue.h"

/* The caller's label image, seen from the crop. */
typedef struct rs_labels {
    uint16_t *cells; /* label of crop cell (x, y) = cells[y * stride + x] */
    uint32_t stride;
} rs_labels;

/* Labels every cell with a surface value above 0: each regional maximum (a plateau none of
 * whose 4-neighbours is higher) founds a region, 1..*region_count in falling order of
 * height; the cells then join, in falling order of height and first in first out among
 * equals, the region that reaches them first (Beucher and Meyer's flooding without lines).
 * labels must be 0 where the surface is above 0; elsewhere they are not touched.
 * Every region is 4-connected. When the queue runs full, the lost cells are found again by
 * reading the surface: the regions are the same and as connected, ties between them may fall
 * otherwise, and it takes longer. queue: initialised and empty, any number of blocks.
 * Fails iff: more than max_regions maxima (ROOMSEG_ERR_REGIONS, *region_count then is
 * max_regions + 1), or cancelled. */
int rs_watershed_run(const rs_frame *frame, const uint8_t *surface, uint32_t max_regions,
                     const rs_labels *labels, uint32_t *region_count, rs_queue *queue,
                     rs_ticker *ticker);

#endif
