#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "args.h"
#include "bench_json.h"
#include "bench_run.h"
#include "bench_stages.h"
#include "bench_table.h"
#include "commands.h"
#include "config_option.h"
#include "dataset.h"
#include "json.h"
#include "profile_option.h"
#include "truth.h"
#include "workers.h"

static const char usage[] =
    "usage: roomseg bench DATASET [--set NAMES] [--profile NAME] [--align] [--reps N]\n"
    "                     [--stages] [-j N] [--json] [--resolution M] [--invert]\n"
    "                     [--config FIELD=VALUE]... [--labels FOLDER]\n"
    "                     [--reference FOLDER] [--no-room VALUE]\n";

static const char help[] =
    "\n"
    "Segments every map of a data set; prints scores against the truth, time and memory.\n"
    "\n"
    "DATASET is a folder with maps (PNG, PGM or YAML) in one of these layouts:\n"
    "  SET/NAME.png       a set per folder; truth in groundtruth/NAME.png or .pgm\n"
    "  NAME/map.pgm       one set; truth beside each map as truth.pgm or .png\n"
    "  NAME.png           one set; truth in groundtruth/\n"
    "Maps without truth: rooms, time and memory alone. How truth is read: roomseg eval --help.\n"
    "\n"
    "  --set NAME[,NAME]...  these sets alone\n"
    "  --profile NAME        default, or paper: the published system, which leaves cells\n"
    "                        beside walls and between rooms without a room; or paper-home:\n"
    "                        that with its settings for homes, and --align\n"
    "  --align               turns each map until its walls lie along the axes\n"
    "  --reps N              timed runs per map, 1 to 1000; default 3; the median counts\n"
    "  --stages              time and cell visits of each stage too\n"
    "  -j, --jobs N          maps at a time, 1 to 256; default: as many as there are cores.\n"
    "                        Times are least disturbed with 1\n"
    "  --json                one JSON document instead of tables; shares from 0 to 1\n"
    "  --resolution M        edge of a cell in metres, 0.02 to 0.2; default: what the map\n"
    "                        says, else 0.04\n"
    "  --invert              the images are white where the floor is free (not for YAML)\n"
    "  --config FIELD=VALUE  sets a field of the configuration; may be repeated\n"
    "  --labels FOLDER       writes the labels to FOLDER/SET/NAME.pgm\n"
    "  --reference FOLDER    compares with the labels of another program, FOLDER/SET/NAME.png\n"
    "                        or .pgm of the map's size: its rooms, and the adjusted Rand index\n"
    "                        over the cells that both label\n"
    "  --no-room VALUE       this label of the reference is no room either, 1 to 65535\n"
    "\n"
    "The time is the CPU time of roomseg_run, without reading files. Deviations are those of\n"
    "a sample (n - 1). A map that fails is named and left out; the exit code is then 1.\n";

#define DEFAULT_REPETITIONS 3

typedef struct request {
    const char *folder;
    const char *set; /* NULL: all */
    bench_settings settings;
    int workers;
    int align, json, help;
} request;

/* Says before the first map what the library would say to each. */
static int check_config(const roomseg_config *config, tool_error *error) {
    size_t bytes;
    int status = roomseg_arena_size(config, 1, 1, ROOMSEG_MIN_RESOLUTION_MM, &bytes);
    if (status != ROOMSEG_OK) {
        tool_error_set(error, "option --config: %s", roomseg_status_text(status));
        return -1;
    }
    return 0;
}

static int read_workers(const char *jobs, int *workers, tool_error *error) {
    long count = workers_default();
    if (jobs != NULL && args_integer("--jobs", jobs, 1, WORKERS_MAX, &count, error) != 0) {
        return -1;
    }
    *workers = (int)count;
    return 0;
}

static int read_values(const char *repetitions, const char *resolution, const char *no_room,
                       request *out, tool_error *error) {
    long count = DEFAULT_REPETITIONS;
    long no_room_label = 0;
    if (repetitions != NULL &&
        args_integer("--reps", repetitions, 1, BENCH_MAX_REPETITIONS, &count, error) != 0) {
        return -1;
    }
    if (resolution != NULL &&
        args_real("--resolution", resolution, ROOMSEG_MIN_RESOLUTION_MM / 1000.0,
                  ROOMSEG_MAX_RESOLUTION_MM / 1000.0, &out->settings.map.resolution_m,
                  error) != 0) {
        return -1;
    }
    if (no_room != NULL &&
        args_integer("--no-room", no_room, 1, 65535, &no_room_label, error) != 0) {
        return -1;
    }
    out->settings.repetitions = (int)count;
    out->settings.reference.no_room = (uint32_t)no_room_label;
    if (out->align) {
        out->settings.config.align = ROOMSEG_ALIGN_ON;
    }
    return check_config(&out->settings.config, error);
}

static int read_request(int argc, char **argv, request *out, tool_error *error) {
    const char *repetitions = NULL;
    const char *resolution = NULL;
    const char *no_room = NULL;
    const char *jobs = NULL;
    int operands;
    memset(out, 0, sizeof *out);
    const arg_option options[] = {
        {"--set", NULL, &out->set, NULL},
        {"--align", NULL, NULL, &out->align},
        {"--reps", NULL, &repetitions, NULL},
        {"--stages", NULL, NULL, &out->settings.stages},
        {"--jobs", "-j", &jobs, NULL},
        {"--resolution", NULL, &resolution, NULL},
        {"--labels", NULL, &out->settings.labels_folder, NULL},
        {"--reference", NULL, &out->settings.reference.folder, NULL},
        {"--no-room", NULL, &no_room, NULL},
        {"--invert", NULL, NULL, &out->settings.map.invert},
        {"--json", NULL, NULL, &out->json},
        {"--help", "-h", NULL, &out->help},
        {NULL, NULL, NULL, NULL},
    };
    if (profile_take_option(&argc, argv, &out->settings.config, error) != 0 ||
        config_take_options(&argc, argv, &out->settings.config, error) != 0 ||
        args_parse(argc, argv, options, &out->folder, 1, &operands, error) != 0) {
        return -1;
    }
    if (!out->help && operands == 0) {
        tool_error_set(error, "bench: which data set?");
        return -1;
    }
    if (read_workers(jobs, &out->workers, error) != 0) {
        return -1;
    }
    return read_values(repetitions, resolution, no_room, out, error);
}

/* Position in the whole run, for the progress line. */
typedef struct progress {
    size_t done, total;
    int terminal; /* standard error is one: the line is overwritten */
} progress;

/* A set in work, shared by all workers; each map's result is its worker's alone. */
typedef struct set_job {
    const request *q;
    const dataset_set *set;
    set_result *out;
    progress *progress;
} set_job;

static void run_map(void *user, size_t index) {
    const set_job *job = user;
    tool_error failure = {""};
    map_result *result = &job->out->maps[index];
    if (bench_run_map(&job->q->settings, job->set, &job->set->maps[index], result, &failure) !=
        0) {
        result->failure = failure;
    }
}

static void show_map(void *user, size_t index) {
    const set_job *job = user;
    const map_result *result = &job->out->maps[index];
    progress *p = job->progress;
    p->done++;
    if (p->terminal) {
        fputs("\r\033[K", stderr);
    }
    if (result->failure.text[0] != '\0') {
        tool_error_print(&result->failure);
    } else if (!p->terminal) {
        fprintf(stderr, "[%zu/%zu] %s/%s: %u rooms, %.1f ms\n", p->done, p->total,
                job->set->name, result->name, (unsigned)result->rooms, result->time_ms);
    }
    if (p->terminal && p->done < p->total) {
        fprintf(stderr, "[%zu/%zu] %s/%s", p->done, p->total, job->set->name, result->name);
    }
}

/* Fails iff memory runs out: what goes wrong with a map is part of the result. */
static int run_set(const request *q, const dataset_set *set, progress *p, set_result *out) {
    set_job job = {q, set, out, p};
    if (set_result_open(out, set->name) != 0) {
        return -1;
    }
    for (size_t i = 0; i < set->count; i++) {
        if (set_result_add(out, set->maps[i].name) == NULL) {
            return -1;
        }
    }
    workers_run(set->count, q->workers, run_map, show_map, &job);
    return 0;
}

/* Whether the set's name stands in the list NAME,NAME... */
static int is_wanted(const request *q, const dataset_set *set) {
    size_t length = strlen(set->name);
    const char *names = q->set;
    while (names != NULL) {
        if (strncmp(names, set->name, length) == 0 &&
            (names[length] == ',' || names[length] == '\0')) {
            return 1;
        }
        names = strchr(names, ',');
        names += names != NULL;
    }
    return q->set == NULL;
}

static void print_json(const request *q, const set_result *sets, size_t count) {
    fputs("{\"dataset\": ", stdout);
    json_string(stdout, q->folder);
    printf(",\n \"profile\": \"%s\", \"align\": %s, \"repetitions\": %d, "
           "\"speck_cells\": %u,\n",
           profile_name(&q->settings.config),
           q->settings.config.align != NULL ? "true" : "false", q->settings.repetitions,
           TRUTH_SPECK_CELLS);
    fputs(" \"config\": ", stdout);
    config_print_json(stdout, &q->settings.config);
    fputs(",\n \"sets\": ", stdout);
    bench_json_print_sets(stdout, sets, count);
    fputs("}\n", stdout);
}

/* Runs the wanted sets; *count receives how many have a record in `results`, which has room
 * for all. */
static int run_sets(const request *q, const dataset *data, set_result *results,
                    size_t *count) {
    progress p = {0, 0, isatty(STDERR_FILENO)};
    *count = 0;
    for (size_t i = 0; i < data->count; i++) {
        p.total += is_wanted(q, &data->sets[i]) ? data->sets[i].count : 0;
    }
    for (size_t i = 0; i < data->count; i++) {
        if (!is_wanted(q, &data->sets[i])) {
            continue;
        }
        set_result *result = &results[(*count)++];
        if (run_set(q, &data->sets[i], &p, result) != 0) {
            return -1;
        }
        if (!q->json) {
            bench_table_print(stdout, result);
            bench_stages_print(stdout, result);
            fflush(stdout);
        }
    }
    return 0;
}

static int bench(const request *q, const dataset *data, tool_error *error) {
    size_t count = 0;
    size_t failures = 0;
    set_result *results = calloc(data->count, sizeof *results);
    int rc = results != NULL ? run_sets(q, data, results, &count) : -1;
    if (rc != 0) {
        tool_error_set(error, "%s: out of memory", q->folder);
    } else if (count == 0) {
        tool_error_set(error, "%s: has no set '%s'", q->folder, q->set);
        rc = -1;
    } else if (q->json) {
        print_json(q, results, count);
    } else {
        bench_table_print_summary(stdout, results, count);
    }
    for (size_t i = 0; i < count; i++) {
        failures += result_failures(&results[i]);
        set_result_free(&results[i]);
    }
    free(results);
    if (rc == 0 && failures > 0) {
        tool_error_set(error, "%s: %zu maps failed", q->folder, failures);
        rc = -1;
    }
    return rc;
}

int cmd_bench(int argc, char **argv) {
    request q;
    dataset data;
    tool_error error;
    if (read_request(argc, argv, &q, &error) != 0) {
        return args_usage_error(&error, usage);
    }
    if (q.help) {
        printf("%s%s", usage, help);
        return EXIT_DONE;
    }
    int rc = dataset_open(q.folder, &data, &error);
    if (rc == 0 && q.settings.reference.folder != NULL &&
        !dataset_is_folder(q.settings.reference.folder)) {
        tool_error_set(&error, "%s: is no folder", q.settings.reference.folder);
        dataset_free(&data);
        rc = -1;
    }
    if (rc == 0) {
        rc = bench(&q, &data, &error);
        dataset_free(&data);
    }
    if (rc != 0) {
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    return EXIT_DONE;
}
