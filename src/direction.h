/* Alignment, step 3: the direction of most walls. */
#ifndef RS_DIRECTION_H
#define RS_DIRECTION_H

#include "base.h"
#include "hough.h"

/* Walls a quarter turn apart count as one direction: a histogram over 90 degrees. */
#define RS_DIRECTION_HALF_WINDOW 2u /* bins */

typedef struct rs_direction_bin {
    uint64_t weight; /* sum of length^3: a segment of n cells shows its direction with a variance
                        of 1 / n^3; below 2^52, as lengths count as RS_DIRECTION_LONG at most in
                        two of the factors */
    uint64_t excess; /* sum of length^3 * (angle - lower end of the bin) [degree/100] */
    uint32_t length; /* of all segments in this degree [cells]; of all degrees below 2^32,
                        because a segment has an edge cell of its own at least at every
                        RS_HOUGH_GAP + 1 steps */
    uint32_t unused;
} rs_direction_bin;

#define RS_DIRECTION_LONG 1023u /* cells */

RS_STATIC_ASSERT(sizeof(rs_direction_bin) == ROOMSEG_DIRECTION_BIN_BYTES, direction_bin);

/* bins: ROOMSEG_DIRECTION_BINS elements, one a degree. */
void rs_direction_clear(rs_direction_bin *bins);

/* Adds a segment. */
void rs_direction_add(rs_direction_bin *bins, const rs_line *line);

/* The mean direction, by weight, of the segments in those 2 * RS_DIRECTION_HALF_WINDOW + 1
 * adjacent bins that hold the greatest length; of several such windows the first. In
 * hundredths of a degree, -4500..4499; 0 for an empty histogram. */
int32_t rs_direction_find(const rs_direction_bin *bins);

#endif
