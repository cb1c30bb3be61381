#include "run.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "unity.h"

run run_unchecked(const roomseg_config *config, const roomseg_grid *grid)
{
    run r;
    memset(&r, 0, sizeof r);
    r.config = *config;
    r.grid = *grid;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(config, grid, &r.arena_size));
    if (r.arena_size > 0) {
        r.arena = malloc(r.arena_size);
        TEST_ASSERT_NOT_NULL(r.arena);
        memset(r.arena, 0xEE, r.arena_size);
    }
    size_t cells = (size_t)grid->width * grid->height;
    r.labels = malloc(cells * sizeof *r.labels);
    TEST_ASSERT_NOT_NULL(r.labels);
    memset(r.labels, 0xEE, cells * sizeof *r.labels);
    int rc = roomseg_run(config, grid, r.labels, grid->width, &r.result, r.arena, r.arena_size);
    TEST_ASSERT_EQUAL_STRING(roomseg_status_text(ROOMSEG_OK), roomseg_status_text(rc));
    return r;
}

run run_checked(const roomseg_config *config, const roomseg_grid *grid)
{
    run r = run_unchecked(config, grid);
    check_everything(&r);
    return r;
}

uint16_t run_label(const run *r, uint32_t x, uint32_t y)
{
    return r->labels[(size_t)y * r->grid.width + x];
}

static void assert_same_doorway(const roomseg_doorway *a, const roomseg_doorway *b)
{
    TEST_ASSERT_EQUAL_UINT(a->room_a, b->room_a);
    TEST_ASSERT_EQUAL_UINT(a->room_b, b->room_b);
    TEST_ASSERT_EQUAL_UINT(a->x, b->x);
    TEST_ASSERT_EQUAL_UINT(a->y, b->y);
    TEST_ASSERT_EQUAL_UINT(a->width_mm, b->width_mm);
    TEST_ASSERT_EQUAL_UINT(a->border_cells, b->border_cells);
}

static void assert_same_room(const roomseg_room *a, const roomseg_room *b)
{
    TEST_ASSERT_EQUAL_UINT(a->label, b->label);
    TEST_ASSERT_EQUAL_UINT(a->link_count, b->link_count);
    TEST_ASSERT_EQUAL_UINT(a->link_first, b->link_first);
    TEST_ASSERT_EQUAL_UINT(a->area_cells, b->area_cells);
    TEST_ASSERT_EQUAL_UINT(a->area_cm2, b->area_cm2);
    TEST_ASSERT_EQUAL_UINT(a->centroid_x_q8, b->centroid_x_q8);
    TEST_ASSERT_EQUAL_UINT(a->centroid_y_q8, b->centroid_y_q8);
    TEST_ASSERT_EQUAL_UINT(a->min_x, b->min_x);
    TEST_ASSERT_EQUAL_UINT(a->min_y, b->min_y);
    TEST_ASSERT_EQUAL_UINT(a->max_x, b->max_x);
    TEST_ASSERT_EQUAL_UINT(a->max_y, b->max_y);
    TEST_ASSERT_EQUAL_UINT(a->interior_x, b->interior_x);
    TEST_ASSERT_EQUAL_UINT(a->interior_y, b->interior_y);
    TEST_ASSERT_EQUAL_UINT(a->inscribed_radius_mm, b->inscribed_radius_mm);
}

void run_assert_same(const run *a, const run *b)
{
    TEST_ASSERT_EQUAL_UINT(a->grid.width, b->grid.width);
    TEST_ASSERT_EQUAL_UINT(a->grid.height, b->grid.height);
    TEST_ASSERT_EQUAL_UINT(a->result.region_count, b->result.region_count);
    TEST_ASSERT_EQUAL_UINT(a->result.room_count, b->result.room_count);
    TEST_ASSERT_EQUAL_UINT(a->result.doorway_count, b->result.doorway_count);
    TEST_ASSERT_EQUAL_UINT(a->result.crop_x, b->result.crop_x);
    TEST_ASSERT_EQUAL_UINT(a->result.crop_y, b->result.crop_y);
    TEST_ASSERT_EQUAL_UINT(a->result.crop_width, b->result.crop_width);
    TEST_ASSERT_EQUAL_UINT(a->result.crop_height, b->result.crop_height);
    TEST_ASSERT_EQUAL_INT(0, memcmp(a->labels, b->labels, (size_t)a->grid.width *
                                    a->grid.height * sizeof *a->labels));
    for (uint32_t i = 0; i < a->result.room_count; i++) {
        assert_same_room(&a->result.rooms[i], &b->result.rooms[i]);
    }
    for (uint32_t i = 0; i < a->result.doorway_count; i++) {
        assert_same_doorway(&a->result.doorways[i], &b->result.doorways[i]);
    }
    for (uint32_t i = 0; i < 2 * a->result.doorway_count; i++) {
        TEST_ASSERT_EQUAL_UINT(a->result.links[i], b->result.links[i]);
    }
}

void run_free(run *r)
{
    free(r->labels);
    free(r->arena);
    memset(r, 0, sizeof *r);
}
