#include "room_labels.h"

#include <math.h>
#include <stdio.h>

/* Share of the cells under a text that should be the room's own, and that must be where no
 * such place is found: chair legs may be there. */
#define GOOD_OWN_SHARE 0.995
#define MIN_OWN_SHARE 0.93
#define MAX_SAMPLES 40

/* Sizes as multiples of the number's height. */
#define AREA_HEIGHT 0.62
#define LINE_GAP 0.5
#define ROOM_AROUND 0.5

/* The number's height is such that so many fit in the picture's long side and in the
 * radius of a usual room's inscribed circle, within limits. */
#define LONG_SIDE_HEIGHTS 60.0
#define RADIUS_HEIGHTS 1.8
#define MIN_NUMBER_PX 14.0
#define MAX_NUMBER_PX 40.0

#define MIN_HEIGHT_PX 8.5
#define INK_RADIUS 0.08
#define HALO_PX 1.7

static const color ink = {33, 37, 41};
static const color halo = {255, 255, 255};

double room_text_height(const view *v) {
    const roomseg_result *r = &v->s->result;
    double height = (v->width_px > v->height_px ? v->width_px : v->height_px) / LONG_SIDE_HEIGHTS;
    if (r->room_count > 0) {
        /* Rooms are sorted by area: the middle one stands for them all. */
        double radius_m = r->rooms[r->room_count / 2].inscribed_radius_mm / 1000.0;
        height = fmin(height, view_px(v, radius_m / v->m->resolution_m) / RADIUS_HEIGHTS);
    }
    return fmin(fmax(height, MIN_NUMBER_PX), MAX_NUMBER_PX);
}

void draw_label(canvas *c, double x, double y, const char *text, double height) {
    /* Thin strokes would fade without the constant part. */
    double radius = INK_RADIUS * height + 0.1;
    draw_text(c, x, y, text, height, radius + HALO_PX, halo);
    draw_text(c, x, y, text, height, radius, ink);
}

typedef struct size_px {
    double width, height;
} size_px;

/* A place for a text: its middle [cells]. */
typedef struct place {
    int x, y;
} place;

/* Share of the 2 * half_x + 1 by 2 * half_y + 1 cells around the place that lie in the
 * room. Looks at about MAX_SAMPLES cells a row and column. */
static double own_share(const view *v, uint16_t label, place at, int half_x, int half_y) {
    int step_x = 1 + 2 * half_x / MAX_SAMPLES;
    int step_y = 1 + 2 * half_y / MAX_SAMPLES;
    long own = 0;
    long seen = 0;
    for (int y = at.y - half_y; y <= at.y + half_y; y += step_y) {
        for (int x = at.x - half_x; x <= at.x + half_x; x += step_x) {
            own += view_label(v, x, y) == label;
            seen++;
        }
    }
    return (double)own / (double)seen;
}

/* Looks for a place at the room's interior point, or moved so far that the text still
 * touches it, nearest first. Returns whether there is one. */
static int find_place(const view *v, const roomseg_room *room, size_px size, place *out) {
    /* In quarters of the text's size. */
    static const int8_t moves[][2] = {
        {0, 0},   {0, -1},  {0, 1},  {-1, 0}, {1, 0},   {-1, -1}, {1, -1}, {-1, 1}, {1, 1},
        {0, -2},  {0, 2},   {-2, 0}, {2, 0},  {-2, -1}, {2, -1},  {-2, 1}, {2, 1},  {-1, -2},
        {1, -2},  {-1, 2},  {1, 2},  {-2, -2}, {2, -2}, {-2, 2},  {2, 2},
    };
    int half_x = (int)(size.width / view_px(v, 2));
    int half_y = (int)(size.height / view_px(v, 2));
    double best = 0;
    for (size_t i = 0; i < sizeof moves / sizeof moves[0] && best < GOOD_OWN_SHARE; i++) {
        place at = {room->interior_x + moves[i][0] * half_x / 2,
                    room->interior_y + moves[i][1] * half_y / 2};
        double share = own_share(v, room->label, at, half_x, half_y);
        if (share >= GOOD_OWN_SHARE || (best == 0 && share >= MIN_OWN_SHARE)) {
            best = share;
            *out = at;
        }
    }
    return best > 0;
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

/* Pixels that a layout takes, with some space around it. */
static size_px size_of(const label_text *t, layout how, double height) {
    double around = ROOM_AROUND * height;
    double small = AREA_HEIGHT * height;
    double number = text_width(t->number, height);
    double area = text_width(t->area, small);
    switch (how) {
    case TWO_LINES:
        return (size_px){fmax(number, area) + around, (1 + LINE_GAP) * height + small + around};
    case ONE_LINE:
        return (size_px){text_width(t->both, small) + around, small + around};
    default:
        return (size_px){number + around, height + around};
    }
}

static void draw_layout(canvas *c, const view *v, place at, const label_text *t, layout how,
                        double height) {
    double x = view_px_x(v, at.x);
    double y = view_px_y(v, at.y);
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
    place at;
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        double height = choices[i].size * full;
        double smallest = choices[i].how == NUMBER_ONLY ? height : AREA_HEIGHT * height;
        if (smallest >= MIN_HEIGHT_PX &&
            find_place(v, room, size_of(&t, choices[i].how, height), &at)) {
            draw_layout(c, v, at, &t, choices[i].how, height);
            return;
        }
    }
    at = (place){room->interior_x, room->interior_y};
    draw_layout(c, v, at, &t, NUMBER_ONLY, fmax(0.6 * full, MIN_HEIGHT_PX));
}

void draw_room_labels(canvas *c, const view *v) {
    const roomseg_result *r = &v->s->result;
    for (uint32_t i = 0; i < r->room_count; i++) {
        draw_room_label(c, v, &r->rooms[i]);
    }
}
