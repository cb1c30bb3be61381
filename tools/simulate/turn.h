/* Angles and their sines in integers. A turn is 65536 units; angles grow from the x axis
 * to the y axis, which points down as in images: clockwise to the eye. */
#ifndef ROOMSEG_SIMULATE_TURN_H
#define ROOMSEG_SIMULATE_TURN_H

#include <stdint.h>

#define TURN_FULL 65536
#define TURN_QUARTER 16384
#define TURN_DEGREES(d) ((d) * TURN_FULL / 360)

/* Sine and cosine times 65536, exact to +-1; any angle. */
int32_t turn_sin(int32_t angle);
int32_t turn_cos(int32_t angle);

#endif
