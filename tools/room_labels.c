#include "room_labels.h"

#include <math.h>
#include <stdio.h>

/* Share of the cells under a text that must be the room's own: chair legs may be there. */
#define MIN_OWN_SHARE 0.93

/* Sizes as multiples of the number's height. */
#define AREA_HEIGHT 0.62
#define LINE_GAP 0.5
#define ROOM_AROUND 0.5

#define MIN_HEIGHT_PX 8.5
#define INK_RADIUS 0.08
#define HALO_PX 1.7

static const color ink = {33, 37, 41};
static const color halo = {255, 255, 255};

double room_text_height(const view *v) {
    double long_side = v->width_px > v->height_px ? v->width_px : v->height_px;
    double height = long_side / 64;
    return height < 13 ? 13 : height > 40 ? 40 : height;
}

void draw_label(canvas *c, double x, double y, const char *text, double height) {
    /* Small strokes would fade without the constant part. */
    double radius = INK_RADIUS * height + 0.1;
    draw_text(c, x, y, text, height, radius + HALO_PX, halo);
    draw_text(c, x, y, text, height, radius, ink);
}

/* Does a box of that many pixels around the interior point lie in the room? */
static int fits(const view *v, const roomseg_room *room, double width_px, double height_px) {
    int half_x = (int)(width_px / view_px(v, 2));
    int half_y = (int)(height_px / view_px(v, 2));
    long own = 0;
    for (int y = -half_y; y <= half_y; y++) {
        for (int x = -half_x; x <= half_x; x++) {
            own += view_label(v, room->interior_x + x, room->interior_y + y) == room->label;
        }
    }
    return (double)own >= MIN_OWN_SHARE * (2.0 * half_x + 1) * (2.0 * half_y + 1);
}

/* How a label of a given height can be laid out. */
typedef enum layout { TWO_LINES, ONE_LINE, NUMBER_ONLY } layout;

typedef struct label_text {
    char number[8];
    char area[24];
    char both[40];
} label_text;

static label_text text_of(const roomseg_room *room, double cell_m2) {
    label_text t;
    double area_m2 = room->area_cells * cell_m2;
    snprintf(t.number, sizeof t.number, "%u", (unsigned)room->label);
    snprintf(t.area, sizeof t.area, area_m2 < 99.95 ? "%.1f m^" : "%.0f m^", area_m2);
    snprintf(t.both, sizeof t.both, "%s   %s", t.number, t.area);
    return t;
}

static int layout_fits(const view *v, const roomseg_room *room, const label_text *t,
                       layout how, double height) {
    double around = ROOM_AROUND * height;
    double number = text_width(t->number, height);
    double area = text_width(t->area, AREA_HEIGHT * height);
    switch (how) {
    case TWO_LINES:
        return fits(v, room, (number > area ? number : area) + around,
                    (1 + LINE_GAP + AREA_HEIGHT) * height + around);
    case ONE_LINE:
        return fits(v, room, text_width(t->both, AREA_HEIGHT * height) + around,
                    AREA_HEIGHT * height + around);
    default:
        return fits(v, room, number + around, height + around);
    }
}

static void draw_layout(canvas *c, const view *v, const roomseg_room *room,
                        const label_text *t, layout how, double height) {
    double x = view_px_x(v, room->interior_x);
    double y = view_px_y(v, room->interior_y);
    double small = AREA_HEIGHT * height;
    if (how == TWO_LINES) {
        draw_label(c, x, y - (LINE_GAP * height + small) / 2, t->number, height);
        draw_label(c, x, y + (LINE_GAP * height + height) / 2, t->area, small);
    } else {
        draw_label(c, x, y, how == ONE_LINE ? t->both : t->number,
                   how == ONE_LINE ? small : height);
    }
}

static void draw_room_label(canvas *c, const view *v, const roomseg_room *room) {
    static const struct {
        layout how;
        double size;
    } choices[] = {
        {TWO_LINES, 1.0},   {ONE_LINE, 1.2},    {TWO_LINES, 0.85},  {ONE_LINE, 1.0},
        {TWO_LINES, 0.72},  {ONE_LINE, 0.85},   {NUMBER_ONLY, 1.0}, {NUMBER_ONLY, 0.8},
        {NUMBER_ONLY, 0.6},
    };
    label_text t = text_of(room, v->m->resolution_m * v->m->resolution_m);
    double full = room_text_height(v);
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        double height = choices[i].size * full;
        double smallest = choices[i].how == NUMBER_ONLY ? height : AREA_HEIGHT * height;
        if (smallest >= MIN_HEIGHT_PX && layout_fits(v, room, &t, choices[i].how, height)) {
            draw_layout(c, v, room, &t, choices[i].how, height);
            return;
        }
    }
    draw_layout(c, v, room, &t, NUMBER_ONLY, fmax(0.6 * full, MIN_HEIGHT_PX));
}

void draw_room_labels(canvas *c, const view *v) {
    const roomseg_result *r = &v->s->result;
    for (uint32_t i = 0; i < r->room_count; i++) {
        draw_room_label(c, v, &r->rooms[i]);
    }
}
