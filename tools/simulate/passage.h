/* Whether a robot still gets about in a room when one more thing stands there. */
#ifndef ROOMSEG_SIMULATE_PASSAGE_H
#define ROOMSEG_SIMULATE_PASSAGE_H

#include <stdint.h>

#include "world.h"

/* Mesh of the grids on which furniture is placed and ways are planned [cm]. */
#define PASSAGE_CELL 5

/* Sets *mask, of columns x rows cells, to 0 around the cell: everywhere where a robot of
 * 17 cm radius cannot have its centre when something stands in the cell. */
void passage_block_around(uint8_t *mask, int columns, int rows, int x, int y);

/* The part of a grid that is looked at. */
typedef struct passage_grid {
    const uint8_t *flags; /* (flags & taken) != 0: something stands in the cell */
    int taken;
    int columns, rows;
    uint8_t *mask;  /* scratch, a byte a cell of the grid */
    int32_t *queue; /* scratch, an entry a cell of the grid */
} passage_grid;

/* 1 when, within the box `area` of cells, the robot can drive between all the gates, and
 * from them to most of where it could stand at all. gates: boxes of cells; those where it
 * cannot stand count as blocked. */
int passage_is_open(const passage_grid *g, box area, const box *gates, int gate_count);

#endif
