#include "tiny_png.h"

#include <string.h>

static void put(tiny_png *png, const void *bytes, size_t size) {
    if (size > 0) {
        memcpy(png->bytes + png->size, bytes, size);
        png->size += size;
    }
}

static void put_number(tiny_png *png, uint32_t value) {
    const uint8_t bytes[4] = {(uint8_t)(value >> 24), (uint8_t)(value >> 16),
                              (uint8_t)(value >> 8), (uint8_t)value};
    put(png, bytes, 4);
}

static uint32_t crc_of(const uint8_t *bytes, size_t size) {
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
        }
    }
    return ~crc;
}

static void store_number(uint8_t *out, uint32_t value) {
    const uint8_t bytes[4] = {(uint8_t)(value >> 24), (uint8_t)(value >> 16),
                              (uint8_t)(value >> 8), (uint8_t)value};
    memcpy(out, bytes, 4);
}

static size_t store_chunk(uint8_t *out, const char *type, const uint8_t *data, size_t size) {
    store_number(out, (uint32_t)size);
    memcpy(out + 4, type, 4);
    if (size > 0) {
        memcpy(out + 8, data, size);
    }
    store_number(out + 8 + size, crc_of(out + 4, size + 4));
    return size + 12;
}

size_t tiny_png_wrap(uint32_t width, uint32_t height, int bit_depth, int color_type,
                     const uint8_t *stream, size_t stream_size, uint8_t *out) {
    uint8_t header[13] = {0};
    store_number(header, width);
    store_number(header + 4, height);
    header[8] = (uint8_t)bit_depth;
    header[9] = (uint8_t)color_type;
    memcpy(out, "\x89PNG\r\n\x1a\n", 8);
    size_t size = 8;
    size += store_chunk(out + size, "IHDR", header, sizeof header);
    size += store_chunk(out + size, "IDAT", stream, stream_size);
    return size + store_chunk(out + size, "IEND", NULL, 0);
}

static void put_chunk(tiny_png *png, const char *type, const uint8_t *data, size_t size) {
    put_number(png, (uint32_t)size);
    size_t start = png->size;
    put(png, type, 4);
    put(png, data, size);
    put_number(png, crc_of(png->bytes + start, png->size - start));
}

/* A zlib stream of one stored block. */
static size_t store(const uint8_t *raw, size_t size, uint8_t *out) {
    const uint8_t head[7] = {0x78, 0x01, 1, (uint8_t)size, (uint8_t)(size >> 8),
                             (uint8_t)~size, (uint8_t)(~size >> 8)};
    uint32_t a = 1;
    uint32_t b = 0;
    memcpy(out, head, sizeof head);
    memcpy(out + sizeof head, raw, size);
    for (size_t i = 0; i < size; i++) {
        a = (a + raw[i]) % 65521u;
        b = (b + a) % 65521u;
    }
    const uint8_t tail[4] = {(uint8_t)(b >> 8), (uint8_t)b, (uint8_t)(a >> 8), (uint8_t)a};
    memcpy(out + sizeof head + size, tail, sizeof tail);
    return sizeof head + size + sizeof tail;
}

tiny_png tiny_png_make(uint32_t width, uint32_t height, int bit_depth, int color_type,
                       const uint8_t *rows, size_t row_bytes, size_t row_count,
                       const uint8_t *palette, size_t palette_size) {
    tiny_png png = {{0}, 0, 0};
    tiny_png header = {{0}, 0, 0};
    uint8_t raw[256] = {0};
    uint8_t stream[300];
    put(&png, "\x89PNG\r\n\x1a\n", 8);
    put_number(&header, width);
    put_number(&header, height);
    const uint8_t rest[5] = {(uint8_t)bit_depth, (uint8_t)color_type, 0, 0, 0};
    put(&header, rest, sizeof rest);
    put_chunk(&png, "IHDR", header.bytes, header.size);
    if (palette != NULL) {
        put_chunk(&png, "PLTE", palette, palette_size * 3);
    }
    for (size_t i = 0; i < row_count; i++) {
        memcpy(raw + i * (row_bytes + 1) + 1, rows + i * row_bytes, row_bytes);
    }
    png.idat = png.size;
    put_chunk(&png, "IDAT", stream, store(raw, row_count * (row_bytes + 1), stream));
    put_chunk(&png, "IEND", NULL, 0);
    return png;
}
