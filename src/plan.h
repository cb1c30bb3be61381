/* The memory plan at run time; the tables themselves are in roomseg/plan.h. */
#ifndef RS_PLAN_H
#define RS_PLAN_H

#include "base.h"

/* Buffers of the default profile. */
#define RS_PLAN_NAME(S, name, element, count, first, last) RS_BUFFER_##name,
enum rs_buffer {
    ROOMSEG_PLAN_TABLE(RS_PLAN_NAME, , 0, 0, 0, 0, 0) RS_BUFFER_COUNT
};
#undef RS_PLAN_NAME

#define RS_PLAN_MAX_BUFFERS 32u

/* One line of a table. */
typedef struct rs_plan_row {
    size_t bytes;
    int first, last; /* stages in which the buffer is alive */
} rs_plan_row;

/* Where each buffer lies in the arena. */
typedef struct rs_plan {
    size_t offset[RS_PLAN_MAX_BUFFERS]; /* bytes, multiples of 8 */
    size_t size;                        /* bytes of the whole arena */
} rs_plan;

/* Stacks what the last stage needs downwards from the arena's end, everything else upwards from
 * its start; each buffer beyond those above it in the table with which it shares an end and a
 * stage. The size is what the macros of roomseg/plan.h compute, the most that any one stage has
 * alive. The tables are ordered so that the stacks have no gaps, and never meet (tested). */
void rs_plan_place(const rs_plan_row *rows, uint32_t count, rs_plan *plan);

/* The default profile's plan. The numbers must have been checked: width, height in
 * 1..ROOMSEG_MAX_SIDE, at most ROOMSEG_MAX_CROP_CELLS cells. */
void rs_plan_default(const roomseg_config *config, uint32_t width, uint32_t height,
                     uint32_t resolution_mm, rs_plan *plan);

#endif
