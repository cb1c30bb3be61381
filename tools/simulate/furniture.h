/* Puts furniture into the rooms of a flat. */
#ifndef ROOMSEG_SIMULATE_FURNITURE_H
#define ROOMSEG_SIMULATE_FURNITURE_H

#include "flat.h"

/* Furnishes every room whose flag in skip[room] is 0; doors and a way to each piece stay
 * clear. clutter: 0 = the large pieces only, 50 = as people live, 100 = full of things.
 * seed: each part draws from a stream of its own, so that skipping one changes no other.
 * Returns 0, or -1 without memory. */
int furniture_place(const flat *f, world *w, int clutter, const uint8_t *skip, uint64_t seed);

#endif
