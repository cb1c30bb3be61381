#include "plan_paper.h"

RS_STATIC_ASSERT((int)RS_PAPER_COUNT <= (int)RS_PLAN_MAX_BUFFERS, paper_buffers);

void rs_plan_paper(const roomseg_config *config, uint32_t width, uint32_t height,
                   uint32_t resolution_mm, rs_plan *plan)
{
    size_t small = ROOMSEG_PLAN_SMALL(config->speck_mm2, config->clutter_mm, resolution_mm);
#define ROW(S, name, element, count, first, last) {(element) * (count), first, last},
    const rs_plan_row rows[RS_PAPER_COUNT] = {ROOMSEG_PLAN_PAPER_TABLE(
        ROW, , width, height, small, config->max_regions, config->max_rooms)};
#undef ROW

    rs_plan_place(rows, RS_PAPER_COUNT, plan);
}
