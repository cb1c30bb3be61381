#include "draw_regions.h"

#include <stdlib.h>

#include "room_colors.h"
#include "watershed_lines.h"

#define SEAM_SHARE 0.28 /* of ink, where regions of one room meet */

int is_region(const observation *o, uint16_t label) {
    return label != 0 && label <= o->before.region_count;
}

int region_paint_make(const explanation *e, int labels, region_paint *out) {
    uint32_t count = e->o.before.region_count;
    *out = (region_paint){e, labels, malloc((size_t)count + 1), 0};
    if (out->index != NULL &&
        label_colors_choose(e->o.labels[labels], e->o.frame.width, e->o.frame.height, count,
                            out->index) == 0) {
        return 0;
    }
    region_paint_free(out);
    return -1;
}

void region_paint_free(region_paint *p) {
    free(p->index);
    p->index = NULL;
}

color region_color(const void *user, uint32_t x, uint32_t y) {
    const region_paint *p = user;
    const observation *o = &p->e->o;
    uint16_t label = label_at(o, p->labels, x, y);
    if (is_region(o, label)) {
        return paint_mix(room_color(p->index[label]), PAINT_FREE, p->pale);
    }
    if (label == RS_LINE) {
        return PAINT_INK;
    }
    if (label == RS_BACKGROUND) {
        return plane_at(o, PLANE_CLEARED, x, y) != 0 ? PAINT_BACKGROUND : PAINT_QUIET;
    }
    return picture_map_color(&o->frame, &p->e->staged, x, y);
}

/* The room of each region's root, found by any of its cells. */
static void find_rooms(const observation *o, uint16_t *room_of_root) {
    for (uint32_t y = 0; y < o->frame.height; y++) {
        for (uint32_t x = 0; x < o->frame.width; x++) {
            uint16_t label = label_at(o, LABELS_REGIONS, x, y);
            uint16_t room = room_at(o, x, y);
            if (is_region(o, label) && room != 0) {
                room_of_root[root_of(o, label)] = room;
            }
        }
    }
}

int merged_paint_make(const explanation *e, region_paint *out) {
    const observation *o = &e->o;
    uint32_t count = o->before.region_count;
    uint8_t *room_index = malloc((size_t)o->s.result.room_count + 1);
    uint16_t *rooms = calloc((size_t)count + 1, sizeof *rooms);
    *out = (region_paint){e, LABELS_REGIONS, malloc((size_t)count + 1), 0};
    int rc = -1;
    if (room_index != NULL && rooms != NULL && out->index != NULL &&
        room_colors_choose(&o->s.result, room_index) == 0) {
        find_rooms(o, rooms);
        for (uint32_t r = 1; r <= count; r++) {
            uint16_t room = rooms[root_of(o, (uint16_t)r)];
            out->index[r] = room > 0 ? room_index[room - 1] : 0;
        }
        rc = 0;
    } else {
        region_paint_free(out);
    }
    free(room_index);
    free(rooms);
    return rc;
}

/* Whether the next cell in one direction is another region of the same room. */
static int is_seam(const observation *o, uint16_t label, uint32_t x, uint32_t y) {
    if (x >= o->frame.width || y >= o->frame.height) {
        return 0;
    }
    uint16_t other = label_at(o, LABELS_REGIONS, x, y);
    return is_region(o, other) && other != label && root_of(o, other) == root_of(o, label);
}

color merged_color(const void *user, uint32_t x, uint32_t y) {
    const region_paint *p = user;
    const observation *o = &p->e->o;
    uint16_t label = label_at(o, LABELS_REGIONS, x, y);
    if (!is_region(o, label)) {
        return region_color(user, x, y);
    }
    color own = p->e->fates.of[label] != FATE_ROOM ? PAINT_BACKGROUND
                                                    : room_color(p->index[label]);
    own = paint_mix(own, PAINT_FREE, p->pale);
    return is_seam(o, label, x + 1, y) || is_seam(o, label, x, y + 1)
               ? paint_mix(own, PAINT_INK, SEAM_SHARE)
               : own;
}
