/* Number and area, written into each room of a picture. */
#ifndef ROOMSEG_TOOLS_ROOM_LABELS_H
#define ROOMSEG_TOOLS_ROOM_LABELS_H

#include "draw.h"
#include "view.h"

/* Height of a room's number where there is space for it, for the picture's size [px]. */
double room_text_height(const view *v);

/* Text in dark ink on a light halo, readable on any ground. */
void draw_label(canvas *c, double x, double y, const char *text, double height);

/* Writes number and area at each room's interior point, smaller where the room is small and
 * without the area where it is tiny. */
void draw_room_labels(canvas *c, const view *v);

#endif
