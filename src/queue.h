/* A set of first-in-first-out lists of cells in one pool of blocks. */
#ifndef RS_QUEUE_H
#define RS_QUEUE_H

#include "base.h"

#define RS_QUEUE_LISTS 512u

typedef struct rs_queue_block {
    uint32_t next; /* the list's next block; of a vacant one: the next vacant */
    uint32_t cells[ROOMSEG_QUEUE_BLOCK_CELLS];
} rs_queue_block;

/* A list occupies the cells from `head` of block `first` up to before `tail` of `last`. */
typedef struct rs_queue_list {
    uint32_t first, last; /* RS_QUEUE_NONE when the list is empty */
    uint16_t head, tail;
} rs_queue_list;

#define RS_QUEUE_NONE UINT32_MAX

RS_STATIC_ASSERT(sizeof(rs_queue_block) == ROOMSEG_QUEUE_BLOCK_BYTES, queue_block);
RS_STATIC_ASSERT(sizeof(rs_queue_list) * RS_QUEUE_LISTS == ROOMSEG_QUEUE_LISTS_BYTES,
                 queue_lists);

typedef struct rs_queue {
    rs_queue_list *lists;   /* RS_QUEUE_LISTS of them */
    rs_queue_block *blocks;
    uint32_t block_count;
    uint32_t vacant;        /* first vacant block or RS_QUEUE_NONE */
    uint32_t untouched;     /* blocks from here on were never used */
    uint32_t left;          /* vacant and untouched blocks */
} rs_queue;

/* Empties all lists. */
void rs_queue_init(rs_queue *queue, rs_queue_list *lists, rs_queue_block *blocks,
                   uint32_t block_count);

/* Appends a cell to a list. False, and nothing changed: no block is left. */
bool rs_queue_push(rs_queue *queue, uint32_t list, uint32_t cell);

/* Takes the oldest cell of a list. False: the list is empty. */
bool rs_queue_pop(rs_queue *queue, uint32_t list, uint32_t *cell);

#endif
