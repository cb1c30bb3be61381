/* All that an explanation is made from: the run, its stages, its pictures. */
#ifndef ROOMSEG_EXPLAIN_EXPLANATION_H
#define ROOMSEG_EXPLAIN_EXPLANATION_H

#include <stdio.h>

#include "album.h"
#include "fates.h"
#include "label_image.h"
#include "map.h"
#include "observe.h"
#include "picture.h"
#include "rules.h"
#include "score.h"
#include "segment.h"
#include "tool_error.h"
#include "walls.h"

typedef struct explanation {
    const char *name;       /* the map's file */
    map m;                  /* owned */
    roomseg_config config;
    rs_frame frame;         /* the map's crop */
    segmentation s;         /* of the map itself; owned */
    walls walls;            /* edges, lines and directions; owned */
    map turned;             /* the map with its walls along the axes; owned */
    int is_turned;          /* the stages below are those of the turned map */
    observation o;          /* of the stages; owned */
    view given, staged;     /* the map's crop, and that of the stages' map */
    uint8_t *joins;         /* a join_rule for each edge of o.before; NULL in the paper profile */
    fates fates;            /* of the regions; owned */
    int has_truth;
    label_image truth;      /* owned */
    score score;
    album album;            /* owned */
} explanation;

/* Whether the stages are those of the paper profile. */
int is_paper(const explanation *e);

/* Edge of a cell [mm]. */
uint32_t cell_mm(const explanation *e);

/* Loads map and truth, runs the library and observes it, and computes what the pictures need.
 * truth_path may be NULL. e->album is left empty.
 * Fails iff: a file cannot be read, sizes differ, the library refuses the map, no cell is free,
 * or memory runs out. Returns 0, or -1 with *error set and *e zeroed. */
int explanation_make(const char *map_path, const map_options *options,
                     const roomseg_config *config, const char *truth_path, explanation *e,
                     tool_error *error);

void explanation_free(explanation *e);

/* Paints every cell of the stages' crop into a new canvas; user: for `paint`.
 * Returns 0, or -1 when memory runs out. */
int draw_staged(const explanation *e, cell_paint paint, const void *user, canvas *out);

/* The same for the album, without anything on top. */
int draw_and_add(explanation *e, const char *name, cell_paint paint, const void *user);

/* Draw into the album. Return 0, or -1 when memory runs out. */
int draw_given_map(explanation *e);
int draw_threshold_pictures(explanation *e);
int draw_wall_pictures(explanation *e);
int draw_default_pictures(explanation *e);
int draw_paper_pictures(explanation *e);
int draw_result_pictures(explanation *e);

#endif
