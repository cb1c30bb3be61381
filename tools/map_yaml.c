#include "map_yaml.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "yaml.h"

typedef enum map_mode { MODE_TRINARY, MODE_SCALE, MODE_RAW } map_mode;

typedef struct settings {
    const char *image; /* as written */
    double resolution_m;
    double origin[3]; /* m, m, rad */
    int negate;
    double occupied_thresh, free_thresh;
    map_mode mode;
} settings;

/* The document, for functions that read one key each. */
typedef struct reader {
    const yaml *doc;
    const char *path;
    tool_error *error;
} reader;

static int fail(const reader *r, const yaml_entry *entry, const char *cause) {
    tool_error_set(r->error, "%s:%d: %s %s", r->path, entry->line, entry->key, cause);
    return -1;
}

/* The entry of a key that must be there, as a list or as a scalar; NULL with the error set. */
static const yaml_entry *need(const reader *r, const char *key, int is_list) {
    const yaml_entry *entry = yaml_find(r->doc, key);
    if (entry == NULL) {
        tool_error_set(r->error, "%s: key '%s' is missing", r->path, key);
        return NULL;
    }
    if (entry->nested || entry->is_list != is_list ||
        (!is_list && (entry->item_count == 0 || entry->items[0][0] == '\0'))) {
        fail(r, entry, is_list ? "is not a list" : "is not a single value");
        return NULL;
    }
    return entry;
}

static int read_real(const reader *r, const char *key, double *out) {
    const yaml_entry *entry = need(r, key, 0);
    if (entry == NULL) {
        return -1;
    }
    return parse_real(entry->items[0], out) == 0 ? 0 : fail(r, entry, "is not a finite number");
}

static int read_share(const reader *r, const char *key, double *out) {
    if (read_real(r, key, out) != 0) {
        return -1;
    }
    return *out >= 0 && *out <= 1 ? 0 : fail(r, yaml_find(r->doc, key), "is not within 0..1");
}

static int read_origin(const reader *r, double origin[3]) {
    const yaml_entry *entry = need(r, "origin", 1);
    if (entry == NULL) {
        return -1;
    }
    if (entry->item_count != 3) {
        return fail(r, entry, "does not have the three numbers x, y, yaw");
    }
    for (int i = 0; i < 3; i++) {
        if (parse_real(entry->items[i], &origin[i]) != 0) {
            return fail(r, entry, "holds something that is not a finite number");
        }
    }
    return 0;
}

/* Index of the scalar in a list of words that ends with NULL, without regard to case; -1
 * with the error set. */
static int read_word(const reader *r, const char *key, const char *const *words,
                     const char *cause) {
    const yaml_entry *entry = need(r, key, 0);
    if (entry == NULL) {
        return -1;
    }
    for (int i = 0; words[i] != NULL; i++) {
        size_t n = 0;
        while (words[i][n] != '\0' && tolower((unsigned char)entry->items[0][n]) == words[i][n]) {
            n++;
        }
        if (words[i][n] == '\0' && entry->items[0][n] == '\0') {
            return i;
        }
    }
    return fail(r, entry, cause);
}

static int read_settings(const reader *r, settings *out) {
    static const char *const switches[] = {"0", "1", "false", "true", NULL};
    static const char *const modes[] = {"trinary", "scale", "raw", NULL};
    const yaml_entry *file = need(r, "image", 0);
    if (file == NULL || read_real(r, "resolution", &out->resolution_m) != 0 ||
        read_origin(r, out->origin) != 0) {
        return -1;
    }
    out->image = file->items[0];
    if (!(out->resolution_m > 0)) {
        return fail(r, yaml_find(r->doc, "resolution"), "is not above 0");
    }
    int word = read_word(r, "negate", switches, "is neither 0 nor 1");
    if (word < 0 || read_share(r, "occupied_thresh", &out->occupied_thresh) != 0 ||
        read_share(r, "free_thresh", &out->free_thresh) != 0) {
        return -1;
    }
    out->negate = word % 2;
    if (out->free_thresh >= out->occupied_thresh) {
        return fail(r, yaml_find(r->doc, "free_thresh"), "is not below occupied_thresh");
    }
    out->mode = MODE_TRINARY;
    if (yaml_find(r->doc, "mode") != NULL) {
        word = read_word(r, "mode", modes, "is none of trinary, scale, raw");
        out->mode = (map_mode)word;
    }
    return word < 0 ? -1 : 0;
}

/* sample: with negate already applied, so that black is occupied in all modes but raw. */
static uint8_t cell_of_sample(const settings *s, uint32_t sample, uint32_t maxval) {
    if (s->mode == MODE_RAW) {
        return (uint8_t)(sample > 100 ? MAP_UNKNOWN : (sample * 255u + 50u) / 100u);
    }
    double p = (double)(maxval - sample) / maxval;
    if (p > s->occupied_thresh) {
        return 255;
    }
    if (p < s->free_thresh) {
        return 0;
    }
    if (s->mode == MODE_TRINARY) {
        return MAP_UNKNOWN;
    }
    double share = (p - s->free_thresh) / (s->occupied_thresh - s->free_thresh);
    return (uint8_t)(share * 255.0 + 0.5);
}

/* The image's path as seen from here, to be freed; NULL when memory runs out. */
static char *image_path(const char *yaml_path, const char *image_name) {
    const char *slash = strrchr(yaml_path, '/');
    size_t folder = image_name[0] == '/' || slash == NULL ? 0 : (size_t)(slash - yaml_path) + 1;
    size_t size = folder + strlen(image_name) + 1;
    char *path = malloc(size);
    if (path != NULL) {
        memcpy(path, yaml_path, folder);
        memcpy(path + folder, image_name, size - folder);
    }
    return path;
}

static int load_cells(const settings *s, const char *path, map *out, tool_error *error) {
    image img;
    if (image_load(path, &img, error) != 0) {
        return -1;
    }
    uint8_t cell_of[65536];
    for (uint32_t v = 0; v <= img.maxval; v++) {
        cell_of[v] = cell_of_sample(s, s->negate ? img.maxval - v : v, img.maxval);
    }
    int rc = map_from_image(&img, cell_of, path, out, error);
    image_free(&img);
    return rc;
}

int map_yaml_load(char *text, const char *path, map *out, tool_error *error) {
    yaml doc;
    settings s;
    const reader r = {&doc, path, error};
    if (yaml_parse(text, path, &doc, error) != 0 || read_settings(&r, &s) != 0) {
        return -1;
    }
    char *file = image_path(path, s.image);
    if (file == NULL) {
        tool_error_set(error, "%s: out of memory", path);
        return -1;
    }
    int rc = load_cells(&s, file, out, error);
    free(file);
    if (rc == 0) {
        out->resolution_m = s.resolution_m;
        out->origin_x_m = s.origin[0];
        out->origin_y_m = s.origin[1];
        out->origin_yaw_rad = s.origin[2];
    }
    return rc;
}
