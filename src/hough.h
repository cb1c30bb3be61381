/* Alignment, step 2: straight lines among the edge cells.
 * Progressive probabilistic Hough transform: J. Matas, C. Galambos, J. Kittler, "Robust
 * detection of lines using the progressive probabilistic Hough transform", 2000. Cells vote
 * in random order; as soon as a line has enough votes it is followed through the edges and
 * its cells are taken away. The random order is the same in every run. */
#ifndef RS_HOUGH_H
#define RS_HOUGH_H

#include "base.h"

/* Votes that a line needs, least extent of a segment along x or y, and longest gap in it
 * [cells]. In cells at every resolution: how exact a direction is depends on them alone. */
#define RS_HOUGH_VOTES 20u
#define RS_HOUGH_LENGTH 10u
#define RS_HOUGH_GAP 5u

/* End cells of a segment, crop coordinates. */
typedef struct rs_line {
    uint16_t x0, y0, x1, y1;
} rs_line;

/* Normal of the lines of one column of the accumulator, Q14. */
typedef struct rs_normal {
    int16_t cos, sin;
} rs_normal;

RS_STATIC_ASSERT(sizeof(rs_normal) == ROOMSEG_NORMAL_BYTES, normal);

typedef struct rs_hough {
    const rs_frame *frame;
    uint8_t *edges;
    uint32_t *points;
    uint32_t left, total; /* points that have not been drawn yet; all */
    uint16_t *votes;      /* by angle of the normal, then by distance from the crop's middle */
    rs_normal *normals;
    uint32_t distances;   /* of them for each angle */
    uint32_t random;
} rs_hough;

/* edges: bordered, 1 on edge cells, else 0; is used up.
 * points: the point_count edge cells, packed; is used up.
 * votes: scratch, ROOMSEG_HOUGH_ANGLES * ROOMSEG_PLAN_DISTANCES(width, height) elements.
 * normals: scratch, ROOMSEG_HOUGH_ANGLES elements. */
void rs_hough_init(rs_hough *hough, const rs_frame *frame, uint8_t *edges, uint32_t *points,
                   uint32_t point_count, uint16_t *votes, rs_normal *normals);

/* The next segment; *found is false when there are no more. Fails iff cancelled. */
int rs_hough_next(rs_hough *hough, rs_line *line, bool *found, rs_ticker *ticker);

#endif
