/* Single pieces of furniture, as a laser 10 cm above the floor meets them. */
#ifndef ROOMSEG_SIMULATE_PIECES_H
#define ROOMSEG_SIMULATE_PIECES_H

#include "frame.h"
#include "rng.h"

typedef enum piece_kind {
    PIECE_CABINET,
    PIECE_SHELF,
    PIECE_BED,
    PIECE_SOFA,
    PIECE_CORNER_SOFA,
    PIECE_ARMCHAIR,
    PIECE_DESK,
    PIECE_DINING_SET,
    PIECE_COFFEE_TABLE,
    PIECE_ISLAND,
    PIECE_COUNTER,
    PIECE_TUB,
    PIECE_SHOWER,
    PIECE_TOILET,
    PIECE_SINK,
    PIECE_PLANT,
    PIECE_RACK,
    PIECE_BOX,
    PIECE_TOYS,
    PIECE_CHAIR,
    PIECE_JUNK,
    PIECE_COUNT
} piece_kind;

/* How large a kind of piece is and where it stands [cm]. */
typedef struct piece_size {
    int width_low, width_high; /* along the wall */
    int depth_low, depth_high; /* into the room */
    int front;                 /* room that is left in front of it; all around a piece that
                                  stands free, which may also be in front of others when 0 */
    int at_wall;               /* its back leans on a wall; else it stands free */
} piece_size;

/* Draws a piece into the rectangle -width/2..width/2, 0..depth of the frame. */
void piece_draw(world *w, piece_kind kind, const frame *f, int width, int depth, rng *r);

const piece_size *piece_size_of(piece_kind kind);

#endif
