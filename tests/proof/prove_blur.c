#include "../../src/blur.c"
#include "proof.h"

/* The box's weights, whatever the variance. */
void prove_box(void)
{
    uint32_t variance = nondet_u32();
    rs_box box = rs_box_of_variance(variance);
    PROVE(box.radius <= RS_BLUR_MAX_RADIUS);
    PROVE((2u * box.radius + 1u) * box.centre + 2u * box.end == 1u << 16);
}
