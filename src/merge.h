/* Stage 6: regions -> rooms. */
#ifndef RS_MERGE_H
#define RS_MERGE_H

#include "base.h"
#include "heap.h"
#include "join.h"

/* Merges regions, the best opening first, then lets the small ones join the neighbour with
 * the widest opening, smallest first. Only the regions' parent, area, peak and first_cell
 * change; roots stand for what was merged.
 * heap: max_regions * 3 elements of scratch. */
int rs_merge_run(const rs_join_rules *rules, rs_graph *graph, rs_heap_item *heap,
                 rs_ticker *ticker);

#endif
