#include "seed_map.h"

#include <stdlib.h>
#include <string.h>

static uint8_t last_scale(const observation *o) {
    uint8_t last = 0;
    for (uint32_t y = 0; y < o->frame.height; y++) {
        for (uint32_t x = 0; x < o->frame.width; x++) {
            uint8_t lifetime = plane_at(o, PLANE_LIFETIME, x, y);
            last = lifetime > last ? lifetime : last;
        }
    }
    return last;
}

int seed_map_count(const observation *o) {
    int last = last_scale(o);
    return last < SEED_MAPS_SHOWN ? last : SEED_MAPS_SHOWN;
}

uint8_t seed_map_scale(const observation *o, int which) {
    int last = last_scale(o);
    int steps = seed_map_count(o) - 1;
    return (uint8_t)(steps > 0 ? 1 + ((last - 1) * which + steps / 2) / steps : 1);
}

/* Numbers the seed that holds crop cell `start`. stack: as many elements as cells. */
static void flood(const observation *o, uint8_t scale, uint32_t start, uint16_t number,
                  uint16_t *seeds, uint32_t *stack) {
    uint32_t width = o->frame.width, height = o->frame.height;
    size_t count = 0;
    seeds[start] = number;
    stack[count++] = start;
    while (count > 0) {
        uint32_t cell = stack[--count];
        uint32_t x = cell % width, y = cell / width;
        for (uint32_t k = 1; k < 9; k += 2) { /* the four of a 3 x 3 square that share a side */
            uint32_t nx = x + k % 3 - 1, ny = y + k / 3 - 1; /* modulo 2^32 */
            if (nx < width && ny < height && seeds[ny * width + nx] == 0 &&
                plane_at(o, PLANE_LIFETIME, nx, ny) >= scale) {
                seeds[ny * width + nx] = number;
                stack[count++] = ny * width + nx;
            }
        }
    }
}

int seed_map_make(const observation *o, uint8_t scale, uint16_t *seeds, uint32_t *count) {
    size_t cells = (size_t)o->frame.width * o->frame.height;
    uint32_t *stack = malloc(cells * sizeof *stack);
    *count = 0;
    if (stack == NULL) {
        return -1;
    }
    memset(seeds, 0, cells * sizeof *seeds);
    for (uint32_t cell = 0; cell < cells; cell++) {
        uint32_t x = cell % o->frame.width, y = cell / o->frame.width;
        if (seeds[cell] == 0 && plane_at(o, PLANE_LIFETIME, x, y) >= scale) {
            flood(o, scale, cell, (uint16_t)((*count)++ % UINT16_MAX + 1), seeds, stack);
        }
    }
    free(stack);
    return 0;
}
