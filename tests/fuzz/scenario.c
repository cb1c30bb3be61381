#include "scenario.h"

#include <stdlib.h>
#include <string.h>

#include "config_fields.h"

typedef struct source {
    const uint8_t *bytes;
    size_t left;
} source;

static uint32_t take(source *from)
{
    if (from->left == 0) {
        return 0;
    }
    from->left--;
    return *from->bytes++;
}

static uint32_t take_u32(source *from)
{
    uint32_t value = take(from);
    value |= take(from) << 8;
    value |= take(from) << 16;
    return value | take(from) << 24;
}

/* Sets some fields. Half of the numbers are scaled into the field's range, the others are left
 * as they are where that makes a difference. */
static void change_config(source *from, scenario *s)
{
    for (uint32_t count = take(from) % 8; count > 0; count--) {
        uint32_t choice = take(from);
        const config_field *field = &config_fields[choice % config_field_count];
        uint32_t value = take_u32(from);
        uint64_t span = (uint64_t)field->high - field->low + 1;
        if (choice < 240) {
            value = (uint32_t)(field->low + value % span);
        } else {
            s->wild = true;
        }
        config_field_set(&s->config, field, value);
    }
    if (!s->wild && s->config.free_max >= s->config.occupied_min) {
        s->config.occupied_min = 255;
    }
    if (!s->wild && s->config.max_rooms > s->config.max_regions) {
        s->config.max_rooms = s->config.max_regions;
    }
}

static const uint8_t palette[8] = {0, 255, 127, 51, 52, 203, 204, 30};

/* Rectangles of the palette's values, one over the other. */
static void draw_rectangles(source *from, const roomseg_grid *grid, uint8_t *cells)
{
    while (from->left > 0) {
        uint8_t value = palette[take(from) % 8];
        uint32_t x = take(from) % grid->width;
        uint32_t y = take(from) % grid->height;
        uint32_t last_x = x + take(from) % (grid->width - x);
        uint32_t last_y = y + take(from) % (grid->height - y);
        for (uint32_t row = y; row <= last_y; row++) {
            memset(cells + (size_t)row * grid->stride + x, value, last_x - x + 1);
        }
    }
}

/* Cell by cell, 2 or 8 bits of the input each, in squares of scale x scale cells. */
static void draw_cells(source *from, bool packed, uint32_t scale, const roomseg_grid *grid,
                       uint8_t *cells)
{
    uint32_t bits = 0;
    uint32_t bit_count = 0;
    for (uint32_t y = 0; y < grid->height; y++) {
        uint8_t *row = cells + (size_t)y * grid->stride;
        if (y % scale != 0) {
            memcpy(row, row - grid->stride, grid->width);
            continue;
        }
        for (uint32_t x = 0; x < grid->width; x++) {
            if (x % scale != 0) {
                row[x] = row[x - 1];
            } else if (packed) {
                if (bit_count == 0) {
                    bits = take(from);
                    bit_count = 8;
                }
                row[x] = palette[bits & 3u];
                bits >>= 2;
                bit_count -= 2;
            } else {
                row[x] = (uint8_t)take(from);
            }
        }
    }
}

static void make_grid(source *from, scenario *s)
{
    uint32_t style = take(from);
    uint32_t width = 1 + take(from) % 120;
    uint32_t height = 1 + take(from) % 120;
    while (width * height > SCENARIO_MAX_CELLS) {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
    uint32_t stride = width + (style >> 2) % 4;
    size_t size = (size_t)(height - 1) * stride + width;
    uint8_t *cells = malloc(size);
    if (cells == NULL) {
        abort();
    }
    /* The gap between rows is free, so that code that reads it gives itself away. */
    memset(cells, 0, size);
    s->grid = (roomseg_grid){cells, width, height, stride, 20 + take(from) % 181};
    s->label_stride = width + (style >> 4) % 4;
    if (style % 4 < 2) {
        memset(cells, palette[style >> 6], size);
        draw_rectangles(from, &s->grid, cells);
    } else {
        draw_cells(from, style % 4 == 2, 1 + (style >> 6), &s->grid, cells);
    }
}

scenario scenario_make(const uint8_t *bytes, size_t size)
{
    source from = {bytes, size};
    scenario s;
    memset(&s, 0, sizeof s);
    uint32_t flags = take(&from);
    s.config = (flags & 1u) != 0 ? roomseg_config_paper() : roomseg_config_default();
    s.config.align = (flags & 2u) != 0 ? ROOMSEG_ALIGN_ON : NULL;
    /* Small capacities, so that an arena costs little to fill; a field may change them. */
    s.config.max_regions = 120;
    s.config.max_rooms = 120;
    s.arena_shift = (flags >> 2) % 8;
    s.cancel_at = flags >> 5;
    change_config(&from, &s);
    make_grid(&from, &s);
    return s;
}

void scenario_free(scenario *s)
{
    free((void *)(uintptr_t)s->grid.cells);
    memset(s, 0, sizeof *s);
}
