#include "segment_file.h"

#include "image.h"
#include "out.h"
#include "report.h"
#include "rooms_png.h"

/* In the order of writing; the picture comes last, see write_picture. */
enum { OUT_LABELS, OUT_JSON, OUT_PNG, OUT_COUNT };

static const char *const out_names[OUT_COUNT] = {"labels.pgm", "rooms.json", "rooms.png"};

/* The encoder takes as much memory again as the picture, so cells and labels go before. */
static int write_picture(map *m, segmentation *s, out_file *file, tool_error *error) {
    canvas c;
    if (rooms_png_draw(m, s, file->path, &c, error) != 0) {
        return -1;
    }
    map_free_cells(m);
    segmentation_free_labels(s);
    int rc = image_write_png(file->stream, c.rgb, c.width, c.height, 3);
    if (rc != 0) {
        tool_error_set(error, "%s: out of memory", file->path);
    }
    canvas_free(&c);
    return rc;
}

static int write_one(int which, const char *path, map *m, segmentation *s, out_file *file,
                     tool_error *error) {
    switch (which) {
    case OUT_LABELS:
        report_labels_pgm(m, s, file->stream);
        break;
    case OUT_JSON:
        report_json(m, s, path, file->stream);
        break;
    default:
        if (write_picture(m, s, file, error) != 0) {
            return -1;
        }
    }
    return out_flush(file, error);
}

/* Writes all files before any gets its name, so that a full disk leaves the old ones. */
static int write_outputs(const char *path, const char *folder, map *m, segmentation *s,
                         tool_error *error) {
    out_file files[OUT_COUNT] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}, {NULL, NULL, NULL}};
    int rc = out_make_folder(folder, error);
    for (int i = 0; i < OUT_COUNT && rc == 0; i++) {
        rc = out_open_in(&files[i], folder, out_names[i], error);
        if (rc == 0) {
            rc = write_one(i, path, m, s, &files[i], error);
        }
    }
    return out_end_all(files, OUT_COUNT, rc, error);
}

int segment_file(const char *path, const char *folder, const map_options *options,
                 const roomseg_config *config, map *m, segmentation *s, tool_error *error) {
    if (map_load(path, options, m, error) != 0) {
        return -1;
    }
    int rc = segment_map(m, config, path, s, error);
    if (rc == 0) {
        rc = write_outputs(path, folder, m, s, error);
        if (rc != 0) {
            segmentation_free(s);
        }
    }
    if (rc != 0) {
        map_free(m);
    }
    return rc;
}
