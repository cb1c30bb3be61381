/* Part of stage 6: what is free, but no room. */
#ifndef RS_DROP_H
#define RS_DROP_H

#include "graph.h"

/* Sets the area of roots to 0 that are no rooms: smaller than isolated_cells and touching no
 * other root, or seen through a window or door (see unwalled_percent in roomseg_config).
 * One pass over the regions and their edges. */
void rs_drop_run(uint32_t isolated_cells, uint32_t unwalled_percent, rs_graph *graph);

#endif
