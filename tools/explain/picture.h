/* Pictures of the crop: every cell in a colour, things drawn on top. */
#ifndef ROOMSEG_EXPLAIN_PICTURE_H
#define ROOMSEG_EXPLAIN_PICTURE_H

#include "base.h"
#include "draw.h"
#include "view.h"

/* The crop with a narrow margin, at a size that fits a page: the long side has 700 to 1400
 * pixels; larger crops are shrunk by a whole number. */
view picture_view(const map *m, const segmentation *s, const rs_frame *frame);

/* What a cell looks like; (x, y) in crop coordinates. */
typedef color (*cell_paint)(const void *user, uint32_t x, uint32_t y);

/* A picture with every cell of the crop painted; cells around it as the map has them. Where
 * cells share a pixel, they are mixed. Returns 0, or -1 when memory runs out. */
int picture_paint(const rs_frame *frame, const view *v, cell_paint paint, const void *user,
                  canvas *out);

/* Pixel of a position in crop coordinates. */
double picture_x(const rs_frame *frame, const view *v, double x);
double picture_y(const rs_frame *frame, const view *v, double y);

/* The map's own look: free, not certain, obstacle. Crop coordinates; may lie outside. */
color picture_map_color(const rs_frame *frame, const view *v, uint32_t x, uint32_t y);

#endif
