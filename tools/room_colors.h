/* A colour for each room of a picture. */
#ifndef ROOMSEG_TOOLS_ROOM_COLORS_H
#define ROOMSEG_TOOLS_ROOM_COLORS_H

#include <stdint.h>

#include "draw.h"
#include "roomseg/roomseg.h"

#define ROOM_COLOR_COUNT 11

/* The pastel of an index 0..ROOM_COLOR_COUNT-1. */
color room_color(uint8_t index);

/* Chooses an index for each room, index[i] for rooms[i]: never that of a neighbour, and as
 * unlike those of rooms nearby as can be had. index: room_count elements.
 * Returns 0, or -1 when memory runs out. */
int room_colors_choose(const roomseg_result *result, uint8_t *index);

#endif
