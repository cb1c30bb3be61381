/* Alignment, step 4: the grid turned until its walls lie along the axes, and labels turned
 * back. */
#ifndef RS_ROTATE_H
#define RS_ROTATE_H

#include "base.h"
#include "trig.h"
#include "watershed.h"

/* Two frames with the middle cell of the crop in common: the crop, and the turned one, whose x
 * axis has the given direction in the crop. The turned frame is the smallest that holds the
 * turned free cells: at most ROOMSEG_PLAN_TURNED_WIDTH(crop) wide, and with border it has at
 * most ROOMSEG_PLAN_CELLS of ROOMSEG_PLAN_TURNED_WIDTH x _HEIGHT cells. */
typedef struct rs_rotation {
    const rs_frame *crop;
    rs_direction axis;
    int32_t left, top;      /* of the turned frame, from the middle cell [cells] */
    uint32_t width, height; /* of the turned frame */
} rs_rotation;

/* grid: with at least one cell of at most free_max, all of them in the crop.
 * angle: direction of the turned x axis in the crop, -4500..4500. */
int rs_rotate_init(const rs_frame *crop, const roomseg_grid *grid, uint8_t free_max,
                   int32_t angle, rs_rotation *rotation, rs_ticker *ticker);

/* How four cells are mixed. */
typedef struct rs_mixture {
    uint8_t free_max;  /* obstacles are above this */
    uint8_t whole_min; /* those below this count half; at most free_max + 1: none does */
    uint8_t fill;      /* value of cells outside of the grid */
} rs_mixture;

/* cells: of the turned frame, `stride` bytes from row to row. Each takes the value of one of
 * the four grid cells around it: of an obstacle where obstacles make up more than a fifth of
 * the bilinear mixture, else of a free cell. So walls that count whole stay closed and no value
 * is new. */
int rs_rotate_grid(const rs_rotation *rotation, const roomseg_grid *grid, rs_mixture mixture,
                   uint8_t *cells, uint32_t stride, rs_ticker *ticker);

/* turned: labels of the turned frame, no gap between rows.
 * labels: of the crop, each from the nearest turned cell; cells with a mask of 0 become 0, and
 * those that the turned frame does not hold. */
int rs_rotate_labels_back(const rs_rotation *rotation, const uint16_t *turned,
                          const uint8_t *mask, const rs_labels *labels, rs_ticker *ticker);

/* The crop cell nearest to a turned cell. False: it lies outside of the crop. */
bool rs_rotate_cell_back(const rs_rotation *rotation, uint32_t turned_x, uint32_t turned_y,
                         uint32_t *x, uint32_t *y);

#endif
