#include "../../src/components.c"
#include "proof.h"

void prove_add_area(void)
{
    uint32_t a = nondet_u32(), b = nondet_u32();
    ASSUME(a <= RS_COMPONENT_OPEN && b <= RS_COMPONENT_OPEN);
    PROVE(add_area(a, b) <= RS_COMPONENT_OPEN);
}

/* Any row of eight cells: the runs are maximal, in order, and as few as the plan says. */
void prove_runs(void)
{
    enum { WIDTH = 8 };
    uint8_t row[WIDTH + 1u];
    rs_run runs[(WIDTH + 1u) / 2u];
    for (uint32_t x = 0; x < WIDTH; x++) {
        row[x] = nondet_u8() & 1u;
    }
    uint32_t count = find_runs(row, WIDTH, 1, runs);
    PROVE(count <= ROOMSEG_PLAN_RUNS(WIDTH - 2u));
    uint32_t x = nondet_u8(), inside = 0;
    ASSUME(x < WIDTH);
    for (uint32_t i = 0; i < count; i++) {
        PROVE(runs[i].first <= runs[i].last && runs[i].last < WIDTH);
        PROVE(i == 0u || runs[i].first > runs[i - 1u].last + 1u);
        inside += runs[i].first <= x && x <= runs[i].last;
    }
    PROVE(inside == row[x]);
}
