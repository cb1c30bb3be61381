/* Watershed of the paper's system: basins grow from markers, with lines between them. */
#ifndef RS_WATERSHED_LINES_H
#define RS_WATERSHED_LINES_H

#include "base.h"
#include "queue.h"
#include "watershed.h"

/* Labels above those of regions. */
#define RS_LINE 0xFFFFu       /* a cell between two basins */
#define RS_BACKGROUND 0xFFFEu /* the basin of walls and of what lies behind them */
#define RS_WAITING 0xFFFDu    /* in the queue; only while the flood runs */
#define RS_LINES_MAX_REGIONS 0xFFFCu

/* Floods a surface from markers, lowest cells first, first in first out among equals. A cell
 * that is reached takes the label of its basin when its 8 neighbours carry one label only;
 * it becomes a line when they carry more (Meyer's flooding with lines, as in scikit-image).
 * surface: bordered. labels: on entry 0 where nothing is known, else a marker: a region or
 * RS_BACKGROUND; what lies outside of the crop is background. On return every cell is in a
 * basin or RS_LINE; lines are one cell wide.
 * When the queue runs full, the lost cells are found again by reading the surface: the result
 * is as good, ties may fall otherwise, and it takes longer. Fails iff cancelled. */
int rs_watershed_lines_run(const rs_frame *frame, const uint8_t *surface,
                           const rs_labels *labels, rs_queue *queue, rs_ticker *ticker);

#endif
