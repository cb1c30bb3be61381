/* A turned coordinate system to draw things in: u along the thing, v a quarter turn
 * clockwise from u. */
#ifndef ROOMSEG_SIMULATE_FRAME_H
#define ROOMSEG_SIMULATE_FRAME_H

#include "world.h"

typedef struct frame {
    int32_t x, y;   /* origin in the world, in 1/16 cm */
    int32_t ux, uy; /* direction of u, times 65536 */
} frame;

/* Origin in cm, angle as in turn.h. */
frame frame_at(int x, int y, int32_t angle);

/* Draws the rectangle u0..u1, v0..v1 [cm], u0 < u1 and v0 < v1; room numbers are kept. */
void frame_box(world *w, const frame *f, int u0, int v0, int u1, int v1, material m);

/* Draws a disc around (u, v) [cm]. */
void frame_disc(world *w, const frame *f, int u, int v, int radius, material m);

/* The frame at (u, v) of this one, turned by angle against it. */
frame frame_inside(const frame *f, int u, int v, int32_t angle);

#endif
