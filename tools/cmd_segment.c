#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "commands.h"
#include "map.h"
#include "profile_option.h"
#include "report.h"
#include "segment_batch.h"
#include "segment_file.h"
#include "workers.h"

static const char usage[] =
    "usage: roomseg segment MAP... -o FOLDER [-j N] [--resolution M] [--profile NAME] [--align]\n"
    "                       [--free-below N] [--occupied-above N] [--invert]\n";

static const char help[] =
    "\n"
    "Cuts a map into rooms. Writes labels.pgm, rooms.json and rooms.png into FOLDER,\n"
    "which is made when it is missing, and prints a table of the rooms. Of several maps each\n"
    "has its folder, FOLDER/NAME for NAME.png, and a line; one that fails is named, the others\n"
    "go on, and the exit code is then 1.\n"
    "\n"
    "MAP is a PNG or PGM occupancy grid (0 free, 255 occupied, 127 unknown; resolution\n"
    "and origin from the header of a Neato robot's PGM), or a ROS map_server YAML.\n"
    "\n"
    "  -o, --output FOLDER   where the results go\n"
    "  -j, --jobs N          maps at a time, 1 to 256; default: as many as there are cores\n"
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
    const char **maps; /* room for all arguments, owned */
    int map_count;
    const char *folder;
    map_options options;
    roomseg_config config;
    int workers;
    int align, help;
} request;

/* Numbers out of the texts of options; a text that is NULL leaves the default. */
static int read_values(const char *resolution, const char *jobs, const char *free_below,
                       const char *occupied_above, request *out, tool_error *error) {
    long workers = workers_default();
    long free_max = out->config.free_max;
    long highest_unsure = out->config.occupied_min - 1;
    if (resolution != NULL &&
        args_real("--resolution", resolution, ROOMSEG_MIN_RESOLUTION_MM / 1000.0,
                  ROOMSEG_MAX_RESOLUTION_MM / 1000.0, &out->options.resolution_m, error) != 0) {
        return -1;
    }
    if (jobs != NULL && args_integer("--jobs", jobs, 1, WORKERS_MAX, &workers, error) != 0) {
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
    out->workers = (int)workers;
    out->config.free_max = (uint8_t)free_max;
    out->config.occupied_min = (uint8_t)(highest_unsure + 1);
    out->config.align = out->align ? ROOMSEG_ALIGN_ON : out->config.align;
    return 0;
}

static int read_request(int argc, char **argv, request *out, tool_error *error) {
    const char *resolution = NULL;
    const char *jobs = NULL;
    const char *free_below = NULL;
    const char *occupied_above = NULL;
    memset(out, 0, sizeof *out);
    out->maps = malloc((size_t)argc * sizeof *out->maps);
    if (out->maps == NULL) {
        tool_error_set(error, "segment: out of memory");
        return -1;
    }
    const arg_option options[] = {
        {"--output", "-o", &out->folder, NULL},
        {"--jobs", "-j", &jobs, NULL},
        {"--resolution", NULL, &resolution, NULL},
        {"--align", NULL, NULL, &out->align},
        {"--free-below", NULL, &free_below, NULL},
        {"--occupied-above", NULL, &occupied_above, NULL},
        {"--invert", NULL, NULL, &out->options.invert},
        {"--help", "-h", NULL, &out->help},
        {NULL, NULL, NULL, NULL},
    };
    if (profile_take_option(&argc, argv, &out->config, error) != 0 ||
        args_parse(argc, argv, options, out->maps, argc, &out->map_count, error) != 0) {
        return -1;
    }
    if (!out->help && (out->map_count == 0 || out->folder == NULL)) {
        tool_error_set(error, out->map_count == 0 ? "segment: which map?"
                                                  : "segment: -o FOLDER is missing");
        return -1;
    }
    return read_values(resolution, jobs, free_below, occupied_above, out, error);
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
    printf("\nwritten: %s/%s\n", q->folder, SEGMENT_FILE_NAMES);
}

static int segment_one(const request *q, tool_error *error) {
    map m;
    segmentation s;
    if (segment_file(q->maps[0], q->folder, &q->options, &q->config, &m, &s, error) != 0) {
        return -1;
    }
    print_summary(q, &m, &s);
    segmentation_free(&s);
    map_free(&m);
    return 0;
}

static int segment_all(const request *q, tool_error *error) {
    segment_batch batch = {q->maps,    (size_t)q->map_count, q->folder,
                           q->options, q->config,            q->workers};
    return segment_batch_run(&batch, error);
}

int cmd_segment(int argc, char **argv) {
    request q;
    tool_error error;
    int code = EXIT_DONE;
    if (read_request(argc, argv, &q, &error) != 0) {
        code = args_usage_error(&error, usage);
    } else if (q.help) {
        printf("%s%s", usage, help);
    } else if ((q.map_count == 1 ? segment_one : segment_all)(&q, &error) != 0) {
        tool_error_print(&error);
        code = EXIT_BAD_INPUT;
    }
    free(q.maps);
    return code;
}
