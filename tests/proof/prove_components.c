#include "../../src/components.c"
#include "proof.h"

/* Union-find: after any five unions of six slots each find ends at a root, within five steps, and
 * areas add up. */
void prove_union_find(void)
{
    enum { SLOTS = 6, UNIONS = 5 };
    rs_component c[SLOTS];
    uint32_t total = 0, found = 0;
    for (uint16_t i = 0; i < SLOTS; i++) {
        uint32_t area = nondet_u32();
        ASSUME(area >= 1u && area <= RS_COMPONENT_OPEN / SLOTS);
        c[i] = (rs_component){area, i, i, i, i, i, i, i, 0};
        total += area;
    }
    for (uint32_t k = 0; k < UNIONS; k++) {
        uint16_t a = nondet_u8(), b = nondet_u8();
        ASSUME(a < SLOTS && b < SLOTS);
        uint16_t root = find_root(c, a);
        unite(c, root, find_root(c, b));
        PROVE(find_root(c, a) == find_root(c, b));
    }
    for (uint16_t i = 0; i < SLOTS; i++) {
        uint16_t root = find_root(c, i);
        PROVE(c[root].parent == root && c[root].min_x <= i && i <= c[root].max_x);
        found += c[i].parent == i ? c[i].area : 0u;
    }
    PROVE(found == total);
}

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
