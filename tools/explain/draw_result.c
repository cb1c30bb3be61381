/* The rooms, and the truth beside them. */
#include <stdlib.h>

#include "colors.h"
#include "explanation.h"
#include "room_colors.h"
#include "rooms_png.h"

static int draw_rooms(explanation *e) {
    canvas c;
    return rooms_draw(&e->given, &c) == 0 ? album_add(&e->album, "rooms", &c) : -1;
}

/* Colours for the rooms of the truth or of the result, within the crop. */
typedef struct result_paint {
    const explanation *e;
    uint16_t *labels; /* owned */
    uint8_t *index;   /* owned */
    int outlines;     /* of the true rooms, on top */
} result_paint;

static uint32_t truth_at(const explanation *e, uint32_t x, uint32_t y) {
    return x < e->frame.width && y < e->frame.height
               ? e->truth.values[(size_t)(e->frame.y + y) * e->m.width + e->frame.x + x]
               : 0;
}

static color result_color(const void *user, uint32_t x, uint32_t y) {
    const result_paint *p = user;
    uint16_t label = p->labels[(size_t)y * p->e->frame.width + x];
    uint32_t truth = truth_at(p->e, x, y);
    if (p->outlines && (truth != truth_at(p->e, x + 1, y) || truth != truth_at(p->e, x, y + 1))) {
        return PAINT_SIGNAL;
    }
    return label != 0 ? room_color(p->index[label])
                      : picture_map_color(&p->e->frame, &p->e->given, x, y);
}

/* Labels of the crop, at most UINT16_MAX of them; returns the greatest. */
static uint16_t copy_crop(const explanation *e, int truth, uint16_t *labels) {
    const rs_frame *f = &e->frame;
    uint16_t most = 0;
    for (uint32_t y = 0; y < f->height; y++) {
        for (uint32_t x = 0; x < f->width; x++) {
            size_t cell = (size_t)(f->y + y) * e->m.width + f->x + x;
            uint32_t value = truth ? e->truth.values[cell] : e->s.labels[cell];
            uint16_t label = value == 0 ? 0 : (uint16_t)((value - 1) % UINT16_MAX + 1);
            labels[(size_t)y * f->width + x] = label;
            most = label > most ? label : most;
        }
    }
    return most;
}

static int draw_labels(explanation *e, const char *name, int truth, int outlines) {
    const rs_frame *f = &e->frame;
    result_paint p = {e, malloc((size_t)f->width * f->height * sizeof *p.labels),
                      malloc((size_t)UINT16_MAX + 1), outlines};
    canvas c;
    int rc = -1;
    if (p.labels != NULL && p.index != NULL) {
        uint16_t most = copy_crop(e, truth, p.labels);
        rc = label_colors_choose(p.labels, f->width, f->height, most, p.index);
    }
    if (rc == 0) {
        rc = picture_paint(f, &e->given, result_color, &p, &c);
    }
    free(p.labels);
    free(p.index);
    return rc == 0 ? album_add(&e->album, name, &c) : -1;
}

int draw_result_pictures(explanation *e) {
    int rc = draw_rooms(e);
    if (rc == 0 && e->has_truth) {
        rc = draw_labels(e, "truth", 1, 0);
        rc = rc == 0 ? draw_labels(e, "rooms_and_truth", 0, 1) : rc;
    }
    return rc;
}
