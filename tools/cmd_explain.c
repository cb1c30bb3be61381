#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "args.h"
#include "commands.h"
#include "config_option.h"
#include "explain/explanation.h"
#include "explain/files.h"
#include "explain/sheet.h"
#include "explain/tell.h"
#include "profile_option.h"

static const char usage[] =
    "usage: roomseg explain MAP -o FOLDER [--profile NAME] [--align] [--truth IMAGE]\n"
    "                       [--resolution M] [--invert] [--config FIELD=VALUE]...\n"
    "       roomseg explain --sheet DATASET -o FOLDER [--set NAME] [--reference FOLDER]\n"
    "                       [--profile NAME] [--align] [--resolution M] [--invert]\n";

static const char help[] =
    "\n"
    "Draws every step from a map to its rooms, and tells what it does, with which parameters,\n"
    "and what came out. Writes FOLDER/explain.html, one page that needs no other file and no\n"
    "network, and its pictures as FOLDER/NN_NAME.png.\n"
    "\n"
    "MAP is a PNG or PGM occupancy grid or a ROS map_server YAML, as roomseg segment takes it.\n"
    "\n"
    "  -o, --output FOLDER   where the files go\n"
    "  --profile NAME        default, or paper: the published system; or paper-home: that with\n"
    "                        its settings for homes, and --align\n"
    "  --align               turns the map until its walls lie along the axes, and shows how\n"
    "  --truth IMAGE         the true rooms, for a comparison; see roomseg eval --help\n"
    "  --resolution M        edge of a cell in metres, 0.02 to 0.2; default: what the map\n"
    "                        says, else 0.04\n"
    "  --invert              the image is white where the floor is free (not for YAML)\n"
    "  --config FIELD=VALUE  sets a field of the configuration; may be repeated\n"
    "\n"
    "With --sheet the maps of a data set side by side, as roomseg bench finds them: the map, the\n"
    "truth, the rooms of both profiles. Writes FOLDER/sheet.html and a picture for each set.\n"
    "\n"
    "  --set NAME            this set alone\n"
    "  --profile paper-home  the paper's rooms are those of its settings for homes\n"
    "  --reference FOLDER    labels of another program, FOLDER/SET/NAME.png or .pgm, or named\n"
    "                        by the number that NAME begins with; 255 is no room\n";

typedef struct request {
    const char *map_path, *folder, *truth, *dataset, *set, *reference;
    map_options options;
    roomseg_config config;
    int has_fields; /* --config was given */
    int align, help;
} request;

static int check_words(const request *q, int operands, tool_error *error) {
    if (q->dataset == NULL && operands == 0) {
        tool_error_set(error, "explain: which map?");
    } else if (q->dataset != NULL && (operands > 0 || q->truth != NULL || q->has_fields)) {
        tool_error_set(error, "explain: %s does not go with --sheet",
                       operands > 0       ? "a map"
                       : q->truth != NULL ? "--truth"
                                          : "--config");
    } else if (q->dataset == NULL && (q->set != NULL || q->reference != NULL)) {
        tool_error_set(error, "explain: %s goes with --sheet only",
                       q->set != NULL ? "--set" : "--reference");
    } else if (q->folder == NULL) {
        tool_error_set(error, "explain: -o FOLDER is missing");
    } else {
        return 0;
    }
    return -1;
}

static int read_request(int argc, char **argv, request *out, tool_error *error) {
    const char *resolution = NULL;
    int operands;
    memset(out, 0, sizeof *out);
    const arg_option options[] = {
        {"--output", "-o", &out->folder, NULL},
        {"--truth", NULL, &out->truth, NULL},
        {"--sheet", NULL, &out->dataset, NULL},
        {"--set", NULL, &out->set, NULL},
        {"--reference", NULL, &out->reference, NULL},
        {"--align", NULL, NULL, &out->align},
        {"--resolution", NULL, &resolution, NULL},
        {"--invert", NULL, NULL, &out->options.invert},
        {"--help", "-h", NULL, &out->help},
        {NULL, NULL, NULL, NULL},
    };
    if (profile_take_option(&argc, argv, &out->config, error) != 0) {
        return -1;
    }
    int words = argc;
    if (config_take_options(&argc, argv, &out->config, error) != 0) {
        return -1;
    }
    out->has_fields = argc < words;
    if (args_parse(argc, argv, options, &out->map_path, 1, &operands, error) != 0) {
        return -1;
    }
    if (out->align) {
        out->config.align = ROOMSEG_ALIGN_ON;
    }
    if (resolution != NULL &&
        args_real("--resolution", resolution, ROOMSEG_MIN_RESOLUTION_MM / 1000.0,
                  ROOMSEG_MAX_RESOLUTION_MM / 1000.0, &out->options.resolution_m, error) != 0) {
        return -1;
    }
    return out->help ? 0 : check_words(out, operands, error);
}

static int draw_all(explanation *e) {
    int rc = draw_given_map(e);
    if (rc == 0 && e->turned.cells != NULL) {
        rc = draw_wall_pictures(e);
    }
    rc = rc == 0 ? draw_threshold_pictures(e) : rc;
    if (rc == 0) {
        rc = is_paper(e) ? draw_paper_pictures(e) : draw_default_pictures(e);
    }
    return rc == 0 ? draw_result_pictures(e) : rc;
}

static int write_page(const request *q, explanation *e, tool_error *error) {
    char *page = NULL;
    size_t size = 0;
    FILE *stream = draw_all(e) == 0 ? open_memstream(&page, &size) : NULL;
    int rc = stream != NULL ? tell_page(e, stream) : -1;
    rc = stream != NULL && (ferror(stream) || fclose(stream) != 0) ? -1 : rc;
    if (rc != 0) {
        tool_error_set(error, "%s: out of memory", q->map_path);
    } else {
        rc = files_write(q->folder, &e->album, "explain.html", page, size, error);
    }
    free(page);
    if (rc == 0) {
        printf("%u rooms; %zu pictures and explain.html written to %s\n",
               (unsigned)e->s.result.room_count, e->album.count, q->folder);
    }
    return rc;
}

static int explain_map(const request *q, tool_error *error) {
    explanation e;
    int rc = explanation_make(q->map_path, &q->options, &q->config, q->truth, &e, error);
    if (rc == 0) {
        rc = write_page(q, &e, error);
        explanation_free(&e);
    }
    return rc;
}

static int explain_dataset(const request *q, tool_error *error) {
    sheet_request sheet = {q->dataset, q->set, q->reference, q->options,
                           roomseg_config_default(), roomseg_config_paper()};
    if (q->config.profile == ROOMSEG_PROFILE_PAPER) {
        sheet.by_paper = q->config;
    }
    if (q->align) {
        sheet.by_default.align = sheet.by_paper.align = ROOMSEG_ALIGN_ON;
    }
    size_t maps;
    int rc = sheet_write(&sheet, q->folder, &maps, error);
    if (rc == 0) {
        printf("%zu maps; pictures and sheet.html written to %s\n", maps, q->folder);
    }
    return rc;
}

int cmd_explain(int argc, char **argv) {
    request q;
    tool_error error;
    if (read_request(argc, argv, &q, &error) != 0) {
        return args_usage_error(&error, usage);
    }
    if (q.help) {
        printf("%s%s", usage, help);
        return EXIT_DONE;
    }
    int rc = q.dataset != NULL ? explain_dataset(&q, &error) : explain_map(&q, &error);
    if (rc != 0) {
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    return EXIT_DONE;
}
