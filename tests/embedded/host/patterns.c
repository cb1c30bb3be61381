#include "patterns.h"

static int is_open(uint32_t x, uint32_t y)
{
    (void)x;
    (void)y;
    return 1;
}

/* One-cell corridors side by side that meet at one end: long fronts of equal height. */
static int is_comb(uint32_t x, uint32_t y)
{
    return x % 2u == 1u || y == 1u;
}

/* Every free cell is a region of its own. */
static int is_checker(uint32_t x, uint32_t y)
{
    return (x + y) % 2u == 0u;
}

/* Rooms of seven by seven cells with doors of one: many regions, many openings. */
static int is_cells(uint32_t x, uint32_t y)
{
    return (x % 8u != 0u || y % 8u == 4u) && (y % 8u != 0u || x % 8u == 4u);
}

/* Half of the cells at random: all shapes of obstacles and of free space. */
static int is_noise(uint32_t x, uint32_t y)
{
    uint32_t h = (y * PATTERN_SIDE + x) * 2654435761u;

    h = (h ^ h >> 15) * 2246822519u;
    h = (h ^ h >> 13) * 3266489917u;
    return (h >> 16 & 1u) != 0u;
}

const pattern patterns[] = {{"open", is_open, 0},
                            {"comb", is_comb, 0},
                            {"cells", is_cells, 4096},
                            {"noise", is_noise, 16384},
                            {"checker", is_checker, 32768}};
const unsigned pattern_count = sizeof patterns / sizeof patterns[0];
