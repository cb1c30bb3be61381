#include "heap.h"

static bool comes_before(const rs_heap_item *a, const rs_heap_item *b)
{
    return a->key > b->key || (a->key == b->key && a->item < b->item);
}

void rs_heap_push(rs_heap *heap, uint32_t key, uint32_t item)
{
    rs_heap_item fresh = {key, item};
    uint32_t hole = heap->count++;

    while (hole > 0u) {
        uint32_t parent = (hole - 1u) / 2u;
        if (!comes_before(&fresh, &heap->items[parent])) {
            break;
        }
        heap->items[hole] = heap->items[parent];
        hole = parent;
    }
    heap->items[hole] = fresh;
}

rs_heap_item rs_heap_pop(rs_heap *heap)
{
    rs_heap_item top = heap->items[0];
    rs_heap_item last = heap->items[--heap->count];
    uint32_t hole = 0;

    for (;;) {
        uint32_t child = 2u * hole + 1u;
        if (child >= heap->count) {
            break;
        }
        if (child + 1u < heap->count &&
            comes_before(&heap->items[child + 1u], &heap->items[child])) {
            child++;
        }
        if (!comes_before(&heap->items[child], &last)) {
            break;
        }
        heap->items[hole] = heap->items[child];
        hole = child;
    }
    heap->items[hole] = last;
    return top;
}
