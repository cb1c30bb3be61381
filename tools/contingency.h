/* Which label covers how much of which true room: all that the metrics need to know of
 * two label images. */
#ifndef ROOMSEG_TOOLS_CONTINGENCY_H
#define ROOMSEG_TOOLS_CONTINGENCY_H

#include <stddef.h>
#include <stdint.h>

#include "label_image.h"

/* Cells that carry this truth and this label. */
typedef struct overlap {
    uint32_t truth; /* 0: outside the true rooms */
    uint32_t label; /* 0: no room was found there */
    uint64_t cells; /* >= 1 */
} overlap;

typedef struct contingency {
    overlap *overlaps; /* sorted by truth, then label; no pair twice; owned */
    size_t count;
} contingency;

/* Counts. The images must have the same size.
 * Fails iff: memory runs out. Returns 0, or -1 with *out zeroed. */
int contingency_count(const label_image *truth, const label_image *labels,
                      contingency *out);

/* Puts true rooms of fewer than min_cells cells outside the truth. */
void contingency_drop_specks(contingency *table, uint64_t min_cells);

/* Frees the overlaps and zeroes the record. */
void contingency_free(contingency *table);

#endif
