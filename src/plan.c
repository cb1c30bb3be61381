#include "plan.h"

static size_t end_of(const rs_plan *plan, const rs_plan_row *rows, uint32_t i)
{
    return plan->offset[i] + ROOMSEG_PLAN_ALIGN(rows[i].bytes);
}

void rs_plan_place(const rs_plan_row *rows, uint32_t count, rs_plan *plan)
{
    plan->size = 0;
    for (uint32_t i = 0; i < count; i++) {
        size_t offset = 0;
        for (uint32_t j = 0; j < i; j++) {
            if (rows[j].first <= rows[i].last && rows[i].first <= rows[j].last &&
                end_of(plan, rows, j) > offset) {
                offset = end_of(plan, rows, j);
            }
        }
        plan->offset[i] = offset;
        if (end_of(plan, rows, i) > plan->size) {
            plan->size = end_of(plan, rows, i);
        }
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
