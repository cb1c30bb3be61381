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

/* surface: bordered, of the values above, at least one cell of each room settled.
 * labels: not 0 on settled cells; others are a proposal.
 * From the settled cells outwards, nearest first: settles all cells that a room reaches over
 * cells with its own label, then those without label, then whatever else is 4-connected with
 * a settled cell. Cells that no room reaches become 0.
 * queue: initialised and empty; is left so. A full queue costs time, not correctness.
 * Fails iff cancelled. */
int rs_spread_run(const rs_frame *frame, uint8_t *surface, const rs_labels *labels,
                  rs_queue *queue, rs_ticker *ticker);

#endif
