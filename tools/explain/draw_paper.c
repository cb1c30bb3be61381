/* The paper profile's stages from the seed maps on. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "draw_regions.h"
#include "facts.h"
#include "graph_picture.h"
#include "ridge.h"
#include "room_colors.h"
#include "seed_map.h"

/* A border's stroke is so much thinner than the border is long. */
#define STROKE_SHARE 0.08
#define STROKE_MIN_PX 1.6
#define STROKE_MAX_PX 10.0

typedef struct plane_paint {
    const explanation *e;
    double most;
} plane_paint;

/* Free cells that are never in a seed map are white. */
static color lifetime_color(const void *user, uint32_t x, uint32_t y) {
    const plane_paint *p = user;
    const observation *o = &p->e->o;
    uint8_t lifetime = plane_at(o, PLANE_LIFETIME, x, y);
    if (lifetime > 0) {
        return paint_heat(lifetime / p->most);
    }
    return plane_at(o, PLANE_CLEARED, x, y) != 0 ? PAINT_FREE : PAINT_BACKGROUND;
}

static color ridge_color(const void *user, uint32_t x, uint32_t y) {
    const plane_paint *p = user;
    uint8_t ridge = plane_at(&p->e->o, PLANE_RIDGE, x, y);
    return ridge == RS_RIDGE_OBSTACLE ? PAINT_BACKGROUND : paint_ridge(ridge / p->most);
}

static int draw_plane(explanation *e, const char *name, int plane, cell_paint paint) {
    plane_paint p = {e, plane_most(&e->o, plane)};
    return draw_and_add(e, name, paint, &p);
}

typedef struct seed_paint {
    const explanation *e;
    uint16_t *seeds; /* owned */
    uint8_t *index;  /* a pastel for each; owned */
} seed_paint;

static color seed_color(const void *user, uint32_t x, uint32_t y) {
    const seed_paint *p = user;
    const observation *o = &p->e->o;
    uint16_t seed = p->seeds[(size_t)y * o->frame.width + x];
    if (seed != 0) {
        return paint_mix(room_color(p->index[seed]), PAINT_INK, 0.12);
    }
    return plane_at(o, PLANE_CLEARED, x, y) != 0 ? PAINT_FREE : PAINT_BACKGROUND;
}

/* One seed map: every seed in a colour. */
static int draw_seed_map(explanation *e, int which) {
    const rs_frame *f = &e->o.frame;
    seed_paint p = {e, malloc((size_t)f->width * f->height * sizeof *p.seeds), NULL};
    uint32_t count = 0;
    char name[24];
    int rc = -1;
    snprintf(name, sizeof name, "seed_map_%d", which + 1);
    if (p.seeds != NULL &&
        seed_map_make(&e->o, seed_map_scale(&e->o, which), p.seeds, &count) == 0) {
        count = count > UINT16_MAX ? UINT16_MAX : count;
        p.index = malloc((size_t)count + 1);
    }
    if (p.index != NULL &&
        label_colors_choose(p.seeds, f->width, f->height, count, p.index) == 0) {
        rc = draw_and_add(e, name, seed_color, &p);
    }
    free(p.index);
    free(p.seeds);
    return rc;
}

static int draw_regions_of(explanation *e, const char *name, int labels) {
    region_paint p;
    if (region_paint_make(e, labels, &p) != 0) {
        return -1;
    }
    int rc = draw_and_add(e, name, region_color, &p);
    region_paint_free(&p);
    return rc;
}

typedef struct border_user {
    const explanation *e;
    const rs_graph *graph;
} border_user;

/* Thickness by the length of the border, colour by whether it is too long for one. */
static edge_style border_style(const void *user, uint32_t edge) {
    const border_user *u = user;
    uint32_t border = u->graph->edges[edge].border;
    uint32_t longest = u->e->config.longest_border_mm / cell_mm(u->e);
    double px = STROKE_SHARE * view_px(&u->e->staged, border);
    edge_style style = {0, border > longest ? PAINT_SIGNAL : PAINT_SECOND};
    if (border > 0) {
        style.thickness = fmin(fmax(px, STROKE_MIN_PX), STROKE_MAX_PX);
    }
    return style;
}

static int draw_graph_over(explanation *e, const char *name, const rs_graph *graph) {
    border_user u = {e, graph};
    int merged = graph == &e->o.after;
    region_paint p;
    canvas c;
    int rc = merged ? merged_paint_make(e, &p) : region_paint_make(e, LABELS_REGIONS, &p);
    if (rc != 0) {
        return -1;
    }
    p.pale = REGION_PALE;
    rc = draw_staged(e, merged ? merged_color : region_color, &p, &c);
    region_paint_free(&p);
    if (rc != 0) {
        return -1;
    }
    draw_graph(&e->o, graph, &e->staged, border_style, &u, &c);
    return album_add(&e->album, name, &c);
}

int draw_paper_pictures(explanation *e) {
    int rc = 0;
    for (int i = 0; i < seed_map_count(&e->o) && rc == 0; i++) {
        rc = draw_seed_map(e, i);
    }
    rc = rc == 0 ? draw_plane(e, "lifetime", PLANE_LIFETIME, lifetime_color) : rc;
    rc = rc == 0 ? draw_regions_of(e, "seeds", LABELS_SEEDS) : rc;
    rc = rc == 0 ? draw_plane(e, "ridge", PLANE_RIDGE, ridge_color) : rc;
    rc = rc == 0 ? draw_regions_of(e, "regions", LABELS_REGIONS) : rc;
    rc = rc == 0 ? draw_graph_over(e, "graph_before", &e->o.before) : rc;
    return rc == 0 ? draw_graph_over(e, "graph_after", &e->o.after) : rc;
}
