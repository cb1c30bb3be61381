#include "sketch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "unity.h"

static uint8_t value_of(char character)
{
    switch (character) {
    case '.':
        return 0;
    case '?':
        return 127;
    default:
        TEST_ASSERT_EQUAL_CHAR_MESSAGE('#', character, "a sketch is drawn with . # ?");
        return 255;
    }
}

static sketch make(uint32_t width, uint32_t height, uint32_t stride, uint8_t value,
                   uint32_t resolution_mm)
{
    sketch s;
    s.memory = malloc((size_t)stride * height);
    TEST_ASSERT_NOT_NULL(s.memory);
    memset(s.memory, value, (size_t)stride * height);
    s.grid.cells = s.memory;
    s.grid.width = width;
    s.grid.height = height;
    s.grid.stride = stride;
    s.grid.resolution_mm = resolution_mm;
    return s;
}

sketch sketch_make(const char *const *rows, uint32_t scale, uint32_t stride,
                   uint32_t resolution_mm)
{
    uint32_t columns = (uint32_t)strlen(rows[0]);
    uint32_t height = 0;
    while (rows[height] != NULL) {
        TEST_ASSERT_EQUAL_UINT_MESSAGE(columns, strlen(rows[height]), "ragged sketch");
        height++;
    }
    sketch s = make(columns * scale, height * scale, stride != 0 ? stride : columns * scale, 0,
                    resolution_mm);
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < columns; x++) {
            sketch_fill(&s, x * scale, y * scale, scale, scale, value_of(rows[y][x]));
        }
    }
    return s;
}

sketch sketch_blank(uint32_t width, uint32_t height, uint8_t value, uint32_t resolution_mm)
{
    return make(width, height, width, value, resolution_mm);
}

void sketch_fill(sketch *s, uint32_t x, uint32_t y, uint32_t width, uint32_t height,
                 uint8_t value)
{
    TEST_ASSERT_TRUE(x + width <= s->grid.width && y + height <= s->grid.height);
    for (uint32_t row = y; row < y + height; row++) {
        memset(s->memory + (size_t)row * s->grid.stride + x, value, width);
    }
}

sketch sketch_rooms(uint32_t columns, uint32_t rows, uint32_t side, uint32_t door,
                    uint32_t resolution_mm)
{
    uint32_t pitch = side + 1;
    uint32_t middle = 1 + (side - door) / 2;
    sketch s = sketch_blank(columns * pitch + 1, rows * pitch + 1, 255, resolution_mm);
    for (uint32_t row = 0; row < rows; row++) {
        for (uint32_t column = 0; column < columns; column++) {
            uint32_t x = column * pitch;
            uint32_t y = row * pitch;
            sketch_fill(&s, x + 1, y + 1, side, side, 0);
            if (column + 1 < columns) {
                sketch_fill(&s, x + pitch, y + middle, 1, door, 0);
            }
            if (row + 1 < rows) {
                sketch_fill(&s, x + middle, y + pitch, door, 1, 0);
            }
        }
    }
    return s;
}

sketch sketch_turned(const sketch *s, double degrees)
{
    const double radians = degrees * 3.14159265358979323846 / 180.0;
    const double cosine = cos(radians);
    const double sine = sin(radians);
    uint32_t side = (uint32_t)ceil(hypot(s->grid.width, s->grid.height)) + 4;
    sketch turned = sketch_blank(side, side, 127, s->grid.resolution_mm);
    for (uint32_t y = 0; y < side; y++) {
        for (uint32_t x = 0; x < side; x++) {
            double dx = x - side / 2.0;
            double dy = y - side / 2.0;
            double from_x = floor(cosine * dx + sine * dy + s->grid.width / 2.0 + 0.5);
            double from_y = floor(cosine * dy - sine * dx + s->grid.height / 2.0 + 0.5);
            if (from_x >= 0 && from_y >= 0 && from_x < s->grid.width &&
                from_y < s->grid.height) {
                turned.memory[(size_t)y * side + x] =
                    s->memory[(size_t)from_y * s->grid.stride + (size_t)from_x];
            }
        }
    }
    return turned;
}

void sketch_free(sketch *s)
{
    free(s->memory);
    s->memory = NULL;
    s->grid.cells = NULL;
}
