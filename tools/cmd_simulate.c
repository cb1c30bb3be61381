#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "args.h"
#include "commands.h"
#include "out.h"
#include "simulate/simulate.h"
#include "simulate/turn.h"

static const char usage[] =
    "usage: roomseg simulate --seed N [--size small|medium|large] [--furnished|--empty]\n"
    "                        [--clutter C] [--noise E] [--resolution M] [--rotate DEG] -o DIR\n";

static const char help[] =
    "Makes up a flat, drives a robot with a laser through it and writes DIR/map.pgm as the\n"
    "robot would, with DIR/truth.pgm: the true rooms 1, 2, ..., 0 = no room. The same numbers\n"
    "give the same files on every machine.\n"
    "  --seed N        which flat, 0..18446744073709551615\n"
    "  --size S        small 38-62 m2, medium 65-115 m2 (default), large 120-190 m2\n"
    "  --furnished     with furniture (default)\n"
    "  --empty         bare rooms, with their doors\n"
    "  --clutter C     things that stand about, 0..100; 50 = as people live (default)\n"
    "  --noise E       errors of laser and mapping, 0..100; 50 = as real robots (default)\n"
    "  --resolution M  edge of a cell, 0.02..0.2 m; default 0.05\n"
    "  --rotate DEG    turns the flat in the map counter-clockwise, -360..360; default: by\n"
    "                  the seed, mostly little\n"
    "The truth covers the cells that the map shows as free (up to 63). The floor of a doorway\n"
    "is halved between its rooms; what is seen through windows and shut rooms is 0.\n";

typedef struct simulate_options {
    const char *seed, *resolution, *size, *rotate, *clutter, *noise, *folder;
    int furnished, empty, help;
} simulate_options;

static int parse_seed(const char *text, uint64_t *seed, tool_error *error) {
    uint64_t value = 0;
    size_t length = strlen(text);
    int bad = length == 0;
    for (size_t i = 0; i < length && !bad; i++) {
        uint64_t digit = (uint64_t)(text[i] - '0');
        bad = text[i] < '0' || text[i] > '9' || value > (UINT64_MAX - digit) / 10;
        value = value * 10 + digit;
    }
    if (bad) {
        tool_error_set(error, "option --seed needs a whole number from 0 to %" PRIu64 ", not '%s'",
                       UINT64_MAX, text);
        return -1;
    }
    *seed = value;
    return 0;
}

static int parse_size(const char *text, flat_size *size, tool_error *error) {
    static const char *const names[] = {"small", "medium", "large"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(text, names[i]) == 0) {
            *size = (flat_size)i;
            return 0;
        }
    }
    tool_error_set(error, "option --size needs small, medium or large, not '%s'", text);
    return -1;
}

static int parse_percent(const char *option, const char *text, int *out, tool_error *error) {
    long value;
    if (args_integer(option, text, 0, 100, &value, error) != 0) {
        return -1;
    }
    *out = (int)value;
    return 0;
}

/* The nearest whole number: of all numbers from outside, these two are the only ones that
 * are not whole, and they are whole before anything is computed from them. */
static int32_t nearest(double value) {
    return (int32_t)(value < 0 ? value - 0.5 : value + 0.5);
}

static int read_numbers(const simulate_options *text, sim_options *o, tool_error *error) {
    double value;
    if (parse_seed(text->seed, &o->seed, error) != 0) {
        return -1;
    }
    if (text->resolution != NULL) {
        if (args_real("--resolution", text->resolution, 0.02, 0.2, &value, error) != 0) {
            return -1;
        }
        o->resolution_mm = nearest(value * 1000.0);
    }
    if (text->rotate != NULL) {
        if (args_real("--rotate", text->rotate, -360.0, 360.0, &value, error) != 0) {
            return -1;
        }
        o->has_turn = 1;
        o->turn = -nearest(value * TURN_FULL / 360.0);
    }
    if (text->size != NULL && parse_size(text->size, &o->size, error) != 0) {
        return -1;
    }
    if (text->clutter != NULL &&
        parse_percent("--clutter", text->clutter, &o->clutter, error) != 0) {
        return -1;
    }
    if (text->noise != NULL && parse_percent("--noise", text->noise, &o->noise, error) != 0) {
        return -1;
    }
    return 0;
}

static int parse(int argc, char **argv, simulate_options *text, sim_options *o,
                 tool_error *error) {
    int operands;
    const arg_option table[] = {{"--seed", NULL, &text->seed, NULL},
                                {"--resolution", NULL, &text->resolution, NULL},
                                {"--size", NULL, &text->size, NULL},
                                {"--rotate", NULL, &text->rotate, NULL},
                                {"--clutter", NULL, &text->clutter, NULL},
                                {"--noise", NULL, &text->noise, NULL},
                                {"--output", "-o", &text->folder, NULL},
                                {"--furnished", NULL, NULL, &text->furnished},
                                {"--empty", NULL, NULL, &text->empty},
                                {"--help", "-h", NULL, &text->help},
                                {NULL, NULL, NULL, NULL}};
    *o = sim_options_default();
    if (args_parse(argc, argv, table, NULL, 0, &operands, error) != 0) {
        return -1;
    }
    if (text->help) {
        return 0;
    }
    if (text->seed == NULL || text->folder == NULL) {
        tool_error_set(error, "simulate needs %s", text->seed == NULL ? "--seed" : "-o DIR");
        return -1;
    }
    if (text->furnished && text->empty) {
        tool_error_set(error, "--furnished and --empty exclude each other");
        return -1;
    }
    o->furnished = !text->empty;
    return read_numbers(text, o, error);
}

/* The turn that makes the walls parallel to the axes, counter-clockwise, 0 to pi/2, in
 * millionths of a radian: what the robot calls its map's alignment. */
static int32_t alignment_urad(int32_t turn) {
    int32_t rest = turn % TURN_QUARTER;
    rest = rest < 0 ? rest + TURN_QUARTER : rest;
    return (int32_t)((int64_t)rest * 6283185 / TURN_FULL);
}

static int write_pgm(const char *folder, const char *name, const sim_map *m,
                     const uint8_t *cells, int with_pose, out_file *file, tool_error *error) {
    if (out_open_in(file, folder, name, error) != 0) {
        return -1;
    }
    fputs("P5\n", file->stream);
    if (with_pose) {
        int32_t alignment = alignment_urad(m->turn);
        fprintf(file->stream,
                "# Neato metadata: origin_x=%" PRId32 " origin_y=%" PRId32
                " resolution=%d alignment=%" PRId32 ".%06" PRId32 "\n",
                m->origin_x_mm, m->origin_y_mm, m->resolution_mm, alignment / 1000000,
                alignment % 1000000);
    }
    fprintf(file->stream, "%" PRIu32 " %" PRIu32 "\n255\n", m->width, m->height);
    fwrite(cells, m->width, m->height, file->stream);
    return out_flush(file, error);
}

/* Both files or none. */
static int write_files(const char *folder, const sim_map *m, tool_error *error) {
    out_file files[2] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
    int rc = out_make_folder(folder, error);
    if (rc == 0) {
        rc = write_pgm(folder, "truth.pgm", m, m->truth, 0, &files[0], error);
    }
    if (rc == 0) {
        rc = write_pgm(folder, "map.pgm", m, m->cells, 1, &files[1], error);
    }
    return out_end_all(files, 2, rc, error);
}

int cmd_simulate(int argc, char **argv) {
    simulate_options text = {NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0, 0, 0};
    sim_options options;
    sim_map map;
    tool_error error = {""};
    if (parse(argc, argv, &text, &options, &error) != 0) {
        return args_usage_error(&error, usage);
    }
    if (text.help) {
        printf("%s%s", usage, help);
        return EXIT_DONE;
    }
    if (sim_run(&options, &map) != 0) {
        tool_error_set(&error, "seed %s: out of memory", text.seed);
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    int rc = write_files(text.folder, &map, &error);
    if (rc == 0) {
        printf("%s/map.pgm: %" PRIu32 " x %" PRIu32 " cells of %d mm, %d rooms\n", text.folder,
               map.width, map.height, map.resolution_mm, map.room_count);
    } else {
        tool_error_print(&error);
    }
    sim_map_free(&map);
    return rc == 0 ? EXIT_DONE : EXIT_BAD_INPUT;
}
