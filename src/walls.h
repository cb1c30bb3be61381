/* How much of a region's border is walls: what was only seen through a window has few. */
#ifndef RS_WALLS_H
#define RS_WALLS_H

#include "graph.h"

/* The map's whole border, to compare regions with. */
typedef struct rs_map_border {
    uint32_t faces, walls; /* sums of the regions' border and walls, or their ratio: < 2^22 */
} rs_map_border;

rs_map_border rs_walls_of_map(const rs_graph *graph);

/* Maps whose border is walls by less than this do not mark their walls. */
#define RS_MARKED_WALLS_PERCENT 35u

/* Whether walls make up less of a region's border than permille/1000 of what they make up of
 * the map's. On a map that does not mark its walls nothing can be told: false. */
bool rs_walls_are_few(const rs_map_border *map, const rs_region *region, uint32_t permille);

#endif
