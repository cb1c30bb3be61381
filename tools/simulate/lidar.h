/* A spinning laser as vacuum robots carry it: one beam a degree. */
#ifndef ROOMSEG_SIMULATE_LIDAR_H
#define ROOMSEG_SIMULATE_LIDAR_H

#include "rng.h"
#include "world.h"

#define LIDAR_BEAMS 360
#define LIDAR_MAX_MM 5500 /* nothing comes back from farther away */

/* Positions in the world [1/65536 cm], x right, y down. */
typedef struct position {
    int32_t x, y;
} position;

/* Sends one beam. noise: 0 = exact, 50 = as the real ones, 100 = twice that.
 * Returns the measured range in mm, or 0 when nothing came back. */
int32_t lidar_measure(const world *w, position from, int32_t angle, int noise, rng *r);

#endif
