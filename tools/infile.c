#include "infile.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reads to the end into *bytes, which grows by doubling. Returns NULL or the cause. */
static const char *read_stream(FILE *stream, unsigned char **bytes, size_t *size) {
    size_t capacity = 0;
    for (;;) {
        if (capacity - *size < 2) {
            capacity = capacity == 0 ? 65536 : capacity * 2;
            unsigned char *grown = realloc(*bytes, capacity);
            if (grown == NULL) {
                return "out of memory";
            }
            *bytes = grown;
        }
        errno = 0;
        size_t count = fread(*bytes + *size, 1, capacity - *size - 1, stream);
        *size += count;
        if (ferror(stream)) {
            return errno != 0 ? strerror(errno) : "cannot be read";
        }
        if (count == 0) {
            (*bytes)[*size] = 0;
            return *size == 0 ? "the file is empty" : NULL;
        }
        if (*size > INFILE_MAX_BYTES) {
            return "the file is larger than 1 GiB";
        }
    }
}

int infile_read(const char *path, unsigned char **bytes, size_t *size, tool_error *error) {
    *bytes = NULL;
    *size = 0;
    FILE *stream = fopen(path, "rb");
    const char *cause = stream == NULL ? strerror(errno) : read_stream(stream, bytes, size);
    if (stream != NULL) {
        fclose(stream);
    }
    if (cause == NULL) {
        return 0;
    }
    tool_error_set(error, "%s: %s", path, cause);
    free(*bytes);
    *bytes = NULL;
    *size = 0;
    return -1;
}
