#include "memory_files.h"

#include <stdlib.h>
#include <string.h>

#include "infile.h"

static const uint8_t *contents[2];
static size_t sizes[2];
static size_t next;

void memory_files_set(const uint8_t *first, size_t first_size, const uint8_t *second,
                      size_t second_size)
{
    contents[0] = first;
    contents[1] = second;
    sizes[0] = first_size;
    sizes[1] = second_size;
    next = 0;
}

int infile_read(const char *path, unsigned char **bytes, size_t *size, tool_error *error)
{
    *bytes = NULL;
    *size = 0;
    if (next >= 2 || sizes[next] == 0) {
        tool_error_set(error, "%s: no such file", path);
        return -1;
    }
    /* Exactly the promised zero behind the contents, so that one byte further is found. */
    *bytes = malloc(sizes[next] + 1);
    if (*bytes == NULL) {
        abort();
    }
    memcpy(*bytes, contents[next], sizes[next]);
    (*bytes)[sizes[next]] = 0;
    *size = sizes[next++];
    return 0;
}
