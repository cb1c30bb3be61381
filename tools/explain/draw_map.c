/* The map itself, the threshold, and what is small. */
#include "colors.h"
#include "explanation.h"

/* Shades from white for 0 to black for 255. */
static color raw_color(const void *user, uint32_t x, uint32_t y) {
    const explanation *e = user;
    uint8_t cell = e->m.cells[(size_t)(e->frame.y + y) * e->m.width + e->frame.x + x];
    uint8_t gray = (uint8_t)(255 - cell);
    color c = {gray, gray, gray};
    return c;
}

/* The paper's threshold knows two kinds of cells, the default profile three. */
static color threshold_color(const void *user, uint32_t x, uint32_t y) {
    const explanation *e = user;
    if (plane_at(&e->o, PLANE_FREE, x, y) != 0) {
        return PAINT_FREE;
    }
    return is_paper(e) ? PAINT_OBSTACLE
                       : picture_map_color(&e->o.frame, &e->staged, x, y);
}

/* A free part inside of an obstacle that is itself too small is lost and won again; it shows
 * as if it had stayed. */
static color free_parts_color(const void *user, uint32_t x, uint32_t y) {
    const explanation *e = user;
    int free_before = plane_at(&e->o, PLANE_FREE, x, y) != 0;
    int free_after = plane_at(&e->o, PLANE_CLEARED, x, y) != 0;
    return !free_before ? PAINT_OBSTACLE : free_after ? PAINT_FREE : PAINT_SECOND;
}

/* Obstacles that became transparent; in the default profile those whose cells carry the
 * label of the room around have a colour of their own. */
static color cleared_color(const void *user, uint32_t x, uint32_t y) {
    const explanation *e = user;
    color own = picture_map_color(&e->o.frame, &e->staged, x, y);
    if (plane_at(&e->o, PLANE_CLEARED, x, y) == 0) {
        return is_paper(e) || own.r == PAINT_FREE.r ? PAINT_OBSTACLE : own;
    }
    if (plane_at(&e->o, PLANE_FREE, x, y) != 0) {
        return PAINT_FREE;
    }
    return own.r == PAINT_OBSTACLE.r ? PAINT_SIGNAL : PAINT_AMBER;
}

int draw_staged(const explanation *e, cell_paint paint, const void *user, canvas *out) {
    return picture_paint(&e->o.frame, &e->staged, paint, user, out);
}

int draw_and_add(explanation *e, const char *name, cell_paint paint, const void *user) {
    canvas c;
    return draw_staged(e, paint, user, &c) == 0 ? album_add(&e->album, name, &c) : -1;
}

int draw_given_map(explanation *e) {
    canvas c;
    return picture_paint(&e->frame, &e->given, raw_color, e, &c) == 0
               ? album_add(&e->album, "map", &c)
               : -1;
}

int draw_threshold_pictures(explanation *e) {
    int rc = draw_and_add(e, "threshold", threshold_color, e);
    if (rc == 0 && is_paper(e)) {
        rc = draw_and_add(e, "free_parts", free_parts_color, e);
    }
    return rc == 0 ? draw_and_add(e, "small_obstacles", cleared_color, e) : -1;
}
