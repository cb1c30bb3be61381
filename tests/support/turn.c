#include "turn.h"

#include <math.h>
#include <stdlib.h>

#include "unity.h"

#define UNKNOWN 127u

/* Cell of the grid at a position, UNKNOWN outside. */
static uint8_t cell_near(const roomseg_grid *grid, double x, double y)
{
    double column = floor(x + 0.5);
    double row = floor(y + 0.5);
    if (column < 0.0 || row < 0.0 || column >= grid->width || row >= grid->height) {
        return UNKNOWN;
    }
    return grid->cells[(size_t)row * grid->stride + (size_t)column];
}

roomseg_grid turn_grid(const roomseg_grid *grid, double degrees)
{
    double angle = degrees * acos(-1.0) / 180.0;
    double c = cos(angle);
    double s = sin(angle);
    roomseg_grid turned = *grid;
    turned.width = (uint32_t)ceil(fabs(grid->width * c) + fabs(grid->height * s));
    turned.height = (uint32_t)ceil(fabs(grid->width * s) + fabs(grid->height * c));
    turned.stride = turned.width;
    uint8_t *cells = malloc((size_t)turned.width * turned.height);
    TEST_ASSERT_NOT_NULL(cells);
    for (uint32_t y = 0; y < turned.height; y++) {
        for (uint32_t x = 0; x < turned.width; x++) {
            double dx = x - (turned.width - 1) / 2.0;
            double dy = y - (turned.height - 1) / 2.0;
            cells[(size_t)y * turned.width + x] =
                cell_near(grid, dx * c + dy * s + (grid->width - 1) / 2.0,
                          dy * c - dx * s + (grid->height - 1) / 2.0);
        }
    }
    turned.cells = cells;
    return turned;
}

double turn_difference(double a, double b, double period)
{
    double difference = fmod(a - b, period);
    if (difference > period / 2.0) {
        difference -= period;
    } else if (difference < -period / 2.0) {
        difference += period;
    }
    return difference;
}
