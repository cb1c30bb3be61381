/* The paper profile's memory plan at run time; the table is in roomseg/plan_paper.h. */
#ifndef RS_PLAN_PAPER_H
#define RS_PLAN_PAPER_H

#include "plan.h"

#define RS_PLAN_PAPER_NAME(S, name, element, count, first, last) RS_PAPER_##name,
enum rs_paper_buffer {
    ROOMSEG_PLAN_PAPER_TABLE(RS_PLAN_PAPER_NAME, , 0, 0, 0, 0, 0) RS_PAPER_COUNT
};
#undef RS_PLAN_PAPER_NAME

/* As rs_plan_default. */
void rs_plan_paper(const roomseg_config *config, uint32_t width, uint32_t height,
                   uint32_t resolution_mm, rs_plan *plan);

#endif
