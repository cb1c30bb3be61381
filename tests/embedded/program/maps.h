/* Maps in constant memory; make_maps writes the file that defines them. */
#ifndef EMBEDDED_MAPS_H
#define EMBEDDED_MAPS_H

#include <stdint.h>

typedef struct test_map {
    const char *name;
    const uint8_t *cells; /* width * height */
    uint16_t width, height;
    uint16_t resolution_mm;
    uint16_t max_regions; /* 0: the default configuration's */
} test_map;

extern const test_map test_maps[];
extern const unsigned test_map_count;

#endif
