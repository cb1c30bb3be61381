/* Seed maps of the paper profile, one scale at a time, from the lifetime map. */
#ifndef ROOMSEG_EXPLAIN_SEED_MAP_H
#define ROOMSEG_EXPLAIN_SEED_MAP_H

#include "observe.h"

/* Seed maps that are shown. */
#define SEED_MAPS_SHOWN 8

/* How many there are to show: one for each scale, at most SEED_MAPS_SHOWN. */
int seed_map_count(const observation *o);

/* The scale of the one number `which`, 0..seed_map_count - 1: the first, the last, and others
 * evenly between them. */
uint8_t seed_map_scale(const observation *o, int which);

/* Numbers the seeds of a scale, the 4-connected components of the cells that live so long, by
 * 1..*count in reading order; beyond 65535 numbers begin anew.
 * seeds: width * height of the crop, out. Returns 0, or -1 when memory runs out. */
int seed_map_make(const observation *o, uint8_t scale, uint16_t *seeds, uint32_t *count);

#endif
