/* Is a PNG file whole? The decoder in use skips the checksums and is content with files
 * whose end is missing. */
#ifndef ROOMSEG_TOOLS_PNG_CHECK_H
#define ROOMSEG_TOOLS_PNG_CHECK_H

#include <stddef.h>
#include <stdint.h>

typedef struct png_info {
    uint32_t width, height;
    int bit_depth; /* 1, 2, 4, 8, 16 */
    int channels;  /* 1..4; 0 when the file names no known kind */
    size_t palette; /* offset of the first PLTE chunk; 0: there is none */
} png_info;

/* Bytes that the image takes before it was compressed, but for what interlacing adds. Both
 * sides must be within the limits of image.h. */
uint64_t png_raw_bytes(const png_info *info);

/* A copy of a file that png_check() let pass, for the decoder. Its first palette has all 256
 * entries, those that it lacked in red: the decoder takes colours that a palette does not hold from
 * memory that nobody wrote. Chunks of image data without a byte are left out: the decoder counts
 * from a null pointer when such a one is the first. Checksums are not renewed. *size: of the copy,
 * to be freed. NULL: out of memory. */
unsigned char *png_mend(const unsigned char *bytes, size_t *size, const png_info *info);

/* Walks the chunks of a file that begins with the PNG signature.
 * Returns NULL when each is whole and its checksum right, IHDR is the first and IEND comes;
 * else the cause, static storage, and *info is undefined. */
const char *png_check(const unsigned char *bytes, size_t size, png_info *info);

#endif
