#include "../../src/queue.c"
#include "proof.h"

/* Any 14 pushes and pops on two lists with two blocks: first in, first out, nothing lost, and the
 * number of blocks left is right at the end. */
void prove_queue(void)
{
    enum { STEPS = 14, BLOCKS = 2 };
    static rs_queue_list lists[RS_QUEUE_LISTS];
    static rs_queue_block blocks[BLOCKS];
    uint32_t pushed[2] = {0, 0}, popped[2] = {0, 0};
    rs_queue queue;
    rs_queue_init(&queue, lists, blocks, BLOCKS);
    for (uint32_t step = 0; step < STEPS; step++) {
        uint32_t list = nondet_u8() & 1u, cell;
        if ((nondet_u8() & 1u) != 0u) {
            if (rs_queue_push(&queue, list, pushed[list])) {
                pushed[list]++;
            } else {
                PROVE(queue.left == 0u);
            }
        } else if (rs_queue_pop(&queue, list, &cell)) {
            PROVE(cell == popped[list] && cell < pushed[list]);
            popped[list]++;
        } else {
            PROVE(pushed[list] == popped[list]);
        }
        PROVE(queue.left <= BLOCKS);
        PROVE(queue.left < BLOCKS || (pushed[0] == popped[0] && pushed[1] == popped[1]));
    }
}
