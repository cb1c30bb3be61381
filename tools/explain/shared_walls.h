/* Where the walls are that two regions share. */
#ifndef ROOMSEG_EXPLAIN_SHARED_WALLS_H
#define ROOMSEG_EXPLAIN_SHARED_WALLS_H

#include "observe.h"

enum { WALL_NONE, WALL_SHORT, WALL_LONG };

/* Marks the obstacle cells that a row or a column crosses on its way from one region to
 * another within RS_GRAPH_WALL_MM, which is what rs_graph_build counts.
 * walls: width * height of the crop, 0 on entry; WALL_LONG where the two regions share
 * `keeps_apart` cells of wall or more, else WALL_SHORT.
 * crossings: how many rows and columns cross; the sum of `wall` over all edges.
 * Returns 0, or -1 when memory runs out. */
int shared_walls_mark(const observation *o, uint32_t keeps_apart, uint8_t *walls,
                      uint64_t *crossings);

#endif
