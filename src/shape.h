/* How narrow regions are, by the second moments of their cells. */
#ifndef RS_SHAPE_H
#define RS_SHAPE_H

#include "graph.h"

/* Fills graph->shapes, of region_count + 1 elements, in one reading of the labels. The graph is
 * built, and nothing is merged yet. Fails iff: cancelled. */
int rs_shape_measure(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                     const rs_labels *labels, rs_graph *graph, rs_ticker *ticker);

/* Adds the shape of `from` to that of `into`, around a new peak (x, y); their areas and peaks are
 * still their own. */
void rs_shape_unite(rs_graph *graph, uint16_t into, uint16_t from, uint32_t x, uint32_t y);

/* Whether two roots together, or one when a == b, fit across: whether the rectangle with the same
 * second moments is at most `width` cells wide, in whichever direction. Always false from 2^20
 * cells on, and for what reaches some thousand cells from its peak. width: < 2^11. */
bool rs_shape_are_narrow(const rs_graph *graph, uint16_t a, uint16_t b, uint32_t width);

#endif
