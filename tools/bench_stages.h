/* The cost of each stage over a set of maps. */
#ifndef ROOMSEG_TOOLS_BENCH_STAGES_H
#define ROOMSEG_TOOLS_BENCH_STAGES_H

#include <stdio.h>

#include "bench_result.h"

/* A table: mean of the set's maps; nothing when the stages were not measured. */
void bench_stages_print(FILE *out, const set_result *set);

#endif
