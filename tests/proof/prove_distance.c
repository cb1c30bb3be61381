#include "../../src/distance.c"
#include "proof.h"

/* Heights are squares of 0..255. */
static rs_parabola any_parabola(void)
{
    uint32_t vertical = nondet_u8();
    rs_parabola p = {nondet_u16(), nondet_u16(), vertical * vertical};
    return p;
}

/* Columns up to 65534, the last one of the widest bordered row. */
void prove_crossing(void)
{
    rs_parabola a = any_parabola(), b = any_parabola();
    ASSUME(a.x < b.x && b.x <= 65534u);
    uint32_t from = crossing(&a, &b);
    PROVE(from <= b.x + 32768u + 65025u);
}
