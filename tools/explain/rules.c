#include "rules.h"

#include <stdlib.h>

/* The config with the rules from JOIN_ROOM to `last` alone. At 100 percent an opening as wide
 * as both regions is left, which every rule would join. */
static roomseg_config only_up_to(const roomseg_config *config, join_rule last) {
    roomseg_config c = *config;
    c.passage_opening_percent = last < JOIN_PASSAGE ? 100 : c.passage_opening_percent;
    c.niche_mm2 = last < JOIN_NICHE ? 0 : c.niche_mm2;
    c.lived_in_permille = last < JOIN_NO_WALL ? 1000 : c.lived_in_permille;
    c.hall_mm = last < JOIN_HALL ? 0 : c.hall_mm;
    c.smallest_room_mm2 = last < JOIN_SMALL ? 0 : c.smallest_room_mm2;
    return c;
}

static int are_joined(const observation *o, const rs_edge *edge) {
    return root_of(o, edge->a) == root_of(o, edge->b);
}

int rules_find(const observation *o, const char *name, uint8_t **joins, tool_error *error) {
    uint32_t count = o->before.edge_count;
    *joins = calloc((size_t)count + 1, 1);
    if (*joins == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    for (int rule = JOIN_ROOM; rule < JOIN_COUNT; rule++) {
        roomseg_config config = only_up_to(&o->s.config, (join_rule)rule);
        observation part;
        if (observe_run(o->m, &config, name, &part, error) != 0) {
            free(*joins);
            *joins = NULL;
            return -1;
        }
        /* The regions before merging are the same in all runs. */
        for (uint32_t e = 0; e < count; e++) {
            const rs_edge *edge = &o->before.edges[e];
            if ((*joins)[e] == JOIN_NONE && are_joined(o, edge) && are_joined(&part, edge)) {
                (*joins)[e] = (uint8_t)rule;
            }
        }
        observation_free(&part);
    }
    return 0;
}
