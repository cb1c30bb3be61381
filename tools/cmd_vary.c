#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "args.h"
#include "commands.h"
#include "dataset.h"
#include "out.h"
#include "roomseg/roomseg.h"
#include "simulate/turn.h"
#include "vary/vary.h"

static const char usage[] =
    "usage: roomseg vary DATASET [--set NAME] [--clutter N] [--turn DEG] [--cells M]\n"
    "                    [--salt PERCENT] [--seed N] [--resolution M] [--invert] -o FOLDER\n";

static const char help[] =
    "\n"
    "Changes every map of a set in the same way, and its truth with it: FOLDER/NAME/map.pgm\n"
    "and truth.pgm, a data set for roomseg bench that shows what the change does to the rooms.\n"
    "DATASET is a folder as roomseg bench takes it. The same numbers give the same files on\n"
    "every machine. The maps are cut to what is known in them and lose their origin.\n"
    "\n"
    "  --set NAME      which set, when the folder has several\n"
    "  --clutter N     N squares of 25 to 55 cm a square metre stand about on the free floor,\n"
    "                  0 to 4; the truth stays as it is\n"
    "  --turn DEG      turns counter-clockwise, -360 to 360\n"
    "  --cells M       draws the map with cells of M metres, 0.02 to 0.2\n"
    "  --salt PERCENT  so many of the known cells become certainly free or certainly\n"
    "                  occupied, half each, 0 to 100; the truth stays as it is\n"
    "  --seed N        which clutter and salt, 0 to 2147483647; default 1\n"
    "  --resolution M  edge of a cell of the maps; default: what they say, else 0.04\n"
    "  --invert        the images are white where the floor is free (not for YAML)\n"
    "\n"
    "Several changes are made in this order.\n";

typedef struct request {
    const char *folder, *set, *output;
    map_options map;
    uint32_t clutter;  /* pieces per 1000 m2 */
    int32_t turn;      /* as in simulate/turn.h */
    int resolution_mm; /* 0: as it is */
    uint32_t salt;     /* cells per million */
    uint64_t seed;
    int help;
} request;

/* The texts of the options that hold numbers; NULL: not given. */
typedef struct number_texts {
    const char *clutter, *turn, *cells, *salt, *seed, *resolution;
} number_texts;

/* Reads a number and scales it to a whole one; text NULL leaves 0. */
static int read_scaled(const char *option, const char *text, double low, double high,
                       double scale, int32_t *out, tool_error *error) {
    double value = 0.0;
    if (text != NULL && args_real(option, text, low, high, &value, error) != 0) {
        return -1;
    }
    value *= scale;
    *out = (int32_t)(value < 0.0 ? value - 0.5 : value + 0.5);
    return 0;
}

static int read_numbers(const number_texts *text, request *q, tool_error *error) {
    const double finest = ROOMSEG_MIN_RESOLUTION_MM / 1000.0;
    const double coarsest = ROOMSEG_MAX_RESOLUTION_MM / 1000.0;
    int32_t clutter, turn, cells, salt;
    long seed = 1;
    if (read_scaled("--clutter", text->clutter, 0.0, 4.0, 1000.0, &clutter, error) != 0 ||
        read_scaled("--turn", text->turn, -360.0, 360.0, TURN_FULL / 360.0, &turn, error) != 0 ||
        read_scaled("--cells", text->cells, finest, coarsest, 1000.0, &cells, error) != 0 ||
        read_scaled("--salt", text->salt, 0.0, 100.0, 10000.0, &salt, error) != 0 ||
        (text->seed != NULL &&
         args_integer("--seed", text->seed, 0, 2147483647, &seed, error) != 0) ||
        (text->resolution != NULL &&
         args_real("--resolution", text->resolution, finest, coarsest, &q->map.resolution_m,
                   error) != 0)) {
        return -1;
    }
    q->clutter = (uint32_t)clutter;
    q->turn = -turn;
    q->resolution_mm = cells;
    q->salt = (uint32_t)salt;
    q->seed = (uint64_t)seed;
    return 0;
}

static int read_request(int argc, char **argv, request *out, tool_error *error) {
    number_texts text = {NULL, NULL, NULL, NULL, NULL, NULL};
    int operands;
    memset(out, 0, sizeof *out);
    const arg_option options[] = {
        {"--output", "-o", &out->output, NULL},
        {"--set", NULL, &out->set, NULL},
        {"--clutter", NULL, &text.clutter, NULL},
        {"--turn", NULL, &text.turn, NULL},
        {"--cells", NULL, &text.cells, NULL},
        {"--salt", NULL, &text.salt, NULL},
        {"--seed", NULL, &text.seed, NULL},
        {"--resolution", NULL, &text.resolution, NULL},
        {"--invert", NULL, NULL, &out->map.invert},
        {"--help", "-h", NULL, &out->help},
        {NULL, NULL, NULL, NULL},
    };
    if (args_parse(argc, argv, options, &out->folder, 1, &operands, error) != 0) {
        return -1;
    }
    if (!out->help && (operands == 0 || out->output == NULL)) {
        tool_error_set(error, operands == 0 ? "vary: which data set?"
                                            : "vary: -o FOLDER is missing");
        return -1;
    }
    return read_numbers(&text, out, error);
}

/* Things stand on the floor before the robot maps them, noise comes last. */
static int change(const request *q, scene *s) {
    const roomseg_config config = roomseg_config_default();
    rng clutter, salt;
    rng_seed(&clutter, q->seed, 1);
    rng_seed(&salt, q->seed, 2);
    vary_clutter(s, config.free_max, q->clutter, &clutter);
    if (q->turn != 0 && vary_turn(s, q->turn) != 0) {
        return -1;
    }
    if (q->resolution_mm != 0 && vary_resample(s, q->resolution_mm) != 0) {
        return -1;
    }
    vary_salt(s, q->salt, &salt);
    return 0;
}

static int vary_map(const request *q, const dataset_map *files, tool_error *error) {
    scene s;
    if (scene_load(files->map, files->truth, &q->map, &s, error) != 0) {
        return -1;
    }
    int rc = change(q, &s);
    if (rc != 0) {
        tool_error_set(error, "%s: too large, or out of memory", files->map);
    } else {
        char *folder = out_join(q->output, files->name);
        if (folder == NULL) {
            tool_error_set(error, "%s: out of memory", files->map);
        }
        rc = folder != NULL ? scene_write(&s, folder, error) : -1;
        free(folder);
    }
    scene_free(&s);
    return rc;
}

/* The set that was asked for, or the only one; NULL with *error set. */
static const dataset_set *find_set(const request *q, const dataset *data, tool_error *error) {
    if (q->set == NULL && data->count == 1) {
        return &data->sets[0];
    }
    for (size_t i = 0; q->set != NULL && i < data->count; i++) {
        if (strcmp(q->set, data->sets[i].name) == 0) {
            return &data->sets[i];
        }
    }
    if (q->set != NULL) {
        tool_error_set(error, "%s: has no set '%s'", q->folder, q->set);
    } else {
        tool_error_set(error, "%s: has %zu sets; which one (--set)?", q->folder, data->count);
    }
    return NULL;
}

static int vary_set(const request *q, const dataset_set *set, tool_error *error) {
    int terminal = isatty(STDERR_FILENO);
    int rc = 0;
    for (size_t i = 0; i < set->count && rc == 0; i++) {
        if (terminal) {
            fprintf(stderr, "\r\033[K[%zu/%zu] %s", i + 1, set->count, set->maps[i].name);
        }
        rc = vary_map(q, &set->maps[i], error);
    }
    if (terminal) {
        fputs("\r\033[K", stderr);
    }
    return rc;
}

int cmd_vary(int argc, char **argv) {
    request q;
    dataset data;
    tool_error error = {""};
    if (read_request(argc, argv, &q, &error) != 0) {
        return args_usage_error(&error, usage);
    }
    if (q.help) {
        printf("%s%s", usage, help);
        return EXIT_DONE;
    }
    int rc = dataset_open(q.folder, &data, &error);
    if (rc == 0) {
        const dataset_set *set = find_set(&q, &data, &error);
        rc = set != NULL ? vary_set(&q, set, &error) : -1;
        if (rc == 0) {
            printf("%s: %zu maps\n", q.output, set->count);
        }
        dataset_free(&data);
    }
    if (rc != 0) {
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    return EXIT_DONE;
}
