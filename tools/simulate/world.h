/* The flat as the laser meets it: a picture of 1 cm pixels, each with its material and
 * the true room. Coordinates in cm, x right, y down. */
#ifndef ROOMSEG_SIMULATE_WORLD_H
#define ROOMSEG_SIMULATE_WORLD_H

#include <stddef.h>
#include <stdint.h>

/* In the order of what stops a laser beam; the robot drives on floor and rug only. */
typedef enum material {
    MAT_FLOOR = 0,
    MAT_OUTSIDE, /* clear air that the robot cannot reach */
    MAT_RUG,     /* floor that returns a beam now and then */
    MAT_HAZE,    /* grass, stairs, railings: returns a beam somewhere, or not */
    MAT_GLASS,   /* lets most beams through */
    MAT_DARK,    /* swallows most beams */
    MAT_CRACK,   /* edge of a wall where a beam may slip by */
    MAT_SOLID,   /* furniture */
    MAT_WALL,
    MAT_RIM /* border of the picture: nothing comes back from there */
} material;

typedef struct world {
    int width, height;
    uint8_t *materials; /* one material a pixel, row by row; owned */
    uint8_t *rooms;     /* 0 = no room; owned */
} world;

/* Half-open: x0 <= x < x1. */
typedef struct box {
    int x0, y0, x1, y1;
} box;

int box_area(box b);
int box_overlap(box a, box b); /* 1 when they share a pixel */

/* What a shape does to the room numbers below it. */
#define ROOM_KEEP (-1)

/* Everything outside, no room, a rim of one pixel. Returns 0, or -1 without memory. */
int world_make(world *w, int width, int height);
void world_free(world *w);

/* Shapes; what lies beyond the picture or on its rim is cut off. room: 0..255 or ROOM_KEEP. */
void world_fill_box(world *w, box b, material m, int room);
void world_fill_disc(world *w, int x, int y, int radius, material m, int room);

/* A convex polygon, corners clockwise to the eye, in 1/16 cm; count 3..8. */
void world_fill_convex(world *w, const int32_t (*corners)[2], int count, material m, int room);

/* 1 when every pixel of the box has the material. */
int world_is_all(const world *w, box b, material m);

/* Bends the picture: right of x = from, columns slide down by slope_permille of their
 * distance to it (left of it they stay), so that a wing of the flat is not at right angles. */
void world_bend(world *w, int from, int slope_permille);

material world_material(const world *w, int x, int y);

#endif
