#include "../../src/join.c"
#include "proof.h"

/* Distances are 1..255 steps, and no saddle is higher than the peaks on its sides. */
void prove_openness(void)
{
    uint32_t saddle = nondet_u8(), p = nondet_u8(), q = nondet_u8(), percent = nondet_u8();
    ASSUME(saddle >= 1u && saddle <= p && saddle <= q && percent >= 1u && percent <= 100u);
    PROVE(openness(saddle, p, q, percent) <= OPENING_KEY * 10000u);
}

void prove_niche(void)
{
    uint32_t saddle = nondet_u8();
    rs_region region = {0};
    region.area = nondet_u32();
    region.peak = nondet_u8();
    ASSUME(saddle >= 1u && saddle <= region.peak);
    PROVE(niche_key(nondet_u32(), &region, saddle) <= OPENING_KEY / 2u);
}
