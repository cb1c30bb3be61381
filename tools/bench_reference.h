/* A map's labels against those of another program. */
#ifndef ROOMSEG_TOOLS_BENCH_REFERENCE_H
#define ROOMSEG_TOOLS_BENCH_REFERENCE_H

#include <stdint.h>

#include "label_image.h"
#include "metrics.h"
#include "tool_error.h"

typedef struct bench_reference {
    const char *folder; /* with SET/NAME.pgm or .png, or NAME.pgm or .png; NULL: none */
    uint32_t no_room;   /* this label is no room; 0: none but 0 */
} bench_reference;

/* Scores the labels of a map with the reference's as truth, whose labels may be in several
 * pieces. Fails iff: the file cannot be read, holds no room, has another size than `labels`,
 * or memory runs out. Returns 1, 0 when there is no file of this name, or -1 with *error set. */
int bench_reference_score(const bench_reference *reference, const char *set, const char *map,
                          const label_image *labels, metrics *out, tool_error *error);

#endif
