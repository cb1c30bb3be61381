/* Stage 6: regions -> rooms. */
#ifndef RS_MERGE_H
#define RS_MERGE_H

#include "base.h"
#include "graph.h"
#include "heap.h"

/* The config's rules in cells. */
typedef struct rs_merge_rules {
    uint32_t smallest_cells;         /* smaller regions never stand alone */
    uint32_t niche_cells;            /* smaller regions stand alone only behind a narrowing */
    uint32_t room_opening_percent;   /* 1..100 */
    uint32_t passage_opening_percent;
    uint32_t teeth_cells;            /* up to here a wall may be the teeth of one that is askew */
    uint32_t shared_wall_cells;      /* from here on two regions stay apart */
    uint32_t passage_min_neighbours; /* 2..RS_MERGE_MAX_NEIGHBOURS */
    /* The rest holds where furniture makes narrow places, so that walls have to decide. */
    bool lived_in;
    uint32_t open_plan_percent; /* 1..100 */
    uint32_t no_wall_cells;     /* at most this much shared wall is none */
    uint32_t stub_cells;        /* from here on a wall can hold a door */
    uint32_t door_cells;        /* longer borders are no doors */
} rs_merge_rules;

#define RS_MERGE_MAX_NEIGHBOURS 8u

/* Merges regions, the best opening first, then lets the small ones join the neighbour with
 * the widest opening, smallest first. Only the regions' parent, area, peak and first_cell
 * change; roots stand for what was merged.
 * heap: max_regions * 3 elements of scratch. */
int rs_merge_run(const rs_merge_rules *rules, rs_graph *graph, rs_heap_item *heap,
                 rs_ticker *ticker);

#endif
