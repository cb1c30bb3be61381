/* Leaf seeds: the parts of the free space that never divide as the blur grows. */
#ifndef RS_SEEDS_H
#define RS_SEEDS_H

#include "base.h"
#include "watershed.h"

/* Every regional maximum of the lifetime map T is the last that is left of one leaf of the
 * seed graph: its death. Going back to smaller scales, the leaf grows, until at T = saddle
 * it and another seed are one: its birth is the scale behind that, and its seed is the
 * component of {T > saddle} that holds it.
 *
 * labels: on entry one region per regional maximum of T, by rs_watershed_run; on return the
 * cells of leaf seeds, each at its birth, keep their label, the region's others are 0.
 * births: region_count + 1 elements; the scale of each birth, 1..RS_LIFETIME_MAX. Cells with
 * T = 0 are neither read nor changed. */
int rs_seeds_run(const rs_frame *frame, const uint8_t *lifetime, uint32_t region_count,
                 const rs_labels *labels, uint8_t *births, rs_ticker *ticker);

/* Gives `label` to all obstacles (cells: bordered, 0 = obstacle). */
int rs_seeds_mark_obstacles(const rs_frame *frame, const uint8_t *cells, uint16_t label,
                            const rs_labels *labels, rs_ticker *ticker);

/* Sets the lifetime to 0 on the cells that carry `label`: around a small obstacle in a wide
 * space the blur leaves its cells too, but the watershed wants cells of T > 0 without label. */
int rs_seeds_leave_out(const rs_frame *frame, uint16_t label, const rs_labels *labels,
                       uint8_t *lifetime, rs_ticker *ticker);

#endif
