/* The default profile's stages from the distance map on. */
#include <math.h>
#include <stdlib.h>

#include "distance.h"
#include "draw_regions.h"
#include "facts.h"
#include "graph_picture.h"
#include "shared_walls.h"

/* Regions below this have a smaller dot on the peak [cells]. */
#define TINY_CELLS 25u

/* An opening's stroke is so much thinner than the opening. */
#define STROKE_SHARE 0.2
#define STROKE_MIN_PX 1.6
#define STROKE_MAX_PX 9.0

typedef struct distance_paint {
    const explanation *e;
    double deepest;
} distance_paint;

static color distance_color(const void *user, uint32_t x, uint32_t y) {
    const distance_paint *p = user;
    uint8_t distance = plane_at(&p->e->o, PLANE_DISTANCE, x, y);
    return distance == 0 ? picture_map_color(&p->e->o.frame, &p->e->staged, x, y)
                         : paint_heat(distance / p->deepest);
}

static int draw_distance(explanation *e) {
    distance_paint p = {e, plane_most(&e->o, PLANE_DISTANCE)};
    return draw_and_add(e, "distance", distance_color, &p);
}

static int draw_watershed(explanation *e) {
    region_paint p;
    canvas c;
    if (region_paint_make(e, LABELS_REGIONS, &p) != 0) {
        return -1;
    }
    int rc = draw_staged(e, region_color, &p, &c);
    for (uint32_t r = 1; rc == 0 && r <= e->o.before.region_count; r++) {
        const rs_region *region = &e->o.before.regions[r];
        double x = picture_x(&e->o.frame, &e->staged, region->peak_x);
        double y = picture_y(&e->o.frame, &e->staged, region->peak_y);
        if (region->area > 0) {
            draw_line(&c, x, y, x, y, region->area < TINY_CELLS ? 1.0 : 2.4, PAINT_INK);
        }
    }
    region_paint_free(&p);
    return rc == 0 ? album_add(&e->album, "regions", &c) : -1;
}

typedef struct walls_paint {
    region_paint regions;
    uint8_t *walls;
} walls_paint;

static color walls_color(const void *user, uint32_t x, uint32_t y) {
    const walls_paint *p = user;
    const explanation *e = p->regions.e;
    uint8_t wall = p->walls[(size_t)y * e->o.frame.width + x];
    if (wall != WALL_NONE) {
        return wall == WALL_LONG ? PAINT_SIGNAL : PAINT_SECOND;
    }
    color c = region_color(&p->regions, x, y);
    return label_at(&e->o, LABELS_REGIONS, x, y) == 0 ? paint_mix(c, PAINT_FREE, REGION_PALE) : c;
}

static int draw_shared_walls(explanation *e) {
    size_t cells = (size_t)e->o.frame.width * e->o.frame.height;
    walls_paint p = {{NULL, 0, NULL, 0}, calloc(cells, 1)};
    uint64_t crossings;
    int rc = -1;
    if (p.walls != NULL && region_paint_make(e, LABELS_REGIONS, &p.regions) == 0) {
        p.regions.pale = REGION_PALE;
        rc = shared_walls_mark(&e->o, e->config.shared_wall_mm / cell_mm(e), p.walls,
                               &crossings);
    }
    rc = rc == 0 ? draw_and_add(e, "shared_walls", walls_color, &p) : -1;
    region_paint_free(&p.regions);
    free(p.walls);
    return rc;
}

/* Thickness by the width of the opening, colour by the rule. */
static edge_style opening_style(const void *user, uint32_t edge) {
    const explanation *e = user;
    const rs_edge *opening = &e->o.before.edges[edge];
    double cells = 2.0 * opening->saddle * RS_DISTANCE_UNIT_MM / cell_mm(e);
    double px = STROKE_SHARE * view_px(&e->staged, cells);
    edge_style style = {0, rule_paint(e->joins[edge])};
    if (opening->saddle > 0) {
        style.thickness = fmin(fmax(px, STROKE_MIN_PX), STROKE_MAX_PX);
    }
    return style;
}

static int draw_region_graph(explanation *e) {
    region_paint p;
    canvas c;
    if (region_paint_make(e, LABELS_REGIONS, &p) != 0) {
        return -1;
    }
    p.pale = REGION_PALE;
    int rc = draw_staged(e, region_color, &p, &c);
    region_paint_free(&p);
    if (rc != 0) {
        return -1;
    }
    draw_graph(&e->o, &e->o.before, &e->staged, opening_style, e, &c);
    return album_add(&e->album, "graph", &c);
}

static int draw_merged(explanation *e) {
    region_paint p;
    if (merged_paint_make(e, &p) != 0) {
        return -1;
    }
    int rc = draw_and_add(e, "merged", merged_color, &p);
    region_paint_free(&p);
    return rc;
}

static color dropped_color(const void *user, uint32_t x, uint32_t y) {
    const region_paint *p = user;
    const observation *o = &p->e->o;
    uint16_t label = label_at(o, LABELS_REGIONS, x, y);
    if (is_region(o, label) && p->e->fates.of[label] != FATE_ROOM) {
        return dropped_paint((fate)p->e->fates.of[label]);
    }
    return merged_color(user, x, y);
}

static int draw_dropped(explanation *e) {
    region_paint p;
    if (merged_paint_make(e, &p) != 0) {
        return -1;
    }
    p.pale = 0.75;
    int rc = draw_and_add(e, "dropped", dropped_color, &p);
    region_paint_free(&p);
    return rc;
}

int draw_default_pictures(explanation *e) {
    int rc = draw_distance(e);
    rc = rc == 0 ? draw_watershed(e) : rc;
    rc = rc == 0 ? draw_shared_walls(e) : rc;
    rc = rc == 0 ? draw_region_graph(e) : rc;
    rc = rc == 0 ? draw_merged(e) : rc;
    return rc == 0 ? draw_dropped(e) : rc;
}
