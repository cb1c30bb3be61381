/* The direction of the walls: edges, lines, histogram, and the map turned. */
#include <math.h>
#include <stdio.h>

#include "colors.h"
#include "explanation.h"

static const color EDGE_PAINT = {11, 114, 133};

/* The map, pale, under what is drawn on it. */
static color pale_map(const explanation *e, uint32_t x, uint32_t y) {
    return paint_mix(picture_map_color(&e->frame, &e->given, x, y), PAINT_FREE, 0.75);
}

static color edges_color(const void *user, uint32_t x, uint32_t y) {
    const explanation *e = user;
    return e->walls.edges[rs_frame_index(&e->frame, x, y)] != 0 ? EDGE_PAINT
                                                                : pale_map(e, x, y);
}

static color pale_color(const void *user, uint32_t x, uint32_t y) {
    return pale_map(user, x, y);
}

/* Whether a direction [degrees] lies within the window around the angle that was found. */
static int is_along(const explanation *e, double degrees) {
    double off = fmod(degrees - e->walls.angle / 100.0 + 45 + 360, 90) - 45;
    return fabs(off) <= RS_DIRECTION_HALF_WINDOW + 0.5;
}

static int draw_lines(explanation *e) {
    const view *v = &e->given;
    canvas c;
    if (picture_paint(&e->frame, v, pale_color, e, &c) != 0) {
        return -1;
    }
    for (size_t i = 0; i < e->walls.line_count; i++) {
        const rs_line *line = &e->walls.lines[i];
        double x0 = picture_x(&e->frame, v, line->x0);
        double y0 = picture_y(&e->frame, v, line->y0);
        double x1 = picture_x(&e->frame, v, line->x1);
        double y1 = picture_y(&e->frame, v, line->y1);
        double degrees = atan2(y1 - y0, x1 - x0) * 180 / 3.14159265358979;
        draw_line(&c, x0, y0, x1, y1, 1.2,
                  is_along(e, degrees) ? PAINT_SIGNAL : PAINT_SECOND);
    }
    return album_add(&e->album, "lines", &c);
}

/* The histogram's place in its picture [px]. */
enum { LEFT = 40, BAR = 11, TOP = 30, HEIGHT = 300, BOTTOM = 60 };

static void draw_axis(canvas *c) {
    for (int degrees = 0; degrees <= 90; degrees += 15) {
        char text[12];
        int x = LEFT + degrees * BAR;
        snprintf(text, sizeof text, "%d", degrees);
        draw_line(c, x, TOP + HEIGHT, x, TOP + HEIGHT + 8, 1, PAINT_QUIET);
        draw_text(c, x, TOP + HEIGHT + 30, text, 20, 1.6, PAINT_INK);
    }
    draw_line(c, LEFT, TOP + HEIGHT, LEFT + 90 * BAR, TOP + HEIGHT, 1, PAINT_QUIET);
}

static int draw_histogram(explanation *e) {
    uint32_t most = 1;
    canvas c;
    if (canvas_create(&c, 2 * LEFT + 90 * BAR, TOP + HEIGHT + BOTTOM, PAINT_FREE) != 0) {
        return -1;
    }
    for (uint32_t i = 0; i < ROOMSEG_DIRECTION_BINS; i++) {
        most = e->walls.bins[i].length > most ? e->walls.bins[i].length : most;
    }
    for (int i = 0; i < (int)ROOMSEG_DIRECTION_BINS; i++) {
        double share = (double)e->walls.bins[i].length / most;
        int height = (int)(share * HEIGHT + 0.5);
        draw_rectangle(&c, LEFT + i * BAR + 1, TOP + HEIGHT - height, BAR - 2, height,
                       is_along(e, i + 0.5) ? PAINT_SIGNAL : PAINT_SECOND);
    }
    draw_axis(&c);
    return album_add(&e->album, "directions", &c);
}

/* A picture of the whole turned map. */
typedef struct turned_map {
    rs_frame frame;
    view v;
} turned_map;

static color turned_color(const void *user, uint32_t x, uint32_t y) {
    const turned_map *t = user;
    return picture_map_color(&t->frame, &t->v, x, y);
}

static int draw_turned(explanation *e) {
    turned_map t = {{0, 0, e->turned.width, e->turned.height, e->turned.width + 2}, e->given};
    canvas c;
    t.v = picture_view(&e->turned, &e->s, &t.frame);
    return picture_paint(&t.frame, &t.v, turned_color, &t, &c) == 0
               ? album_add(&e->album, "turned", &c)
               : -1;
}

int draw_wall_pictures(explanation *e) {
    canvas c;
    int rc = picture_paint(&e->frame, &e->given, edges_color, e, &c) == 0
                 ? album_add(&e->album, "edges", &c)
                 : -1;
    rc = rc == 0 ? draw_lines(e) : rc;
    rc = rc == 0 ? draw_histogram(e) : rc;
    return rc == 0 ? draw_turned(e) : rc;
}
