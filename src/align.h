/* Alignment: the profile runs on a grid that is turned until its walls lie along the axes,
 * and what it finds is turned back. The config points here, so a firmware that never asks
 * for it does not link it. */
#ifndef RS_ALIGN_H
#define RS_ALIGN_H

#include "base.h"
#include "components.h"
#include "direction.h"
#include "distance.h"
#include "graph.h"
#include "hough.h"
#include "plan.h"
#include "profile.h"
#include "rooms.h"
#include "rotate.h"

/* A grid whose walls are off by less than this is left as it is: the direction is not known
 * better, and turning blurs [degree/100]. */
#define RS_ALIGN_LEAST 100

struct roomseg_aligner {
    /* Arena bytes for a crop of width x height cells; all numbers are in range. Fails iff
     * the turned crop may exceed the limits of a crop (ROOMSEG_ERR_GRID_SIZE). */
    int (*plan)(const roomseg_config *config, uint32_t width, uint32_t height,
                uint32_t resolution_mm, size_t *bytes);

    /* As the run of a profile, which it carries out. arena: as many bytes as plan says. */
    int (*run)(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
               const rs_labels *labels, roomseg_result *result, void *arena,
               rs_ticker *ticker);
};

/* Buffers by the tables in roomseg/plan.h. */
typedef struct rs_find_buffers {
    uint8_t *mask;
    uint32_t *points;
    void *small_scratch;
    uint16_t *rows;
    uint16_t *votes;
    rs_normal *normals;
    rs_direction_bin *bins;
} rs_find_buffers;

#define RS_ALIGN_LOST UINT32_MAX

typedef struct rs_turn_buffers {
    uint16_t *turned_labels;
    uint32_t *anchors; /* one cell of each room [crop, packed], or RS_ALIGN_LOST */
    uint8_t *turned_cells;
    void *turned_arena, *turned_queue;
    uint8_t *surface;
    void *small_scratch, *queue;
    rs_distance_scratch distance;
    rs_region *regions;
    rs_edge *edges;
    void *measure_rows;
    rs_heap_item *heap;
    roomseg_room *rooms;
    rs_room_sum *room_sums;
    roomseg_doorway *doorways;
    uint16_t *links;
} rs_turn_buffers;

int rs_align_plan(const roomseg_config *config, uint32_t width, uint32_t height,
                  uint32_t resolution_mm, size_t *bytes);
void rs_align_place_find(const roomseg_config *config, const rs_frame *frame,
                         uint32_t resolution_mm, void *arena, rs_find_buffers *b);
void rs_align_place_turn(const roomseg_config *config, const rs_frame *frame,
                         uint32_t resolution_mm, void *arena, rs_turn_buffers *b);

/* mask: bordered; 1 where the crop is free or its obstacles are small, else 0.
 * scratch: ROOMSEG_PLAN_SMALL_BYTES for limits up to those of the config. */
int rs_align_mask(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                  rs_component_limits limits, uint8_t *mask, void *scratch, rs_ticker *ticker);

/* Direction of most walls, -4500..4499 hundredths of a degree from the x axis towards the
 * y axis. arena: as many bytes as the aligner's plan says. Fails iff cancelled. */
int rs_align_find(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                  void *arena, int32_t *angle, rs_ticker *ticker);

/* How the config's profile mixes cells as the grid is turned. */
rs_mixture rs_align_mixture(const roomseg_config *config);

/* Free space that the profile left without label although it is open to a room gets a label
 * of its own, so that it is not taken for what is lost in turning. Lines between rooms stay
 * without: they are drawn anew. Turned cells become a surface. */
int rs_align_mark_dropped(const roomseg_config *config, const rs_rotation *rotation,
                          const rs_turn_buffers *b, rs_ticker *ticker);

/* Labels of the crop from those of the turned frame. b->surface: not 0 on the cells that may
 * carry one. Lines between rooms, if the profile has them, are RS_LINE. */
int rs_align_carry_labels(const roomseg_config *config, const roomseg_grid *grid,
                          const rs_rotation *rotation, const rs_turn_buffers *b,
                          uint32_t room_count, const rs_labels *labels, rs_ticker *ticker);

#endif
