/* Where the robot drives: it covers the floor that it can reach, always going to the
 * nearest place where it has not been. */
#ifndef ROOMSEG_SIMULATE_DRIVE_H
#define ROOMSEG_SIMULATE_DRIVE_H

#include <stddef.h>
#include <stdint.h>

#include "rng.h"
#include "world.h"

/* Places where the robot takes a scan, in the order of its way. */
typedef struct route {
    int (*stops)[2]; /* x, y [cm]; owned */
    size_t count;
    uint8_t visited[256]; /* visited[room] = 1 when the robot has been in the room */
} route;

/* Starts at a random place of the largest floor that is connected for a robot of 17 cm
 * radius. Returns 0, or -1 without memory; a world without floor gives an empty route. */
int drive_cover(const world *w, rng *r, route *out);
void drive_free(route *way);

#endif
