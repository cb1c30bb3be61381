/* Stage 2: small obstacles, and small islands of free cells. Components are found row by row:
 * runs of cells, joined with the runs above by union-find. Only the components that reach the
 * current row are kept, so the memory is a few rows, whatever the map. */
#ifndef RS_COMPONENTS_H
#define RS_COMPONENTS_H

#include "base.h"

typedef struct rs_run {
    uint16_t first, last; /* columns of the bordered row, both ends inside */
    uint16_t component;   /* its component's slot */
} rs_run;

/* A component while it grows. Positions in bordered coordinates. */
typedef struct rs_component {
    uint32_t area;                       /* cells, saturates at RS_COMPONENT_OPEN */
    uint16_t min_x, max_x, min_y, max_y; /* bounding box, both ends inside */
    uint16_t anchor_x, anchor_y;         /* one cell of it */
    uint16_t parent;                     /* slot it was joined to; its own: a root */
    uint16_t unused;
} rs_component;

/* Area of whatever touches the border: what lies beyond is not known. */
#define RS_COMPONENT_OPEN (1u << 30)

RS_STATIC_ASSERT(sizeof(rs_run) == ROOMSEG_RUN_BYTES, run);
RS_STATIC_ASSERT(sizeof(rs_component) == ROOMSEG_COMPONENT_BYTES, component);

/* Which obstacles are small. */
typedef struct rs_component_limits {
    uint32_t speck_cells;   /* fewer cells than this: noise */
    uint32_t clutter_cells; /* compact and at most this long on both sides: clutter */
    bool diagonal;          /* cells that touch at a corner belong together */
} rs_component_limits;

/* The config's physical sizes in cells. */
rs_component_limits rs_components_limits(const roomseg_config *config, uint32_t resolution_mm);

/* Sets to 1 the cells of all obstacle components (surface 0) that are noise
 * or clutter. Components that touch the border of the frame stay.
 * scratch: see the struct; the arrays need no preparation. */
typedef struct rs_component_scratch {
    rs_run *runs;             /* 2 * ROOMSEG_PLAN_RUNS(frame->width) */
    rs_component *components; /* the same number */
    uint16_t *active;         /* the same number */
    uint16_t *vacant;         /* the same number */
    uint32_t *stack;          /* max(speck_cells, clutter_cells^2) */
} rs_component_scratch;

int rs_components_clear_small(const rs_frame *frame, rs_component_limits limits,
                              uint8_t *surface, const rs_component_scratch *scratch,
                              rs_ticker *ticker);

/* Sets to 0 the cells of all components of free cells (surface 1, 4-connected) of fewer cells
 * than `cells`: too small for a room, and it is regions that cost.
 * scratch: as above, but the stack has cells - 1 elements. cells: at least 1. */
int rs_components_drop_islands(const rs_frame *frame, uint32_t cells, uint8_t *surface,
                               const rs_component_scratch *scratch, rs_ticker *ticker);

/* Sets to 0 the cells of all components of free cells (surface 1, 8-connected) that are
 * smaller than the mean of them.
 * scratch: as above, but the stack has half as many elements as the crop has cells: where
 * there are two components or more, those below the mean have less than half of the area. */
int rs_components_keep_large_free(const rs_frame *frame, uint8_t *surface,
                                  const rs_component_scratch *scratch, rs_ticker *ticker);

#endif
