/* Grids drawn with characters, so that a test shows its map. */
#ifndef SUPPORT_SKETCH_H
#define SUPPORT_SKETCH_H

#include "roomseg/roomseg.h"

typedef struct sketch {
    roomseg_grid grid; /* cells are owned by the sketch */
    uint8_t *memory;
} sketch;

/* Makes a grid from rows of characters of equal length, the list ending with NULL:
 * '.' free (0), '#' occupied (255), '?' unknown (127). Each character becomes a square of
 * `scale` x `scale` cells. stride 0 means no gap between rows. Cells beyond the width are
 * free, so that code that reads them gives itself away. */
sketch sketch_make(const char *const *rows, uint32_t scale, uint32_t stride,
                   uint32_t resolution_mm);

/* A grid of one value. */
sketch sketch_blank(uint32_t width, uint32_t height, uint8_t value, uint32_t resolution_mm);

/* Sets the rectangle from (x, y), width x height cells, to a value. */
void sketch_fill(sketch *s, uint32_t x, uint32_t y, uint32_t width, uint32_t height,
                 uint8_t value);

/* A plan of columns x rows equal rooms with walls one cell thick between and around them;
 * every wall between neighbours has a doorway in its middle.
 * side: free cells along a room's edge; door: free cells across a doorway, 0 for none. */
sketch sketch_rooms(uint32_t columns, uint32_t rows, uint32_t side, uint32_t door,
                    uint32_t resolution_mm);

/* The same map seen by a robot whose x axis lies `degrees` counter-clockwise of the drawing's:
 * turned clockwise to the eye, unknown around. */
sketch sketch_turned(const sketch *s, double degrees);

void sketch_free(sketch *s);

#endif
