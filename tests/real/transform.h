/* Changes of a map that leave its rooms what they are. */
#ifndef TESTS_TRANSFORM_H
#define TESTS_TRANSFORM_H

#include <stdint.h>

#include "roomseg/roomseg.h"

typedef enum transform {
    TRANSFORM_SHIFT,  /* elsewhere on a larger canvas, unknown around */
    TRANSFORM_PAD,    /* an occupied frame around */
    TRANSFORM_MIRROR, /* left and right swapped */
    TRANSFORM_TURN_90,
    TRANSFORM_TURN_180,
    TRANSFORM_TURN_270,
    TRANSFORM_TWICE,  /* two of it side by side, unknown between them */
    TRANSFORM_FINER,  /* each cell four of half the edge */
    TRANSFORM_COUNT
} transform;

const char *transform_name(transform t);

/* The changed map; its cells are to be freed. */
roomseg_grid transform_apply(transform t, const roomseg_grid *grid);

/* Of the original cell that lies at (x, y) of the changed map: its index width * y + x, or
 * SIZE_MAX where there is none; *copy: 1 on the second building of TRANSFORM_TWICE, else 0. */
size_t transform_source(transform t, const roomseg_grid *grid, uint32_t x, uint32_t y,
                        uint32_t *copy);

#endif
