/* The robot's map: scans are laid into a grid at the places where the robot believes to
 * be, which drifts away from where it is. */
#ifndef ROOMSEG_SIMULATE_SLAM_H
#define ROOMSEG_SIMULATE_SLAM_H

#include <stdint.h>

#include "lidar.h"
#include "rng.h"
#include "world.h"

#define WARP_STEP 256 /* mesh of the warp [cm] */

/* Cells that no beam has crossed. */
#define SLAM_UNKNOWN 128

/* Cells up to this value count as free: a quarter of full occupancy. */
#define SLAM_FREE 63

typedef struct slam {
    int width, height; /* cells */
    int resolution_mm;
    uint8_t *cells;   /* 0 free .. 255 occupied; owned */
    uint8_t *truth;   /* room in which most beams really were when they crossed the cell */
    uint8_t *weights; /* lead of that room over all others, 255 at most */
    /* How the world lies in the grid: turned around its centre ... */
    int32_t turn;              /* clockwise, see turn.h */
    int64_t cos_turn, sin_turn;
    int32_t centre_x, centre_y; /* of the world [cm] */
    /* ... and warped: what mapping gets wrong for good, by place. */
    int warp_columns, warp_rows;
    int32_t (*warp)[2]; /* displacement of each node [1/65536 cm]; owned */
    /* What it gets wrong for a while. */
    int32_t drift_x, drift_y; /* [1/65536 cm] */
    int32_t drift_turn;
    int noise;
    rng r;
} slam;

/* turn: how far the flat is turned in the grid, clockwise. noise: see lidar_measure.
 * Returns 0, or -1 without memory. */
int slam_make(slam *s, const world *w, int resolution_mm, int32_t turn, int noise, rng r);
void slam_free(slam *s);

/* One turn of the laser at (x, y) [cm]. */
void slam_scan(slam *s, const world *w, int x, int y);

/* Takes the true room from the cells that are not free in the map. */
void slam_finish_truth(slam *s);

/* The cell in which the robot believes to be at (x, y) [cm], without passing drift. */
void slam_cell_of(const slam *s, int x, int y, int *column, int *row);

#endif
