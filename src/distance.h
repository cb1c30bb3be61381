/* Stage 3: distance of each free cell to the nearest obstacle. */
#ifndef RS_DISTANCE_H
#define RS_DISTANCE_H

#include "base.h"

/* A candidate of the lower envelope over one row: a run of equal vertical distances. Flat over
 * its columns, a parabola on both sides. */
typedef struct rs_basin {
    uint16_t first, last; /* its columns */
    uint16_t from;        /* first column where it is the lowest of all */
    uint16_t height;      /* its lowest value: squared vertical distance [cells^2] */
} rs_basin;

RS_STATIC_ASSERT(sizeof(rs_basin) == 8u, basin);

/* Distances are stored in steps of 40 mm: fine enough for doors, and 255 steps reach to
 * the middle of a hall of 20 m. */
#define RS_DISTANCE_UNIT_MM 40u
#define RS_DISTANCE_MAX 255u

typedef struct rs_distance_scratch {
    rs_basin *envelope; /* frame->stride */
    uint32_t *least;    /* RS_DISTANCE_MAX + 1 */
} rs_distance_scratch;

/* surface: bordered, 0 = obstacle, else free; the border must be 0. Each free cell becomes
 * the Euclidean distance from its centre to the nearest obstacle cell's centre, rounded down
 * to whole units of RS_DISTANCE_UNIT_MM, 1..RS_DISTANCE_MAX (both ends saturate).
 * Exact up to the rounding. Separable lower envelope of parabolas: Meijster, Roerdink,
 * Hesselink, "A general algorithm for computing distance transforms in linear time", 2000; here
 * one candidate for each run of equal vertical distances, of which rooms with straight walls have
 * few. */
int rs_distance_run(const rs_frame *frame, uint32_t resolution_mm, uint8_t *surface,
                    const rs_distance_scratch *scratch, rs_ticker *ticker);

#endif
