/* Reading a map from memory_files, and what must hold of it. */
#ifndef FUZZ_CHECK_MAP_H
#define FUZZ_CHECK_MAP_H

#include <stddef.h>
#include <stdint.h>

#include "map.h"

/* Loads twice: both maps are equal and within their limits, or both fail with one line that
 * names the file. */
void check_map(const map_options *options, const uint8_t *first, size_t first_size,
               const uint8_t *second, size_t second_size);

/* One line of printable text that names `name`. */
void check_error(const tool_error *error, const char *name);

#endif
