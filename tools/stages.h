/* What each stage of a run costs, seen through the progress hook: the library itself does not
 * measure. */
#ifndef ROOMSEG_TOOLS_STAGES_H
#define ROOMSEG_TOOLS_STAGES_H

#include "map.h"
#include "segment.h"
#include "stage_costs.h"

/* CPU time of the calling thread [ms]: a monotonic clock that stands while other threads and
 * programs have the core. */
double stages_cpu_ms(void);

/* Runs the map `repetitions` times more and measures its stages. repetitions: at least 1.
 * Returns 0; a roomseg_status; or 1 when memory runs out. */
int stages_measure(const map *m, segmentation *s, int repetitions, stage_costs *out);

#endif
