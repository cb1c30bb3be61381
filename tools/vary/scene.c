#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "out.h"
#include "truth.h"

int scene_is_known(uint8_t cell) {
    return cell != MAP_UNKNOWN && cell != MAP_UNKNOWN + 1;
}

int scene_resolution_mm(const scene *s) {
    return (int)(s->m.resolution_m * 1000.0 + 0.5);
}

void scene_free(scene *s) {
    map_free(&s->m);
    label_image_free(&s->truth);
}

int scene_rearrange(scene *s, uint32_t width, uint32_t height, scene_source_fn source_of,
                    const void *user) {
    size_t count = (size_t)width * height;
    uint8_t *cells = malloc(count);
    uint32_t *rooms = s->truth.values != NULL ? malloc(count * sizeof *rooms) : NULL;
    if (cells == NULL || (s->truth.values != NULL && rooms == NULL)) {
        free(cells);
        free(rooms);
        return -1;
    }
    size_t i = 0;
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++, i++) {
            size_t source = source_of(user, x, y);
            cells[i] = source == SCENE_OUTSIDE ? MAP_UNKNOWN : s->m.cells[source];
            if (rooms != NULL) {
                rooms[i] = source == SCENE_OUTSIDE ? 0 : s->truth.values[source];
            }
        }
    }
    free(s->m.cells);
    free(s->truth.values);
    s->m.cells = cells;
    s->truth.values = rooms;
    s->m.width = s->truth.width = width;
    s->m.height = s->truth.height = height;
    return 0;
}

typedef struct window {
    uint32_t x, y; /* its first cell in the old scene, both at least 1 */
    uint32_t width, height; /* of the old scene */
} window;

/* The new scene begins one cell to the left of and above the window. */
static size_t window_source(const void *user, uint32_t x, uint32_t y) {
    const window *w = user;
    uint32_t old_x = w->x + x;
    uint32_t old_y = w->y + y;
    if (old_x < 1 || old_y < 1 || old_x > w->width || old_y > w->height) {
        return SCENE_OUTSIDE;
    }
    return (size_t)(old_y - 1) * w->width + old_x - 1;
}

static int is_content(const scene *s, size_t i) {
    return scene_is_known(s->m.cells[i]) ||
           (s->truth.values != NULL && s->truth.values[i] != 0);
}

/* Large maps are mostly unknown; what is left out has no influence on the rooms. A scene of
 * which nothing is known stays as it is. */
static int crop(scene *s) {
    uint32_t right = 0, bottom = 0;
    window w = {s->m.width, s->m.height, s->m.width, s->m.height};
    size_t i = 0;
    for (uint32_t y = 0; y < s->m.height; y++) {
        for (uint32_t x = 0; x < s->m.width; x++, i++) {
            if (is_content(s, i)) {
                w.x = x < w.x ? x : w.x;
                w.y = y < w.y ? y : w.y;
                right = x > right ? x : right;
                bottom = y;
            }
        }
    }
    if (w.x == s->m.width) {
        return 0;
    }
    return scene_rearrange(s, right - w.x + 3, bottom - w.y + 3, window_source, &w);
}

static int load_truth(const char *path, scene *s, tool_error *error) {
    if (truth_load(path, TRUTH_AUTO, &s->truth, error) != 0) {
        return -1;
    }
    if (s->truth.width != s->m.width || s->truth.height != s->m.height) {
        tool_error_set(error, "%s: %ux%u cells, but the map has %ux%u", path,
                       (unsigned)s->truth.width, (unsigned)s->truth.height,
                       (unsigned)s->m.width, (unsigned)s->m.height);
        return -1;
    }
    return 0;
}

int scene_load(const char *map_path, const char *truth_path, const map_options *options,
               scene *out, tool_error *error) {
    memset(out, 0, sizeof *out);
    if (map_load(map_path, options, &out->m, error) != 0) {
        return -1;
    }
    int rc = truth_path != NULL ? load_truth(truth_path, out, error) : 0;
    if (rc == 0 && crop(out) != 0) {
        tool_error_set(error, "%s: out of memory", map_path);
        rc = -1;
    }
    if (rc != 0) {
        scene_free(out);
    }
    return rc;
}

static int write_map(const scene *s, const char *folder, out_file *file, tool_error *error) {
    if (out_open_in(file, folder, "map.pgm", error) != 0) {
        return -1;
    }
    fprintf(file->stream, "P5\n# Neato metadata: resolution=%d\n%u %u\n255\n",
            scene_resolution_mm(s), (unsigned)s->m.width, (unsigned)s->m.height);
    fwrite(s->m.cells, s->m.width, s->m.height, file->stream);
    return out_flush(file, error);
}

/* Two bytes a cell, as there may be more than 255 rooms. */
static int write_truth(const scene *s, const char *folder, out_file *file, tool_error *error) {
    size_t count = (size_t)s->truth.width * s->truth.height;
    if (out_open_in(file, folder, "truth.pgm", error) != 0) {
        return -1;
    }
    fprintf(file->stream, "P5\n%u %u\n65535\n", (unsigned)s->truth.width,
            (unsigned)s->truth.height);
    for (size_t i = 0; i < count; i++) {
        putc((int)(s->truth.values[i] >> 8 & 255), file->stream);
        putc((int)(s->truth.values[i] & 255), file->stream);
    }
    return out_flush(file, error);
}

int scene_write(const scene *s, const char *folder, tool_error *error) {
    out_file files[2] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
    int rc = out_make_folder(folder, error);
    if (rc == 0 && s->truth.values != NULL) {
        rc = write_truth(s, folder, &files[0], error);
    }
    if (rc == 0) {
        rc = write_map(s, folder, &files[1], error);
    }
    return out_end_all(files, 2, rc, error);
}
