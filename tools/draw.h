/* A canvas of RGB pixels. Coordinates in pixels, the centre of pixel (x, y) being (x, y);
 * what lies outside the canvas is cut off. Edges are smooth. */
#ifndef ROOMSEG_TOOLS_DRAW_H
#define ROOMSEG_TOOLS_DRAW_H

#include <stdint.h>

typedef struct color {
    uint8_t r, g, b;
} color;

typedef struct canvas {
    uint8_t *rgb; /* 3 * width * height bytes, owned */
    uint32_t width, height;
} canvas;

/* A canvas of one colour; sides up to 65535. Returns 0, or -1 when memory runs out. */
int canvas_create(canvas *c, uint32_t width, uint32_t height, color fill);

/* Frees the pixels and zeroes the record. */
void canvas_free(canvas *c);

void draw_pixel(canvas *c, int x, int y, color paint);

/* width x height pixels, the first one at (x, y). */
void draw_rectangle(canvas *c, int x, int y, int width, int height, color paint);

/* A line with round ends, 2 * radius thick; a dot when both ends are the same. */
void draw_line(canvas *c, double x0, double y0, double x1, double y1, double radius,
               color paint);

/* Width of a text whose digits are `height` pixels tall. */
double text_width(const char *text, double height);

/* Text with its middle at (x, y) in the characters of font.h; radius: half the thickness
 * of the strokes. */
void draw_text(canvas *c, double x, double y, const char *text, double height, double radius,
               color paint);

#endif
