/* How narrow regions are, by the second moments of their cells. */
#ifndef RS_SHAPE_H
#define RS_SHAPE_H

#include "base.h"
#include "watershed.h"

/* Sums over the cells of a region, crop coordinates, modulo 2^64; each cell counts as a square.
 * xx, xy and yy are twelve times the sums, which makes them whole. */
typedef struct rs_shape {
    uint64_t x, y, xx, xy, yy;
    uint64_t cells;
} rs_shape;

RS_STATIC_ASSERT(sizeof(rs_shape) == ROOMSEG_SHAPE_BYTES, shape);

/* Measures all regions in one reading of the labels. shapes: of label_count + 1 elements.
 * Fails iff: cancelled. */
int rs_shape_measure(const rs_frame *frame, const rs_labels *labels, uint32_t label_count,
                     rs_shape *shapes, rs_ticker *ticker);

/* What two regions make up together. */
rs_shape rs_shape_join(const rs_shape *a, const rs_shape *b);

/* Whether the rectangle of the same second moments is at most `width` cells wide, in whichever
 * direction. (x, y): any cell of the shape or near it. Always false for shapes of 2^20 cells and
 * more, and for such as reach some thousand cells from (x, y). width: < 2^11. */
bool rs_shape_is_narrow(const rs_shape *shape, uint32_t x, uint32_t y, uint32_t width);

#endif
