/* The region graph while regions are merged: clusters of regions, each with a root. A root's
 * record and list of half-edges stand for the whole cluster. */
#ifndef RS_CLUSTER_H
#define RS_CLUSTER_H

#include "graph.h"

/* The root of a region's cluster. */
uint16_t rs_cluster_root(rs_region *regions, uint16_t region);

/* Joins two different roots and returns the one that remains, the larger. Its area, border
 * and walls become the sums, its peak the greater one. */
uint16_t rs_cluster_unite(rs_graph *graph, uint16_t p, uint16_t q);

/* Steps from half-edge `half` of a root's list to the next one that leads to another root;
 * takes those that have become internal out of the list. RS_NO_HALF: none is left. */
uint32_t rs_cluster_next(rs_graph *graph, uint16_t root, uint32_t half);

/* The first half-edge of a root that leads to another root, to start a walk with; a walk has
 * ended when it is met again. RS_NO_HALF: there is none. */
uint32_t rs_cluster_first(rs_graph *graph, uint16_t root);

#endif
