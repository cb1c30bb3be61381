/* The region graph drawn over the regions. */
#ifndef ROOMSEG_EXPLAIN_GRAPH_PICTURE_H
#define ROOMSEG_EXPLAIN_GRAPH_PICTURE_H

#include "observe.h"
#include "picture.h"

/* Which edges, and how an edge looks. */
typedef struct edge_style {
    double thickness; /* [px], 0: not drawn */
    color paint;
} edge_style;

typedef edge_style (*edge_look)(const void *user, uint32_t edge);

/* Draws edges from the one region's peak to the other's by way of the opening, and a dot on
 * each region with an area in proportion to the region's.
 * graph: o->before, or o->after, where the roots stand for what was merged. */
void draw_graph(const observation *o, const rs_graph *graph, const view *v, edge_look look,
                const void *user, canvas *c);

#endif
