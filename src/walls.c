#include "walls.h"

rs_map_border rs_walls_of_map(const rs_graph *graph)
{
    uint64_t faces = 0, walls = 0;

    for (uint32_t r = 1; r <= graph->region_count; r++) {
        const rs_region *region = &graph->regions[r];
        if (region->parent == r && region->area > 0u) {
            faces += region->border;
            walls += region->walls;
        }
    }
    while (faces >= 1u << 22) {
        faces >>= 1;
        walls >>= 1;
    }
    return (rs_map_border){(uint32_t)faces, (uint32_t)walls};
}

bool rs_walls_are_few(const rs_map_border *map, const rs_region *region, uint32_t permille)
{
    /* A crop has fewer than 2^30 faces, so the products are below 2^62. */
    return map->walls * 100u >= map->faces * RS_MARKED_WALLS_PERCENT &&
           (uint64_t)region->walls * map->faces * 1000u <
               (uint64_t)region->border * map->walls * permille;
}
