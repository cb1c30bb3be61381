#include "reference.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "unity.h"

typedef struct box {
    uint32_t min_x, min_y, max_x, max_y;
} box;

static box bounds_of_free(const uint8_t *kinds, uint32_t width, uint32_t height)
{
    box b = {width, height, 0, 0};
    for (uint32_t y = 0; y < height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            if (kinds[(size_t)y * width + x] == CELL_OPEN) {
                b.min_x = x < b.min_x ? x : b.min_x;
                b.max_x = x > b.max_x ? x : b.max_x;
                b.min_y = y < b.min_y ? y : b.min_y;
                b.max_y = y > b.max_y ? y : b.max_y;
            }
        }
    }
    return b;
}

/* Gathers the 8-connected wall component of `start` into `list`, marking its cells as seen. False
 * when it touches the edge of the crop, beyond which everything counts as wall. */
static bool gather(const uint8_t *kinds, uint32_t width, const box *crop, size_t start,
                   uint8_t *seen, size_t *list, size_t *count, box *bounds)
{
    bool inside = true;
    *bounds = (box){UINT32_MAX, UINT32_MAX, 0, 0};
    *count = 0;
    list[(*count)++] = start;
    seen[start] = 1;
    for (size_t head = 0; head < *count; head++) {
        uint32_t x = (uint32_t)(list[head] % width);
        uint32_t y = (uint32_t)(list[head] / width);
        bounds->min_x = x < bounds->min_x ? x : bounds->min_x;
        bounds->max_x = x > bounds->max_x ? x : bounds->max_x;
        bounds->min_y = y < bounds->min_y ? y : bounds->min_y;
        bounds->max_y = y > bounds->max_y ? y : bounds->max_y;
        if (x == crop->min_x || x == crop->max_x || y == crop->min_y || y == crop->max_y) {
            inside = false;
        }
        for (uint32_t ny = y > crop->min_y ? y - 1 : y; ny <= y + 1 && ny <= crop->max_y; ny++) {
            for (uint32_t nx = x > crop->min_x ? x - 1 : x; nx <= x + 1 && nx <= crop->max_x;
                 nx++) {
                size_t next = (size_t)ny * width + nx;
                if (kinds[next] == CELL_WALL && !seen[next]) {
                    seen[next] = 1;
                    list[(*count)++] = next;
                }
            }
        }
    }
    return inside;
}

/* Noise, or compact clutter, by the words of roomseg_config. */
static bool is_small(const roomseg_config *config, uint32_t resolution_mm, size_t count,
                     const box *b)
{
    uint64_t area_mm2 = (uint64_t)count * resolution_mm * resolution_mm;
    uint64_t width = b->max_x - b->min_x + 1u;
    uint64_t height = b->max_y - b->min_y + 1u;
    uint64_t longer = width > height ? width : height;
    uint64_t shorter = width > height ? height : width;
    bool compact = longer <= 2 * shorter && 3 * count >= width * height;
    return area_mm2 < config->speck_mm2 ||
           (compact && longer * resolution_mm <= config->clutter_mm);
}

/* What a cell of an obstacle that is noise or clutter becomes. */
static uint8_t kind_of_small(const roomseg_config *config, const roomseg_grid *grid, size_t cell)
{
    size_t x = cell % grid->width;
    size_t y = cell / grid->width;
    bool certain = grid->cells[y * grid->stride + x] >= config->occupied_min;
    return certain ? CELL_BRIDGE : CELL_OPEN;
}

uint8_t *reference_kinds(const roomseg_config *config, const roomseg_grid *grid)
{
    uint32_t width = grid->width;
    size_t cells = (size_t)width * grid->height;
    uint8_t *kinds = malloc(cells);
    uint8_t *seen = calloc(cells, 1);
    size_t *list = malloc(cells * sizeof *list);
    TEST_ASSERT_TRUE(kinds != NULL && seen != NULL && list != NULL);
    for (uint32_t y = 0; y < grid->height; y++) {
        for (uint32_t x = 0; x < width; x++) {
            uint8_t value = grid->cells[(size_t)y * grid->stride + x];
            kinds[(size_t)y * width + x] = value <= config->free_max ? CELL_OPEN : CELL_WALL;
        }
    }
    box crop = bounds_of_free(kinds, width, grid->height);
    for (uint32_t y = crop.min_y; y <= crop.max_y; y++) {
        for (uint32_t x = crop.min_x; x <= crop.max_x; x++) {
            size_t start = (size_t)y * width + x;
            size_t count;
            box bounds;
            if (kinds[start] == CELL_WALL && !seen[start] &&
                gather(kinds, width, &crop, start, seen, list, &count, &bounds) &&
                is_small(config, grid->resolution_mm, count, &bounds)) {
                for (size_t i = 0; i < count; i++) {
                    kinds[list[i]] = kind_of_small(config, grid, list[i]);
                }
            }
        }
    }
    free(list);
    free(seen);
    return kinds;
}

/* Distance of each cell to the nearest wall in its column; the rows outside are wall. */
static uint32_t *column_distances(const uint8_t *kinds, uint32_t width, uint32_t height)
{
    uint32_t *distances = malloc((size_t)width * height * sizeof *distances);
    TEST_ASSERT_NOT_NULL(distances);
    for (uint32_t x = 0; x < width; x++) {
        uint32_t distance = 0;
        for (uint32_t y = 0; y < height; y++) {
            size_t at = (size_t)y * width + x;
            distance = kinds[at] == CELL_WALL ? 0 : distance + 1;
            distances[at] = distance;
        }
        distance = 0;
        for (uint32_t y = height; y-- > 0;) {
            size_t at = (size_t)y * width + x;
            distance = kinds[at] == CELL_WALL ? 0 : distance + 1;
            distances[at] = distances[at] < distance ? distances[at] : distance;
        }
    }
    return distances;
}

/* Squared distance over column x, `across` columns away; columns outside are wall. */
static uint64_t over_column(const uint32_t *row, uint32_t width, int64_t x, int64_t across)
{
    uint64_t along = x < 0 || x >= width ? 0 : row[x];
    return along * along + (uint64_t)(across * across);
}

uint32_t *reference_wall_distances2(const uint8_t *kinds, uint32_t width, uint32_t height)
{
    uint32_t *columns = column_distances(kinds, width, height);
    uint32_t *distances = malloc((size_t)width * height * sizeof *distances);
    TEST_ASSERT_NOT_NULL(distances);
    for (uint32_t y = 0; y < height; y++) {
        const uint32_t *row = columns + (size_t)y * width;
        for (uint32_t x = 0; x < width; x++) {
            uint64_t best = (uint64_t)row[x] * row[x];
            for (int64_t across = 1; (uint64_t)(across * across) < best; across++) {
                uint64_t left = over_column(row, width, (int64_t)x - across, across);
                uint64_t right = over_column(row, width, (int64_t)x + across, across);
                best = left < best ? left : best;
                best = right < best ? right : best;
            }
            distances[(size_t)y * width + x] = (uint32_t)best;
        }
    }
    free(columns);
    return distances;
}
