/* Which part of a map a picture shows, and where its cells lie in it. */
#ifndef ROOMSEG_TOOLS_VIEW_H
#define ROOMSEG_TOOLS_VIEW_H

#include <stdint.h>

#include "map.h"
#include "segment.h"

/* A cell takes `scale` x `scale` pixels, or `shrink` x `shrink` cells one pixel; one of the
 * two is 1. */
typedef struct view {
    const map *m;
    const segmentation *s;
    int x, y;                  /* the first cell shown; may lie outside the map */
    int width_cells, height_cells;
    int scale, shrink;
    int width_px, height_px;
} view;

/* The box around the rooms with a margin; without rooms the crop, without crop the map. */
view view_of_rooms(const map *m, const segmentation *s);

/* Pixel of a cell's coordinate: the middle of the cell for whole numbers. */
double view_px_x(const view *v, double cell_x);
double view_px_y(const view *v, double cell_y);

/* Pixels that a length in cells takes. */
double view_px(const view *v, double cells);

/* Label of the cell at (x, y), 0 outside the map. */
uint16_t view_label(const view *v, int x, int y);

#endif
