/* What became of each region: part of a room, or dropped and why. */
#ifndef ROOMSEG_EXPLAIN_FATES_H
#define ROOMSEG_EXPLAIN_FATES_H

#include "observe.h"

typedef enum fate {
    FATE_ROOM,
    FATE_ALONE,    /* dropped; what it was merged to touches nothing else */
    FATE_UNWALLED, /* dropped though it touches others: for its border */
    FATE_COUNT
} fate;

typedef struct fates {
    uint8_t *of;                /* a fate for each region, region_count + 1 elements; owned */
    uint32_t regions;           /* with a cell that may carry a label, before merging ... */
    uint32_t islands;           /* ... and those of them that touch no other */
    uint32_t roots[FATE_COUNT]; /* what they were merged to */
    uint64_t cells[FATE_COUNT];
} fates;

/* Returns 0, or -1 with *out zeroed when memory runs out. */
int fates_find(const observation *o, fates *out);

void fates_free(fates *f);

#endif
