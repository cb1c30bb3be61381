#include "spread.h"

/* Over which cells a settled cell spreads. */
typedef enum spread_rule { OWN_LABEL, OWN_OR_NO_LABEL, ANY_LABEL, RULE_COUNT } spread_rule;

typedef struct spread {
    const rs_frame *frame;
    uint8_t *surface;
    const rs_labels *labels;
    rs_queue *queue;
    rs_ticker *ticker;
    spread_rule rule;
} spread;

static bool may_settle(const spread *s, uint16_t label, uint32_t x, uint32_t y)
{
    uint16_t proposed;

    if (s->surface[rs_frame_index(s->frame, x, y)] != RS_SPREAD_OPEN) {
        return false; /* the border is wall, so (x, y) is inside behind this line */
    }
    proposed = s->labels->cells[(size_t)y * s->labels->stride + x];
    return s->rule == ANY_LABEL || proposed == label ||
           (s->rule == OWN_OR_NO_LABEL && proposed == 0u);
}

/* Settles one neighbour, if it may be and there is room to go on from it later. */
static void reach(const spread *s, uint16_t label, uint32_t x, uint32_t y)
{
    if (may_settle(s, label, x, y) && rs_queue_push(s->queue, 0, rs_cell_pack(x, y))) {
        s->surface[rs_frame_index(s->frame, x, y)] = RS_SPREAD_SETTLED;
        s->labels->cells[(size_t)y * s->labels->stride + x] = label;
    }
}

static int drain(const spread *s)
{
    uint32_t cell;

    while (rs_queue_pop(s->queue, 0, &cell)) {
        uint32_t x = rs_cell_x(cell), y = rs_cell_y(cell);
        uint16_t label = s->labels->cells[(size_t)y * s->labels->stride + x];

        if (rs_tick(s->ticker, 4u, (uint32_t)s->rule, RULE_COUNT)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        reach(s, label, x, y - 1u);
        reach(s, label, x - 1u, y);
        reach(s, label, x + 1u, y);
        reach(s, label, x, y + 1u);
    }
    return ROOMSEG_OK;
}

/* Queues the settled cells that have a neighbour to settle, as many as the queue takes. */
static int queue_front(const spread *s, bool *any)
{
    *any = false;
    for (uint32_t y = 0; y < s->frame->height; y++) {
        const uint8_t *row = s->surface + rs_frame_index(s->frame, 0, y);
        const uint16_t *labels = s->labels->cells + (size_t)y * s->labels->stride;

        if (rs_tick(s->ticker, s->frame->width, (uint32_t)s->rule, RULE_COUNT)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < s->frame->width; x++) {
            uint16_t label = labels[x];
            if (row[x] == RS_SPREAD_SETTLED &&
                (may_settle(s, label, x, y - 1u) || may_settle(s, label, x - 1u, y) ||
                 may_settle(s, label, x + 1u, y) || may_settle(s, label, x, y + 1u))) {
                *any = true;
                if (!rs_queue_push(s->queue, 0, rs_cell_pack(x, y))) {
                    return ROOMSEG_OK;
                }
            }
        }
    }
    return ROOMSEG_OK;
}

static int clear_unreached(const spread *s)
{
    for (uint32_t y = 0; y < s->frame->height; y++) {
        const uint8_t *row = s->surface + rs_frame_index(s->frame, 0, y);
        uint16_t *labels = s->labels->cells + (size_t)y * s->labels->stride;

        if (rs_tick(s->ticker, s->frame->width, y, s->frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < s->frame->width; x++) {
            labels[x] = row[x] == RS_SPREAD_OPEN ? (uint16_t)0 : labels[x];
        }
    }
    return ROOMSEG_OK;
}

int rs_spread_run(const rs_frame *frame, uint8_t *surface, const rs_labels *labels,
                  rs_queue *queue, rs_ticker *ticker)
{
    spread s = {frame, surface, labels, queue, ticker, OWN_LABEL};
    int status = ROOMSEG_OK;

    for (; status == ROOMSEG_OK && s.rule != RULE_COUNT; s.rule = (spread_rule)(s.rule + 1)) {
        bool any = true;

        /* Again after the queue was full: each round settles at least one cell, and as many
         * as the queue holds while it overflows. */
        while (status == ROOMSEG_OK && any) {
            status = queue_front(&s, &any);
            if (status == ROOMSEG_OK) {
                status = drain(&s);
            }
        }
    }
    return status == ROOMSEG_OK ? clear_unreached(&s) : status;
}
