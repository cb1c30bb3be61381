#include "picture.h"

#include "colors.h"

#define LONG_SIDE_PX 1400
#define MAX_SCALE 16
#define MARGIN_CELLS 4

view picture_view(const map *m, const segmentation *s, const rs_frame *f) {
    view v = {m, s, (int)f->x - MARGIN_CELLS, (int)f->y - MARGIN_CELLS,
              (int)f->width + 2 * MARGIN_CELLS, (int)f->height + 2 * MARGIN_CELLS, 1, 1, 0, 0};
    int longest = v.width_cells > v.height_cells ? v.width_cells : v.height_cells;
    if (longest < LONG_SIDE_PX) {
        v.scale = LONG_SIDE_PX / longest;
        v.scale = v.scale > MAX_SCALE ? MAX_SCALE : v.scale;
    }
    v.shrink = (longest + LONG_SIDE_PX - 1) / LONG_SIDE_PX;
    v.width_px = (v.width_cells + v.shrink - 1) / v.shrink * v.scale;
    v.height_px = (v.height_cells + v.shrink - 1) / v.shrink * v.scale;
    return v;
}

color picture_map_color(const rs_frame *frame, const view *v, uint32_t x, uint32_t y) {
    uint32_t column = frame->x + x; /* modulo 2^32: too large left of the map */
    uint32_t row = frame->y + y;
    if (column >= v->m->width || row >= v->m->height) {
        return PAINT_UNKNOWN;
    }
    uint8_t cell = v->m->cells[(size_t)row * v->m->width + column];
    return cell <= v->s->config.free_max       ? PAINT_FREE
           : cell >= v->s->config.occupied_min ? PAINT_OBSTACLE
                                               : PAINT_UNKNOWN;
}

/* The mixture of the cells that share the pixel of view cell (x, y). */
static color pixel_color(const rs_frame *frame, const view *v, cell_paint paint, const void *user,
                         int x, int y) {
    unsigned sum[3] = {0, 0, 0};
    unsigned count = (unsigned)(v->shrink * v->shrink);
    for (int i = 0; i < v->shrink * v->shrink; i++) {
        uint32_t cell_x = (uint32_t)(v->x + x + i % v->shrink) - frame->x;
        uint32_t cell_y = (uint32_t)(v->y + y + i / v->shrink) - frame->y;
        int inside = cell_x < frame->width && cell_y < frame->height;
        color c = inside ? paint(user, cell_x, cell_y)
                         : picture_map_color(frame, v, cell_x, cell_y);
        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
    }
    color mixed = {(uint8_t)(sum[0] / count), (uint8_t)(sum[1] / count),
                   (uint8_t)(sum[2] / count)};
    return mixed;
}

int picture_paint(const rs_frame *frame, const view *v, cell_paint paint, const void *user,
                  canvas *out) {
    if (canvas_create(out, (uint32_t)v->width_px, (uint32_t)v->height_px, PAINT_UNKNOWN) != 0) {
        return -1;
    }
    for (int y = 0; y < v->height_cells; y += v->shrink) {
        for (int x = 0; x < v->width_cells; x += v->shrink) {
            draw_rectangle(out, x / v->shrink * v->scale, y / v->shrink * v->scale, v->scale,
                           v->scale, pixel_color(frame, v, paint, user, x, y));
        }
    }
    return 0;
}

double picture_x(const rs_frame *frame, const view *v, double x) {
    return view_px_x(v, frame->x + x);
}

double picture_y(const rs_frame *frame, const view *v, double y) {
    return view_px_y(v, frame->y + y);
}
