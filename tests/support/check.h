/* What must hold for every successful run, by the words of roomseg.h. Each function fails the
 * test with a message that says what does not. */
#ifndef SUPPORT_CHECK_H
#define SUPPORT_CHECK_H

#include "run.h"

/* Labels: none on an obstacle but uncertain noise and clutter, none above room_count, none
 * missing; each room is 4-connected, noise and clutter counting as bridges. */
void check_labels(const run *r, const uint8_t *kinds);

/* Another cell without a label lies in a connected area that has none at all and is small
 * enough to be dropped. Where rooms without walls are dropped too, less than half of an area
 * may lack labels: true of maps of homes, not of any noise at all. */
void check_dropped(const run *r, const uint8_t *kinds);

/* Room records against the labels: order, area, centroid, bounding box, interior point.
 * kinds: NULL leaves out the distance to walls. */
void check_rooms(const run *r, const uint8_t *kinds);

/* Doorway records and links against the labels. kinds: NULL for a profile that parts rooms by a
 * line without labels; then the borders are not counted. */
void check_doorways(const run *r, const uint8_t *kinds);

/* All of it but check_dropped, and the crop. */
void check_records(const run *r, const uint8_t *kinds);

/* All of it. */
void check_everything(const run *r);

#endif
