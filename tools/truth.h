/* The true rooms of a map, from an image. */
#ifndef ROOMSEG_TOOLS_TRUTH_H
#define ROOMSEG_TOOLS_TRUTH_H

#include "label_image.h"

/* Components of the truth below this size are specks: slips of the pen that count as
 * rooms only when nobody looks. Scores are given with and without them [cells]. */
#define TRUTH_SPECK_CELLS 60u

/* How to read the image. */
typedef enum truth_kind {
    TRUTH_AUTO,  /* two values or one: as TRUTH_MASK, more: as TRUTH_LABELS */
    TRUTH_MASK,  /* every 8-connected component of the cells above 0 is a room */
    TRUTH_LABELS /* every value above 0 is a room, connected or not */
} truth_kind;

/* Numbers the components of the cells above 0 by 1, 2, ... in reading order of their first
 * cells; cells that touch by a corner belong together. Values are replaced.
 * Fails iff: memory runs out. Returns 0 or -1. */
int truth_label_components(label_image *image);

/* Reads a truth image. With TRUTH_AUTO and two values, the higher one marks the rooms, be
 * it 255, 127 or 1.
 * Fails iff: as label_image_load, or no cell belongs to a room. Returns 0, or -1 with
 * *error set and *out zeroed. */
int truth_load(const char *path, truth_kind kind, label_image *out, tool_error *error);

#endif
