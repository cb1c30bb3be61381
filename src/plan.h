/* The memory plan at run time; the table itself is in roomseg/plan.h. */
#ifndef RS_PLAN_H
#define RS_PLAN_H

#include "base.h"

#define RS_PLAN_NAME(S, name, element, count, first, last) RS_BUFFER_##name,
enum rs_buffer {
    ROOMSEG_PLAN_TABLE(RS_PLAN_NAME, , 0, 0, 0, 0, 0) RS_BUFFER_COUNT
};
#undef RS_PLAN_NAME

/* Where each buffer lies in the arena. */
typedef struct rs_plan {
    size_t offset[RS_BUFFER_COUNT]; /* bytes, multiples of 8 */
    size_t size;                    /* bytes of the whole arena */
} rs_plan;

/* Places the buffers for a crop of width x height cells. The numbers must have been
 * checked: width, height in 1..ROOMSEG_MAX_SIDE, at most ROOMSEG_MAX_CROP_CELLS cells. */
void rs_plan_make(const roomseg_config *config, uint32_t width, uint32_t height,
                  uint32_t resolution_mm, rs_plan *plan);

#endif
