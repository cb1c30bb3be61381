/* The memory plan of the paper profile; see plan.h for how such a table is used.
 *
 *       stage   THRESHOLD COMPONENTS MASK LIFETIME SEEDS RIDGE WATERSHED DISTANCE GRAPH MERGE
 *   surface     ########################################################################
 *   lifetime                         ###################
 *   shares                                ########                           (2 bytes a cell)
 *   roots                                                #####               (2 bytes a cell)
 *   line_blocks                                                #########  (2.3 bytes a cell)
 *   graph                                                                         ##########
 *
 * Then ROOMS. The surface and the lifetime take 1 byte a cell; the most is taken by LIFETIME:
 * 4 bytes a cell and a few rows. */
#ifndef ROOMSEG_PLAN_PAPER_H
#define ROOMSEG_PLAN_PAPER_H

#include "roomseg/plan.h"

/* Cells around the crop in which the blur is followed. */
#define ROOMSEG_BLUR_MARGIN 8u
#define ROOMSEG_PLAN_BLURRED(side) ((size_t)(side) + 2u * ROOMSEG_BLUR_MARGIN)

/* Rows that the blur keeps, for boxes at 20 mm per cell (tested). */
#define ROOMSEG_BLUR_ROWS 10u

/* Scratch of the blur as one buffer. */
#define ROOMSEG_PLAN_BLUR_BYTES(w)                                            \
    (ROOMSEG_PLAN_BLURRED(w) * (2u * ROOMSEG_BLUR_ROWS + 8u) + 8u * ROOMSEG_BLUR_ROWS)

/* Half the taps of the ridge map's Gaussian, and rows that its stage keeps. */
#define ROOMSEG_RIDGE_MAX_RADIUS 19u
#define ROOMSEG_RIDGE_ROWS (2u * ROOMSEG_RIDGE_MAX_RADIUS + 6u)

/* Blocks of the queue of the watershed with lines: room for half of the cells at once. */
#define ROOMSEG_PLAN_LINE_BLOCKS(w, h) \
    (ROOMSEG_PLAN_CELLS(w, h) / (2u * ROOMSEG_QUEUE_BLOCK_CELLS) + 512u)

/* The stack for dropping components: of obstacles, or of free cells, see
 * rs_components_keep_large_free. */
#define ROOMSEG_PLAN_FREE_STACK(w, h, small) \
    ROOMSEG_PLAN_MAX((size_t)(small), (size_t)(w) * (h) / 2u + 1u)

/* Columns as in ROOMSEG_PLAN_TABLE; stages are numbered from 0 in the order of the drawing,
 * ROOMS is 10. */
#define ROOMSEG_PLAN_PAPER_TABLE(X, S, w, h, small, max_regions, max_rooms)                       \
    X(S, surface, 1u, ROOMSEG_PLAN_CELLS(w, h), 0, 10)                                            \
    X(S, small_scratch, 1u,                                                                       \
      ROOMSEG_PLAN_SMALL_BYTES(w, ROOMSEG_PLAN_FREE_STACK(w, h, small)), 1, 1)                    \
    X(S, lifetime, 1u, ROOMSEG_PLAN_CELLS(w, h), 2, 4)                                            \
    X(S, background, 1u, ROOMSEG_PLAN_CELLS(w, h), 2, 2)                                          \
    X(S, columns, 1u, (size_t)(w) + 2u, 2, 2)                                                     \
    X(S, shares, 2u, ROOMSEG_PLAN_BLURRED(w) * ROOMSEG_PLAN_BLURRED(h), 3, 3)                     \
    X(S, blur_rows, 1u, ROOMSEG_PLAN_BLUR_BYTES(w), 3, 3)                                         \
    X(S, seed_ring, 4u, ROOMSEG_PLAN_RING(w, h), 4, 4)                                            \
    X(S, births, 1u, (size_t)(max_regions) + 1u, 4, 4)                                            \
    X(S, ridge_rows, 4u, ROOMSEG_RIDGE_ROWS * ((size_t)(w) + 2u), 5, 5)                           \
    X(S, roots, 2u, (size_t)(w) * (h), 5, 5)                                                      \
    X(S, line_lists, 1u, ROOMSEG_QUEUE_LISTS_BYTES, 6, 6)                                         \
    X(S, line_blocks, ROOMSEG_QUEUE_BLOCK_BYTES, ROOMSEG_PLAN_LINE_BLOCKS(w, h), 6, 6)            \
    X(S, envelope, 8u, (size_t)(w) + 2u, 7, 7)                                                    \
    X(S, levels, 4u, 256u, 7, 7)                                                                  \
    X(S, regions, ROOMSEG_REGION_BYTES, (size_t)(max_regions) + 1u, 8, 10)                        \
    X(S, edges, ROOMSEG_EDGE_BYTES, ROOMSEG_PLAN_EDGES(max_regions), 8, 10)                       \
    X(S, heap, ROOMSEG_HEAP_ITEM_BYTES, ROOMSEG_PLAN_EDGES(max_regions), 9, 10)                   \
    X(S, marks, 4u, (size_t)(max_regions) + 1u, 9, 9)                                             \
    X(S, line_rows, 2u, 3u * (size_t)(w), 10, 10)                                                 \
    X(S, rooms, ROOMSEG_ROOM_BYTES, (size_t)(max_rooms), 10, 10)                                  \
    X(S, room_sums, ROOMSEG_ROOM_SUM_BYTES, (size_t)(max_rooms), 10, 10)                          \
    X(S, doorways, ROOMSEG_DOORWAY_BYTES, ROOMSEG_PLAN_EDGES(max_rooms), 10, 10)                  \
    X(S, links, 2u, 2u * ROOMSEG_PLAN_EDGES(max_rooms), 10, 10)

#define ROOMSEG_PLAN_PAPER_AT(stage, w, h, small, regions, rooms) \
    ((size_t)0 ROOMSEG_PLAN_PAPER_TABLE(ROOMSEG_PLAN_ALIVE, stage, w, h, small, regions, rooms))
#define ROOMSEG_PLAN_PAPER_MOST(a, b, w, h, small, regions, rooms)            \
    ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_PAPER_AT(a, w, h, small, regions, rooms),   \
                     ROOMSEG_PLAN_PAPER_AT(b, w, h, small, regions, rooms))

/* Arena bytes for a config of the paper profile; arguments as for ROOMSEG_ARENA_SIZE.
 * A few arguments can make any of these stages the largest: COMPONENTS, LIFETIME, SEEDS,
 * RIDGE, WATERSHED, GRAPH, MERGE, ROOMS. */
#define ROOMSEG_ARENA_SIZE_PAPER(w, h, small, regions, rooms)                                  \
    ROOMSEG_PLAN_MAX(                                                                          \
        ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_PAPER_MOST(1, 3, w, h, small, regions, rooms),           \
                         ROOMSEG_PLAN_PAPER_MOST(4, 5, w, h, small, regions, rooms)),          \
        ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_PAPER_MOST(6, 8, w, h, small, regions, rooms),           \
                         ROOMSEG_PLAN_PAPER_MOST(9, 10, w, h, small, regions, rooms)))

/* The same for the parameters of roomseg_config_paper(). */
#define ROOMSEG_ARENA_SIZE_PAPER_DEFAULT(w, h, resolution_mm)                             \
    ROOMSEG_ARENA_SIZE_PAPER(w, h, ROOMSEG_PLAN_SMALL(96000u, 0u, resolution_mm), 1024u,  \
                             255u)

/* The same for those of roomseg_config_paper_home(). */
#define ROOMSEG_ARENA_SIZE_PAPER_HOME(w, h, resolution_mm)                                       \
    ROOMSEG_ARENA_SIZE_ALIGNED(                                                                  \
        w, h, ROOMSEG_PLAN_SMALL(4000000u, 0u, resolution_mm), 255u,                             \
        ROOMSEG_ARENA_SIZE_PAPER(ROOMSEG_PLAN_TURNED_WIDTH(w, h),                                \
                                 ROOMSEG_PLAN_TURNED_HEIGHT(w, h),                               \
                                 ROOMSEG_PLAN_SMALL(4000000u, 0u, resolution_mm), 1024u, 255u))

#endif
