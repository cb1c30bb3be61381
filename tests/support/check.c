#include "check.h"

#include <stdlib.h>

#include "reference.h"
#include "unity.h"

static void check_crop(const run *r)
{
    uint32_t min_x = UINT32_MAX;
    uint32_t min_y = UINT32_MAX;
    uint32_t end_x = 0;
    uint32_t end_y = 0;
    for (uint32_t y = 0; y < r->grid.height; y++) {
        for (uint32_t x = 0; x < r->grid.width; x++) {
            if (r->grid.cells[(size_t)y * r->grid.stride + x] <= r->config.free_max) {
                min_x = x < min_x ? x : min_x;
                min_y = y < min_y ? y : min_y;
                end_x = x + 1 > end_x ? x + 1 : end_x;
                end_y = y + 1;
            }
        }
    }
    if (end_x == 0) {
        min_x = min_y = 0;
    }
    TEST_ASSERT_EQUAL_UINT(min_x, r->result.crop_x);
    TEST_ASSERT_EQUAL_UINT(min_y, r->result.crop_y);
    TEST_ASSERT_EQUAL_UINT(end_x - min_x, r->result.crop_width);
    TEST_ASSERT_EQUAL_UINT(end_y - min_y, r->result.crop_height);
}

void check_records(const run *r, const uint8_t *kinds)
{
    check_crop(r);
    check_labels(r, kinds);
    check_rooms(r, kinds);
    check_doorways(r, kinds);
    TEST_ASSERT_TRUE(r->result.room_count <= r->config.max_rooms);
    TEST_ASSERT_TRUE(r->result.region_count <= r->config.max_regions);
    TEST_ASSERT_TRUE(r->result.region_count >= r->result.room_count);
    TEST_ASSERT_EQUAL_UINT(r->arena_size, r->result.arena_used);
}

void check_everything(const run *r)
{
    uint8_t *kinds = reference_kinds(&r->config, &r->grid);
    check_records(r, kinds);
    check_dropped(r, kinds);
    free(kinds);
}
