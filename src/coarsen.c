#include "coarsen.h"

#include <string.h>

/* With sides of at least RS_COARSEN_MIN_SIDE and the margins of the profile, the shares of a
 * level and the lives of all take less than the shares of level 0 (tested). */
void rs_coarsen_place(rs_level *levels, uint32_t level, uint32_t margin, uint16_t *shares)
{
    const rs_level *from = &levels[level - 1u];
    rs_level *to = &levels[level];

    to->width = (from->width + 1u) / 2u;
    to->height = (from->height + 1u) / 2u;
    to->lives = level > 1u ? from->lives + (size_t)from->width * from->height
                           : shares + ((size_t)to->width + 2u * margin) *
                                          ((size_t)to->height + 2u * margin);
}

/* Mean of 2 x 2 cells; beyond an odd side the share is 0. */
static void halve_row(const uint16_t *upper, const uint16_t *lower, uint32_t width,
                      uint16_t *out)
{
    uint32_t pairs = width / 2u;

    for (uint32_t x = 0; x < pairs; x++) {
        uint32_t sum = (uint32_t)upper[2u * x] + upper[2u * x + 1u];
        sum += lower != NULL ? (uint32_t)lower[2u * x] + lower[2u * x + 1u] : 0u;
        out[x] = (uint16_t)((sum + 2u) / 4u);
    }
    if (width % 2u != 0u) {
        uint32_t sum = upper[width - 1u] + (lower != NULL ? (uint32_t)lower[width - 1u] : 0u);
        out[pairs] = (uint16_t)((sum + 2u) / 4u);
    }
}

/* Halves width x height cells in place, without a gap between the rows. */
static int halve_shares(uint32_t width, uint32_t height, uint16_t *shares, rs_ticker *ticker)
{
    for (uint32_t y = 0; y < (height + 1u) / 2u; y++) {
        const uint16_t *upper = shares + (size_t)2u * y * width;
        const uint16_t *lower = 2u * y + 1u < height ? upper + width : NULL;

        if (rs_tick(ticker, width, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        halve_row(upper, lower, width, shares + (size_t)y * ((width + 1u) / 2u));
    }
    return ROOMSEG_OK;
}

/* Puts `border` cells of share 0 around width x height cells, in place. */
static int widen(uint32_t width, uint32_t height, uint32_t border, uint16_t *shares,
                 rs_ticker *ticker)
{
    uint32_t wide = width + 2u * border;

    for (uint32_t y = height + 2u * border; y-- > 0u;) {
        uint16_t *to = shares + (size_t)y * wide;

        if (rs_tick(ticker, wide, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (y < border || y >= border + height) {
            /* Rows above the first one lie where rows still are that were not yet moved,
             * but for those moved already, as rows are moved from the last one on. */
            memset(to, 0, wide * sizeof *to);
            continue;
        }
        memmove(to + border, shares + (size_t)(y - border) * width, width * sizeof *to);
        memset(to, 0, border * sizeof *to);
        memset(to + border + width, 0, border * sizeof *to);
    }
    return ROOMSEG_OK;
}

/* Lifetime of cell (x, y) of a level that will be halved or was; 0 outside. A seed's is not
 * known yet, beyond that it has passed last_scale. */
static uint32_t life_at(const rs_frame *frame, const rs_level *levels, uint32_t level,
                        uint32_t limit, const uint8_t *cells, uint32_t x, uint32_t y)
{
    const rs_level *at = &levels[level];
    uint32_t life;

    if (x >= at->width || y >= at->height) {
        return 0;
    }
    if (level == 0u) {
        life = cells[rs_frame_index(frame, x, y)];
        return life == 0u ? 0u : life * RS_COARSEN_UNIT + RS_COARSEN_UNIT / 2u;
    }
    life = at->lives[(size_t)y * at->width + x];
    return life >= limit ? at->last_scale * RS_COARSEN_UNIT + RS_COARSEN_UNIT / 2u : life;
}

int rs_coarsen_run(const rs_frame *frame, const rs_level *levels, uint32_t level,
                   uint32_t margin, uint32_t limit, const uint8_t *cells, uint16_t *shares,
                   rs_ticker *ticker)
{
    const rs_level *from = &levels[level - 1u], *to = &levels[level];
    uint32_t wide = to->width + 2u * margin;
    int status = halve_shares(from->width + 2u * margin, from->height + 2u * margin, shares,
                              ticker);

    /* Half of the margin is there. */
    if (status == ROOMSEG_OK) {
        status = widen(to->width + margin, to->height + margin, margin / 2u, shares, ticker);
    }
    for (uint32_t y = 0; status == ROOMSEG_OK && y < to->height; y++) {
        const uint16_t *row = shares + (size_t)(y + margin) * wide + margin;
        uint16_t *lives = to->lives + (size_t)y * to->width;

        if (rs_tick(ticker, to->width, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < to->width; x++) {
            uint32_t sum = 0;

            if (row[x] >= limit) {
                lives[x] = row[x];
                continue;
            }
            for (uint32_t k = 0; k < 4u; k++) {
                sum += life_at(frame, levels, level - 1u, limit, cells, 2u * x + k % 2u,
                               2u * y + k / 2u);
            }
            lives[x] = (uint16_t)(sum / 4u);
        }
    }
    return status;
}

bool rs_coarsen_settle_row(uint16_t *lives, const uint16_t *shares, uint32_t width,
                           uint32_t limit, uint32_t scale)
{
    bool alive = false;

    for (uint32_t x = 0; x < width; x++) {
        uint32_t now = shares[x], before = lives[x];

        if (now >= limit) {
            lives[x] = (uint16_t)now;
            alive = true;
        } else if (before >= limit) {
            /* It crossed the limit since the last scale; the share fell linearly. */
            lives[x] = (uint16_t)((scale - 1u) * RS_COARSEN_UNIT +
                                  (before - limit) * RS_COARSEN_UNIT / (before - now));
        }
    }
    return alive;
}

/* Lifetime at cell (x, y) of level - 1 from the four cells of `level` around it. */
static uint32_t interpolate(const rs_frame *frame, const rs_level *levels, uint32_t level,
                            uint32_t limit, uint32_t x, uint32_t y)
{
    uint32_t near_x = x / 2u, near_y = y / 2u;
    uint32_t far_x = near_x + x % 2u * 2u - 1u, far_y = near_y + y % 2u * 2u - 1u;
    uint32_t sum;

    sum = 9u * life_at(frame, levels, level, limit, NULL, near_x, near_y);
    sum += 3u * life_at(frame, levels, level, limit, NULL, far_x, near_y);
    sum += 3u * life_at(frame, levels, level, limit, NULL, near_x, far_y);
    sum += life_at(frame, levels, level, limit, NULL, far_x, far_y);
    return sum / 16u;
}

int rs_coarsen_undo(const rs_frame *frame, const rs_level *levels, uint32_t level,
                    uint32_t limit, uint8_t *cells, rs_ticker *ticker)
{
    const rs_level *to = &levels[level - 1u];
    uint32_t last = to->last_scale;

    for (uint32_t y = 0; y < to->height; y++) {
        uint16_t *lives = level > 1u ? to->lives + (size_t)y * to->width : NULL;
        uint8_t *row = cells + rs_frame_index(frame, 0, y);

        if (rs_tick(ticker, to->width, 1, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t x = 0; x < to->width; x++) {
            bool seed = lives != NULL ? lives[x] >= limit : row[x] == last;
            uint32_t life;

            if (!seed) {
                continue;
            }
            life = rs_max_u32(interpolate(frame, levels, level, limit, x, y),
                              last * RS_COARSEN_UNIT);
            if (lives != NULL) {
                lives[x] = (uint16_t)life;
            } else {
                row[x] = (uint8_t)(life / RS_COARSEN_UNIT);
            }
        }
    }
    return ROOMSEG_OK;
}
