#include "../../src/distance.c"
#include "proof.h"

/* Heights are squares of 0..255. */
static rs_parabola any_parabola(void)
{
    uint32_t vertical = nondet_u8();
    rs_parabola p = {nondet_u16(), nondet_u16(), vertical * vertical};
    return p;
}

static uint32_t value_at(const rs_parabola *p, uint32_t x)
{
    uint32_t offset = x > p->x ? x - p->x : p->x - x;
    return offset * offset + p->height;
}

/* Columns up to 65534, the last one of the widest bordered row. */
void prove_crossing(void)
{
    rs_parabola a = any_parabola(), b = any_parabola();
    ASSUME(a.x < b.x && b.x <= 65534u);
    uint32_t from = crossing(&a, &b);
    PROVE(from <= b.x + 32768u + 65025u);
}

/* In rows of up to 16 columns the crossing is the first column where b lies below a. */
void prove_crossing_value(void)
{
    rs_parabola a = any_parabola(), b = any_parabola();
    uint32_t x = nondet_u8();
    ASSUME(a.x < b.x && b.x < 16u && x < 16u && a.height < 256u && b.height < 256u);
    bool below = value_at(&b, x) < value_at(&a, x);
    PROVE(below == (x >= crossing(&a, &b)));
}

void prove_levels(void)
{
    uint32_t least[RS_DISTANCE_MAX + 1u];
    uint32_t mm = nondet_u32(), level = nondet_u8();
    ASSUME(mm >= 20u && mm <= 200u && level > 0u);
    make_levels(mm, least);
    PROVE(least[level] > least[level - 1u] && least[level] <= 260100u);
}

/* Any row of 8 cells, any distances in it: within bounds, levels 1..255. */
void prove_run(void)
{
    enum { LAST = 7 };
    uint8_t row[LAST + 2u];
    rs_parabola envelope[LAST + 2u];
    uint32_t least[RS_DISTANCE_MAX + 1u];
    const rs_distance_scratch scratch = {envelope, least};
    make_levels(50, least);
    for (uint32_t x = 0; x < LAST + 2u; x++) {
        row[x] = x == 0u || x > LAST ? 0u : nondet_u8();
        ASSUME(x == 0u || x > LAST || (row[x] >= 1u && row[x] <= 4u));
    }
    transform_run(row, 1, LAST, &scratch);
    for (uint32_t x = 1; x <= LAST; x++) {
        PROVE(row[x] >= 1u);
    }
}
