#include "view.h"

#include <math.h>

#define LONG_SIDE_PX 1600
#define LONG_SIDE_MAX_CELLS 4000
#define MAX_SCALE 32

#define MARGIN_M 0.6
#define MARGIN_MIN_CELLS 5

static int smaller(int a, int b) {
    return a < b ? a : b;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

view view_of_rooms(const map *m, const segmentation *s) {
    const roomseg_result *r = &s->result;
    int left = r->crop_x;
    int top = r->crop_y;
    int right = r->crop_x + r->crop_width;
    int bottom = r->crop_y + r->crop_height;
    if (r->crop_width == 0) {
        right = (int)m->width;
        bottom = (int)m->height;
    }
    for (uint32_t i = 0; i < r->room_count; i++) {
        const roomseg_room *room = &r->rooms[i];
        left = i == 0 ? room->min_x : smaller(left, room->min_x);
        top = i == 0 ? room->min_y : smaller(top, room->min_y);
        right = i == 0 ? room->max_x + 1 : larger(right, room->max_x + 1);
        bottom = i == 0 ? room->max_y + 1 : larger(bottom, room->max_y + 1);
    }
    int margin = larger(MARGIN_MIN_CELLS, (int)ceil(MARGIN_M / m->resolution_m));
    view v = {m, s, left - margin, top - margin, right - left + 2 * margin,
              bottom - top + 2 * margin, 1, 1, 0, 0};
    int long_side = larger(v.width_cells, v.height_cells);
    v.scale = smaller(MAX_SCALE, larger(1, LONG_SIDE_PX / long_side));
    v.shrink = (long_side + LONG_SIDE_MAX_CELLS - 1) / LONG_SIDE_MAX_CELLS;
    v.width_px = (v.width_cells + v.shrink - 1) / v.shrink * v.scale;
    v.height_px = (v.height_cells + v.shrink - 1) / v.shrink * v.scale;
    return v;
}

double view_px(const view *v, double cells) {
    return cells * v->scale / v->shrink;
}

double view_px_x(const view *v, double cell_x) {
    return view_px(v, cell_x + 0.5 - v->x) - 0.5;
}

double view_px_y(const view *v, double cell_y) {
    return view_px(v, cell_y + 0.5 - v->y) - 0.5;
}

uint16_t view_label(const view *v, int x, int y) {
    if (x < 0 || y < 0 || x >= (int)v->m->width || y >= (int)v->m->height) {
        return 0;
    }
    return v->s->labels[(size_t)y * v->m->width + (size_t)x];
}
