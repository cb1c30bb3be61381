#define _POSIX_C_SOURCE 200809L

#include "png.h"

#include <stdio.h>

#include "image.h"

int png_encode(const canvas *c, encoded_png *out) {
    *out = (encoded_png){NULL, 0, c->width, c->height};
    FILE *stream = open_memstream(&out->bytes, &out->size);
    if (stream == NULL) {
        return -1;
    }
    int rc = image_write_png(stream, c->rgb, c->width, c->height, 3);
    rc = ferror(stream) ? -1 : rc;
    return fclose(stream) == 0 ? rc : -1;
}

/* Mean of the pixels of `from` that pixel (x, y) of a picture `step` times smaller covers. */
static color mean_color(const canvas *from, uint32_t x, uint32_t y, double step) {
    uint32_t left = (uint32_t)(x * step);
    uint32_t top = (uint32_t)(y * step);
    uint32_t right = (uint32_t)((x + 1) * step);
    uint32_t bottom = (uint32_t)((y + 1) * step);
    unsigned long sum[3] = {0, 0, 0};
    unsigned long count = 0;
    for (uint32_t row = top; row < bottom && row < from->height; row++) {
        for (uint32_t i = left; i < right && i < from->width; i++) {
            const uint8_t *p = from->rgb + ((size_t)row * from->width + i) * 3;
            sum[0] += p[0];
            sum[1] += p[1];
            sum[2] += p[2];
            count++;
        }
    }
    count = count > 0 ? count : 1;
    color mean = {(uint8_t)(sum[0] / count), (uint8_t)(sum[1] / count),
                  (uint8_t)(sum[2] / count)};
    return mean;
}

int canvas_shrink(const canvas *c, uint32_t width, uint32_t height, canvas *out) {
    double step_x = (double)c->width / width;
    double step_y = (double)c->height / height;
    double step = step_x > step_y ? step_x : step_y;
    step = step < 1 ? 1 : step;
    uint32_t small_width = (uint32_t)(c->width / step);
    uint32_t small_height = (uint32_t)(c->height / step);
    if (canvas_create(out, small_width > 0 ? small_width : 1, small_height > 0 ? small_height : 1,
                      (color){255, 255, 255}) != 0) {
        return -1;
    }
    for (uint32_t y = 0; y < out->height; y++) {
        for (uint32_t x = 0; x < out->width; x++) {
            draw_pixel(out, (int)x, (int)y, mean_color(c, x, y, step));
        }
    }
    return 0;
}
