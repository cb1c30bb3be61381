/* Grids turned about their middle, for tests of alignment. */
#ifndef SUPPORT_TURN_H
#define SUPPORT_TURN_H

#include "roomseg/roomseg.h"

/* The grid turned from the x axis towards the y axis (clockwise on screen) by any angle, large
 * enough to hold all of it; nearest cells, 127 where nothing was. Its cells are to be freed:
 * free((void *)turned.cells). */
roomseg_grid turn_grid(const roomseg_grid *grid, double degrees);

/* The signed difference between two directions that are the same after each `period`
 * [degrees], at most half a period either way. */
double turn_difference(double a, double b, double period);

#endif
