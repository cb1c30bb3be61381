/* A map of its own: a furnished flat, a robot that drives through it with a noisy laser,
 * and the grid that it makes of it, with the true rooms. The same options give the same
 * bits on every machine: integers only. */
#ifndef ROOMSEG_SIMULATE_SIMULATE_H
#define ROOMSEG_SIMULATE_SIMULATE_H

#include <stdint.h>

#include "flat.h"

typedef struct sim_options {
    uint64_t seed;
    int resolution_mm; /* 20..200 */
    flat_size size;
    int furnished;
    int clutter;   /* 0..100: how many things stand about; 50 = as people live */
    int noise;     /* 0..100: errors of laser and mapping; 50 = as real robots have */
    int has_turn;  /* else the seed chooses */
    int32_t turn;  /* of the flat in the map, clockwise, see turn.h */
} sim_options;

sim_options sim_options_default(void);

typedef struct sim_map {
    uint32_t width, height;
    uint8_t *cells; /* 0 free .. 255 occupied, 128 unknown; row 0 = top; owned */
    /* True rooms 1..room_count, 0 = no room. Cells that the map shows as free (up to 63)
     * have the room in which most of the beams that crossed them really were, whatever the
     * map's errors; the floor of a passage is halved between its rooms. Cells that are not
     * free are 0, furniture as well as walls, as there is nothing to label; so are free
     * cells outside the flat and in rooms that the robot has not entered. */
    uint8_t *truth; /* owned */
    int room_count;
    int resolution_mm;
    /* World position of the lower left corner, x right, y up; the robot starts at 0, 0. */
    int32_t origin_x_mm, origin_y_mm;
    int32_t turn; /* as in the options */
} sim_map;

/* Makes the map. Fails iff: an option is outside its range, or memory runs out.
 * Returns 0, or -1 with *out zeroed. */
int sim_run(const sim_options *options, sim_map *out);
void sim_map_free(sim_map *map);

#endif
