/* Alignment, step 5: labels that came back from the turned frame become whole again. Nearest
 * cells leave gaps beside walls and tear off single cells; afterwards every room is
 * connected and every cell that a room can reach has a label. */
#ifndef RS_SPREAD_H
#define RS_SPREAD_H

#include "base.h"
#include "queue.h"
#include "watershed.h"

/* What a byte of the surface says. */
#define RS_SPREAD_WALL 0u
#define RS_SPREAD_OPEN 1u    /* may carry a label */
#define RS_SPREAD_SETTLED 2u /* carries the label that it keeps */

/* A label like any other here: free space that belongs to no room. */
#define RS_SPREAD_DROPPED 0xFFFFu

/* surface: bordered, of the values above; the border must be wall.
 * labels: not 0 on settled cells; those of open cells are a proposal.
 * From the settled cells outwards, nearest first: settles all cells that a label reaches over
 * cells that propose it, then over those that propose none, then whatever else is 4-connected
 * with a settled cell. Open cells that no label reaches become 0.
 * queue: initialised and empty; is left so. A full queue costs time, not correctness.
 * Fails iff cancelled. */
int rs_spread_run(const rs_frame *frame, uint8_t *surface, const rs_labels *labels,
                  rs_queue *queue, rs_ticker *ticker);

#endif
