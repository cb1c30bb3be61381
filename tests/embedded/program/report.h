/* What a run found, as text that must be equal on every target. */
#ifndef EMBEDDED_REPORT_H
#define EMBEDDED_REPORT_H

#include "maps.h"
#include "roomseg/roomseg.h"

/* CRC-32 of the labels, rooms, doorways, links. labels: width * height of the map. */
void report_write(const test_map *map, const char *variant, const uint16_t *labels,
                  const roomseg_result *result);

#endif
