/* Sine, cosine and direction of a vector in integers.
 * Angles are in hundredths of a degree and grow from the x axis towards the y axis, that
 * is, clockwise in a grid whose y axis points down. */
#ifndef RS_TRIG_H
#define RS_TRIG_H

#include <stdint.h>

#define RS_DEGREE 100
#define RS_TRIG_ONE (INT32_C(1) << 30) /* 1.0 */

/* A direction as a unit vector, Q30. */
typedef struct rs_direction {
    int32_t cos, sin; /* -RS_TRIG_ONE..RS_TRIG_ONE */
} rs_direction;

/* For any angle in -720..720 degrees. Error of either part: below 2^-27; multiples of 90
 * degrees are exact. */
rs_direction rs_trig_direction(int32_t angle);

/* Direction of the vector (x, y), -18000..18000; 0 for (0, 0). Error: below 0.011 degrees,
 * towards the nearest axis; directions along the axes are exact. |x|, |y| < 2^31. */
int32_t rs_trig_angle(int32_t x, int32_t y);

#endif
