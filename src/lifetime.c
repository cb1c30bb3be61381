#include "lifetime.h"

#include <string.h>

#include "coarsen.h"

typedef struct cascade {
    const rs_frame *frame;
    const rs_lifetime_rules *rules;
    uint8_t *cells;
    rs_ticker *ticker;
    uint32_t limit;    /* smallest free share [1/65535] of a seed cell */
    uint32_t variance; /* of the blur so far [2^-16 cells^2 of the present grid] */
    uint32_t scale;    /* 1.. */
    rs_blur blur;      /* the present grid */
    rs_level levels[RS_LIFETIME_LEVELS];
    uint32_t level;
} cascade;

/* Sigma squared in 2^-16 cells^2 of a grid with cells of the given size. */
static uint32_t variance_of(uint32_t sigma_mm, uint32_t cell_mm)
{
    uint64_t squared = (uint64_t)sigma_mm * sigma_mm;

    return rs_divide_q8(squared << 8, cell_mm * cell_mm);
}

static uint32_t sigma_of(const rs_lifetime_rules *rules, uint32_t scale)
{
    return rules->start_mm + (scale - 1u) * rules->step_mm;
}

static uint32_t cell_of(const cascade *c)
{
    return c->rules->resolution_mm << c->level;
}

/* No step needs a larger box than the last one of the level on which boxes are largest: the
 * first, up to the sigma at which the grid is halved for the first time. */
uint32_t rs_lifetime_ring_rows(const rs_lifetime_rules *rules)
{
    uint32_t last = sigma_of(rules, RS_LIFETIME_MAX), before;
    rs_box box;

    if (rules->halve_sigma_q4 != UINT32_MAX) {
        last = rs_min_u32(last, (rules->halve_sigma_q4 * rules->resolution_mm >> 3) +
                                    2u * rules->step_mm);
        last = rs_max_u32(last, rules->start_mm + rules->step_mm);
    }
    before = last - rules->step_mm;
    box = rs_box_of_variance(variance_of(last, rules->resolution_mm) -
                             variance_of(before, rules->resolution_mm));
    return rs_max_u32(box.radius, rs_box_of_variance(
                          variance_of(rules->start_mm, rules->resolution_mm) / 3u).radius) + 4u;
}

/* The blur's grid is the present level with a margin around it. */
static void size_blur(cascade *c)
{
    c->blur.width = c->levels[c->level].width + 2u * c->rules->margin;
    c->blur.height = c->levels[c->level].height + 2u * c->rules->margin;
}

/* Free cells have the share 1, and no lifetime yet. */
static int fill_shares(cascade *c)
{
    uint32_t margin = c->rules->margin;

    for (uint32_t y = 0; y < c->blur.height; y++) {
        uint16_t *to = c->blur.cells + (size_t)y * c->blur.width;
        uint8_t *from;

        if (rs_tick(c->ticker, c->blur.width, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        memset(to, 0, (size_t)c->blur.width * sizeof *to);
        if (y < margin || y >= margin + c->frame->height) {
            continue;
        }
        from = c->cells + rs_frame_index(c->frame, 0, y - margin);
        for (uint32_t x = 0; x < c->frame->width; x++) {
            to[margin + x] = from[x] != 0u ? UINT16_MAX : 0u;
        }
        memset(from, 0, c->frame->width);
    }
    return ROOMSEG_OK;
}

/* Notes for one row of the full grid which cells are seeds at this scale. */
static bool settle_row(uint8_t *cells, const uint16_t *shares, uint32_t width, uint32_t limit,
                       uint8_t scale)
{
    uint16_t highest = 0;

    for (uint32_t x = 0; x < width; x++) {
        cells[x] = shares[x] >= limit ? scale : cells[x];
        highest = shares[x] > highest ? shares[x] : highest;
    }
    return highest >= limit;
}

/* One pass of the box over the present grid, without a note of the seeds. */
static int blur_only(cascade *c)
{
    rs_blur_begin(&c->blur);
    for (uint32_t y = 0; y < c->blur.height; y++) {
        if (rs_tick(c->ticker, c->blur.width, 0, 1)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        rs_blur_row(&c->blur, y);
    }
    return ROOMSEG_OK;
}

/* Blurs by the box and notes the seeds of the scale. *alive: whether there are any. */
static int blur_to_scale(cascade *c, bool *alive)
{
    const rs_level *level = &c->levels[c->level];

    *alive = false;
    rs_blur_begin(&c->blur);
    for (uint32_t row = 0; row < c->blur.height; row++) {
        uint32_t y = row - c->rules->margin; /* modulo 2^32: too large above the level */
        const uint16_t *shares;
        bool seeds;

        /* How many scales there will be is not known. */
        if (rs_tick(c->ticker, c->blur.width, c->scale, c->scale + 24u)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        shares = rs_blur_row(&c->blur, row) + c->rules->margin;
        if (y >= level->height) {
            continue;
        }
        if (c->level == 0u) {
            seeds = settle_row(c->cells + rs_frame_index(c->frame, 0, y), shares, level->width,
                               c->limit, (uint8_t)c->scale);
        } else {
            seeds = rs_coarsen_settle_row(level->lives + (size_t)y * level->width, shares,
                                          level->width, c->limit, c->scale);
        }
        *alive = *alive || seeds;
    }
    return ROOMSEG_OK;
}

/* Chooses the box for the step to a variance, and counts what it really adds. */
static void aim_at(cascade *c, uint32_t variance)
{
    c->blur.box = rs_box_of_variance(variance > c->variance ? variance - c->variance : 0u);
    c->variance += rs_box_variance(&c->blur.box);
}

/* Halves the grid once, if the scale that comes next is coarse enough for it. */
static int halve_if_coarse(cascade *c)
{
    uint32_t coarse_mm = cell_of(c) * 2u;
    uint64_t sigma_q4 = (uint64_t)sigma_of(c->rules, c->scale) << 4;

    if (sigma_q4 < (uint64_t)c->rules->halve_sigma_q4 * coarse_mm ||
        c->level + 1u == RS_LIFETIME_LEVELS ||
        c->levels[c->level].width < RS_COARSEN_MIN_SIDE ||
        c->levels[c->level].height < RS_COARSEN_MIN_SIDE) {
        return ROOMSEG_OK;
    }
    c->levels[c->level].last_scale = c->scale - 1u;
    rs_coarsen_place(c->levels, c->level + 1u, c->rules->margin, c->blur.cells);
    c->level++;
    /* The mean of two cells adds a quarter of a cell^2, then cells count for twice the side. */
    c->variance = (c->variance + (1u << 14)) / 4u;
    size_blur(c);
    return rs_coarsen_run(c->frame, c->levels, c->level, c->rules->margin, c->limit, c->cells,
                          c->blur.cells, c->ticker);
}

/* All scales, until no seed is left. */
static int run_scales(cascade *c)
{
    bool alive = true;
    int status = fill_shares(c);

    for (uint32_t box = 0; status == ROOMSEG_OK && box < 2u; box++) {
        uint32_t first = variance_of(c->rules->start_mm, cell_of(c));
        aim_at(c, c->variance + (first - c->variance) / (3u - box));
        status = blur_only(c);
    }
    while (status == ROOMSEG_OK && alive && c->scale < RS_LIFETIME_MAX) {
        c->scale++;
        if (c->scale > 1u) {
            status = halve_if_coarse(c);
        }
        if (status == ROOMSEG_OK) {
            aim_at(c, variance_of(sigma_of(c->rules, c->scale), cell_of(c)));
            status = blur_to_scale(c, &alive);
        }
    }
    c->levels[c->level].last_scale = c->scale;
    return status;
}

int rs_lifetime_run(const rs_frame *frame, const rs_lifetime_rules *rules, uint8_t *cells,
                    const rs_lifetime_scratch *scratch, rs_ticker *ticker)
{
    cascade c = {.frame = frame, .rules = rules, .cells = cells, .ticker = ticker};
    int status;

    c.limit = (65535u * (1000u - rules->occupied_permille) + 999u) / 1000u;
    c.blur.cells = scratch->shares;
    c.blur.scratch = scratch->blur;
    c.levels[0].width = frame->width;
    c.levels[0].height = frame->height;
    size_blur(&c);
    status = run_scales(&c);
    for (; status == ROOMSEG_OK && c.level > 0u; c.level--) {
        status = rs_coarsen_undo(frame, c.levels, c.level, c.limit, cells, ticker);
    }
    return status;
}
