/* One run of the library in memory of its own. */
#ifndef SUPPORT_RUN_H
#define SUPPORT_RUN_H

#include "roomseg/roomseg.h"

typedef struct run {
    roomseg_config config;
    roomseg_grid grid;
    uint16_t *labels; /* owned; grid.width * grid.height, no gap between rows */
    void *arena;      /* owned; NULL when no cell is free */
    size_t arena_size;
    roomseg_result result; /* its arrays lie in the arena */
} run;

/* Runs in an arena of exactly the size that roomseg_arena_size_for_grid asks for; fails the
 * test unless that succeeds and all of check.h holds. */
run run_checked(const roomseg_config *config, const roomseg_grid *grid);

/* The same without check.h, for maps on which its brute force takes too long. */
run run_unchecked(const roomseg_config *config, const roomseg_grid *grid);

/* Label of a cell. */
uint16_t run_label(const run *r, uint32_t x, uint32_t y);

/* Fails the test unless labels and all records of both are the same. */
void run_assert_same(const run *a, const run *b);

void run_free(run *r);

#endif
