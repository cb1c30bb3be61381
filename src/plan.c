#include "plan.h"

/* Bytes that are alive in a stage. */
static size_t alive_in(const rs_plan_row *rows, uint32_t count, int stage)
{
    size_t bytes = 0;

    for (uint32_t i = 0; i < count; i++) {
        if (rows[i].first <= stage && stage <= rows[i].last) {
            bytes += ROOMSEG_PLAN_ALIGN(rows[i].bytes);
        }
    }
    return bytes;
}

/* The most bytes that rows above row i, of the same end of the arena and alive with it, reach
 * from that end. */
static size_t reach_above(const rs_plan_row *rows, const rs_plan *plan, uint32_t i, int last)
{
    size_t most = 0;

    for (uint32_t j = 0; j < i; j++) {
        bool same_end = (rows[j].last == last) == (rows[i].last == last);

        if (same_end && rows[j].first <= rows[i].last && rows[i].first <= rows[j].last) {
            size_t reach = rows[j].last == last
                               ? plan->size - plan->offset[j]
                               : plan->offset[j] + ROOMSEG_PLAN_ALIGN(rows[j].bytes);
            most = ROOMSEG_PLAN_MAX(most, reach);
        }
    }
    return most;
}

void rs_plan_place(const rs_plan_row *rows, uint32_t count, rs_plan *plan)
{
    int last = 0;

    plan->size = 0;
    for (uint32_t i = 0; i < count; i++) {
        plan->size = ROOMSEG_PLAN_MAX(plan->size, alive_in(rows, count, rows[i].first));
        last = ROOMSEG_PLAN_MAX(last, rows[i].last);
    }
    for (uint32_t i = 0; i < count; i++) {
        size_t before = reach_above(rows, plan, i, last);

        plan->offset[i] = rows[i].last == last
                              ? plan->size - before - ROOMSEG_PLAN_ALIGN(rows[i].bytes)
                              : before;
    }
}

void rs_plan_default(const roomseg_config *config, uint32_t width, uint32_t height,
                     uint32_t resolution_mm, rs_plan *plan)
{
    size_t small = ROOMSEG_PLAN_SMALL(config->speck_mm2, config->clutter_mm, resolution_mm);
#define ROW(S, name, element, count, first, last) {(element) * (count), first, last},
    const rs_plan_row rows[RS_BUFFER_COUNT] = {ROOMSEG_PLAN_TABLE(
        ROW, , width, height, small, config->max_regions, config->max_rooms)};
#undef ROW

    rs_plan_place(rows, RS_BUFFER_COUNT, plan);
}
