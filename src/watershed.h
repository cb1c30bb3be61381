/* Stage 4: one region for each peak of the surface. */
#ifndef RS_WATERSHED_H
#define RS_WATERSHED_H

#include "base.h"
#include "ring.h"

/* The caller's label image, seen from the crop. */
typedef struct rs_labels {
    uint16_t *cells; /* label of crop cell (x, y) = cells[y * stride + x] */
    uint32_t stride;
} rs_labels;

/* Labels every cell with a surface value above 0, and touches no other: each regional maximum (a
 * plateau none of whose 4-neighbours is higher) founds a region, which takes all cells from which
 * the steepest way up leads there. On a plateau the way leads to the nearest cell that has a
 * higher neighbour. Regions are 1..*region_count in the order of their first cells in reading
 * order, and 4-connected.
 * labels: need no preparation.
 * ring: empty. When it runs full, the crop is read again: the regions stay as many and as
 * connected, ties on plateaus may fall otherwise, and it takes longer.
 * Fails iff: more than max_regions maxima (ROOMSEG_ERR_REGIONS, *region_count then is
 * max_regions + 1), or cancelled; labels then mean nothing.
 * max_regions: at most ROOMSEG_MAX_REGIONS. */
int rs_watershed_run(const rs_frame *frame, const uint8_t *surface, uint32_t max_regions,
                     const rs_labels *labels, uint32_t *region_count, rs_ring *ring,
                     rs_ticker *ticker);

#endif
