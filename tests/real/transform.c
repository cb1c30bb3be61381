#include "transform.h"

#include <stdlib.h>

#define GAP 20u /* cells between two buildings, and around a map that is shifted */
#define FRAME 7u
#define SHIFT_X 37u
#define SHIFT_Y 13u

const char *transform_name(transform t)
{
    static const char *const names[TRANSFORM_COUNT] = {
        "shift", "pad", "mirror", "turn 90", "turn 180", "turn 270", "twice", "finer"};
    return names[t];
}

size_t transform_source(transform t, const roomseg_grid *grid, uint32_t x, uint32_t y,
                        uint32_t *copy)
{
    uint32_t width = grid->width;
    uint32_t height = grid->height;
    uint32_t from_x = x;
    uint32_t from_y = y;
    *copy = 0;
    switch (t) {
    case TRANSFORM_SHIFT: /* modulo 2^32: beyond the sides before the first cell */
        from_x = x - SHIFT_X;
        from_y = y - SHIFT_Y;
        break;
    case TRANSFORM_PAD:
        from_x = x - FRAME;
        from_y = y - FRAME;
        break;
    case TRANSFORM_MIRROR:
        from_x = width - 1 - x;
        break;
    case TRANSFORM_TURN_90:
        from_x = y;
        from_y = height - 1 - x;
        break;
    case TRANSFORM_TURN_180:
        from_x = width - 1 - x;
        from_y = height - 1 - y;
        break;
    case TRANSFORM_TURN_270:
        from_x = width - 1 - y;
        from_y = x;
        break;
    case TRANSFORM_TWICE:
        *copy = x >= width + GAP;
        from_x = *copy != 0 ? x - width - GAP : x;
        break;
    default:
        from_x = x / 2;
        from_y = y / 2;
        break;
    }
    return from_x < width && from_y < height ? (size_t)from_y * width + from_x : SIZE_MAX;
}

static void size_of(transform t, const roomseg_grid *grid, roomseg_grid *out)
{
    *out = *grid;
    switch (t) {
    case TRANSFORM_SHIFT:
        out->width += SHIFT_X + GAP;
        out->height += SHIFT_Y + GAP;
        break;
    case TRANSFORM_PAD:
        out->width += 2 * FRAME;
        out->height += 2 * FRAME;
        break;
    case TRANSFORM_TURN_90:
    case TRANSFORM_TURN_270:
        out->width = grid->height;
        out->height = grid->width;
        break;
    case TRANSFORM_TWICE:
        out->width = 2 * grid->width + GAP;
        break;
    case TRANSFORM_FINER:
        out->width *= 2;
        out->height *= 2;
        out->resolution_mm /= 2;
        break;
    default:
        break;
    }
    out->stride = out->width + 3; /* a gap that is never read */
}

roomseg_grid transform_apply(transform t, const roomseg_grid *grid)
{
    roomseg_grid out;
    size_of(t, grid, &out);
    uint8_t outside = t == TRANSFORM_PAD ? 255 : 127;
    uint8_t *cells = calloc((size_t)out.stride * out.height, 1);
    if (cells == NULL) {
        abort();
    }
    for (uint32_t y = 0; y < out.height; y++) {
        for (uint32_t x = 0; x < out.width; x++) {
            uint32_t copy;
            size_t from = transform_source(t, grid, x, y, &copy);
            cells[(size_t)y * out.stride + x] =
                from == SIZE_MAX
                    ? outside
                    : grid->cells[from / grid->width * grid->stride + from % grid->width];
        }
    }
    out.cells = cells;
    return out;
}
