#include "frame.h"

#include "turn.h"

frame frame_at(int x, int y, int32_t angle) {
    return (frame){x * 16, y * 16, turn_cos(angle), turn_sin(angle)};
}

/* The point (u, v) [cm] in the world, in 1/16 cm. */
static void to_world(const frame *f, int u, int v, int32_t point[2]) {
    int64_t x = (int64_t)u * f->ux - (int64_t)v * f->uy;
    int64_t y = (int64_t)u * f->uy + (int64_t)v * f->ux;
    point[0] = f->x + (int32_t)(x / 4096);
    point[1] = f->y + (int32_t)(y / 4096);
}

void frame_box(world *w, const frame *f, int u0, int v0, int u1, int v1, material m) {
    int32_t corners[4][2];
    to_world(f, u0, v0, corners[0]);
    to_world(f, u1, v0, corners[1]);
    to_world(f, u1, v1, corners[2]);
    to_world(f, u0, v1, corners[3]);
    world_fill_convex(w, (const int32_t(*)[2])corners, 4, m, ROOM_KEEP);
}

void frame_disc(world *w, const frame *f, int u, int v, int radius, material m) {
    int32_t centre[2];
    to_world(f, u, v, centre);
    world_fill_disc(w, centre[0] / 16, centre[1] / 16, radius, m, ROOM_KEEP);
}

frame frame_inside(const frame *f, int u, int v, int32_t angle) {
    int32_t origin[2];
    int64_t c = turn_cos(angle);
    int64_t s = turn_sin(angle);
    to_world(f, u, v, origin);
    return (frame){origin[0], origin[1], (int32_t)((f->ux * c - f->uy * s) / TURN_FULL),
                   (int32_t)((f->uy * c + f->ux * s) / TURN_FULL)};
}
