#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "bench_json.h"
#include "bench_table.h"
#include "commands.h"
#include "dataset.h"
#include "json.h"
#include "label_image.h"
#include "score.h"
#include "truth.h"

static const char usage[] =
    "usage: roomseg eval --labels LABELS --truth TRUTH [--truth-labels] [--no-room VALUE]\n"
    "                    [--json]\n";

static const char help[] =
    "\n"
    "Scores labels against the true rooms, once with all rooms of the truth and once without\n"
    "those under 60 cells.\n"
    "\n"
    "  --labels LABELS   PGM or gray PNG, 0 = no room; or a folder of them\n"
    "  --truth TRUTH     image of the same size; or a folder of images of the same names.\n"
    "                    With two values the higher one marks the rooms, and cells that\n"
    "                    touch, if only by a corner, are one room. With more values each\n"
    "                    one above 0 is a room.\n"
    "  --truth-labels    each value above 0 is a room, also when there are only two\n"
    "  --no-room VALUE   this label is no room either, 1 to 65535 (some programs mark the\n"
    "                    borders between rooms with 255)\n"
    "  --json            one JSON document instead of the table; shares from 0 to 1\n";

typedef struct eval_options {
    const char *labels, *truth, *no_room_text;
    int json, truth_labels, help;
    long no_room; /* 0: none but 0 */
} eval_options;

static int parse(int argc, char **argv, eval_options *o, tool_error *error) {
    int operands;
    const arg_option table[] = {{"--labels", NULL, &o->labels, NULL},
                                {"--truth", NULL, &o->truth, NULL},
                                {"--no-room", NULL, &o->no_room_text, NULL},
                                {"--json", NULL, NULL, &o->json},
                                {"--truth-labels", NULL, NULL, &o->truth_labels},
                                {"--help", "-h", NULL, &o->help},
                                {NULL, NULL, NULL, NULL}};
    if (args_parse(argc, argv, table, NULL, 0, &operands, error) != 0) {
        return -1;
    }
    if (!o->help && (o->labels == NULL || o->truth == NULL)) {
        tool_error_set(error, "eval: %s is missing",
                       o->labels == NULL ? "--labels LABELS" : "--truth TRUTH");
        return -1;
    }
    if (o->no_room_text != NULL) {
        return args_integer("--no-room", o->no_room_text, 1, 65535, &o->no_room, error);
    }
    return 0;
}

static int score_files(const eval_options *o, const char *labels_path, const char *truth_path,
                       score *out, tool_error *error) {
    label_image truth;
    label_image labels;
    truth_kind kind = o->truth_labels ? TRUTH_LABELS : TRUTH_AUTO;
    if (label_image_load(labels_path, &labels, error) != 0) {
        return -1;
    }
    if (o->no_room != 0) {
        label_image_clear(&labels, (uint32_t)o->no_room);
    }
    int rc = truth_load(truth_path, kind, &truth, error);
    if (rc == 0) {
        rc = score_labels(&truth, &labels, labels_path, out, error);
        label_image_free(&truth);
    }
    label_image_free(&labels);
    return rc;
}

static void print_share(const metrics *m, size_t index) {
    if (m->rooms_true > 0) {
        printf("%18.2f %%", metrics_get(m, index) * 100.0);
    } else {
        printf("%20s", "-");
    }
}

static void print_score(const score *s) {
    const metrics *a = &s->all;
    const metrics *b = &s->without_specks;
    char title[32];
    snprintf(title, sizeof title, "from %u cells on", TRUTH_SPECK_CELLS);
    printf("%-20s%20s%20s\n", "rooms of the truth:", "all", title);
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        printf("%-20s", metric_fields[i].title);
        print_share(a, i);
        print_share(b, i);
        fputc('\n', stdout);
    }
    printf("%-20s%18" PRIu32 "%20" PRIu32 "\n", "rooms found", a->rooms_found,
           b->rooms_found);
    printf("%-20s%18" PRIu32 "%20" PRIu32 "\n", "rooms in the truth", a->rooms_true,
           b->rooms_true);
    printf("%-20s%18" PRIu32 "%20" PRIu32 "\n", "matches, IoU > 0.5", a->rooms_matched,
           b->rooms_matched);
}

static void print_score_json(const eval_options *o, const score *s) {
    fputs("{\"labels\": ", stdout);
    json_string(stdout, o->labels);
    fputs(", \"truth\": ", stdout);
    json_string(stdout, o->truth);
    printf(",\n \"speck_cells\": %u,\n \"scores\": ", TRUTH_SPECK_CELLS);
    bench_json_print_metrics(stdout, &s->all);
    fputs(",\n \"scores_without_specks\": ", stdout);
    bench_json_print_metrics(stdout, &s->without_specks);
    fputs("}\n", stdout);
}

static int eval_files(const eval_options *o, tool_error *error) {
    score s;
    if (score_files(o, o->labels, o->truth, &s, error) != 0) {
        return -1;
    }
    if (o->json) {
        print_score_json(o, &s);
    } else {
        print_score(&s);
    }
    return 0;
}

/* Scores every labels image of the set; one without truth fails the whole. */
static int eval_set(const eval_options *o, const dataset_set *files, set_result *out,
                    tool_error *error) {
    if (set_result_open(out, files->name) != 0) {
        tool_error_set(error, "%s: out of memory", o->labels);
        return -1;
    }
    for (size_t i = 0; i < files->count; i++) {
        const dataset_map *file = &files->maps[i];
        map_result *result = set_result_add(out, file->name);
        if (result == NULL || file->truth == NULL) {
            tool_error_set(error, "%s: %s", file->map,
                           result == NULL ? "out of memory" : "has no truth of its name");
            return -1;
        }
        if (score_files(o, file->map, file->truth, &result->score, error) != 0) {
            return -1;
        }
        result->has_score = 1;
    }
    return 0;
}

static int eval_folders(const eval_options *o, tool_error *error) {
    dataset_set files;
    set_result results = {NULL, NULL, 0, 0};
    if (dataset_pair(o->labels, o->truth, &files, error) != 0) {
        return -1;
    }
    int rc = eval_set(o, &files, &results, error);
    if (rc == 0 && o->json) {
        bench_json_print_sets(stdout, &results, 1);
        fputc('\n', stdout);
    } else if (rc == 0) {
        bench_table_print(stdout, &results);
    }
    set_result_free(&results);
    dataset_set_free(&files);
    return rc;
}

int cmd_eval(int argc, char **argv) {
    eval_options options = {NULL, NULL, NULL, 0, 0, 0, 0};
    tool_error error = {""};
    if (parse(argc, argv, &options, &error) != 0) {
        return args_usage_error(&error, usage);
    }
    if (options.help) {
        printf("%s%s", usage, help);
        return EXIT_DONE;
    }
    int rc = dataset_is_folder(options.labels) ? eval_folders(&options, &error)
                                               : eval_files(&options, &error);
    if (rc != 0) {
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    return EXIT_DONE;
}
