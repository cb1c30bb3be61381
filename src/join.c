#include "join.h"

#include "cluster.h"
#include "shape.h"

/* Whether a root has at least `wanted` distinct neighbours of at least `smallest` cells. */
static bool is_passage(rs_graph *graph, uint16_t root, uint32_t wanted, uint32_t smallest)
{
    uint16_t seen[RS_JOIN_MAX_NEIGHBOURS];
    uint32_t seen_count = 0;
    uint32_t start, half;

    start = rs_cluster_first(graph, root);
    half = start;
    while (half != RS_NO_HALF) {
        uint16_t other = rs_cluster_root(graph->regions, rs_graph_other_end(graph, half));
        bool touches = graph->edges[half >> 1].saddle > 0u;
        uint32_t i = 0;

        while (i < seen_count && seen[i] != other) {
            i++;
        }
        if (touches && i == seen_count && graph->regions[other].area >= smallest) {
            seen[seen_count++] = other;
            if (seen_count == wanted) {
                return true;
            }
        }
        half = rs_cluster_next(graph, root, half);
        if (half == start) {
            break;
        }
    }
    return false;
}

/* The smaller root is asked first: it has few neighbours, where a hall may have thousands of
 * closets too small to count. */
static bool are_passages(const rs_join_rules *rules, rs_graph *graph, uint16_t a, uint16_t b)
{
    bool a_first = graph->regions[a].area < graph->regions[b].area;

    return is_passage(graph, a_first ? a : b, rules->passage_min_neighbours,
                      rules->smallest_cells) &&
           is_passage(graph, a_first ? b : a, rules->passage_min_neighbours,
                      rules->smallest_cells);
}

/* Keys of edges that the opening rules join are at least this; niches come below, from 9/20
 * to 1/2 of it, and what is open without a wall last, up to 1/4. */
#define OPENING_KEY 32768u

/* How open an edge is: 0 when saddle < percent/100 * sqrt(p * q), else OPENING_KEY times
 * saddle^2 / (p * q) * (100 / percent)^2. Saddle, p and q are at most 255, so nothing
 * overflows. */
static uint32_t openness(uint32_t saddle, uint32_t p, uint32_t q, uint32_t percent)
{
    uint32_t squared = saddle * saddle;

    if (squared * 10000u < percent * percent * p * q) {
        return 0;
    }
    return squared * OPENING_KEY / (p * q) * 10000u / (percent * percent);
}

/* A small region that is open to its neighbour on at least 9/10 of its own width is a
 * niche of it: 0, or a number that grows with the opening's share of the width. */
static uint32_t niche_key(uint32_t niche_cells, const rs_region *region, uint32_t saddle)
{
    bool niche = region->area < niche_cells && 10u * saddle >= 9u * region->peak;

    return niche ? saddle * (OPENING_KEY / 2u) / region->peak : 0u;
}

/* What two roots share, over all edges between them [cells]. */
typedef struct contact {
    uint32_t wall, border;
} contact;

static contact find_contact(rs_graph *graph, uint16_t a, uint16_t b)
{
    bool walk_a = graph->regions[a].area < graph->regions[b].area;
    uint16_t root = walk_a ? a : b, target = walk_a ? b : a;
    uint32_t start = rs_cluster_first(graph, root);
    uint32_t half = start;
    contact sum = {0, 0};

    while (half != RS_NO_HALF) {
        if (rs_cluster_root(graph->regions, rs_graph_other_end(graph, half)) == target) {
            sum.wall += graph->edges[half >> 1].wall;
            sum.border += graph->edges[half >> 1].border;
        }
        half = rs_cluster_next(graph, root, half);
        if (half == start) {
            break;
        }
    }
    return sum;
}

/* The key of an edge by its opening alone. With `hopeful` the passage rule counts as met,
 * which gives an upper bound without a look at neighbours. */
static uint32_t opening_key(const rs_join_rules *rules, rs_graph *graph, uint32_t saddle,
                            uint16_t a, uint16_t b, bool hopeful)
{
    const rs_region *p = &graph->regions[a], *q = &graph->regions[b];
    uint32_t as_room = openness(saddle, p->peak, q->peak, rules->room_opening_percent);
    uint32_t as_passage = openness(saddle, p->peak, q->peak, rules->passage_opening_percent);

    if (as_passage > as_room && (hopeful || are_passages(rules, graph, a, b))) {
        return as_passage;
    }
    return as_room > 0u ? as_room
                        : rs_max_u32(niche_key(rules->niche_cells, p, saddle),
                                     niche_key(rules->niche_cells, q, saddle));
}

/* Regions without a wall between them lie end to end, as pieces of a corridor do, when the
 * opening takes this much of their widths and of the narrower one's. */
#define END_TO_END_PERCENT 72u
#define NARROWER_PERCENT 78u

/* Share of the opening in the widths, for what is joined last: 1..OPENING_KEY / 8 + 1. */
static uint32_t last_key(uint32_t saddle, uint32_t p, uint32_t q)
{
    return saddle * saddle * (OPENING_KEY / 8u) / (p * q) + 1u;
}

/* Where nobody lives, the width of an opening decides, and walls veto. */
static uint32_t plain_key(const rs_join_rules *rules, rs_graph *graph, uint32_t saddle, uint16_t a,
                          uint16_t b, uint32_t key)
{
    uint32_t p = graph->regions[a].peak, q = graph->regions[b].peak;
    bool end_to_end = openness(saddle, p, q, END_TO_END_PERCENT) != 0u &&
                      100u * saddle >= NARROWER_PERCENT * rs_min_u32(p, q);
    contact shared;

    if (key == 0u && !end_to_end) {
        return 0; /* spares the way around the regions */
    }
    shared = find_contact(graph, a, b);
    if (shared.wall >= rules->shared_wall_cells) {
        return 0;
    }
    return end_to_end && shared.wall <= rules->teeth_cells
               ? rs_max_u32(key, 2u * last_key(saddle, p, q))
               : key;
}

/* Whether a root has walls of its own: what was only seen through a window has few, and opens
 * as wide as furnished rooms do. */
static bool is_walled(const rs_join_rules *rules, const rs_graph *graph, uint16_t root)
{
    return !rs_walls_are_few(&rules->map_border, &graph->regions[root],
                                 rules->unwalled_permille);
}

/* Whether two regions together are still as narrow as a hall. */
static bool make_hall(const rs_join_rules *rules, const rs_graph *graph, uint16_t a, uint16_t b)
{
    return rs_shape_are_narrow(graph, a, b, rules->hall_cells);
}

/* Whether a region is a hall by itself: as narrow as one, and at least twice as long as the
 * widest. */
static bool is_hall(const rs_join_rules *rules, const rs_graph *graph, uint16_t root)
{
    return graph->regions[root].area > 2u * rules->hall_cells * rules->hall_cells &&
           rs_shape_are_narrow(graph, root, root, rules->hall_cells);
}

/* Pieces of one hall come between niches and what is open without a wall. */
#define HALL_KEY (OPENING_KEY * 3u / 10u)

/* Where people live, furniture makes openings narrow, and walls decide what is a door. */
static uint32_t lived_in_key(const rs_join_rules *rules, rs_graph *graph, uint32_t saddle,
                             uint16_t a, uint16_t b, uint32_t key)
{
    uint32_t p = graph->regions[a].peak, q = graph->regions[b].peak;
    contact shared = find_contact(graph, a, b);
    bool open_plan, wide;

    if (shared.wall < 2u * rules->stub_cells && make_hall(rules, graph, a, b)) {
        return rs_max_u32(key, HALL_KEY + saddle);
    }
    if (shared.wall >= rules->shared_wall_cells ||
        (shared.wall >= rules->stub_cells && shared.border <= rules->door_cells)) {
        return 0;
    }
    if (key > 0u || is_hall(rules, graph, a) != is_hall(rules, graph, b) ||
        !is_walled(rules, graph, a) || !is_walled(rules, graph, b)) {
        return key;
    }
    open_plan = shared.wall <= rules->no_wall_cells &&
                openness(saddle, p, q, rules->open_plan_percent) != 0u;
    wide = shared.border > rules->door_cells && 2u * shared.wall <= shared.border &&
           openness(saddle, p, q, rules->passage_opening_percent) != 0u;
    return open_plan ? 2u * last_key(saddle, p, q) : wide ? last_key(saddle, p, q) : 0u;
}

uint32_t rs_join_key(const rs_join_rules *rules, rs_graph *graph, uint32_t e, bool hopeful)
{
    uint32_t saddle = graph->edges[e].saddle;
    uint16_t a = rs_cluster_root(graph->regions, graph->edges[e].a);
    uint16_t b = rs_cluster_root(graph->regions, graph->edges[e].b);
    uint32_t key;

    if (a == b || saddle == 0u || graph->regions[a].peak == 0u || graph->regions[b].peak == 0u) {
        return 0;
    }
    key = opening_key(rules, graph, saddle, a, b, hopeful);
    return rules->lived_in ? lived_in_key(rules, graph, saddle, a, b, key)
                           : plain_key(rules, graph, saddle, a, b, key);
}
