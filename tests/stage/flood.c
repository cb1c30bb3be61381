#include "flood.h"

#include <ctype.h>
#include <stdlib.h>

#include "unity.h"
#include "watershed_lines.h"

rs_frame frame;
uint8_t *surface;
rs_labels labels;

void setUp(void)
{
    surface = NULL;
    labels.cells = NULL;
}

void tearDown(void)
{
    free(surface);
    free(labels.cells);
}

void flood_prepare(uint32_t width, uint32_t height)
{
    free(surface);
    free(labels.cells);
    frame = stage_frame(width, height);
    surface = stage_buffer(&frame);
    labels = stage_labels(&frame);
}

uint16_t *label_at(uint32_t x, uint32_t y)
{
    return &labels.cells[(size_t)y * labels.stride + x];
}

uint16_t flood_letter(char c)
{
    if (c == '#') {
        return RS_BACKGROUND;
    }
    if (c == '*') {
        return RS_LINE;
    }
    return islower((unsigned char)c) ? (uint16_t)(c - 'a' + 1) : (uint16_t)0;
}
