#include "map_pgm.h"

#include <stdio.h>
#include <string.h>

#include "args.h"

/* Reading position in the file. The byte at `size` is readable and 0 (see infile.h). */
typedef struct cursor {
    const unsigned char *bytes;
    size_t size;
    size_t at;
} cursor;

typedef struct header {
    int text;        /* P2 */
    uint32_t width, height, maxval;
    size_t raster;   /* offset of the first sample */
} header;

static int is_blank(unsigned char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Passes over blanks and comments. Returns how many bytes that were. */
static size_t skip_blanks(cursor *c) {
    size_t start = c->at;
    while (c->at < c->size) {
        if (c->bytes[c->at] == '#') {
            while (c->at < c->size && c->bytes[c->at] != '\n' && c->bytes[c->at] != '\r') {
                c->at++;
            }
        } else if (is_blank(c->bytes[c->at])) {
            c->at++;
        } else {
            break;
        }
    }
    return c->at - start;
}

/* Reads an unsigned decimal of at most 9 digits that ends at a blank, a comment or the end
 * of the file. Returns 0 or -1. */
static int read_number(cursor *c, uint32_t *out) {
    uint32_t value = 0;
    size_t start = c->at;
    while (c->at < c->size && c->bytes[c->at] >= '0' && c->bytes[c->at] <= '9') {
        if (c->at - start == 9) {
            return -1;
        }
        value = value * 10 + (uint32_t)(c->bytes[c->at] - '0');
        c->at++;
    }
    int ends = c->at == c->size || is_blank(c->bytes[c->at]) || c->bytes[c->at] == '#';
    *out = value;
    return c->at > start && ends ? 0 : -1;
}

/* Returns NULL or the cause. */
static const char *read_header(cursor *c, header *out) {
    unsigned char kind = c->bytes[1];
    if (kind == '3' || kind == '6') {
        return "the image is a colour PPM; a map must be a gray PGM or PNG";
    }
    if (kind != '2' && kind != '5') {
        return "this kind of netpbm image is not understood; a map must be a PGM or PNG";
    }
    out->text = kind == '2';
    c->at = 2;
    uint32_t *fields[3] = {&out->width, &out->height, &out->maxval};
    static const char *const causes[3] = {"the PGM header holds no width",
                                          "the PGM header holds no height",
                                          "the PGM header holds no largest value"};
    for (int i = 0; i < 3; i++) {
        if (skip_blanks(c) == 0 || read_number(c, fields[i]) != 0) {
            return causes[i];
        }
    }
    if (out->maxval == 0 || out->maxval > 65535) {
        return "the largest value in the PGM header is not within 1..65535";
    }
    if (!out->text && (c->at == c->size || !is_blank(c->bytes[c->at]))) {
        return "the PGM is truncated behind its header";
    }
    out->raster = out->text ? c->at : c->at + 1;
    return NULL;
}

static void raster_error(const char *name, size_t i, uint32_t width, const char *cause,
                         tool_error *error) {
    tool_error_set(error, "%s: cell (%lu, %lu): %s", name, (unsigned long)(i % width),
                   (unsigned long)(i / width), cause);
}

static int read_text_raster(cursor *c, const char *name, image *out, tool_error *error) {
    size_t count = (size_t)out->width * out->height;
    for (size_t i = 0; i < count; i++) {
        uint32_t value;
        skip_blanks(c);
        if (c->at == c->size) {
            raster_error(name, i, out->width, "missing, the PGM is truncated", error);
            return -1;
        }
        if (read_number(c, &value) != 0) {
            raster_error(name, i, out->width, "not a number", error);
            return -1;
        }
        if (value > out->maxval) {
            raster_error(name, i, out->width, "above the PGM's largest value", error);
            return -1;
        }
        out->gray[i] = (uint16_t)value;
    }
    skip_blanks(c);
    if (c->at != c->size) {
        tool_error_set(error, "%s: there is more behind the PGM's last cell", name);
        return -1;
    }
    return 0;
}

static int read_binary_raster(cursor *c, const char *name, image *out, tool_error *error) {
    size_t count = (size_t)out->width * out->height;
    size_t sample_bytes = out->maxval > 255 ? 2 : 1;
    size_t have = c->size - c->at;
    if (have < count * sample_bytes) {
        tool_error_set(error, "%s: the PGM is truncated: %lu bytes of %lu are missing", name,
                       (unsigned long)(count * sample_bytes - have),
                       (unsigned long)(count * sample_bytes));
        return -1;
    }
    const unsigned char *b = c->bytes + c->at;
    for (size_t i = 0; i < count; i++) {
        unsigned value = sample_bytes == 1 ? b[i] : (unsigned)b[2 * i] << 8 | b[2 * i + 1];
        if (value > out->maxval) {
            raster_error(name, i, out->width, "above the PGM's largest value", error);
            return -1;
        }
        out->gray[i] = (uint16_t)value;
    }
    c->at += count * sample_bytes;
    while (c->at < c->size && is_blank(c->bytes[c->at])) {
        c->at++;
    }
    if (c->at != c->size) {
        tool_error_set(error, "%s: %lu bytes too many behind the PGM's last cell", name,
                       (unsigned long)(c->size - c->at));
        return -1;
    }
    return 0;
}

int pgm_decode(const unsigned char *bytes, size_t size, const char *name, image *out,
               tool_error *error) {
    cursor c = {bytes, size, 0};
    header h;
    const char *cause = read_header(&c, &h);
    if (cause != NULL) {
        tool_error_set(error, "%s: %s", name, cause);
        return -1;
    }
    if (image_check_size(h.width, h.height, name, error) != 0) {
        return -1;
    }
    /* A sample takes a byte at least: a short file must not cost a large allocation. */
    if (size - c.at < (size_t)h.width * h.height) {
        tool_error_set(error, "%s: the PGM is truncated: %u x %u cells do not fit in %lu bytes",
                       name, (unsigned)h.width, (unsigned)h.height, (unsigned long)size);
        return -1;
    }
    if (image_allocate(h.width, h.height, h.maxval, name, out, error) != 0) {
        return -1;
    }
    c.at = h.raster;
    return h.text ? read_text_raster(&c, name, out, error)
                  : read_binary_raster(&c, name, out, error);
}

/* One KEY=VALUE of the comment. */
static int take_pair(const char *key, const char *value, const char *name,
                     neato_metadata *out, tool_error *error) {
    double *target = strcmp(key, "origin_x") == 0     ? &out->origin_x_mm
                     : strcmp(key, "origin_y") == 0   ? &out->origin_y_mm
                     : strcmp(key, "resolution") == 0 ? &out->resolution_mm
                                                      : NULL;
    if (target != NULL && parse_real(value, target) != 0) {
        tool_error_set(error, "%s: Neato metadata: %s is not a number: '%s'", name, key, value);
        return -1;
    }
    return 0;
}

/* text: what stands behind "Neato metadata:", `length` bytes. */
static int parse_metadata(const unsigned char *text, size_t length, const char *name,
                          neato_metadata *out, tool_error *error) {
    char line[256];
    if (length >= sizeof line) {
        tool_error_set(error, "%s: Neato metadata: the line is too long", name);
        return -1;
    }
    memcpy(line, text, length);
    line[length] = '\0';
    for (char *word = strtok(line, " \t"); word != NULL; word = strtok(NULL, " \t")) {
        char *equals = strchr(word, '=');
        if (equals != NULL) {
            *equals = '\0';
            if (take_pair(word, equals + 1, name, out, error) != 0) {
                return -1;
            }
        }
    }
    if (!(out->resolution_mm > 0)) {
        tool_error_set(error, "%s: Neato metadata: no resolution above 0", name);
        return -1;
    }
    out->found = 1;
    return 0;
}

int pgm_neato_metadata(const unsigned char *bytes, size_t size, const char *name,
                       neato_metadata *out, tool_error *error) {
    static const char tag[] = "# Neato metadata:";
    *out = (neato_metadata){0, 0, 0, 0};
    cursor c = {bytes, size, 0};
    header h;
    if (read_header(&c, &h) != NULL) {
        return 0;
    }
    for (size_t at = 0; at + sizeof tag - 1 < h.raster; at++) {
        if (memcmp(bytes + at, tag, sizeof tag - 1) == 0) {
            size_t start = at + sizeof tag - 1;
            size_t end = start;
            while (end < h.raster && bytes[end] != '\n' && bytes[end] != '\r') {
                end++;
            }
            return parse_metadata(bytes + start, end - start, name, out, error);
        }
    }
    return 0;
}
