#include "queue.h"

void rs_queue_init(rs_queue *queue, rs_queue_list *lists, rs_queue_block *blocks,
                   uint32_t block_count)
{
    queue->lists = lists;
    queue->blocks = blocks;
    queue->block_count = block_count;
    queue->vacant = RS_QUEUE_NONE;
    queue->untouched = 0;
    queue->left = block_count;
    for (uint32_t i = 0; i < RS_QUEUE_LISTS; i++) {
        lists[i].first = RS_QUEUE_NONE;
        lists[i].last = RS_QUEUE_NONE;
        lists[i].head = 0;
        lists[i].tail = 0;
    }
}

static uint32_t take_block(rs_queue *queue)
{
    uint32_t block = queue->vacant;

    if (block != RS_QUEUE_NONE) {
        queue->vacant = queue->blocks[block].next;
    } else if (queue->untouched < queue->block_count) {
        block = queue->untouched++;
    }
    queue->left -= block != RS_QUEUE_NONE;
    return block;
}

bool rs_queue_push(rs_queue *queue, uint32_t list, uint32_t cell)
{
    rs_queue_list *l = &queue->lists[list];

    if (l->first == RS_QUEUE_NONE || l->tail == ROOMSEG_QUEUE_BLOCK_CELLS) {
        uint32_t block = take_block(queue);
        if (block == RS_QUEUE_NONE) {
            return false;
        }
        queue->blocks[block].next = RS_QUEUE_NONE;
        if (l->first == RS_QUEUE_NONE) {
            l->first = block;
            l->head = 0;
        } else {
            queue->blocks[l->last].next = block;
        }
        l->last = block;
        l->tail = 0;
    }
    queue->blocks[l->last].cells[l->tail++] = cell;
    return true;
}

bool rs_queue_pop(rs_queue *queue, uint32_t list, uint32_t *cell)
{
    rs_queue_list *l = &queue->lists[list];
    uint32_t block = l->first;

    if (block == RS_QUEUE_NONE) {
        return false;
    }
    *cell = queue->blocks[block].cells[l->head++];
    if (l->head == (block == l->last ? l->tail : ROOMSEG_QUEUE_BLOCK_CELLS)) {
        l->first = queue->blocks[block].next; /* RS_QUEUE_NONE behind the last block */
        l->head = 0;
        queue->blocks[block].next = queue->vacant;
        queue->vacant = block;
        queue->left++;
    }
    return true;
}
