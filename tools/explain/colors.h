/* The colours of the explaining pictures. */
#ifndef ROOMSEG_EXPLAIN_COLORS_H
#define ROOMSEG_EXPLAIN_COLORS_H

#include <stddef.h>
#include <stdint.h>

#include "draw.h"
#include "segment.h"

extern const color PAINT_FREE, PAINT_UNKNOWN, PAINT_OBSTACLE, PAINT_BACKGROUND;
extern const color PAINT_INK, PAINT_HALO, PAINT_SIGNAL, PAINT_SECOND, PAINT_QUIET, PAINT_AMBER;

/* A ramp from dark violet over blue and green to yellow, ever lighter. share: 0 to 1. */
color paint_heat(double share);

/* A ramp from white to dark red, ever darker. share: 0 to 1. */
color paint_ridge(double share);

/* The first colour with so much of the second in it, 0 to 1. */
color paint_mix(color first, color second, double share);

/* Chooses a pastel for each label of an image of labels, so that neighbours differ; labels
 * within a few cells count as neighbours, as between them may be a line or a wall.
 * labels: width * height without gaps; 0 and labels above `count` have no colour.
 * index: count + 1 elements, index[label] for room_color().
 * Returns 0, or -1 when memory runs out. */
int label_colors_choose(const uint16_t *labels, uint32_t width, uint32_t height, uint32_t count,
                        uint8_t *index);

#endif
