#include "rotate.h"

#include <string.h>

/* Positions are fixed-point numbers of 30 fractional bits, from the middle of the crop or
 * from its first cell; at most 2^18 cells either way, so they stay below 2^49. */
#define SHIFT 30

/* Makes every position positive before it is shifted down. */
#define BIAS 262144 /* 2^18 cells */

/* To the nearest whole cell; from the middle between two to the greater one. */
static inline int32_t nearest(int64_t position)
{
    uint64_t biased = (uint64_t)(position + ((int64_t)BIAS << SHIFT)) + (1u << (SHIFT - 1));

    return (int32_t)(uint32_t)(biased >> SHIFT) - BIAS;
}

/* The cell about which is turned: the same in both frames, so that without a turn cells stay
 * cells. */
static int64_t middle_x(const rs_rotation *r)
{
    return r->crop->width / 2u;
}
static int64_t middle_y(const rs_rotation *r)
{
    return r->crop->height / 2u;
}

/* Turned position of crop cell (x, y), from the middle. */
static int64_t turned_x_of(const rs_rotation *r, uint32_t x, uint32_t y)
{
    return (x - middle_x(r)) * r->axis.cos + (y - middle_y(r)) * r->axis.sin;
}

static int64_t turned_y_of(const rs_rotation *r, uint32_t x, uint32_t y)
{
    return (y - middle_y(r)) * r->axis.cos - (x - middle_x(r)) * r->axis.sin;
}

/* Crop position of turned cell (x, y), from the crop's first cell. */
static int64_t crop_x_of(const rs_rotation *r, uint32_t x, uint32_t y)
{
    int64_t dx = (int64_t)r->left + x, dy = (int64_t)r->top + y;

    return dx * r->axis.cos - dy * r->axis.sin + middle_x(r) * RS_TRIG_ONE;
}

static int64_t crop_y_of(const rs_rotation *r, uint32_t x, uint32_t y)
{
    int64_t dx = (int64_t)r->left + x, dy = (int64_t)r->top + y;

    return dx * r->axis.sin + dy * r->axis.cos + middle_y(r) * RS_TRIG_ONE;
}

/* What the turned frame must hold, from the middle. */
typedef struct bounds {
    int32_t left, right, top, bottom;
} bounds;

static void include(const rs_rotation *r, uint32_t x, uint32_t y, bounds *b)
{
    int32_t turned_x = nearest(turned_x_of(r, x, y)), turned_y = nearest(turned_y_of(r, x, y));

    b->left = turned_x < b->left ? turned_x : b->left;
    b->right = turned_x > b->right ? turned_x : b->right;
    b->top = turned_y < b->top ? turned_y : b->top;
    b->bottom = turned_y > b->bottom ? turned_y : b->bottom;
}

int rs_rotate_init(const rs_frame *crop, const roomseg_grid *grid, uint8_t free_max,
                   int32_t angle, rs_rotation *rotation, rs_ticker *ticker)
{
    bounds b = {INT32_MAX, INT32_MIN, INT32_MAX, INT32_MIN};

    rotation->crop = crop;
    rotation->axis = rs_trig_direction(angle);
    /* The cells furthest out are the first or the last of their row. */
    for (uint32_t y = 0; y < crop->height; y++) {
        const uint8_t *row = grid->cells + (size_t)(crop->y + y) * grid->stride + crop->x;
        uint32_t first = 0, last = crop->width;

        if (rs_tick(ticker, crop->width, y, crop->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        while (first < last && row[first] > free_max) {
            first++;
        }
        while (last > first && row[last - 1u] > free_max) {
            last--;
        }
        if (first < last) {
            include(rotation, first, y, &b);
            include(rotation, last - 1u, y, &b);
        }
    }
    rotation->left = b.left;
    rotation->top = b.top;
    rotation->width = (uint32_t)(b.right - b.left) + 1u;
    rotation->height = (uint32_t)(b.bottom - b.top) + 1u;
    return ROOMSEG_OK;
}

/* Four cells around a position, and how near it is to each: 1/256 of a cell along x and y. */
typedef struct around {
    uint8_t values[4]; /* left and right above, left and right below */
    uint32_t right, below; /* 0..255 */
} around;

static uint8_t cell_of(const roomseg_grid *grid, uint32_t x, uint32_t y, uint8_t fill)
{
    return x < grid->width && y < grid->height ? grid->cells[(size_t)y * grid->stride + x] : fill;
}

/* x, y: position in the grid. */
static around look_around(const roomseg_grid *grid, int64_t x, int64_t y, uint8_t fill)
{
    uint64_t biased_x = (uint64_t)(x + ((int64_t)BIAS << SHIFT));
    uint64_t biased_y = (uint64_t)(y + ((int64_t)BIAS << SHIFT));
    uint32_t left = (uint32_t)(biased_x >> SHIFT) - BIAS; /* modulo 2^32 */
    uint32_t above = (uint32_t)(biased_y >> SHIFT) - BIAS;
    around a;

    a.right = (uint32_t)(biased_x >> (SHIFT - 8)) & 255u;
    a.below = (uint32_t)(biased_y >> (SHIFT - 8)) & 255u;
    a.values[0] = cell_of(grid, left, above, fill);
    a.values[1] = cell_of(grid, left + 1u, above, fill);
    a.values[2] = cell_of(grid, left, above + 1u, fill);
    a.values[3] = cell_of(grid, left + 1u, above + 1u, fill);
    return a;
}

/* The nearest of the four cells among the obstacles if these take more than a fifth of the
 * square around the position, else among the free cells. Less than that, and the single
 * cells of a thin wall that touch at corners only would come apart. */
static uint8_t mix(const around *a, rs_mixture mixture)
{
    const uint32_t weights[4] = {(256u - a->right) * (256u - a->below),
                                 a->right * (256u - a->below), (256u - a->right) * a->below,
                                 a->right * a->below};
    uint32_t halves = 0, most = 0; /* halves: of obstacles, at most 2^17 */
    uint8_t value = a->values[0];
    bool obstacle;

    for (uint32_t i = 0; i < 4u; i++) {
        if (a->values[i] > mixture.free_max) {
            halves += a->values[i] >= mixture.whole_min ? 2u * weights[i] : weights[i];
        }
    }
    obstacle = halves * 5u > 2u * 65536u;
    for (uint32_t i = 0; i < 4u; i++) {
        if ((a->values[i] > mixture.free_max) == obstacle && weights[i] > most) {
            most = weights[i];
            value = a->values[i];
        }
    }
    return value;
}

int rs_rotate_grid(const rs_rotation *rotation, const roomseg_grid *grid, rs_mixture mixture,
                   uint8_t *cells, uint32_t stride, rs_ticker *ticker)
{
    const rs_rotation *r = rotation;

    for (uint32_t y = 0; y < r->height; y++, cells += stride) {
        int64_t from_x = crop_x_of(r, 0, y) + ((int64_t)r->crop->x << SHIFT);
        int64_t from_y = crop_y_of(r, 0, y) + ((int64_t)r->crop->y << SHIFT);

        if (rs_tick(ticker, r->width, y, r->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < r->width; x++) {
            around a = look_around(grid, from_x, from_y, mixture.fill);

            cells[x] = mix(&a, mixture);
            from_x += r->axis.cos;
            from_y += r->axis.sin;
        }
    }
    return ROOMSEG_OK;
}

int rs_rotate_labels_back(const rs_rotation *rotation, const uint16_t *turned,
                          const uint8_t *mask, const rs_labels *labels, rs_ticker *ticker)
{
    const rs_rotation *r = rotation;

    for (uint32_t y = 0; y < r->crop->height; y++) {
        int64_t from_x = turned_x_of(r, 0, y), from_y = turned_y_of(r, 0, y);
        const uint8_t *open = mask + rs_frame_index(r->crop, 0, y);
        uint16_t *to = labels->cells + (size_t)y * labels->stride;

        if (rs_tick(ticker, r->crop->width, y, r->crop->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < r->crop->width; x++) {
            uint32_t turned_x = (uint32_t)(nearest(from_x) - r->left); /* modulo 2^32 */
            uint32_t turned_y = (uint32_t)(nearest(from_y) - r->top);

            to[x] = open[x] != 0u && turned_x < r->width && turned_y < r->height
                        ? turned[(size_t)turned_y * r->width + turned_x]
                        : (uint16_t)0;
            from_x += r->axis.cos;
            from_y -= r->axis.sin;
        }
    }
    return ROOMSEG_OK;
}

bool rs_rotate_cell_back(const rs_rotation *rotation, uint32_t turned_x, uint32_t turned_y,
                         uint32_t *x, uint32_t *y)
{
    *x = (uint32_t)nearest(crop_x_of(rotation, turned_x, turned_y)); /* modulo 2^32 */
    *y = (uint32_t)nearest(crop_y_of(rotation, turned_x, turned_y));
    return *x < rotation->crop->width && *y < rotation->crop->height;
}
