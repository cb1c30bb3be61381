/* The rules of stage 6: which regions are one room. */
#ifndef RS_JOIN_H
#define RS_JOIN_H

#include "walls.h"

/* The config's rules in cells. */
typedef struct rs_join_rules {
    uint32_t smallest_cells;         /* smaller regions never stand alone */
    uint32_t niche_cells;            /* smaller regions stand alone only behind a narrowing */
    uint32_t room_opening_percent;   /* 1..100 */
    uint32_t passage_opening_percent;
    uint32_t teeth_cells;            /* up to here a wall may be the teeth of one that is askew */
    uint32_t shared_wall_cells;      /* from here on two regions stay apart */
    uint32_t passage_min_neighbours; /* 2..RS_JOIN_MAX_NEIGHBOURS */
    /* The rest holds where furniture makes narrow places, so that walls have to decide. */
    bool lived_in;
    uint32_t open_plan_percent; /* 1..100 */
    uint32_t no_wall_cells;     /* at most this much shared wall is none */
    uint32_t stub_cells;        /* from here on a wall can hold a door */
    uint32_t door_cells;        /* longer borders are no doors */
    uint32_t hall_cells;        /* what is at most that wide together is one hall */
    uint32_t unwalled_permille; /* regions with a smaller share of the map's walls ... */
    rs_map_border map_border;   /* ... in their border were seen through a window */
} rs_join_rules;

#define RS_JOIN_MAX_NEIGHBOURS 8u

/* How much two regions belong together, the roots at both ends of edge e as the graph stands: 0
 * when they stay apart, else the more, the earlier they are to be joined. With `hopeful` the
 * passage rule counts as met, which gives an upper bound without a look at neighbours. */
uint32_t rs_join_key(const rs_join_rules *rules, rs_graph *graph, uint32_t e, bool hopeful);

#endif
