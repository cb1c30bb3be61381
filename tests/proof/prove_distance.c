#include "../../src/base.c"
#include "../../src/distance.c"
#include "proof.h"

/* Columns of a bordered row, heights the squares of 0..255, that is, at most 65025. */
static rs_basin any_basin(void)
{
    uint32_t vertical = nondet_u8();
    rs_basin b = {nondet_u16(), nondet_u16(), 0, (uint16_t)(vertical * vertical)};
    ASSUME(b.first <= b.last && b.last <= 65534u);
    return b;
}

/* Columns up to 65534, the last one of the widest bordered row. Its value is tried out in
 * tests/proof/exhaust.c. */
void prove_crossing(void)
{
    rs_basin a = any_basin(), b = any_basin();
    ASSUME(a.last < b.first);
    uint32_t from = crossing(&a, &b);
    PROVE(from <= b.last + 32768u + 65025u);
}
