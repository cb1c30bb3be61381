#include "../../src/heap.c"
#include "proof.h"

/* Any six items: they come out in order, and none is lost. */
void prove_heap(void)
{
    enum { COUNT = 6 };
    rs_heap_item items[COUNT];
    rs_heap heap = {items, 0};
    uint32_t sum = 0;
    for (uint32_t i = 0; i < COUNT; i++) {
        rs_heap_push(&heap, nondet_u32(), i);
    }
    rs_heap_item before = {UINT32_MAX, 0};
    for (uint32_t i = 0; i < COUNT; i++) {
        rs_heap_item next = rs_heap_pop(&heap);
        PROVE(next.key < before.key || (next.key == before.key && next.item >= before.item));
        PROVE(next.item < COUNT && (sum >> next.item & 1u) == 0u);
        sum |= 1u << next.item;
        before = next;
    }
    PROVE(heap.count == 0u);
}
