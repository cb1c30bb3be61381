/* Stage 7: labels and records for the caller. */
#ifndef RS_ROOMS_H
#define RS_ROOMS_H

#include "base.h"
#include "graph.h"
#include "heap.h"

/* Sums over the cells of a room, crop coordinates. */
typedef struct rs_room_sum {
    uint64_t x, y;
} rs_room_sum;

RS_STATIC_ASSERT(sizeof(rs_room_sum) == ROOMSEG_ROOM_SUM_BYTES, room_sum);
RS_STATIC_ASSERT(sizeof(roomseg_room) == ROOMSEG_ROOM_BYTES, room);
RS_STATIC_ASSERT(sizeof(roomseg_doorway) == ROOMSEG_DOORWAY_BYTES, doorway);

typedef struct rs_room_records {
    roomseg_room *rooms;        /* max_rooms */
    rs_room_sum *sums;          /* max_rooms, scratch */
    roomseg_doorway *doorways;  /* ROOMSEG_PLAN_EDGES(max_rooms) */
    uint16_t *links;            /* twice that */
    uint32_t max_rooms;
    uint32_t room_count, doorway_count; /* out */
} rs_room_records;

/* Numbers the rooms, which are the roots of the merged graph with area > 0, largest first;
 * replaces the region labels by room labels, 0 on cells of occupied_min or more; measures the
 * rooms and connects them.
 * Fails iff there are more than max_rooms (ROOMSEG_ERR_ROOMS), the hook cancels, or as
 * rs_rooms_connect. */
int rs_rooms_run(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                 const rs_labels *labels, rs_graph *graph, rs_room_records *records,
                 rs_heap_item *heap, rs_ticker *ticker);

/* Fills the doorways and links. Fails iff more than ROOMSEG_PLAN_EDGES(max_rooms) pairs of
 * rooms touch (ROOMSEG_ERR_ROOMS; not for a planar graph). */
int rs_rooms_connect(const rs_frame *frame, uint32_t resolution_mm, const rs_graph *graph,
                     rs_room_records *records, rs_heap_item *heap);

/* What the caller sees of the records, as far as a run came. */
void rs_rooms_report(const rs_room_records *records, roomseg_result *result);

#endif
