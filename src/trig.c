#include "trig.h"

#define QUADRANT (90 * RS_DEGREE)

/* pi / 18000 * 2^38: hundredths of a degree -> radians */
#define RADIAN_Q38 47975245u

/* 1 - z / divisor * rest, all Q30; z / divisor <= 1 and 0 <= rest <= 1. */
static uint32_t taylor_step(uint32_t z, uint32_t divisor, uint32_t rest)
{
    return (uint32_t)RS_TRIG_ONE - (uint32_t)(((uint64_t)(z / divisor) * rest) >> 30);
}

/* Taylor series in nested form; angle in 0..45 degrees, so x <= pi/4 and the first term
 * left out is below 2^-28. */
static rs_direction first_octant(uint32_t angle)
{
    uint32_t x = (uint32_t)(((uint64_t)angle * RADIAN_Q38 + 128u) >> 8);
    uint32_t z = (uint32_t)(((uint64_t)x * x) >> 30);
    uint32_t s = (uint32_t)RS_TRIG_ONE, c = (uint32_t)RS_TRIG_ONE;
    rs_direction d;

    s = taylor_step(z, 72u, s);
    s = taylor_step(z, 42u, s);
    s = taylor_step(z, 20u, s);
    s = taylor_step(z, 6u, s);
    c = taylor_step(z, 90u, c);
    c = taylor_step(z, 56u, c);
    c = taylor_step(z, 30u, c);
    c = taylor_step(z, 12u, c);
    c = taylor_step(z, 2u, c);
    d.sin = (int32_t)(((uint64_t)x * s) >> 30);
    d.cos = (int32_t)c;
    return d;
}

static rs_direction first_quadrant(uint32_t angle)
{
    rs_direction d, mirrored;

    if (angle <= QUADRANT / 2) {
        return first_octant(angle);
    }
    mirrored = first_octant(QUADRANT - angle);
    d.cos = mirrored.sin;
    d.sin = mirrored.cos;
    return d;
}

rs_direction rs_trig_direction(int32_t angle)
{
    uint32_t positive = (uint32_t)(angle + 8 * QUADRANT) % (4u * QUADRANT);
    uint32_t quarter_turns = positive / QUADRANT;
    rs_direction d = first_quadrant(positive % QUADRANT);

    for (; quarter_turns > 0u; quarter_turns--) {
        int32_t sin = d.cos;
        d.cos = -d.sin;
        d.sin = sin;
    }
    return d;
}

/* Greatest angle of 0..45 degrees that is not steeper than low / high; low <= high. */
static int32_t octant_angle(uint32_t low, uint32_t high)
{
    uint32_t angle = 0;

    for (uint32_t step = 4096u; step > 0u; step >>= 1) {
        if (angle + step <= QUADRANT / 2) {
            rs_direction d = first_octant(angle + step);
            if ((uint64_t)(uint32_t)d.sin * high <= (uint64_t)(uint32_t)d.cos * low) {
                angle += step;
            }
        }
    }
    return (int32_t)angle;
}

int32_t rs_trig_angle(int32_t x, int32_t y)
{
    uint32_t width = x < 0 ? (uint32_t)-x : (uint32_t)x;
    uint32_t height = y < 0 ? (uint32_t)-y : (uint32_t)y;
    int32_t angle;

    if (width == 0u && height == 0u) {
        return 0;
    }
    angle = height <= width ? octant_angle(height, width)
                            : QUADRANT - octant_angle(width, height);
    angle = x < 0 ? 2 * QUADRANT - angle : angle;
    return y < 0 ? -angle : angle;
}
