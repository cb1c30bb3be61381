/* The picture of a segmented map. */
#ifndef ROOMSEG_TOOLS_ROOMS_PNG_H
#define ROOMSEG_TOOLS_ROOMS_PNG_H

#include "draw.h"
#include "map.h"
#include "segment.h"
#include "tool_error.h"
#include "view.h"

/* Draws a part of the map: rooms in pastel, certain obstacles dark, other obstacles and unknown
 * cells gray, free cells without a room white; doorways as strokes from wall to wall; number and
 * area at each room's interior point; a scale bar below.
 * Returns 0, or -1 with *out zeroed when memory runs out. */
int rooms_draw(const view *v, canvas *out);

/* The same for the part that holds the rooms.
 * A cell takes a whole number of pixels so that the long side has 800 to 1600; maps above
 * 4000 cells are shrunk by a whole number.
 * Returns 0, or -1 with *error set and *out zeroed when memory runs out. */
int rooms_png_draw(const map *m, const segmentation *s, const char *name, canvas *out,
                   tool_error *error);

#endif
