/* What tests of stages that give labels to the cells of a surface share. setUp and tearDown come
 * with it. */
#ifndef STAGE_FLOOD_H
#define STAGE_FLOOD_H

#include "stage.h"

extern rs_frame frame;
extern uint8_t *surface; /* freed at the end of a test, as are the labels */
extern rs_labels labels;

/* A new frame of that size; its surface and labels all 0. */
void flood_prepare(uint32_t width, uint32_t height);

uint16_t *label_at(uint32_t x, uint32_t y);

/* Label that a character of a drawing stands for: 'a' is 1, '#' background, '*' a line, any
 * other none. */
uint16_t flood_letter(char c);

#endif
