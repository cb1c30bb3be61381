/* A first-in-first-out queue of cells in one block of memory. */
#ifndef RS_RING_H
#define RS_RING_H

#include "base.h"

typedef struct rs_ring {
    uint32_t *cells;
    uint32_t capacity; /* >= 1 */
    uint32_t first, count;
} rs_ring;

/* False, and nothing changed: it is full. */
static inline bool rs_ring_push(rs_ring *ring, uint32_t cell)
{
    uint32_t last = ring->first + ring->count;

    if (ring->count == ring->capacity) {
        return false;
    }
    ring->cells[last < ring->capacity ? last : last - ring->capacity] = cell;
    ring->count++;
    return true;
}

/* The oldest cell; there must be one. */
static inline uint32_t rs_ring_pop(rs_ring *ring)
{
    uint32_t cell = ring->cells[ring->first];

    ring->first = ring->first + 1u == ring->capacity ? 0u : ring->first + 1u;
    ring->count--;
    return cell;
}

#endif
