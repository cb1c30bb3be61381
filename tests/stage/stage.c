#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "unity.h"

rs_frame stage_frame(uint32_t width, uint32_t height)
{
    rs_frame frame = {0, 0, width, height, width + 2u};
    return frame;
}

uint8_t *stage_buffer(const rs_frame *frame)
{
    uint8_t *buffer = calloc(ROOMSEG_PLAN_CELLS(frame->width, frame->height), 1);
    TEST_ASSERT_NOT_NULL(buffer);
    return buffer;
}

uint8_t *stage_mask(const rs_frame *frame, const sketch *s)
{
    uint8_t *mask = stage_buffer(frame);
    TEST_ASSERT_EQUAL_UINT(frame->width, s->grid.width);
    TEST_ASSERT_EQUAL_UINT(frame->height, s->grid.height);
    for (uint32_t y = 0; y < frame->height; y++) {
        for (uint32_t x = 0; x < frame->width; x++) {
            mask[rs_frame_index(frame, x, y)] = s->memory[(size_t)y * s->grid.stride + x] == 0;
        }
    }
    return mask;
}

rs_labels stage_labels(const rs_frame *frame)
{
    rs_labels labels = {calloc((size_t)frame->width * frame->height, sizeof(uint16_t)),
                        frame->width};
    TEST_ASSERT_NOT_NULL(labels.cells);
    return labels;
}

void *stage_scratch(size_t count, size_t size)
{
    void *scratch = malloc(count * size);
    TEST_ASSERT_NOT_NULL(scratch);
    memset(scratch, 0xEE, count * size);
    return scratch;
}

static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    uint32_t *calls = user;
    (void)stage;
    (void)permille;
    return (*calls)-- == 0;
}

rs_ticker stage_canceller(uint32_t *calls)
{
    rs_ticker ticker;
    memset(&ticker, 0, sizeof ticker);
    ticker.hook = hook;
    ticker.user = calls;
    ticker.stage = ROOMSEG_STAGE_ALIGN;
    return ticker;
}
