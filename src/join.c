#include "join.h"

#include "cluster.h"

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

    if (as_passage > as_room &&
        (hopeful ||
         (is_passage(graph, a, rules->passage_min_neighbours, rules->smallest_cells) &&
          is_passage(graph, b, rules->passage_min_neighbours, rules->smallest_cells)))) {
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

/* A number that grows with the opening when no wall explains why it is narrow, as there is none,
 * or far less of it than of the opening, which is no door. Else 0. */
static uint32_t unwalled_key(const rs_join_rules *rules, uint32_t saddle, uint32_t p, uint32_t q,
                             contact shared)
{
    bool end_to_end = shared.wall <= rules->teeth_cells &&
                      openness(saddle, p, q, END_TO_END_PERCENT) != 0u &&
                      100u * saddle >= NARROWER_PERCENT * rs_min_u32(p, q);
    bool open_plan = rules->lived_in && shared.wall <= rules->no_wall_cells &&
                     openness(saddle, p, q, rules->open_plan_percent) != 0u;
    bool wide = rules->lived_in && shared.border > rules->door_cells &&
                2u * shared.wall <= shared.border &&
                openness(saddle, p, q, rules->passage_opening_percent) != 0u;
    uint32_t share = saddle * saddle * (OPENING_KEY / 8u) / (p * q) + 1u;

    return end_to_end || open_plan ? 2u * share : wide ? share : 0u;
}

uint32_t rs_join_key(const rs_join_rules *rules, rs_graph *graph, uint32_t e, bool hopeful)
{
    uint32_t saddle = graph->edges[e].saddle;
    uint16_t a = rs_cluster_root(graph->regions, graph->edges[e].a);
    uint16_t b = rs_cluster_root(graph->regions, graph->edges[e].b);
    uint32_t p = graph->regions[a].peak, q = graph->regions[b].peak;
    uint32_t key;
    contact shared;

    if (a == b || saddle == 0u || p == 0u || q == 0u) {
        return 0;
    }
    key = opening_key(rules, graph, saddle, a, b, hopeful);
    if (key == 0u && !rules->lived_in && openness(saddle, p, q, END_TO_END_PERCENT) == 0u) {
        return 0; /* spares the way around the regions */
    }
    shared = find_contact(graph, a, b);
    if (shared.wall >= rules->shared_wall_cells ||
        (rules->lived_in && shared.wall >= rules->stub_cells &&
         shared.border <= rules->door_cells)) {
        return 0;
    }
    return rs_max_u32(key, unwalled_key(rules, saddle, p, q, shared));
}
