/* Box blur of a plane of 16-bit shares in place, row by row. */
#ifndef RS_BLUR_H
#define RS_BLUR_H

#include "base.h"

/* A box with fractional ends: weight `centre` on the cells up to `radius` away, `end` on the
 * two next to them. (2 * radius + 1) * centre + 2 * end = 2^16 exactly, so that a constant
 * stays what it is. */
typedef struct rs_box {
    uint32_t radius, centre, end;
} rs_box;

#define RS_BLUR_MAX_RADIUS 62u

/* The box of the given variance [2^-16 cells^2]; the largest one with radius
 * RS_BLUR_MAX_RADIUS if that is smaller. */
rs_box rs_box_of_variance(uint32_t variance);

/* The variance that a box really has [2^-16 cells^2]. */
uint32_t rs_box_variance(const rs_box *box);

typedef struct rs_blur_scratch {
    uint32_t *sums;   /* width */
    uint32_t *prefix; /* width + 2 * ring_rows */
    uint16_t *ring;   /* ring_rows * width */
    uint32_t ring_rows; /* the largest radius + 3 */
} rs_blur_scratch;

/* A blur in progress. Outside of the plane the share counts as 0. */
typedef struct rs_blur {
    uint16_t *cells; /* width * height */
    uint32_t width, height;
    rs_box box;
    rs_blur_scratch scratch;
} rs_blur;

/* Begins a blur: requires box.radius + 3 <= scratch.ring_rows. */
void rs_blur_begin(rs_blur *blur);

/* Completes row y; to be called for y = 0, 1, ... height - 1. Later rows hold intermediate
 * results until it is their turn. Returns the row. */
const uint16_t *rs_blur_row(rs_blur *blur, uint32_t y);

#endif
