#include <stdbool.h>
#include <stdlib.h>

#include "check.h"
#include "fail.h"
#include "reference.h"
#include "unity.h"

/* Shared border of each pair of rooms, by the labels: borders[a * (rooms + 1) + b], a < b. */
static uint32_t *count_borders(const run *r)
{
    size_t side = (size_t)r->result.room_count + 1u;
    uint32_t *borders = calloc(side * side, sizeof *borders);
    TEST_ASSERT_NOT_NULL(borders);
    for (uint32_t y = 0; y < r->grid.height; y++) {
        for (uint32_t x = 0; x < r->grid.width; x++) {
            uint16_t here = run_label(r, x, y);
            const uint16_t next[2] = {
                x + 1 < r->grid.width ? run_label(r, x + 1, y) : (uint16_t)0,
                y + 1 < r->grid.height ? run_label(r, x, y + 1) : (uint16_t)0};
            for (int i = 0; i < 2; i++) {
                if (here != 0 && next[i] != 0 && here != next[i]) {
                    uint16_t a = here < next[i] ? here : next[i];
                    uint16_t b = here < next[i] ? next[i] : here;
                    borders[a * side + b]++;
                }
            }
        }
    }
    return borders;
}

static bool has_bridges(const run *r, const uint8_t *kinds)
{
    size_t cells = (size_t)r->grid.width * r->grid.height;
    for (size_t i = 0; i < cells; i++) {
        if (kinds[i] == CELL_BRIDGE) {
            return true;
        }
    }
    return false;
}

/* Rooms may also touch across transparent obstacles, whose cells carry no label; then the
 * labels show a part of the border only. */
static void check_borders(const run *r, const uint8_t *kinds)
{
    uint32_t *borders = count_borders(r);
    size_t side = (size_t)r->result.room_count + 1u;
    bool exact = !has_bridges(r, kinds);
    uint32_t touching = 0;
    for (size_t i = 0; i < side * side; i++) {
        touching += borders[i] > 0;
    }
    uint32_t found = 0;
    for (uint32_t i = 0; i < r->result.doorway_count; i++) {
        const roomseg_doorway *d = &r->result.doorways[i];
        uint32_t seen = borders[d->room_a * side + d->room_b];
        found += seen > 0;
        if (seen > d->border_cells || (exact && seen != d->border_cells)) {
            fail_with("rooms %u and %u share %u pairs of cells, the record says %u", d->room_a,
                      d->room_b, (unsigned)seen, (unsigned)d->border_cells);
        }
    }
    TEST_ASSERT_EQUAL_UINT_MESSAGE(touching, found, "rooms touch without a doorway record");
    free(borders);
}

static void check_record(const run *r, const uint8_t *kinds, const roomseg_doorway *d)
{
    TEST_ASSERT_TRUE(1 <= d->room_a && d->room_a < d->room_b);
    TEST_ASSERT_TRUE(d->room_b <= r->result.room_count);
    TEST_ASSERT_TRUE(d->x < r->grid.width && d->y < r->grid.height);
    uint16_t label = run_label(r, d->x, d->y);
    bool may_lack = kinds == NULL ||
                    kinds[(size_t)d->y * r->grid.width + d->x] == CELL_BRIDGE;
    if (label != d->room_a && label != d->room_b && !(label == 0 && may_lack)) {
        fail_with("the doorway of rooms %u and %u lies at %u, %u in room %u", d->room_a,
                  d->room_b, d->x, d->y, label);
    }
    TEST_ASSERT_GREATER_THAN_UINT(0, d->width_mm);
    TEST_ASSERT_GREATER_THAN_UINT(0, d->border_cells);
}

static void check_links(const run *r)
{
    uint32_t expected_first = 0;
    for (uint32_t i = 0; i < r->result.room_count; i++) {
        const roomseg_room *room = &r->result.rooms[i];
        TEST_ASSERT_EQUAL_UINT(expected_first, room->link_first);
        expected_first += room->link_count;
        for (uint32_t k = 0; k < room->link_count; k++) {
            uint16_t link = r->result.links[room->link_first + k];
            TEST_ASSERT_LESS_THAN_UINT(r->result.doorway_count, link);
            const roomseg_doorway *d = &r->result.doorways[link];
            if (d->room_a != room->label && d->room_b != room->label) {
                fail_with("room %u links to a doorway of other rooms", room->label);
            }
            for (uint32_t earlier = 0; earlier < k; earlier++) {
                TEST_ASSERT_NOT_EQUAL_UINT(r->result.links[room->link_first + earlier], link);
            }
        }
    }
    /* Each doorway was met at most once a room, so the sum says that none is missing. */
    TEST_ASSERT_EQUAL_UINT(2 * r->result.doorway_count, expected_first);
}

void check_doorways(const run *r, const uint8_t *kinds)
{
    for (uint32_t i = 0; i < r->result.doorway_count; i++) {
        const roomseg_doorway *d = &r->result.doorways[i];
        check_record(r, kinds, d);
        if (i > 0 && (d[-1].room_a > d->room_a ||
                      (d[-1].room_a == d->room_a && d[-1].room_b >= d->room_b))) {
            fail_with("doorways %u and %u are in the wrong order", (unsigned)i - 1, (unsigned)i);
        }
    }
    check_links(r);
    if (kinds != NULL) {
        check_borders(r, kinds);
    }
}
