#include "map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "infile.h"
#include "map_pgm.h"
#include "map_yaml.h"
#include "roomseg/roomseg.h"

static const map empty_map = {NULL, 0, 0, 0, 0, 0, 0};

int map_from_image(const image *img, const uint8_t *cell_of, const char *name, map *out,
                   tool_error *error) {
    size_t count = (size_t)img->width * img->height;
    *out = empty_map;
    out->cells = malloc(count);
    if (out->cells == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    out->width = img->width;
    out->height = img->height;
    for (size_t i = 0; i < count; i++) {
        int opaque = img->opaque == NULL || img->opaque[i];
        out->cells[i] = opaque ? cell_of[img->gray[i]] : MAP_UNKNOWN;
    }
    return 0;
}

/* Takes resolution and origin from the header of a PGM, if it tells them. */
static int take_neato_pose(const unsigned char *bytes, size_t size, const char *path, map *out,
                           tool_error *error) {
    neato_metadata meta;
    if (pgm_neato_metadata(bytes, size, path, &meta, error) != 0) {
        return -1;
    }
    if (meta.found) {
        out->resolution_m = meta.resolution_mm / 1000.0;
        out->origin_x_m = meta.origin_x_mm / 1000.0;
        out->origin_y_m = meta.origin_y_mm / 1000.0;
    }
    return 0;
}

static int load_bare(const unsigned char *bytes, size_t size, const char *path, int invert,
                     map *out, tool_error *error) {
    image img;
    if (image_decode(bytes, size, path, &img, error) != 0) {
        return -1;
    }
    uint8_t cell_of[65536];
    for (uint32_t v = 0; v <= img.maxval; v++) {
        uint8_t cell = (uint8_t)((v * 255u + img.maxval / 2) / img.maxval);
        cell_of[v] = invert ? (uint8_t)(255 - cell) : cell;
    }
    int rc = map_from_image(&img, cell_of, path, out, error);
    image_free(&img);
    if (rc == 0) {
        out->resolution_m = MAP_DEFAULT_RESOLUTION_M;
        if (image_is_pnm(bytes, size)) {
            rc = take_neato_pose(bytes, size, path, out, error);
        }
    }
    return rc;
}

static int load_bytes(unsigned char *bytes, size_t size, const char *path,
                      const map_options *options, map *out, tool_error *error) {
    if (image_is_png(bytes, size) || image_is_pnm(bytes, size)) {
        return load_bare(bytes, size, path, options->invert, out, error);
    }
    if (size > MAP_YAML_MAX_BYTES || memchr(bytes, 0, size) != NULL) {
        tool_error_set(error, "%s: neither a PNG or PGM image nor a map_server YAML", path);
        return -1;
    }
    if (options->invert) {
        tool_error_set(error, "%s: a map_server YAML says by 'negate' whether white is free",
                       path);
        return -1;
    }
    return map_yaml_load((char *)bytes, path, out, error);
}

static int check_resolution(const char *path, const map *m, tool_error *error) {
    double mm = round(m->resolution_m * 1000.0);
    if (mm >= ROOMSEG_MIN_RESOLUTION_MM && mm <= ROOMSEG_MAX_RESOLUTION_MM) {
        return 0;
    }
    tool_error_set(error, "%s: a resolution of %g m a cell is not within %g..%g", path,
                   m->resolution_m, ROOMSEG_MIN_RESOLUTION_MM / 1000.0,
                   ROOMSEG_MAX_RESOLUTION_MM / 1000.0);
    return -1;
}

int map_load(const char *path, const map_options *options, map *out, tool_error *error) {
    *out = empty_map;
    unsigned char *bytes;
    size_t size;
    if (infile_read(path, &bytes, &size, error) != 0) {
        return -1;
    }
    int rc = load_bytes(bytes, size, path, options, out, error);
    free(bytes);
    if (rc == 0) {
        if (options->resolution_m > 0) {
            out->resolution_m = options->resolution_m;
        }
        rc = check_resolution(path, out, error);
    }
    if (rc != 0) {
        map_free(out);
    }
    return rc;
}

void map_free_cells(map *m) {
    free(m->cells);
    m->cells = NULL;
}

void map_free(map *m) {
    map_free_cells(m);
    *m = empty_map;
}

void map_cell_to_world(const map *m, double x, double y, double *world_x_m,
                       double *world_y_m) {
    double right = (x + 0.5) * m->resolution_m;
    double up = ((double)m->height - 0.5 - y) * m->resolution_m;
    double c = cos(m->origin_yaw_rad);
    double s = sin(m->origin_yaw_rad);
    *world_x_m = m->origin_x_m + c * right - s * up;
    *world_y_m = m->origin_y_m + s * right + c * up;
}
