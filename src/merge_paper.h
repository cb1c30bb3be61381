/* The three merging rules of the paper's system. */
#ifndef RS_MERGE_PAPER_H
#define RS_MERGE_PAPER_H

#include "base.h"
#include "graph.h"
#include "heap.h"

typedef struct rs_merge_paper_rules {
    uint32_t smallest_cells;    /* A0: smaller regions never stand alone */
    uint32_t isolated_permille; /* ... nor do isolated ones below this share of the whole */
    uint32_t longest_border;    /* L0 [cells]: longer borders are no borders */
} rs_merge_paper_rules;

/* Rule 1: a region without neighbour that is smaller than A0 or than its share of the whole
 * area goes (area 0). Rule 2: a region smaller than A0 joins the neighbour with which it
 * shares the longest border; those with the fewest neighbours come first, then the smaller
 * ones. Both rules until neither applies. Rule 3: the longest border beyond L0 is opened, and
 * again. Where regions merge, their borders with a common neighbour add up.
 * Areas of borders do not count. Borders move to one edge of each pair of roots; the others'
 * become 0.
 * heap: heap_items elements, as many as there are regions or edges at least; marks:
 * region_count + 1. Fails iff cancelled. */
int rs_merge_paper_run(const rs_merge_paper_rules *rules, rs_graph *graph, rs_heap_item *heap,
                       uint32_t heap_items, uint32_t *marks, rs_ticker *ticker);

#endif
