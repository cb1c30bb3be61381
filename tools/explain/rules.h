/* Which rule of the default profile joins which regions. */
#ifndef ROOMSEG_EXPLAIN_RULES_H
#define ROOMSEG_EXPLAIN_RULES_H

#include "observe.h"

/* The rules in the order in which they are switched on here. */
typedef enum join_rule {
    JOIN_NONE,      /* the regions stay apart */
    JOIN_ROOM,      /* room_opening_percent */
    JOIN_PASSAGE,   /* passage_opening_percent */
    JOIN_NICHE,     /* niche_mm2 */
    JOIN_NO_WALL,   /* open_plan_percent, door_mm, on maps that are lived in */
    JOIN_HALL,      /* hall_mm, on such maps, too */
    JOIN_SMALL,     /* smallest_room_mm2 */
    JOIN_COUNT
} join_rule;

/* Segments the map once for each rule, with this one and those before it switched on by their
 * fields of the config. An edge whose two regions end in one room has the rule with which they
 * were first together: joins[e] for each edge of o->before, to be freed.
 * Fails iff: memory runs out. Returns 0, or -1 with *error set and *joins NULL. */
int rules_find(const observation *o, const char *name, uint8_t **joins, tool_error *error);

#endif
