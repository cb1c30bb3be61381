/* The plan of a flat: rooms that tile it, and the openings between them. All lengths and
 * coordinates in cm, x right, y down. */
#ifndef ROOMSEG_SIMULATE_FLAT_H
#define ROOMSEG_SIMULATE_FLAT_H

#include "rng.h"
#include "world.h"

#define FLAT_MAX_PARTS 18
#define FLAT_MAX_OPENINGS 80

typedef enum flat_size { FLAT_SMALL, FLAT_MEDIUM, FLAT_LARGE } flat_size;

typedef enum part_kind {
    PART_VOID, /* outside, or somebody else's flat: never seen */
    PART_STAIRS, /* seen from the hall, not entered, no room */
    PART_HALL,
    PART_LIVING,
    PART_DINING,
    PART_KITCHEN,
    PART_BED,
    PART_BATH,
    PART_STUDY,
    PART_STORE
} part_kind;

/* A rectangle of the plan. Several parts without walls between them are one room, which
 * then is L-shaped, say. */
typedef struct part {
    box area; /* up to the middle of the inner walls */
    part_kind kind;
    int room; /* 1..room_count, 0 where there is none */
} part;

typedef enum opening_kind {
    OPENING_DOOR,
    OPENING_WIDE,   /* passage without a door between two rooms */
    OPENING_MERGED, /* no wall: both parts are one room */
    OPENING_GLASS,  /* window down to the floor */
    OPENING_OUTER   /* the front door, when it stands open */
} opening_kind;

/* A gap in the wall along the line x = line (upright) or y = line, between from and to. */
typedef struct opening {
    opening_kind kind;
    int low, high; /* parts on the side of smaller and of larger coordinates; -1 outside */
    int upright;
    int line, from, to;
    int shut;         /* the door is closed; the robot does not see what is behind */
    int has_leaf;     /* an open door leaf is there */
    int hinge_at_to;  /* else at from */
    int leaf_in_high; /* the side the leaf swings to; else low */
    int leaf_degrees; /* how far it is open, 82..172 */
} opening;

typedef struct flat {
    part parts[FLAT_MAX_PARTS];
    int part_count;
    int room_count;
    opening openings[FLAT_MAX_OPENINGS];
    int opening_count;
    int wall;          /* thickness of the inner walls, even */
    int outer_wall;    /* thickness of the outer walls */
    int width, height; /* of the world: the plan and the margin around it */
    int bend_from, bend_permille; /* see world_bend; 0 permille: right angles */
} flat;

/* Free land around the plan, so that beams through a window have somewhere to go. */
#define FLAT_MARGIN 500

/* Rooms and what they are for; no openings yet. */
void flat_layout(flat *f, flat_size size, rng *r);

/* Joins parts, connects every part with the others by doors, numbers the rooms. Parts that
 * cannot be reached become void. */
void flat_connect(flat *f, rng *r);

/* Moves sides of rooms inwards that have no opening: closets, shafts, a jagged outline. */
void flat_set_back(flat *f, rng *r);

/* Sets windows and the front door. */
void flat_open_outwards(flat *f, rng *r);

/* Draws walls, openings, door leaves and what is outside. */
void flat_draw(const flat *f, world *w, rng *r);

/* The rectangle of floor that belongs to a part: without half of its walls. */
box flat_floor(const flat *f, int part_index);

/* The gap of an opening, reaching `depth` to both sides of the wall's middle. */
box flat_gap(const opening *o, int depth);

#endif
