/* Slow, simple versions of what the header promises about obstacles, to hold runs against. */
#ifndef SUPPORT_REFERENCE_H
#define SUPPORT_REFERENCE_H

#include "roomseg/roomseg.h"

enum {
    CELL_WALL = 0,   /* obstacle or unknown; the whole outside of the crop too */
    CELL_OPEN = 1,   /* free, or noise or clutter that is not certainly occupied: may carry a
                        label */
    CELL_BRIDGE = 2, /* certain obstacle that is noise or clutter: shapes no room, has no label */
};

/* Kind of each cell: width * height bytes, to be freed. */
uint8_t *reference_kinds(const roomseg_config *config, const roomseg_grid *grid);

/* Squared distance between the centre of each cell and that of the nearest wall cell, which may
 * lie just outside of the grid [cells^2]: width * height numbers, to be freed. */
uint32_t *reference_wall_distances2(const uint8_t *kinds, uint32_t width, uint32_t height);

#endif
