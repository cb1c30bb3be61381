#include "graph_picture.h"

#include <math.h>

#include "colors.h"

/* A dot of a region has this share of the region's area, within limits. */
#define DOT_AREA_SHARE 0.02
#define DOT_MIN_PX 1.3
#define DOT_MAX_SHARE 0.02 /* of the picture's long side */
#define HALO_PX 1.4
#define HALO_FROM_PX 2.5 /* smaller dots have none: there are many, and they stand close */

typedef struct point {
    double x, y;
} point;

static uint16_t end_of(const observation *o, const rs_graph *graph, uint16_t region) {
    return graph == &o->after ? root_of(o, region) : region;
}

static point node_of(const observation *o, const rs_graph *graph, const view *v,
                     uint16_t region) {
    const rs_region *r = &graph->regions[region];
    point p = {picture_x(&o->frame, v, r->peak_x), picture_y(&o->frame, v, r->peak_y)};
    return p;
}

static void draw_edge(const observation *o, const rs_graph *graph, const view *v, uint32_t e,
                      edge_style style, canvas *c) {
    const rs_edge *edge = &graph->edges[e];
    point a = node_of(o, graph, v, end_of(o, graph, edge->a));
    point b = node_of(o, graph, v, end_of(o, graph, edge->b));
    point door = {picture_x(&o->frame, v, edge->x), picture_y(&o->frame, v, edge->y)};
    double radius = style.thickness / 2;
    draw_line(c, a.x, a.y, door.x, door.y, radius + HALO_PX, PAINT_HALO);
    draw_line(c, door.x, door.y, b.x, b.y, radius + HALO_PX, PAINT_HALO);
    draw_line(c, a.x, a.y, door.x, door.y, radius, style.paint);
    draw_line(c, door.x, door.y, b.x, b.y, radius, style.paint);
}

static void draw_node(const observation *o, const rs_graph *graph, const view *v,
                      uint16_t region, canvas *c) {
    point at = node_of(o, graph, v, region);
    double cells = graph->regions[region].area;
    double radius = view_px(v, sqrt(cells * DOT_AREA_SHARE / 3.14159));
    double limit = DOT_MAX_SHARE * (c->width > c->height ? c->width : c->height);
    radius = fmin(fmax(radius, DOT_MIN_PX), fmax(limit, DOT_MIN_PX));
    if (radius >= HALO_FROM_PX) {
        draw_line(c, at.x, at.y, at.x, at.y, radius + HALO_PX, PAINT_HALO);
    }
    draw_line(c, at.x, at.y, at.x, at.y, radius, PAINT_INK);
}

void draw_graph(const observation *o, const rs_graph *graph, const view *v, edge_look look,
                const void *user, canvas *c) {
    for (uint32_t e = 0; e < graph->edge_count; e++) {
        const rs_edge *edge = &graph->edges[e];
        uint16_t a = end_of(o, graph, edge->a);
        uint16_t b = end_of(o, graph, edge->b);
        edge_style style = look(user, e);
        if (a != b && style.thickness > 0 && graph->regions[a].area > 0 &&
            graph->regions[b].area > 0) {
            draw_edge(o, graph, v, e, style, c);
        }
    }
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        if (end_of(o, graph, (uint16_t)r) == r && graph->regions[r].area > 0) {
            draw_node(o, graph, v, (uint16_t)r, c);
        }
    }
}
