/* A call of the library, made of the bytes that a fuzzer invents. */
#ifndef FUZZ_SCENARIO_H
#define FUZZ_SCENARIO_H

#include <stdbool.h>

#include "roomseg/roomseg.h"

/* A run takes well below a millisecond on such a grid. */
#define SCENARIO_MAX_CELLS 1200u
#define SCENARIO_MAX_ARENA 1000000u

typedef struct scenario {
    roomseg_config config; /* each field within its range, unless `wild` */
    bool wild;             /* a field was set to any number at all */
    roomseg_grid grid;     /* cells are owned; not a byte behind the last cell */
    uint32_t label_stride;
    uint32_t arena_shift;  /* multiples of 8 that the arena lies behind its block's start */
    uint32_t cancel_at;    /* call of the hook that cancels; 0: none */
} scenario;

/* Any bytes make a scenario, the missing ones being 0. */
scenario scenario_make(const uint8_t *bytes, size_t size);
void scenario_free(scenario *s);

#endif
