#include "observe.h"

#include <stdlib.h>
#include <string.h>

#include "plan.h"
#include "plan_paper.h"
#include "profile.h"
#include "threshold.h"

/* What can be taken on entering a stage. */
typedef enum kind { TAKE_PLANE, TAKE_LABELS, TAKE_BEFORE, TAKE_AFTER } kind;

typedef struct take {
    roomseg_stage stage;
    kind kind;
    int what;   /* plane or labels */
    int buffer; /* of the profile's plan: the plane, or the graph's regions */
    int edges;  /* the graph's edges */
} take;

static const take default_takes[] = {
    {ROOMSEG_STAGE_COMPONENTS, TAKE_PLANE, PLANE_FREE, RS_BUFFER_surface, 0},
    {ROOMSEG_STAGE_SURFACE, TAKE_PLANE, PLANE_CLEARED, RS_BUFFER_surface, 0},
    {ROOMSEG_STAGE_WATERSHED, TAKE_PLANE, PLANE_DISTANCE, RS_BUFFER_surface, 0},
    {ROOMSEG_STAGE_GRAPH, TAKE_LABELS, LABELS_REGIONS, 0, 0},
    {ROOMSEG_STAGE_MERGE, TAKE_BEFORE, 0, RS_BUFFER_regions, RS_BUFFER_edges},
    {ROOMSEG_STAGE_ROOMS, TAKE_AFTER, 0, RS_BUFFER_regions, RS_BUFFER_edges},
};

static const take paper_takes[] = {
    {ROOMSEG_STAGE_COMPONENTS, TAKE_PLANE, PLANE_FREE, RS_PAPER_surface, 0},
    {ROOMSEG_STAGE_SURFACE, TAKE_PLANE, PLANE_CLEARED, RS_PAPER_surface, 0},
    {ROOMSEG_STAGE_SEEDS, TAKE_PLANE, PLANE_LIFETIME, RS_PAPER_lifetime, 0},
    {ROOMSEG_STAGE_SEEDS, TAKE_LABELS, LABELS_BACKGROUND, 0, 0},
    {ROOMSEG_STAGE_RIDGE, TAKE_LABELS, LABELS_SEEDS, 0, 0},
    {ROOMSEG_STAGE_WATERSHED, TAKE_PLANE, PLANE_RIDGE, RS_PAPER_surface, 0},
    {ROOMSEG_STAGE_GRAPH, TAKE_LABELS, LABELS_REGIONS, 0, 0},
    {ROOMSEG_STAGE_MERGE, TAKE_BEFORE, 0, RS_PAPER_regions, RS_PAPER_edges},
    {ROOMSEG_STAGE_ROOMS, TAKE_AFTER, 0, RS_PAPER_regions, RS_PAPER_edges},
};

/* A run while it goes on. */
typedef struct watch {
    observation *o;
    int stage; /* the one that is at work; -1 before the first */
    int failed; /* memory ran out */
} watch;

/* A copy of `bytes` bytes in place of an older one. */
static void *replace(void *old, const void *from, size_t bytes, int *failed) {
    free(old);
    void *copy = malloc(bytes);
    if (copy == NULL) {
        *failed = 1;
    } else {
        memcpy(copy, from, bytes);
    }
    return copy;
}

static uint16_t *copy_labels(const observation *o, uint16_t *old, int *failed) {
    const rs_frame *f = &o->frame;
    free(old);
    uint16_t *copy = malloc((size_t)f->width * f->height * sizeof *copy);
    if (copy == NULL) {
        *failed = 1;
        return NULL;
    }
    for (uint32_t y = 0; y < f->height; y++) {
        memcpy(copy + (size_t)y * f->width,
               o->s.labels + (size_t)(f->y + y) * o->m->width + f->x, f->width * sizeof *copy);
    }
    return copy;
}

/* The counts are not in the arena; they are found when the run is over. */
static void copy_graph(const observation *o, const uint8_t *regions, const uint8_t *edges,
                       rs_graph *graph, int *failed) {
    size_t max_regions = o->s.config.max_regions;
    graph->regions = replace(graph->regions, regions,
                             (max_regions + 1) * sizeof *graph->regions, failed);
    graph->edges = replace(graph->edges, edges,
                           ROOMSEG_PLAN_EDGES(max_regions) * sizeof *graph->edges, failed);
}

static void take_one(watch *w, const take *t, const rs_plan *plan) {
    observation *o = w->o;
    const uint8_t *arena = o->s.arena;
    const uint8_t *from = arena + plan->offset[t->buffer];
    size_t cells = ROOMSEG_PLAN_CELLS(o->frame.width, o->frame.height);
    switch (t->kind) {
    case TAKE_PLANE:
        o->planes[t->what] = replace(o->planes[t->what], from, cells, &w->failed);
        break;
    case TAKE_LABELS:
        o->labels[t->what] = copy_labels(o, o->labels[t->what], &w->failed);
        break;
    case TAKE_BEFORE:
    case TAKE_AFTER:
        copy_graph(o, from, arena + plan->offset[t->edges],
                   t->kind == TAKE_BEFORE ? &o->before : &o->after, &w->failed);
        break;
    }
}

/* The progress hook. The config that counts is the one of the run: its capacities may have
 * grown since the caller's. */
static int look(void *user, roomseg_stage stage, unsigned permille) {
    watch *w = user;
    const observation *o = w->o;
    const roomseg_config *config = &o->s.config;
    int paper = config->profile == ROOMSEG_PROFILE_PAPER;
    const take *takes = paper ? paper_takes : default_takes;
    size_t count = paper ? sizeof paper_takes / sizeof *paper_takes
                         : sizeof default_takes / sizeof *default_takes;
    rs_plan plan;
    (void)permille;
    if ((int)stage == w->stage) {
        return 0;
    }
    w->stage = (int)stage;
    config->profile->plan(config, o->frame.width, o->frame.height,
                          segment_grid(o->m).resolution_mm, &plan);
    for (size_t i = 0; i < count; i++) {
        if (takes[i].stage == stage) {
            take_one(w, &takes[i], &plan);
        }
    }
    return w->failed;
}

/* Every edge stands in the lists of its regions. */
static void count_edges(rs_graph *graph, uint32_t region_count) {
    graph->region_count = region_count;
    graph->edge_count = 0;
    for (uint32_t r = 1; r <= region_count; r++) {
        uint32_t start = graph->regions[r].first_half;
        for (uint32_t half = start; half != RS_NO_HALF;) {
            graph->edge_count = rs_max_u32(graph->edge_count, (half >> 1) + 1u);
            half = rs_graph_next_half(graph, half);
            if (half == start) {
                break;
            }
        }
    }
}

int observe_run(const map *m, const roomseg_config *config, const char *name, observation *out,
                tool_error *error) {
    memset(out, 0, sizeof *out);
    out->m = m;
    watch w = {out, -1, 0};
    roomseg_config watched = *config;
    roomseg_grid grid = segment_grid(m);
    rs_ticker silent = {NULL, NULL, ROOMSEG_STAGE_THRESHOLD, 0, 0, 0, 0};
    rs_threshold_crop(&grid, config->free_max, &out->frame, &silent);
    if (out->frame.width == 0) {
        tool_error_set(error, "%s: no cell is free, there is nothing to explain", name);
        return -1;
    }
    watched.progress = look;
    watched.progress_user = &w;
    if (segment_map(m, &watched, name, &out->s, error) != 0) {
        observation_free(out);
        return -1;
    }
    out->s.config.progress = NULL;
    out->s.config.progress_user = NULL;
    count_edges(&out->before, out->s.result.region_count);
    /* Merging takes edges out of the lists. */
    out->after.region_count = out->before.region_count;
    out->after.edge_count = out->before.edge_count;
    return 0;
}

void observation_free(observation *o) {
    for (int i = 0; i < PLANE_COUNT; i++) {
        free(o->planes[i]);
    }
    for (int i = 0; i < LABELS_COUNT; i++) {
        free(o->labels[i]);
    }
    free(o->before.regions);
    free(o->before.edges);
    free(o->after.regions);
    free(o->after.edges);
    segmentation_free(&o->s);
    memset(o, 0, sizeof *o);
}

uint8_t plane_at(const observation *o, int plane, uint32_t x, uint32_t y) {
    return o->planes[plane][rs_frame_index(&o->frame, x, y)];
}

uint16_t label_at(const observation *o, int labels, uint32_t x, uint32_t y) {
    return o->labels[labels][(size_t)y * o->frame.width + x];
}

uint16_t room_at(const observation *o, uint32_t x, uint32_t y) {
    return o->s.labels[(size_t)(o->frame.y + y) * o->m->width + o->frame.x + x];
}

uint16_t root_of(const observation *o, uint16_t region) {
    while (o->after.regions[region].parent != region) {
        region = o->after.regions[region].parent;
    }
    return region;
}
