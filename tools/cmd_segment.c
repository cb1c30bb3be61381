#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "commands.h"
#include "map.h"
#include "out.h"
#include "profile_option.h"
#include "report.h"
#include "rooms_png.h"
#include "segment.h"

static const char usage[] =
    "usage: roomseg segment MAP -o FOLDER [--resolution M] [--profile NAME] [--align]\n"
    "                       [--free-below N] [--occupied-above N] [--invert]\n";

static const char help[] =
    "\n"
    "Cuts a map into rooms. Writes labels.pgm, rooms.json and rooms.png into FOLDER,\n"
    "which is made when it is missing, and prints a table of the rooms.\n"
    "\n"
    "MAP is a PNG or PGM occupancy grid (0 free, 255 occupied, 127 unknown; resolution\n"
    "and origin from the header of a Neato robot's PGM), or a ROS map_server YAML.\n"
    "\n"
    "  -o, --output FOLDER   where the results go\n"
    "  --resolution M        edge of a cell in metres, 0.02 to 0.2; default: what the map\n"
    "                        says, else 0.04\n"
    "  --profile NAME        default, or paper: the published system, which leaves cells\n"
    "                        beside walls and between rooms without a room; or paper-home:\n"
    "                        that with its settings for homes, and --align\n"
    "  --align               turns the map until its walls lie along the axes; the rooms come\n"
    "                        back in the map's own cells\n"
    "  --free-below N        cells up to this occupancy are free, 0 to 254; default 51\n"
    "  --occupied-above N    cells above this are obstacles for sure and never belong to a\n"
    "                        room, 0 to 254, not below --free-below; default 203\n"
    "  --invert              the image is white where the floor is free (not for YAML)\n";

typedef struct request {
    const char *map_path;
    const char *folder;
    map_options options;
    roomseg_config config;
    int align, help;
} request;

/* Numbers out of the texts of options; a text that is NULL leaves the default. */
static int read_values(const char *resolution, const char *free_below,
                       const char *occupied_above, request *out, tool_error *error) {
    long free_max = out->config.free_max;
    long highest_unsure = out->config.occupied_min - 1;
    if (resolution != NULL &&
        args_real("--resolution", resolution, ROOMSEG_MIN_RESOLUTION_MM / 1000.0,
                  ROOMSEG_MAX_RESOLUTION_MM / 1000.0, &out->options.resolution_m, error) != 0) {
        return -1;
    }
    if (free_below != NULL &&
        args_integer("--free-below", free_below, 0, 254, &free_max, error) != 0) {
        return -1;
    }
    if (occupied_above != NULL &&
        args_integer("--occupied-above", occupied_above, 0, 254, &highest_unsure, error) != 0) {
        return -1;
    }
    if (highest_unsure < free_max) {
        tool_error_set(error, "--occupied-above %ld is below --free-below %ld", highest_unsure,
                       free_max);
        return -1;
    }
    out->config.free_max = (uint8_t)free_max;
    out->config.occupied_min = (uint8_t)(highest_unsure + 1);
    out->config.align = out->align ? ROOMSEG_ALIGN_ON : out->config.align;
    return 0;
}

static int read_request(int argc, char **argv, request *out, tool_error *error) {
    const char *resolution = NULL;
    const char *free_below = NULL;
    const char *occupied_above = NULL;
    int operand_count;
    memset(out, 0, sizeof *out);
    const arg_option options[] = {
        {"--output", "-o", &out->folder, NULL},
        {"--resolution", NULL, &resolution, NULL},
        {"--align", NULL, NULL, &out->align},
        {"--free-below", NULL, &free_below, NULL},
        {"--occupied-above", NULL, &occupied_above, NULL},
        {"--invert", NULL, NULL, &out->options.invert},
        {"--help", "-h", NULL, &out->help},
        {NULL, NULL, NULL, NULL},
    };
    if (profile_take_option(&argc, argv, &out->config, error) != 0 ||
        args_parse(argc, argv, options, &out->map_path, 1, &operand_count, error) != 0) {
        return -1;
    }
    if (!out->help && (operand_count == 0 || out->folder == NULL)) {
        tool_error_set(error, operand_count == 0 ? "segment: which map?"
                                                 : "segment: -o FOLDER is missing");
        return -1;
    }
    return read_values(resolution, free_below, occupied_above, out, error);
}

enum { OUT_LABELS, OUT_JSON, OUT_PNG, OUT_COUNT };

static const char *const out_names[OUT_COUNT] = {"labels.pgm", "rooms.json", "rooms.png"};

static int write_one(int which, const request *q, const map *m, const segmentation *s,
                     out_file *file, tool_error *error) {
    switch (which) {
    case OUT_LABELS:
        report_labels_pgm(m, s, file->stream);
        break;
    case OUT_JSON:
        report_json(m, s, q->map_path, file->stream);
        break;
    default:
        if (rooms_png_write(m, s, file->stream, file->path, error) != 0) {
            return -1;
        }
    }
    return out_flush(file, error);
}

static int open_one(const char *folder, const char *name, out_file *file, tool_error *error) {
    char *path = out_join(folder, name);
    if (path == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    int rc = out_open(file, path, error);
    free(path);
    return rc;
}

/* Writes all files before any gets its name, so that a full disk leaves the old ones. */
static int write_outputs(const request *q, const map *m, const segmentation *s,
                         tool_error *error) {
    out_file files[OUT_COUNT] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}, {NULL, NULL, NULL}};
    int rc = out_make_folder(q->folder, error);
    for (int i = 0; i < OUT_COUNT && rc == 0; i++) {
        rc = open_one(q->folder, out_names[i], &files[i], error);
        if (rc == 0) {
            rc = write_one(i, q, m, s, &files[i], error);
        }
    }
    for (int i = 0; i < OUT_COUNT && rc == 0; i++) {
        rc = out_commit(&files[i], error);
    }
    for (int i = 0; i < OUT_COUNT; i++) {
        out_discard(&files[i]);
    }
    return rc;
}

static void print_summary(const request *q, const map *m, const segmentation *s) {
    const roomseg_result *r = &s->result;
    size_t crop_cells = (size_t)r->crop_width * r->crop_height;
    report_table(m, s, stdout);
    if (s->config.align != NULL) {
        printf("walls: %.2f degrees clockwise of the map's axes\n", r->wall_angle / 100.0);
    }
    printf("arena: %lu bytes for a crop of %u x %u cells", (unsigned long)r->arena_used,
           (unsigned)r->crop_width, (unsigned)r->crop_height);
    if (crop_cells > 0) {
        printf(", %.2f bytes a cell", (double)r->arena_used / (double)crop_cells);
    }
    printf("\nwritten: %s/{%s,%s,%s}\n", q->folder, out_names[0], out_names[1], out_names[2]);
}

int cmd_segment(int argc, char **argv) {
    request q;
    map m;
    segmentation s;
    tool_error error;
    if (read_request(argc, argv, &q, &error) != 0) {
        return args_usage_error(&error, usage);
    }
    if (q.help) {
        printf("%s%s", usage, help);
        return EXIT_DONE;
    }
    if (map_load(q.map_path, &q.options, &m, &error) != 0) {
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    int rc = segment_map(&m, &q.config, q.map_path, &s, &error);
    if (rc == 0) {
        rc = write_outputs(&q, &m, &s, &error);
        if (rc == 0) {
            print_summary(&q, &m, &s);
        }
        segmentation_free(&s);
    }
    map_free(&m);
    if (rc != 0) {
        tool_error_print(&error);
    }
    return rc == 0 ? EXIT_DONE : EXIT_BAD_INPUT;
}
