#include "image.h"

#include <stdlib.h>
#include <string.h>

#include "infile.h"
#include "map_pgm.h"
#include "png_check.h"
#include "workers.h"

/* The PNG decoder grows the block of decompressed bytes as long as there are more of them,
 * whatever the size of the image. So no block may grow beyond this. */
static WORKERS_OWN uint64_t png_block_limit;
static WORKERS_OWN int png_block_refused;

static void *grow_png_block(void *block, size_t size) {
    if (size > png_block_limit) {
        png_block_refused = 1;
        return NULL;
    }
    return realloc(block, size);
}

#define STBI_MALLOC(size) malloc(size)
#define STBI_REALLOC(block, size) grow_png_block(block, size)
#define STBI_FREE(block) free(block)

/* The warnings of third-party code are not ours to fix. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

int image_is_png(const unsigned char *bytes, size_t size) {
    return size >= 8 && memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0;
}

int image_is_pnm(const unsigned char *bytes, size_t size) {
    return size >= 3 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7' &&
           strchr(" \t\r\n\v\f#", bytes[2]) != NULL;
}

int image_check_size(uint32_t width, uint32_t height, const char *name, tool_error *error) {
    if (width == 0 || height == 0) {
        tool_error_set(error, "%s: the image is empty (%u x %u)", name, (unsigned)width,
                       (unsigned)height);
        return -1;
    }
    if (width > IMAGE_MAX_SIDE || height > IMAGE_MAX_SIDE ||
        (size_t)width * height > IMAGE_MAX_CELLS) {
        tool_error_set(error, "%s: %u x %u cells are too many (%u a side, %lu in all)", name,
                       (unsigned)width, (unsigned)height, IMAGE_MAX_SIDE,
                       (unsigned long)IMAGE_MAX_CELLS);
        return -1;
    }
    return 0;
}

int image_allocate(uint32_t width, uint32_t height, uint32_t maxval, const char *name,
                   image *out, tool_error *error) {
    *out = (image){NULL, NULL, width, height, maxval};
    out->gray = malloc((size_t)width * height * sizeof *out->gray);
    if (out->gray == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        *out = (image){NULL, NULL, 0, 0, 0};
        return -1;
    }
    return 0;
}

void image_free(image *img) {
    free(img->gray);
    free(img->opaque);
    *img = (image){NULL, NULL, 0, 0, 0};
}

/* Decoded PNG samples, 8 or 16 bits wide, `channels` a pixel. */
typedef struct samples {
    const stbi_uc *narrow;
    const stbi_us *wide; /* set instead of narrow for 16 bits */
    int channels;
} samples;

static uint16_t sample(const samples *s, size_t pixel, int channel) {
    size_t at = pixel * (size_t)s->channels + (size_t)channel;
    return s->wide != NULL ? s->wide[at] : s->narrow[at];
}

/* Copies the samples into an allocated image. Returns NULL or the cause. */
static const char *take_samples(const samples *s, image *out) {
    size_t count = (size_t)out->width * out->height;
    int alpha = s->channels == 2 || s->channels == 4 ? s->channels - 1 : -1;
    for (size_t i = 0; i < count; i++) {
        out->gray[i] = sample(s, i, 0);
        if (s->channels >= 3 && (sample(s, i, 1) != out->gray[i] ||
                                 sample(s, i, 2) != out->gray[i])) {
            return "the image has colours; a map must be gray";
        }
        if (alpha < 0 || sample(s, i, alpha) == out->maxval) {
            continue;
        }
        if (out->opaque == NULL) {
            out->opaque = malloc(count);
            if (out->opaque == NULL) {
                return "out of memory";
            }
            memset(out->opaque, 1, count);
        }
        out->opaque[i] = 0;
    }
    return NULL;
}

/* Deflate makes at most 1032 bytes of one. */
#define MOST_EXPANSION 1032u

/* Decodes the samples, at most twice as many bytes as the image takes. *decoded is to be freed
 * by stbi_image_free; NULL: failed, and the function returns what is wrong with the file. */
static const char *decode_samples(const unsigned char *bytes, size_t size, const png_info *info,
                                  void **decoded, samples *out) {
    uint64_t raw = png_raw_bytes(info);
    int width = 0;
    int height = 0;
    *decoded = NULL;
    if (raw / MOST_EXPANSION > size) {
        return "too short for its size";
    }
    png_block_limit = 2 * (size + raw) + 65536;
    png_block_refused = 0;
    *out = (samples){NULL, NULL, 0};
    if (info->bit_depth == 16) {
        out->wide = *decoded =
            stbi_load_16_from_memory(bytes, (int)size, &width, &height, &out->channels, 0);
    } else {
        out->narrow = *decoded =
            stbi_load_from_memory(bytes, (int)size, &width, &height, &out->channels, 0);
    }
    if (png_block_refused) {
        return "more bytes than its size needs";
    }
    return stbi_failure_reason() != NULL ? stbi_failure_reason() : "for an unknown reason";
}

static int decode_png(const unsigned char *bytes, size_t size, const char *name, image *out,
                      tool_error *error) {
    png_info info;
    const char *cause = png_check(bytes, size, &info);
    if (cause != NULL) {
        tool_error_set(error, "%s: %s", name, cause);
        return -1;
    }
    uint32_t maxval = info.bit_depth == 16 ? 65535 : 255;
    if (image_check_size(info.width, info.height, name, error) != 0) {
        return -1;
    }
    samples s;
    void *decoded;
    unsigned char *mended = png_mend(bytes, &size, &info);
    if (mended == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    const char *damage = decode_samples(mended, size, &info, &decoded, &s);
    free(mended);
    int rc = -1;
    if (decoded == NULL) {
        tool_error_set(error, "%s: the PNG is damaged (%s)", name, damage);
    } else if (image_allocate(info.width, info.height, maxval, name, out, error) == 0) {
        cause = take_samples(&s, out);
        rc = cause == NULL ? 0 : -1;
        if (cause != NULL) {
            tool_error_set(error, "%s: %s", name, cause);
        }
    }
    stbi_image_free(decoded);
    return rc;
}

int image_decode(const unsigned char *bytes, size_t size, const char *name, image *out,
                 tool_error *error) {
    *out = (image){NULL, NULL, 0, 0, 0};
    int rc = -1;
    if (image_is_png(bytes, size)) {
        rc = decode_png(bytes, size, name, out, error);
    } else if (image_is_pnm(bytes, size)) {
        rc = pgm_decode(bytes, size, name, out, error);
    } else {
        tool_error_set(error, "%s: neither a PNG nor a PGM image", name);
    }
    if (rc != 0) {
        image_free(out);
    }
    return rc;
}

int image_load(const char *path, image *out, tool_error *error) {
    *out = (image){NULL, NULL, 0, 0, 0};
    unsigned char *bytes;
    size_t size;
    if (infile_read(path, &bytes, &size, error) != 0) {
        return -1;
    }
    int rc = image_decode(bytes, size, path, out, error);
    free(bytes);
    return rc;
}

static void write_to_stream(void *stream, void *data, int size) {
    fwrite(data, 1, (size_t)size, stream);
}

int image_write_png(FILE *stream, const uint8_t *pixels, uint32_t width, uint32_t height,
                    int channels) {
    return stbi_write_png_to_func(write_to_stream, stream, (int)width, (int)height, channels,
                                  pixels, (int)width * channels) != 0
               ? 0
               : -1;
}
