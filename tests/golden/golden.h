/* Golden maps: simulated maps and what the library makes of them, as text that is compared. */
#ifndef GOLDEN_H
#define GOLDEN_H

#include <stdint.h>
#include <stdio.h>

#include "roomseg/roomseg.h"
#include "simulate/simulate.h"

typedef struct golden_map {
    const char *name; /* of its file, without .txt */
    sim_options options;
    roomseg_config (*config)(void); /* what it is segmented with */
} golden_map;

/* The first ones are segmented with the default configuration, the others as the paper does. */
enum { GOLDEN_DEFAULT_COUNT = 6, GOLDEN_COUNT = 8 };

/* The maps; index below GOLDEN_COUNT. */
golden_map golden_map_at(int index);

/* A map and its rooms. */
typedef struct golden_run {
    sim_map map;
    uint16_t *labels; /* map.width * map.height, owned */
    void *arena;      /* owned */
    roomseg_result result;
} golden_run;

/* Simulates and segments. Returns 0, or -1 with a line on
 * standard error. */
int golden_make(const golden_map *golden, golden_run *run);
void golden_free(golden_run *run);

/* Writes the text: checksums of the map and of the labels, the room and doorway records, and
 * the labels themselves, a row a line, as LENGTHxLABEL. */
void golden_write(const golden_map *golden, const golden_run *run, FILE *stream);

/* Reads the labels back out of such a text. labels: width * height elements. Returns 0, or -1
 * when the text holds no image of this size. */
int golden_read_labels(FILE *stream, uint32_t width, uint32_t height, uint16_t *labels);

#endif
