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

/* Weights that sum up to 2^16, shares of 16 bits: the weighed sum stays within 32 bits, and its
 * upper half within 16. */
void prove_weigh(void)
{
    rs_box box = {nondet_u32(), nondet_u32(), nondet_u32()};
    uint32_t sums[1] = {nondet_u32()};
    uint16_t first[1] = {nondet_u16()}, last[1] = {nondet_u16()}, out[1];
    ASSUME(box.radius <= RS_BLUR_MAX_RADIUS && box.centre <= 1u << 16 && box.end <= 1u << 15);
    ASSUME((2u * box.radius + 1u) * box.centre + 2u * box.end == 1u << 16);
    ASSUME(sums[0] <= (2u * box.radius + 1u) * 65535u);
    uint64_t exact = (uint64_t)box.centre * sums[0] +
                     (uint64_t)box.end * ((uint32_t)first[0] + last[0]) + (1u << 15);
    PROVE(exact <= UINT32_MAX);
    weigh(&box, sums, first, last, 1, out);
    PROVE(out[0] == exact >> 16);
}
