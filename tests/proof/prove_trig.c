#include "../../src/trig.c"
#include "proof.h"

/* Every angle up to two turns either way is one octant mirrored, and those are all tried. */
void prove_direction(void)
{
    int32_t angle = nondet_i32();
    ASSUME(angle >= -72000 && angle <= 72000);
    rs_direction d = rs_trig_direction(angle);
    PROVE(d.cos >= -RS_TRIG_ONE && d.cos <= RS_TRIG_ONE);
    PROVE(d.sin >= -RS_TRIG_ONE && d.sin <= RS_TRIG_ONE);
}

void prove_angle(void)
{
    int32_t x = nondet_i32(), y = nondet_i32();
    ASSUME(x > INT32_MIN && y > INT32_MIN);
    int32_t angle = rs_trig_angle(x, y);
    PROVE(angle >= -18000 && angle <= 18000);
}
