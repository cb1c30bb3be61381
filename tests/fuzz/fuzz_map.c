/* Maps from PGM and YAML files. The input: a byte of options, the length of the first file
 * (two bytes), that file, and behind it the image that a YAML may name. */
#include <stddef.h>
#include <stdint.h>

#include "check_map.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 3) {
        return 0;
    }
    const map_options options = {(bytes[0] & 2u) != 0 ? 0.05 : 0.0, bytes[0] & 1u};
    size_t length = bytes[1] + (size_t)256 * bytes[2];
    bytes += 3;
    size -= 3;
    length = length < size ? length : size;
    check_map(&options, bytes, length, bytes + length, size - length);
    return 0;
}
