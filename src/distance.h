/* Stage 3: distance of each free cell to the nearest obstacle. */
#ifndef RS_DISTANCE_H
#define RS_DISTANCE_H

#include "base.h"

/* A candidate of the lower envelope of parabolas over one row. */
typedef struct rs_parabola {
    uint16_t x;     /* column of its lowest point */
    uint16_t from;  /* first column where it is the lowest of all */
    uint32_t height; /* its lowest value: squared vertical distance [cells^2] */
} rs_parabola;

RS_STATIC_ASSERT(sizeof(rs_parabola) == 8u, parabola);

/* surface: bordered, 0 = obstacle, else free; the border must be 0. Each free cell becomes
 * the Euclidean distance between its centre and the nearest obstacle cell's centre, rounded
 * down to whole cells, 1..RS_DISTANCE_MAX (saturating).
 * Exact up to the rounding. Separable lower envelope of parabolas: Meijster, Roerdink,
 * Hesselink, "A general algorithm for computing distance transforms in linear time", 2000.
 * envelope: frame->stride elements of scratch. */
#define RS_DISTANCE_MAX 255u

int rs_distance_run(const rs_frame *frame, uint8_t *surface, rs_parabola *envelope,
                    rs_ticker *ticker);

#endif
