/* Ways in which the same rooms may look different on a map. All are integer arithmetic and
 * give the same bits on every machine. */
#ifndef ROOMSEG_VARY_VARY_H
#define ROOMSEG_VARY_VARY_H

#include <stdint.h>

#include "scene.h"
#include "simulate/rng.h"

/* Edges of a piece of clutter, and the floor that stays free around it [mm]. */
#define VARY_CLUTTER_MIN_MM 250
#define VARY_CLUTTER_MAX_MM 550
#define VARY_CLUTTER_GAP_MM 120

/* Stands squares about on the floor, parallel to the axes: as many as `per_1000_m2` says of
 * the area that is free before. One for which a thousand places do not do is left out. The
 * truth stays as it is.
 * free_max: highest value of a free cell. Returns how many stand there. */
uint32_t vary_clutter(scene *s, uint8_t free_max, uint32_t per_1000_m2, rng *r);

/* Turns map and truth counter-clockwise about their middle and enlarges them so that
 * nothing is lost; a cell takes the value of the nearest one, or unknown outside.
 * turn: clockwise, in units of simulate/turn.h. Returns 0, or -1 when the result exceeds
 * IMAGE_MAX_SIDE or memory runs out; *s then is as it was. */
int vary_turn(scene *s, int32_t turn);

/* Draws map and truth with cells of another size. A larger cell takes the highest of the
 * values whose cells' middles it covers, so that no wall gets a gap; a smaller one takes the
 * value of the cell that it lies in. The room is that of the cell in the middle.
 * resolution_mm: ROOMSEG_MIN_RESOLUTION_MM..ROOMSEG_MAX_RESOLUTION_MM. Returns as
 * vary_turn. */
int vary_resample(scene *s, int resolution_mm);

/* Replaces known cells by certainly free and certainly occupied ones, half each.
 * per_million: how many, 0..1000000. The truth stays as it is. */
void vary_salt(scene *s, uint32_t per_million, rng *r);

#endif
