#include "explanation.h"

#include <stdlib.h>
#include <string.h>

#include "align.h"
#include "threshold.h"
#include "truth.h"

int is_paper(const explanation *e) {
    return e->config.profile == ROOMSEG_PROFILE_PAPER;
}

uint32_t cell_mm(const explanation *e) {
    return segment_grid(&e->m).resolution_mm;
}

/* The map's own run, and the direction of its walls where that is part of the story. */
static int look_at_map(explanation *e, tool_error *error) {
    roomseg_grid grid = segment_grid(&e->m);
    rs_ticker silent = {NULL, NULL, ROOMSEG_STAGE_THRESHOLD, 0, 0, 0, 0};
    rs_threshold_crop(&grid, e->config.free_max, &e->frame, &silent);
    if (segment_map(&e->m, &e->config, e->name, &e->s, error) != 0) {
        return -1;
    }
    if (e->frame.width == 0) {
        tool_error_set(error, "%s: no cell is free, there is nothing to explain", e->name);
        return -1;
    }
    if (!is_paper(e) && e->config.align == NULL) {
        return 0;
    }
    if (walls_find(&e->m, &e->config, &e->frame, e->name, &e->walls, error) != 0) {
        return -1;
    }
    return walls_turn(&e->m, &e->config, &e->frame, e->walls.angle, e->name, &e->turned, error);
}

/* The run whose stages are shown: of the turned map where the library turns it. */
static int look_at_stages(explanation *e, tool_error *error) {
    roomseg_config config = e->s.config;
    e->is_turned = config.align != NULL &&
                   (e->walls.angle >= RS_ALIGN_LEAST || e->walls.angle <= -RS_ALIGN_LEAST);
    config.align = NULL;
    if (observe_run(e->is_turned ? &e->turned : &e->m, &config, e->name, &e->o, error) != 0) {
        return -1;
    }
    e->given = picture_view(&e->m, &e->s, &e->frame);
    e->staged = picture_view(e->o.m, &e->o.s, &e->o.frame);
    if (fates_find(&e->o, &e->fates) != 0) {
        tool_error_set(error, "%s: out of memory", e->name);
        return -1;
    }
    return is_paper(e) ? 0 : rules_find(&e->o, e->name, &e->joins, error);
}

static int look_at_truth(explanation *e, const char *path, tool_error *error) {
    size_t cells = (size_t)e->m.width * e->m.height;
    label_image labels = {NULL, e->m.width, e->m.height};
    if (truth_load(path, TRUTH_AUTO, &e->truth, error) != 0) {
        return -1;
    }
    e->has_truth = 1;
    labels.values = malloc(cells * sizeof *labels.values);
    if (labels.values == NULL) {
        tool_error_set(error, "%s: out of memory", e->name);
        return -1;
    }
    for (size_t i = 0; i < cells; i++) {
        labels.values[i] = e->s.labels[i];
    }
    int rc = score_labels(&e->truth, &labels, e->name, &e->score, error);
    label_image_free(&labels);
    return rc;
}

int explanation_make(const char *map_path, const map_options *options,
                     const roomseg_config *config, const char *truth_path, explanation *e,
                     tool_error *error) {
    memset(e, 0, sizeof *e);
    e->name = map_path;
    e->config = *config;
    int rc = map_load(map_path, options, &e->m, error);
    rc = rc == 0 ? look_at_map(e, error) : rc;
    rc = rc == 0 ? look_at_stages(e, error) : rc;
    rc = rc == 0 && truth_path != NULL ? look_at_truth(e, truth_path, error) : rc;
    if (rc != 0) {
        explanation_free(e);
    }
    return rc;
}

void explanation_free(explanation *e) {
    album_free(&e->album);
    label_image_free(&e->truth);
    fates_free(&e->fates);
    free(e->joins);
    observation_free(&e->o);
    map_free(&e->turned);
    walls_free(&e->walls);
    segmentation_free(&e->s);
    map_free(&e->m);
    memset(e, 0, sizeof *e);
}
