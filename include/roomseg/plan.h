/* The memory plan: every buffer of a run, in one table.
 *
 * The arena is laid out from this table alone. ROOMSEG_ARENA_SIZE() evaluates it at
 * compile time, roomseg_arena_size() at run time, and roomseg_run() places the buffers
 * by it; all three agree to the byte.
 *
 *       stage   THRESHOLD COMPONENTS SURFACE WATERSHED GRAPH MERGE ROOMS DOORWAYS
 *   surface     ##########################################               (1 byte a cell)
 *   components            ########
 *   envelope                         #####
 *   ring                                   #######                      (1/8 byte a cell)
 *   graph                                          ############################
 *   shapes                                               #####
 *   rooms                                                      ################
 *   doorways                                                            #######
 *
 * Buffers that are never alive in the same stage share bytes: graph, rooms and doorways lie at
 * the arena's end, all others at its start. The arena is the most that any stage has alive. */
#ifndef ROOMSEG_PLAN_H
#define ROOMSEG_PLAN_H

#include <stddef.h>
#include <stdint.h>

/* Sizes of internal records [bytes]; src/ asserts them at compile time. They hold no
 * pointers, so they are equal on every target. */
#define ROOMSEG_RUN_BYTES 6u
#define ROOMSEG_COMPONENT_BYTES 20u
#define ROOMSEG_QUEUE_LISTS_BYTES 6144u
#define ROOMSEG_QUEUE_BLOCK_BYTES 32u
#define ROOMSEG_QUEUE_BLOCK_CELLS 7u
#define ROOMSEG_REGION_BYTES 32u
#define ROOMSEG_SHAPE_BYTES 32u
#define ROOMSEG_EDGE_BYTES 24u
#define ROOMSEG_COLUMN_BYTES 4u
#define ROOMSEG_HEAP_ITEM_BYTES 8u
#define ROOMSEG_ROOM_BYTES 40u
#define ROOMSEG_ROOM_SUM_BYTES 16u
#define ROOMSEG_DOORWAY_BYTES 16u
#define ROOMSEG_NORMAL_BYTES 4u
#define ROOMSEG_DIRECTION_BIN_BYTES 24u

/* Cells of the crop with its border of one obstacle cell on every side. */
#define ROOMSEG_PLAN_CELLS(w, h) (((size_t)(w) + 2u) * ((size_t)(h) + 2u))

/* Runs that one bordered row can hold. */
#define ROOMSEG_PLAN_RUNS(w) (((size_t)(w) + 3u) / 2u)

/* Cells of plateaus that the watershed has reached and not yet left. Beyond that it goes on from
 * them before it reads on, and at worst reads the surface again. */
#define ROOMSEG_PLAN_RING(w, h) (ROOMSEG_PLAN_CELLS(w, h) / 32u + 256u)

/* Blocks of the bucket queue of the paper's watershed and of alignment. */
#define ROOMSEG_PLAN_QUEUE_BLOCKS(w, h) \
    (ROOMSEG_PLAN_CELLS(w, h) / (18u * ROOMSEG_QUEUE_BLOCK_CELLS) + 128u)

/* Pairs of regions that touch are fewer than 3 a region, since the map is plane; pairs that
 * only share a wall come out of what is left. */
#define ROOMSEG_PLAN_EDGES(regions) ((size_t)(regions) * 3u)

/* X(buffer, bytes of an element, elements, first stage, last stage); stages are numbered
 * from 0 in the order of the drawing above.
 * w, h: crop [cells]; small: cells of the largest obstacle that is dropped or made
 * transparent; max_regions, max_rooms: capacities. */
#define ROOMSEG_PLAN_TABLE(X, S, w, h, small, max_regions, max_rooms)                             \
    X(S, surface, 1u, ROOMSEG_PLAN_CELLS(w, h), 0, 4)                                             \
    X(S, runs, ROOMSEG_RUN_BYTES, 2u * ROOMSEG_PLAN_RUNS(w), 1, 1)                                \
    X(S, components, ROOMSEG_COMPONENT_BYTES, 2u * ROOMSEG_PLAN_RUNS(w), 1, 1)                    \
    X(S, active, 2u, 2u * ROOMSEG_PLAN_RUNS(w), 1, 1)                                             \
    X(S, vacant, 2u, 2u * ROOMSEG_PLAN_RUNS(w), 1, 1)                                             \
    X(S, stack, 4u, (size_t)(small), 1, 1)                                                        \
    X(S, envelope, 8u, (size_t)(w) + 2u, 2, 2)                                                    \
    X(S, levels, 4u, 256u, 2, 2)                                                                  \
    X(S, ring, 4u, ROOMSEG_PLAN_RING(w, h), 3, 3)                                                 \
    X(S, regions, ROOMSEG_REGION_BYTES, (size_t)(max_regions) + 1u, 4, 7)                         \
    X(S, edges, ROOMSEG_EDGE_BYTES, ROOMSEG_PLAN_EDGES(max_regions), 4, 7)                        \
    X(S, columns, ROOMSEG_COLUMN_BYTES, (size_t)(w), 4, 4)                                        \
    X(S, shapes, ROOMSEG_SHAPE_BYTES, (size_t)(max_regions) + 1u, 5, 5)                           \
    X(S, heap, ROOMSEG_HEAP_ITEM_BYTES, ROOMSEG_PLAN_EDGES(max_regions), 5, 7)                    \
    X(S, rooms, ROOMSEG_ROOM_BYTES, (size_t)(max_rooms), 6, 7)                                    \
    X(S, room_sums, ROOMSEG_ROOM_SUM_BYTES, (size_t)(max_rooms), 6, 6)                            \
    X(S, doorways, ROOMSEG_DOORWAY_BYTES, ROOMSEG_PLAN_EDGES(max_rooms), 7, 7)                    \
    X(S, links, 2u, 2u * ROOMSEG_PLAN_EDGES(max_rooms), 7, 7)

/* Alignment (config.align): first the direction of the walls is found; then, in the same
 * bytes, the profile runs on the turned grid, and its labels are turned back and measured.
 *
 *          stage   MASK EDGES LINES    TURNED DROPPED MASK CARRY DISTANCE GRAPH ROOMS
 *   mask           ################                                     (1 byte a cell)
 *   points              ###########                                     (4 bytes a cell)
 *   votes                     #####
 *   turned_labels                      #########################        (2 bytes a cell)
 *   turned_cells                       ##############                   (1 byte a cell)
 *   turned_arena                       ######                           (profile's arena)
 *   surface                                           ######################## (1 byte a cell)
 *   graph                                                            ########
 *   records                                                                ### */
#define ROOMSEG_CANNY_ROWS 31u
#define ROOMSEG_HOUGH_ANGLES 180u
#define ROOMSEG_DIRECTION_BINS 90u

/* Distances of a line from the middle of a crop, in cells. */
#define ROOMSEG_PLAN_DISTANCES(w, h) ((size_t)(w) + (h) + 3u)

/* Turned by an angle a, the frame of w x h cells is at most w cos a + h sin a + 1 cells wide
 * and takes at most (w + h + 2)^2 / 2 cells. So no turned frame is wider than this one, and
 * none takes more cells, with and without border. */
#define ROOMSEG_PLAN_TURNED_WIDTH(w, h) ((size_t)(w) + (h) + 2u)
#define ROOMSEG_PLAN_TURNED_HEIGHT(w, h) (((size_t)(w) + (h) + 3u) / 2u)

/* The scratch of COMPONENTS as one buffer. */
#define ROOMSEG_PLAN_SMALL_BYTES(w, small)                                        \
    ((ROOMSEG_COMPONENT_BYTES + ROOMSEG_RUN_BYTES + 4u) * 2u * ROOMSEG_PLAN_RUNS(w) + \
     4u * (size_t)(small))

/* Columns as above. */
#define ROOMSEG_PLAN_FIND_TABLE(X, S, w, h, small)                                        \
    X(S, mask, 1u, ROOMSEG_PLAN_CELLS(w, h), 0, 2)                                        \
    X(S, points, 4u, (size_t)(w) * (h), 1, 2)                                             \
    X(S, small_scratch, 1u, ROOMSEG_PLAN_SMALL_BYTES(w, small), 0, 0)                     \
    X(S, rows, 2u, ROOMSEG_CANNY_ROWS * ((size_t)(w) + 4u), 1, 1)                         \
    X(S, votes, 2u, ROOMSEG_HOUGH_ANGLES * ROOMSEG_PLAN_DISTANCES(w, h), 2, 2)            \
    X(S, normals, ROOMSEG_NORMAL_BYTES, (size_t)ROOMSEG_HOUGH_ANGLES, 2, 2)               \
    X(S, bins, ROOMSEG_DIRECTION_BIN_BYTES, (size_t)ROOMSEG_DIRECTION_BINS, 2, 2)

/* The queue's lists and blocks as one buffer. */
#define ROOMSEG_PLAN_QUEUE_BYTES(w, h) \
    (ROOMSEG_QUEUE_LISTS_BYTES + ROOMSEG_QUEUE_BLOCK_BYTES * ROOMSEG_PLAN_QUEUE_BLOCKS(w, h))

/* tw, th: ROOMSEG_PLAN_TURNED_WIDTH and _HEIGHT; inner: the profile's arena for a crop of
 * tw x th cells [bytes]. */
#define ROOMSEG_PLAN_TURN_TABLE(X, S, w, h, tw, th, small, max_rooms, inner)              \
    X(S, turned_labels, 2u, (size_t)(tw) * (th), 0, 3)                                    \
    X(S, anchors, 4u, (size_t)(max_rooms), 0, 3)                                          \
    X(S, turned_cells, 1u, ROOMSEG_PLAN_CELLS(tw, th), 0, 1)                              \
    X(S, turned_arena, 1u, inner, 0, 0)                                                   \
    X(S, turned_queue, 1u, ROOMSEG_PLAN_QUEUE_BYTES(tw, th), 1, 1)                        \
    X(S, surface, 1u, ROOMSEG_PLAN_CELLS(w, h), 2, 6)                                     \
    X(S, small_scratch, 1u, ROOMSEG_PLAN_SMALL_BYTES(w, small), 2, 2)                     \
    X(S, queue, 1u, ROOMSEG_PLAN_QUEUE_BYTES(w, h), 3, 3)                                 \
    X(S, envelope, 8u, (size_t)(w) + 2u, 4, 4)                                            \
    X(S, levels, 4u, 256u, 4, 4)                                                          \
    X(S, regions, ROOMSEG_REGION_BYTES, (size_t)(max_rooms) + 1u, 5, 6)                   \
    X(S, edges, ROOMSEG_EDGE_BYTES, ROOMSEG_PLAN_EDGES(max_rooms), 5, 6)                  \
    X(S, measure_rows, 8u, (size_t)(w), 5, 5)                                             \
    X(S, heap, ROOMSEG_HEAP_ITEM_BYTES, ROOMSEG_PLAN_EDGES(max_rooms), 6, 6)              \
    X(S, rooms, ROOMSEG_ROOM_BYTES, (size_t)(max_rooms), 6, 6)                            \
    X(S, room_sums, ROOMSEG_ROOM_SUM_BYTES, (size_t)(max_rooms), 6, 6)                    \
    X(S, doorways, ROOMSEG_DOORWAY_BYTES, ROOMSEG_PLAN_EDGES(max_rooms), 6, 6)            \
    X(S, links, 2u, 2u * ROOMSEG_PLAN_EDGES(max_rooms), 6, 6)

/* Every buffer starts at a multiple of 8 bytes. */
#define ROOMSEG_PLAN_ALIGN(bytes) (((bytes) + 7u) / 8u * 8u)

#define ROOMSEG_PLAN_ALIVE(stage, name, element, count, first, last) \
    +((first) <= (stage) && (stage) <= (last) ? ROOMSEG_PLAN_ALIGN((element) * (count)) : 0u)
#define ROOMSEG_PLAN_AT(stage, w, h, small, regions, rooms) \
    ((size_t)0 ROOMSEG_PLAN_TABLE(ROOMSEG_PLAN_ALIVE, stage, w, h, small, regions, rooms))
#define ROOMSEG_PLAN_MAX(a, b) ((a) > (b) ? (a) : (b))

/* Cells of the largest obstacle that a config drops or makes transparent; the
 * arguments are the config's speck_mm2, clutter_mm and the grid's resolution_mm. */
#define ROOMSEG_PLAN_SMALL(speck_mm2, clutter_mm, resolution_mm)                    \
    (ROOMSEG_PLAN_MAX((size_t)(speck_mm2) / ((size_t)(resolution_mm) * (resolution_mm)), \
                      ((size_t)(clutter_mm) / (resolution_mm)) *                    \
                          ((size_t)(clutter_mm) / (resolution_mm))) +               \
     1u)

/* Arena bytes, an integer constant expression for constant arguments. w and h are the
 * largest crop in cells (the grid's size is always enough), small comes from
 * ROOMSEG_PLAN_SMALL, regions and rooms are the config's max_regions and max_rooms. */
#define ROOMSEG_ARENA_SIZE(w, h, small, regions, rooms)                          \
    ROOMSEG_PLAN_MAX(                                                            \
        ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_AT(1, w, h, small, regions, rooms),        \
                         ROOMSEG_PLAN_AT(2, w, h, small, regions, rooms)),       \
        ROOMSEG_PLAN_MAX(                                                        \
            ROOMSEG_PLAN_AT(3, w, h, small, regions, rooms),                     \
            ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_AT(4, w, h, small, regions, rooms),    \
                             ROOMSEG_PLAN_MAX(                                   \
                                 ROOMSEG_PLAN_AT(5, w, h, small, regions, rooms), \
                                 ROOMSEG_PLAN_AT(7, w, h, small, regions, rooms)))))

/* The same for the default profile's parameters. */
#define ROOMSEG_ARENA_SIZE_DEFAULT(w, h, resolution_mm)                                  \
    ROOMSEG_ARENA_SIZE(w, h, ROOMSEG_PLAN_SMALL(96000u, 1500u, resolution_mm), 1024u, 255u)

/* Capacities for homes, offices and labs as robots map them: of 52 real maps none needed more
 * than 43 % of these regions and 33 % of these rooms, turned, cluttered and coarser copies not
 * more than 80 % and 55 %. For small grids they are far below the defaults. The config's
 * capacities must be those that the arena is sized for. w, h: largest crop [cells]. */
#define ROOMSEG_PLAN_MIN(a, b) ((a) < (b) ? (a) : (b))
#define ROOMSEG_USUAL_REGIONS(w, h, resolution_mm)                                        \
    ((uint32_t)ROOMSEG_PLAN_MIN(64u + (size_t)(w) * (h) / 64u * (resolution_mm) / 100u,   \
                                ROOMSEG_MAX_REGIONS))
#define ROOMSEG_USUAL_ROOMS(w, h, resolution_mm)                                          \
    ((uint32_t)ROOMSEG_PLAN_MIN(                                                          \
        16u + (size_t)(w) * (h) / 400u * (resolution_mm) / 100u * (resolution_mm) / 100u, \
        ROOMSEG_MAX_ROOMS))
#define ROOMSEG_ARENA_SIZE_USUAL(w, h, resolution_mm)                                        \
    ROOMSEG_ARENA_SIZE(w, h, ROOMSEG_PLAN_SMALL(96000u, 1500u, resolution_mm),               \
                       ROOMSEG_USUAL_REGIONS(w, h, resolution_mm),                           \
                       ROOMSEG_USUAL_ROOMS(w, h, resolution_mm))

/* The same with config.align set; inner: what the profile's macro gives for w =
 * ROOMSEG_PLAN_TURNED_WIDTH and h = ROOMSEG_PLAN_TURNED_HEIGHT of the crop. */
#define ROOMSEG_PLAN_FIND_AT(stage, w, h, small) \
    ((size_t)0 ROOMSEG_PLAN_FIND_TABLE(ROOMSEG_PLAN_ALIVE, stage, w, h, small))
#define ROOMSEG_PLAN_TURN_AT(stage, w, h, small, rooms, inner)                             \
    ((size_t)0 ROOMSEG_PLAN_TURN_TABLE(ROOMSEG_PLAN_ALIVE, stage, w, h,                    \
                                       ROOMSEG_PLAN_TURNED_WIDTH(w, h),                    \
                                       ROOMSEG_PLAN_TURNED_HEIGHT(w, h), small, rooms, inner))
#define ROOMSEG_ARENA_SIZE_ALIGNED(w, h, small, rooms, inner)                       \
    ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_FIND_AT(0, w, h, small),         \
                                      ROOMSEG_PLAN_FIND_AT(1, w, h, small)),        \
                     ROOMSEG_PLAN_MAX(ROOMSEG_PLAN_FIND_AT(2, w, h, small),         \
                                      ROOMSEG_PLAN_TURN_AT(0, w, h, small, rooms, inner)))

/* The default profile's parameters and ROOMSEG_ALIGN_ON. */
#define ROOMSEG_ARENA_SIZE_DEFAULT_ALIGNED(w, h, resolution_mm)                              \
    ROOMSEG_ARENA_SIZE_ALIGNED(                                                              \
        w, h, ROOMSEG_PLAN_SMALL(96000u, 1500u, resolution_mm), 255u,                         \
        ROOMSEG_ARENA_SIZE_DEFAULT(ROOMSEG_PLAN_TURNED_WIDTH(w, h),                          \
                                   ROOMSEG_PLAN_TURNED_HEIGHT(w, h), resolution_mm))

#endif
