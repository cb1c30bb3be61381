/* Whole input files in memory. */
#ifndef ROOMSEG_TOOLS_INFILE_H
#define ROOMSEG_TOOLS_INFILE_H

#include <stddef.h>

#include "tool_error.h"

/* Largest file that is read: what a 16-bit image of IMAGE_MAX_CELLS takes, and more. */
#define INFILE_MAX_BYTES ((size_t)1 << 30)

/* Reads a file to its end. *bytes receives memory to be freed, with a zero byte behind the
 * *size bytes of the file.
 * Fails iff: it cannot be opened or read, is a folder, is empty, is larger than
 * INFILE_MAX_BYTES, or memory runs out. Returns 0, or -1 with *error set. */
int infile_read(const char *path, unsigned char **bytes, size_t *size, tool_error *error);

#endif
