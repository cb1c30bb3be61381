/* The score of one labelled map against its truth. */
#ifndef ROOMSEG_TOOLS_SCORE_H
#define ROOMSEG_TOOLS_SCORE_H

#include "label_image.h"
#include "metrics.h"
#include "tool_error.h"

typedef struct score {
    metrics all;            /* every component of the truth is a room, as in the paper */
    metrics without_specks; /* components below TRUTH_SPECK_CELLS left out of the truth */
} score;

/* name: the labels' file, for messages. Fails iff: the sizes differ, or memory runs out.
 * Returns 0, or -1 with *error set and *out zeroed. */
int score_labels(const label_image *truth, const label_image *labels, const char *name,
                 score *out, tool_error *error);

#endif
