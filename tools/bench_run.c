#include "bench_run.h"

#include <stdlib.h>
#include <string.h>

#include "label_image.h"
#include "out.h"
#include "report.h"
#include "segment.h"
#include "stages.h"
#include "truth.h"

static int compare_times(const void *left, const void *right) {
    const double *a = left;
    const double *b = right;
    return *a < *b ? -1 : *a > *b;
}

static int measure_time(const map *m, const char *name, int repetitions, segmentation *s,
                        double *median_ms, tool_error *error) {
    double times[BENCH_MAX_REPETITIONS];
    for (int i = 0; i < repetitions; i++) {
        double start = stages_cpu_ms();
        int status = segment_again(m, s);
        times[i] = stages_cpu_ms() - start;
        if (status != ROOMSEG_OK) {
            tool_error_set(error, "%s: cannot be segmented again: %s", name,
                           roomseg_status_text(status));
            return -1;
        }
    }
    qsort(times, (size_t)repetitions, sizeof *times, compare_times);
    *median_ms = (times[(repetitions - 1) / 2] + times[repetitions / 2]) / 2.0;
    return 0;
}

static int measure_stages(const map *m, const char *name, int repetitions, segmentation *s,
                          map_result *out, tool_error *error) {
    int status = stages_measure(m, s, repetitions, &out->stages);
    if (status != ROOMSEG_OK) {
        tool_error_set(error, "%s: its stages cannot be measured: %s", name,
                       status == 1 ? "out of memory" : roomseg_status_text(status));
        return -1;
    }
    out->has_stages = 1;
    return 0;
}

static int copy_labels(const map *m, const segmentation *s, const char *name,
                       label_image *out, tool_error *error) {
    size_t cells = (size_t)m->width * m->height;
    out->values = malloc(cells * sizeof *out->values);
    if (out->values == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    out->width = m->width;
    out->height = m->height;
    for (size_t i = 0; i < cells; i++) {
        out->values[i] = s->labels[i];
    }
    return 0;
}

static int score_by_truth(const label_image *labels, const dataset_map *files, score *out,
                          tool_error *error) {
    label_image truth;
    if (truth_load(files->truth, TRUTH_AUTO, &truth, error) != 0) {
        return -1;
    }
    int rc = score_labels(&truth, labels, files->map, out, error);
    label_image_free(&truth);
    return rc;
}

static int score_map(const bench_settings *settings, const dataset_set *set,
                     const dataset_map *files, const map *m, const segmentation *s,
                     map_result *out, tool_error *error) {
    label_image labels;
    int rc = 0;
    if (files->truth == NULL && settings->reference.folder == NULL) {
        return 0;
    }
    if (copy_labels(m, s, files->map, &labels, error) != 0) {
        return -1;
    }
    if (files->truth != NULL) {
        rc = score_by_truth(&labels, files, &out->score, error);
        out->has_score = rc == 0;
    }
    if (rc == 0 && settings->reference.folder != NULL) {
        rc = bench_reference_score(&settings->reference, set->name, files->name, &labels,
                                   &out->reference, error);
        out->has_reference = rc > 0;
    }
    label_image_free(&labels);
    return rc < 0 ? -1 : 0;
}

/* FOLDER/NAME.pgm; memory to be freed, or NULL. */
static char *labels_path(const char *folder, const char *name) {
    static const char ending[] = ".pgm";
    char *path = NULL;
    char *file = malloc(strlen(name) + sizeof ending);
    if (file != NULL) {
        strcpy(file, name);
        strcat(file, ending);
        path = out_join(folder, file);
        free(file);
    }
    return path;
}

static int write_labels(const map *m, const segmentation *s, const char *top,
                        const char *set, const char *name, tool_error *error) {
    out_file file;
    char *folder = out_join(top, set);
    char *path = folder != NULL ? labels_path(folder, name) : NULL;
    int rc = -1;
    if (path == NULL) {
        tool_error_set(error, "%s: out of memory", top);
    } else {
        rc = out_make_folder(folder, error);
    }
    if (rc == 0) {
        rc = out_open(&file, path, error);
    }
    if (rc == 0) {
        report_labels_pgm(m, s, file.stream);
        rc = out_commit(&file, error);
    }
    free(path);
    free(folder);
    return rc;
}

/* All that needs the map's segmentation. */
static int take_results(const bench_settings *settings, const dataset_set *set,
                        const dataset_map *files, const map *m, segmentation *s,
                        map_result *out, tool_error *error) {
    if (measure_time(m, files->map, settings->repetitions, s, &out->time_ms, error) != 0) {
        return -1;
    }
    if (settings->stages &&
        measure_stages(m, files->map, settings->repetitions, s, out, error) != 0) {
        return -1;
    }
    out->rooms = s->result.room_count;
    out->arena_bytes = s->result.arena_used;
    out->crop_cells = (uint64_t)s->result.crop_width * s->result.crop_height;
    out->has_cost = 1;
    if (score_map(settings, set, files, m, s, out, error) != 0) {
        return -1;
    }
    if (settings->labels_folder != NULL) {
        return write_labels(m, s, settings->labels_folder, set->name, files->name, error);
    }
    return 0;
}

int bench_run_map(const bench_settings *settings, const dataset_set *set,
                  const dataset_map *files, map_result *out, tool_error *error) {
    map m;
    segmentation s;
    if (map_load(files->map, &settings->map, &m, error) != 0) {
        return -1;
    }
    int rc = segment_map(&m, &settings->config, files->map, &s, error);
    if (rc == 0) {
        rc = take_results(settings, set, files, &m, &s, out, error);
        segmentation_free(&s);
    }
    map_free(&m);
    return rc;
}
