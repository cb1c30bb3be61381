/* The direction of the walls as the aligner finds it, with what it does so by: edges, lines,
 * their directions; and the map turned by it. The calls are those of src/align_find.c and
 * src/align.c, which give away only the angle. */
#ifndef ROOMSEG_EXPLAIN_WALLS_H
#define ROOMSEG_EXPLAIN_WALLS_H

#include "base.h"
#include "direction.h"
#include "hough.h"
#include "map.h"
#include "tool_error.h"

typedef struct walls {
    uint8_t *edges;      /* bordered, 1 on edge cells; owned */
    uint32_t edge_cells;
    rs_line *lines;      /* owned */
    size_t line_count;
    rs_direction_bin bins[ROOMSEG_DIRECTION_BINS];
    int32_t angle;       /* -4500..4499 hundredths of a degree */
} walls;

/* frame: the map's crop, not empty. Fails iff: memory runs out. Returns 0, or -1 with *error
 * set and *out zeroed. */
int walls_find(const map *m, const roomseg_config *config, const rs_frame *frame,
               const char *name, walls *out, tool_error *error);

void walls_free(walls *w);

/* The map turned until walls of this direction lie along the axes, as the aligner hands it to
 * the profile. Fails iff: memory runs out. Returns 0, or -1 with *error set and *out zeroed. */
int walls_turn(const map *m, const roomseg_config *config, const rs_frame *frame, int32_t angle,
               const char *name, map *out, tool_error *error);

#endif
