/* infile_read() of the tools, replaced: files are pieces of the fuzzer's input. */
#ifndef FUZZ_MEMORY_FILES_H
#define FUZZ_MEMORY_FILES_H

#include <stddef.h>
#include <stdint.h>

/* The files that are read next, in this order; any path names the next one. At most two; an
 * empty or missing one cannot be read. */
void memory_files_set(const uint8_t *first, size_t first_size, const uint8_t *second,
                      size_t second_size);

#endif
