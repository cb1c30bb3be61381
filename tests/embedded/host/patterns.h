/* Drawn maps that are hard on single stages. */
#ifndef EMBEDDED_PATTERNS_H
#define EMBEDDED_PATTERNS_H

#include <stdint.h>

typedef struct pattern {
    const char *name;
    int (*is_free)(uint32_t x, uint32_t y);
    uint32_t max_regions; /* for the configuration; 0: the default one's are enough */
} pattern;

#define PATTERN_SIDE 240u /* cells, both ways; the outermost are walls */
#define PATTERN_RESOLUTION_MM 200u /* so coarse that no wall counts as clutter */

extern const pattern patterns[];
extern const unsigned pattern_count;

#endif
