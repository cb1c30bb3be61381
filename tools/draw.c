#include "draw.h"

#include <math.h>
#include <stdlib.h>

#include "font.h"

int canvas_create(canvas *c, uint32_t width, uint32_t height, color fill) {
    *c = (canvas){malloc((size_t)width * height * 3), width, height};
    if (c->rgb == NULL) {
        return -1;
    }
    draw_rectangle(c, 0, 0, (int)width, (int)height, fill);
    return 0;
}

void canvas_free(canvas *c) {
    free(c->rgb);
    *c = (canvas){NULL, 0, 0};
}

static int clamp(double value, int low, int high) {
    return value < low ? low : value > high ? high : (int)value;
}

static uint8_t *pixel_at(canvas *c, int x, int y) {
    return c->rgb + ((size_t)y * c->width + (size_t)x) * 3;
}

void draw_pixel(canvas *c, int x, int y, color paint) {
    draw_rectangle(c, x, y, 1, 1, paint);
}

void draw_rectangle(canvas *c, int x, int y, int width, int height, color paint) {
    int right = clamp((double)x + width, 0, (int)c->width);
    int bottom = clamp((double)y + height, 0, (int)c->height);
    for (int row = y < 0 ? 0 : y; row < bottom; row++) {
        for (int column = x < 0 ? 0 : x; column < right; column++) {
            uint8_t *p = pixel_at(c, column, row);
            p[0] = paint.r;
            p[1] = paint.g;
            p[2] = paint.b;
        }
    }
}

/* share: 0 leaves the pixel as it is .. 1 replaces it. */
static void blend(uint8_t *p, color paint, double share) {
    const uint8_t to[3] = {paint.r, paint.g, paint.b};
    for (int i = 0; i < 3; i++) {
        p[i] = (uint8_t)(p[i] + (to[i] - p[i]) * share + 0.5);
    }
}

/* Distance from (x, y) to the line from (x0, y0) over (dx, dy), whose square is length2. */
static double distance(double x, double y, double x0, double y0, double dx, double dy,
                       double length2) {
    double t = length2 > 0 ? ((x - x0) * dx + (y - y0) * dy) / length2 : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(x - x0 - t * dx, y - y0 - t * dy);
}

void draw_line(canvas *c, double x0, double y0, double x1, double y1, double radius,
               color paint) {
    double reach = radius + 1;
    int left = clamp(fmin(x0, x1) - reach, 0, (int)c->width);
    int right = clamp(fmax(x0, x1) + reach + 1, 0, (int)c->width);
    int top = clamp(fmin(y0, y1) - reach, 0, (int)c->height);
    int bottom = clamp(fmax(y0, y1) + reach + 1, 0, (int)c->height);
    double dx = x1 - x0;
    double dy = y1 - y0;
    for (int y = top; y < bottom; y++) {
        for (int x = left; x < right; x++) {
            double cover = radius + 0.5 - distance(x, y, x0, y0, dx, dy, dx * dx + dy * dy);
            if (cover > 0) {
                blend(pixel_at(c, x, y), paint, fmin(cover, 1));
            }
        }
    }
}

double text_width(const char *text, double height) {
    int units = 0;
    for (const char *at = text; *at != '\0'; at++) {
        units += font_width(*at) + (at[1] != '\0' ? FONT_GAP : 0);
    }
    return units * height / FONT_HEIGHT;
}

/* Where the pen is, for stroke(). */
typedef struct pen {
    canvas *c;
    double left, top; /* of the character */
    double scale;     /* pixels a font unit */
    double radius;
    color paint;
} pen;

static void stroke(void *user, double x0, double y0, double x1, double y1) {
    const pen *p = user;
    draw_line(p->c, p->left + x0 * p->scale, p->top + y0 * p->scale, p->left + x1 * p->scale,
              p->top + y1 * p->scale, p->radius, p->paint);
}

void draw_text(canvas *c, double x, double y, const char *text, double height, double radius,
               color paint) {
    pen p = {c, x - text_width(text, height) / 2, y - height / 2, height / FONT_HEIGHT, radius,
             paint};
    for (const char *at = text; *at != '\0'; at++) {
        font_draw(*at, stroke, &p);
        p.left += (font_width(*at) + FONT_GAP) * p.scale;
    }
}
