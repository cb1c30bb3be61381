/* The cost of each stage of a run. */
#ifndef ROOMSEG_TOOLS_STAGE_COSTS_H
#define ROOMSEG_TOOLS_STAGE_COSTS_H

#include <stdint.h>

#include "roomseg/roomseg.h"

typedef struct stage_costs {
    double ms[ROOMSEG_STAGE_COUNT];       /* CPU time, median of the repetitions */
    uint64_t visits[ROOMSEG_STAGE_COUNT]; /* of cells, at most 65,536 too few */
} stage_costs;

#endif
