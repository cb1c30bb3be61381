/* The region graph of a watershed with lines, and what becomes of the lines. */
#ifndef RS_GRAPH_LINES_H
#define RS_GRAPH_LINES_H

#include "base.h"
#include "graph.h"
#include "watershed_lines.h"

/* Measures regions and shared borders in one reading of the labels of
 * rs_watershed_lines_run. Two regions share a border where a line cell has exactly these two
 * regions among its 8 neighbours; edge.border counts such cells, edge.saddle and its position
 * are those of the one farthest from obstacles.
 * surface: bordered; distance of each cell to the nearest obstacle. graph, max_edges,
 * occupied_min: as for rs_graph_build. Fails iff: cancelled, or more than max_edges pairs of
 * regions share a border (ROOMSEG_ERR_REGIONS). */
int rs_graph_lines_build(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                         const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                         uint32_t max_edges, rs_ticker *ticker);

/* Gives the borders inside of merged regions to these: a border cell whose two regions are
 * one now takes the label of one of them, unless it is the end of such a border, that is,
 * has exactly one such cell among its 4 neighbours. All other line cells and the background
 * become 0. The roots' areas, first cells and peaks change accordingly.
 * surface: as above. rows: 3 * frame->width elements of scratch. */
int rs_graph_lines_resolve(const rs_frame *frame, const roomseg_grid *grid,
                           uint8_t occupied_min, const uint8_t *surface,
                           const rs_labels *labels, rs_graph *graph, uint16_t *rows,
                           rs_ticker *ticker);

#endif
