#include "png_check.h"

#include <stdlib.h>
#include <string.h>

#define SIGNATURE_BYTES 8u
#define CHUNK_FRAME_BYTES 12u /* length, type, checksum */
#define IHDR_BYTES 13u
#define PALETTE_BYTES 768u

static uint32_t big_endian(const unsigned char *b) {
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

/* CRC-32 (polynomial 0xEDB88320, reflected), four bits a step. */
static uint32_t crc32(const unsigned char *bytes, size_t size) {
    uint32_t table[16];
    for (uint32_t i = 0; i < 16; i++) {
        uint32_t remainder = i;
        for (int bit = 0; bit < 4; bit++) {
            remainder = remainder >> 1 ^ ((remainder & 1u) != 0 ? 0xEDB88320u : 0u);
        }
        table[i] = remainder;
    }
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ table[crc & 15u];
        crc = crc >> 4 ^ table[crc & 15u];
    }
    return ~crc;
}

/* By the colour type of IHDR: gray, -, RGB, palette, gray and alpha, -, RGB and alpha. */
static int channels_of(unsigned color_type) {
    static const int channels[] = {1, 0, 3, 1, 2, 0, 4};
    return color_type < sizeof channels / sizeof channels[0] ? channels[color_type] : 0;
}

uint64_t png_raw_bytes(const png_info *info) {
    uint64_t row_bits = (uint64_t)info->width * (uint64_t)info->channels *
                        (uint64_t)info->bit_depth;
    return ((row_bits + 7) / 8 + 1) * info->height; /* and a byte for each row's filter */
}

const char *png_check(const unsigned char *bytes, size_t size, png_info *info) {
    size_t at = SIGNATURE_BYTES;
    for (;;) {
        if (size < at || size - at < CHUNK_FRAME_BYTES) {
            return "the PNG is truncated";
        }
        uint32_t length = big_endian(bytes + at);
        if (length > size - at - CHUNK_FRAME_BYTES) {
            return "the PNG is truncated";
        }
        const unsigned char *type = bytes + at + 4;
        if (crc32(type, (size_t)length + 4) != big_endian(type + 4 + length)) {
            return "the PNG is damaged (wrong checksum)";
        }
        int is_header = memcmp(type, "IHDR", 4) == 0;
        if (is_header != (at == SIGNATURE_BYTES) || (is_header && length != IHDR_BYTES)) {
            return "the PNG is damaged (header out of place)";
        }
        if (is_header) {
            *info = (png_info){big_endian(type + 4), big_endian(type + 8), type[12],
                               channels_of(type[13]), 0};
        }
        if (info->palette == 0 && memcmp(type, "PLTE", 4) == 0) {
            info->palette = at;
        }
        if (memcmp(type, "IEND", 4) == 0) {
            return NULL;
        }
        at += CHUNK_FRAME_BYTES + length;
    }
}

static void store_big_endian(unsigned char *b, size_t value) {
    for (int i = 0; i < 4; i++) {
        b[i] = (unsigned char)(value >> (24 - 8 * i));
    }
}

unsigned char *png_mend(const unsigned char *bytes, size_t *size, const png_info *info) {
    unsigned char *copy = malloc(*size + PALETTE_BYTES);
    if (copy == NULL) {
        return NULL;
    }
    memcpy(copy, bytes, SIGNATURE_BYTES);
    size_t to = SIGNATURE_BYTES;
    int ended = 0;
    for (size_t at = to; !ended;) {
        size_t length = big_endian(bytes + at);
        size_t whole = CHUNK_FRAME_BYTES + length;
        ended = memcmp(bytes + at + 4, "IEND", 4) == 0;
        if (length > 0 || memcmp(bytes + at + 4, "IDAT", 4) != 0) {
            memcpy(copy + to, bytes + at, whole);
            to += whole;
        }
        if (at == info->palette) {
            unsigned char *start = copy + to - whole;
            for (; length < PALETTE_BYTES; length++) {
                start[8 + length] = length % 3 == 0 ? 255 : 0;
            }
            store_big_endian(start, length);
            to = (size_t)(start - copy) + CHUNK_FRAME_BYTES + length;
        }
        at += whole;
    }
    *size = to;
    return copy;
}
