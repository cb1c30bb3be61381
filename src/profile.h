/* What a profile is to roomseg_run(): how it lays out the arena and what it runs. The
 * config points to its profile, so a firmware that never names a profile does not link it. */
#ifndef RS_PROFILE_H
#define RS_PROFILE_H

#include "base.h"
#include "graph.h"
#include "plan.h"
#include "watershed.h"

struct roomseg_profile {
    /* Places the buffers for a crop of width x height cells; all numbers are in range.
     * Buffers may grow with the width and with the number of cells, not with the height
     * alone: the aligner's bound for turned frames is wide and low. */
    void (*plan)(const roomseg_config *config, uint32_t width, uint32_t height,
                 uint32_t resolution_mm, rs_plan *plan);

    /* Every stage behind the crop. labels are 0 on entry. Fills the records and counts of
     * *result, after an error too as far as the run came. */
    int (*run)(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
               const rs_plan *plan, const rs_labels *labels, roomseg_result *result,
               void *arena, rs_ticker *ticker);

    /* The rest is for the aligner, which turns labels back itself.
     * lines: cells without label separate the rooms; else rooms touch. */
    bool lines;
    /* In turning, an obstacle that is not certain counts half: the published system mixes the
     * values themselves, where unknown is 127. Else all count whole, which keeps thin walls
     * closed on maps without certain ones. */
    bool halves_unknown;
    /* Measures the graph of the labels 1..graph->region_count, which are those of rooms; the
     * lines between them are RS_LINE, and become 0. surface: bordered, distances. rows: scratch
     * of 8 * frame->width bytes, aligned to 4.
     * Fails iff: as rs_graph_build. */
    int (*measure)(const roomseg_config *config, const roomseg_grid *grid, const rs_frame *frame,
                   const uint8_t *surface, const rs_labels *labels, rs_graph *graph,
                   void *rows, rs_ticker *ticker);
};

/* Evaluates a stage unless an earlier one failed or the hook cancels on entering it. */
#define STAGE(name, call)                                              \
    do {                                                               \
        if (status == ROOMSEG_OK) {                                    \
            status = rs_ticker_enter(ticker, ROOMSEG_STAGE_##name)     \
                         ? ROOMSEG_ERR_CANCELLED                       \
                         : (call);                                     \
        }                                                              \
    } while (0)

#endif
