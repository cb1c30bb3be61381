/* Binary max-heap of (key, item) pairs in a caller's array. Equal keys: the smaller item
 * first, so that the order is the same everywhere. */
#ifndef RS_HEAP_H
#define RS_HEAP_H

#include "base.h"

typedef struct rs_heap_item {
    uint32_t key;
    uint32_t item;
} rs_heap_item;

RS_STATIC_ASSERT(sizeof(rs_heap_item) == ROOMSEG_HEAP_ITEM_BYTES, heap_item);

typedef struct rs_heap {
    rs_heap_item *items;
    uint32_t count; /* the caller sees to it that the array is long enough */
} rs_heap;

void rs_heap_push(rs_heap *heap, uint32_t key, uint32_t item);

/* Takes the pair with the greatest key. Requires count > 0. */
rs_heap_item rs_heap_pop(rs_heap *heap);

#endif
