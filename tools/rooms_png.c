#include "rooms_png.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "draw.h"
#include "room_colors.h"
#include "room_labels.h"
#include "view.h"

static const color unknown_color = {233, 236, 239};
static const color frontier_color = {165, 172, 180};
static const color free_color = {255, 255, 255};
static const color obstacle_color = {52, 58, 64};
static const color door_color = {214, 29, 84};
static const color door_edge_color = {255, 255, 255};
static const color bar_color = {73, 80, 87};

/* Height of the strip below the map that holds the scale bar, in heights of a number. */
#define FOOTER_HEIGHT 2.0

/* Thickness of a doorway's stroke. */
#define DOOR_RADIUS_M 0.05
#define DOOR_MIN_RADIUS_PX 2.2
#define DOOR_EDGE_PX 1.4

/* What is shown of a cell; where cells share a pixel, the largest wins. */
enum {
    SHOW_UNKNOWN,
    SHOW_FRONTIER, /* unknown beside a room: shows walls where maps do not tell them */
    SHOW_FREE,
    SHOW_ROOM,
    SHOW_OBSTACLE = SHOW_ROOM + 65536
};

static int touches_room(const view *v, int x, int y) {
    for (int i = 0; i < 9; i++) {
        if (view_label(v, x + i % 3 - 1, y + i / 3 - 1) != 0) {
            return 1;
        }
    }
    return 0;
}

static int what_is_at(const view *v, int x, int y) {
    if (x < 0 || y < 0 || x >= (int)v->m->width || y >= (int)v->m->height) {
        return SHOW_UNKNOWN;
    }
    uint16_t label = view_label(v, x, y);
    uint8_t cell = v->m->cells[(size_t)y * v->m->width + (size_t)x];
    if (label != 0) {
        return SHOW_ROOM + label;
    }
    if (cell >= v->s->config.occupied_min) {
        return SHOW_OBSTACLE;
    }
    if (cell <= v->s->config.free_max) {
        return SHOW_FREE;
    }
    return touches_room(v, x, y) ? SHOW_FRONTIER : SHOW_UNKNOWN;
}

static color color_of(int shown, const uint8_t *color_index) {
    switch (shown) {
    case SHOW_UNKNOWN:
        return unknown_color;
    case SHOW_FRONTIER:
        return frontier_color;
    case SHOW_FREE:
        return free_color;
    case SHOW_OBSTACLE:
        return obstacle_color;
    default:
        return room_color(color_index[shown - SHOW_ROOM - 1]);
    }
}

static void draw_cells(canvas *c, const view *v, const uint8_t *color_index) {
    for (int y = 0; y < v->height_cells; y += v->shrink) {
        for (int x = 0; x < v->width_cells; x += v->shrink) {
            int shown = SHOW_UNKNOWN;
            for (int i = 0; i < v->shrink * v->shrink; i++) {
                int one = what_is_at(v, v->x + x + i % v->shrink, v->y + y + i / v->shrink);
                shown = one > shown ? one : shown;
            }
            draw_rectangle(c, x / v->shrink * v->scale, y / v->shrink * v->scale, v->scale,
                           v->scale, color_of(shown, color_index));
        }
    }
}

/* Sums over the places where two rooms touch. */
typedef struct border_sums {
    double count, x, y, xx, xy, yy;
} border_sums;

/* Adds the place between cell (x, y) and one to the right or below, `dx` or `dy` cells away, if
 * one is in each of the doorway's rooms. */
static void add_border(border_sums *sums, const view *v, const roomseg_doorway *d, int x, int y,
                       int dx, int dy) {
    uint16_t here = view_label(v, x, y);
    uint16_t next = view_label(v, x + dx, y + dy);
    if ((here == d->room_a && next == d->room_b) || (here == d->room_b && next == d->room_a)) {
        double px = x + 0.5 * dx - d->x;
        double py = y + 0.5 * dy - d->y;
        sums->count++;
        sums->x += px;
        sums->y += py;
        sums->xx += px * px;
        sums->xy += px * py;
        sums->yy += py * py;
    }
}

/* Direction of the border between the rooms around the doorway [rad, y down]. */
static double door_direction(const view *v, const roomseg_doorway *d, double width_cells) {
    border_sums sums = {0, 0, 0, 0, 0, 0};
    int reach = (int)ceil(width_cells / 2) + 1;
    /* The paper profile leaves a line of one cell between rooms. */
    int apart = v->s->config.profile == ROOMSEG_PROFILE_PAPER ? 2 : 1;
    for (int y = d->y - reach; y <= d->y + reach; y++) {
        for (int x = d->x - reach; x <= d->x + reach; x++) {
            add_border(&sums, v, d, x, y, apart, 0);
            add_border(&sums, v, d, x, y, 0, apart);
        }
    }
    double n = sums.count > 0 ? sums.count : 1;
    double xx = sums.xx - sums.x * sums.x / n;
    double xy = sums.xy - sums.x * sums.y / n;
    double yy = sums.yy - sums.y * sums.y / n;
    return 0.5 * atan2(2 * xy, xx - yy);
}

static void draw_door(canvas *c, const view *v, const roomseg_doorway *d) {
    double width_cells = d->width_mm / 1000.0 / v->m->resolution_m;
    double angle = door_direction(v, d, width_cells);
    double radius = fmax(DOOR_MIN_RADIUS_PX, view_px(v, DOOR_RADIUS_M / v->m->resolution_m));
    double half = fmax(view_px(v, width_cells / 2) - radius, 0);
    double x = view_px_x(v, d->x);
    double y = view_px_y(v, d->y);
    double dx = half * cos(angle);
    double dy = half * sin(angle);
    draw_line(c, x - dx, y - dy, x + dx, y + dy, radius + DOOR_EDGE_PX, door_edge_color);
    draw_line(c, x - dx, y - dy, x + dx, y + dy, radius, door_color);
}

/* A bar of the longest round length that takes at most a sixth of the picture's width. */
static void draw_scale_bar(canvas *c, const view *v) {
    static const double lengths_m[] = {50, 20, 10, 5, 2, 1, 0.5, 0.2};
    double height = 0.75 * room_text_height(v);
    for (size_t i = 0; i < sizeof lengths_m / sizeof lengths_m[0]; i++) {
        double px = view_px(v, lengths_m[i] / v->m->resolution_m);
        if (px > v->width_px / 6.0) {
            continue;
        }
        char text[16];
        snprintf(text, sizeof text, lengths_m[i] < 1 ? "%.1f m" : "%.0f m", lengths_m[i]);
        double x = 1.2 * height;
        double y = (int)c->height - 1.2 * height;
        double tick = 0.35 * height;
        draw_line(c, x, y, x + px, y, 1, bar_color);
        draw_line(c, x, y - tick, x, y + tick, 1, bar_color);
        draw_line(c, x + px, y - tick, x + px, y + tick, 1, bar_color);
        draw_label(c, x + px + height + text_width(text, height) / 2, y, text, height);
        return;
    }
}

int rooms_draw(const view *v, canvas *out) {
    const roomseg_result *r = &v->s->result;
    uint8_t *color_index = malloc((size_t)r->room_count + 1);
    uint32_t height = (uint32_t)(v->height_px + FOOTER_HEIGHT * room_text_height(v));
    int rc = -1;
    *out = (canvas){NULL, 0, 0};
    if (color_index != NULL && room_colors_choose(r, color_index) == 0 &&
        canvas_create(out, (uint32_t)v->width_px, height, unknown_color) == 0) {
        draw_cells(out, v, color_index);
        for (uint32_t i = 0; i < r->doorway_count; i++) {
            draw_door(out, v, &r->doorways[i]);
        }
        draw_room_labels(out, v);
        draw_scale_bar(out, v);
        rc = 0;
    }
    free(color_index);
    return rc;
}

int rooms_png_draw(const map *m, const segmentation *s, const char *name, canvas *out,
                   tool_error *error) {
    view v = view_of_rooms(m, s);
    if (rooms_draw(&v, out) != 0) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    return 0;
}
