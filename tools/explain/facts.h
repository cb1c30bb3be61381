/* What came out of the stages, in numbers; and the colours that stand for them. */
#ifndef ROOMSEG_EXPLAIN_FACTS_H
#define ROOMSEG_EXPLAIN_FACTS_H

#include "colors.h"
#include "explanation.h"

/* Colour of the edges that a rule joins. */
color rule_paint(int rule);

/* Colour of what was dropped; of a fate other than FATE_ROOM. */
color dropped_paint(fate f);

/* The greatest value of a plane; of the ridge map's free cells. */
double plane_most(const observation *o, int plane);

/* Cells with a free one (1) before and another after, or the other way round. */
typedef struct change {
    uint64_t cells, parts; /* parts: 8-connected */
} change;

/* What became an obstacle or became free between PLANE_FREE and PLANE_CLEARED.
 * Returns 0, or -1 when memory runs out. */
int count_change(const observation *o, int became_free, change *out);

/* Cells of the map's crop of each kind. */
typedef struct cell_counts {
    uint64_t free, unsure, occupied;
} cell_counts;

cell_counts count_cells(const explanation *e);

/* Cells with this label. */
uint64_t count_label(const observation *o, int labels, uint16_t label);

/* Edges of the graph before merging. */
typedef struct edge_counts {
    uint32_t touching, walled;   /* pairs that touch; pairs that share a wall */
    uint32_t long_walled;        /* ... of at least shared_wall_mm */
    uint32_t by_rule[JOIN_COUNT]; /* pairs that touch, by the rule that joins them */
    uint32_t long_border;        /* paper profile: longer than longest_border_mm */
} edge_counts;

edge_counts count_edges_of(const explanation *e);

#endif
