#include "drop.h"

#include "cluster.h"
#include "walls.h"

/* Whether a root touches another root, and not only through a wall. */
static bool touches_another(rs_graph *graph, uint16_t root)
{
    uint32_t start = rs_cluster_first(graph, root);

    for (uint32_t half = start; half != RS_NO_HALF;) {
        if (graph->edges[half >> 1].saddle > 0u) {
            return true;
        }
        half = rs_cluster_next(graph, root, half);
        if (half == start) {
            break;
        }
    }
    return false;
}

static void drop_isolated(uint32_t isolated_cells, rs_graph *graph)
{
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        rs_region *region = &graph->regions[r];
        if (region->parent == r && region->area < isolated_cells &&
            !touches_another(graph, (uint16_t)r)) {
            region->area = 0;
        }
    }
}

/* Largest shares of the whole area. */
#define POORLY_WALLED_AREA_PERCENT 10u
#define HARDLY_WALLED_AREA_PERCENT 20u

/* Marks the roots that are small against the map and bounded by walls far less than the map
 * as a whole. */
static void mark_unwalled(uint32_t unwalled_percent, rs_graph *graph)
{
    rs_map_border map = rs_walls_of_map(graph);
    uint64_t area = 0;

    for (uint32_t r = 1; r <= graph->region_count; r++) {
        area += graph->regions[r].parent == r ? graph->regions[r].area : 0u;
    }
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        rs_region *region = &graph->regions[r];
        uint64_t area_percent = region->area * 100ULL;

        if (region->parent != r) {
            continue;
        }
        if (area_percent < area * HARDLY_WALLED_AREA_PERCENT &&
            rs_walls_are_few(&map, region, unwalled_percent * 5u)) {
            region->unwalled = RS_HARDLY_WALLED;
        } else if (area_percent < area * POORLY_WALLED_AREA_PERCENT &&
                   rs_walls_are_few(&map, region, unwalled_percent * 10u)) {
            region->unwalled = RS_POORLY_WALLED;
        }
    }
}

/* Whether a root touches two roots or more that are not marked as unwalled. */
static bool joins_walled(rs_graph *graph, uint16_t root)
{
    uint32_t start, half;
    uint16_t first = 0;

    start = rs_cluster_first(graph, root);
    for (half = start; half != RS_NO_HALF;) {
        uint16_t other = rs_cluster_root(graph->regions, rs_graph_other_end(graph, half));
        bool walled = graph->regions[other].unwalled == RS_WALLED &&
                      graph->edges[half >> 1].saddle > 0u;

        if (walled && first != 0u && other != first) {
            return true;
        }
        first = walled ? other : first;
        half = rs_cluster_next(graph, root, half);
        if (half == start) {
            break;
        }
    }
    return false;
}

/* Drops what the sensor saw through windows and open doors: what hardly has walls, and dead
 * ends that have few. What leads from one room to another was crossed by the robot. */
static void drop_unwalled(uint32_t unwalled_percent, rs_graph *graph)
{
    mark_unwalled(unwalled_percent, graph);
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        rs_region *region = &graph->regions[r];
        if (region->unwalled == RS_HARDLY_WALLED ||
            (region->unwalled == RS_POORLY_WALLED && !joins_walled(graph, (uint16_t)r))) {
            region->area = 0;
        }
    }
}

void rs_drop_run(uint32_t isolated_cells, uint32_t unwalled_percent, rs_graph *graph)
{
    drop_isolated(isolated_cells, graph);
    drop_unwalled(unwalled_percent, graph);
}
