/* Buffers for tests that call one stage bare. */
#ifndef STAGE_H
#define STAGE_H

#include "base.h"
#include "sketch.h"
#include "watershed.h"

/* A frame of its own, at (0, 0) of its grid. */
rs_frame stage_frame(uint32_t width, uint32_t height);

/* A bordered buffer of the frame, all 0; to be freed. */
uint8_t *stage_buffer(const rs_frame *frame);

/* The same with 1 on the free cells of a sketch of the frame's size. */
uint8_t *stage_mask(const rs_frame *frame, const sketch *s);

/* Labels of the frame, all 0; their cells are to be freed. */
rs_labels stage_labels(const rs_frame *frame);

/* Memory of `count` elements of `size` bytes, filled with a pattern; to be freed. */
void *stage_scratch(size_t count, size_t size);

/* A ticker whose hook lets `calls` calls pass and cancels at the next. */
rs_ticker stage_canceller(uint32_t *calls);

#endif
