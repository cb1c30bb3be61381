/* Maps from PNG files. The input: a byte of options, then the file. */
#include <stdlib.h>
#include <string.h>

#include "check_map.h"
#include "png_repair.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 2) {
        return 0;
    }
    const map_options options = {0.0, bytes[0] & 1u};
    uint8_t *copy = malloc(size - 1);
    if (copy == NULL) {
        abort();
    }
    memcpy(copy, bytes + 1, size - 1);
    if ((bytes[0] & 2u) == 0) {
        png_repair(copy, size - 1);
    }
    check_map(&options, copy, size - 1, NULL, 0);
    free(copy);
    return 0;
}
