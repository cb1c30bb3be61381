#include <stdbool.h>
#include <stdlib.h>

#include "check.h"
#include "fail.h"
#include "reference.h"
#include "unity.h"

/* What the labels say about one room. */
typedef struct tally {
    uint64_t cells, sum_x, sum_y;
    uint32_t min_x, min_y, max_x, max_y;
    size_t first; /* its first cell in reading order */
} tally;

static tally *count_cells(const run *r)
{
    tally *tallies = calloc(r->result.room_count + 1u, sizeof *tallies);
    TEST_ASSERT_NOT_NULL(tallies);
    for (uint32_t y = 0; y < r->grid.height; y++) {
        for (uint32_t x = 0; x < r->grid.width; x++) {
            tally *t = &tallies[run_label(r, x, y)];
            if (t->cells == 0) {
                t->first = (size_t)y * r->grid.width + x;
                t->min_x = t->max_x = x;
                t->min_y = y;
            }
            t->cells++;
            t->sum_x += x;
            t->sum_y += y;
            t->min_x = x < t->min_x ? x : t->min_x;
            t->max_x = x > t->max_x ? x : t->max_x;
            t->max_y = y;
        }
    }
    return tallies;
}

static void check_record(const run *r, const roomseg_room *room, const tally *t)
{
    TEST_ASSERT_EQUAL_UINT64(t->cells, room->area_cells);
    uint64_t cell_mm2 = (uint64_t)r->grid.resolution_mm * r->grid.resolution_mm;
    uint64_t area_cm2 = t->cells * cell_mm2 / 100u;
    TEST_ASSERT_EQUAL_UINT64(area_cm2 < UINT32_MAX ? area_cm2 : UINT32_MAX, room->area_cm2);
    TEST_ASSERT_EQUAL_UINT64(t->sum_x * 256u / t->cells, room->centroid_x_q8);
    TEST_ASSERT_EQUAL_UINT64(t->sum_y * 256u / t->cells, room->centroid_y_q8);
    TEST_ASSERT_EQUAL_UINT(t->min_x, room->min_x);
    TEST_ASSERT_EQUAL_UINT(t->min_y, room->min_y);
    TEST_ASSERT_EQUAL_UINT(t->max_x, room->max_x);
    TEST_ASSERT_EQUAL_UINT(t->max_y, room->max_y);
    TEST_ASSERT_EQUAL_UINT_MESSAGE(room->label, run_label(r, room->interior_x, room->interior_y),
                                   "the interior point is no cell of its room");
}

/* Distances are kept in steps of 40 mm, rounded down, 1 to 255 of them. */
#define STEP_MM 40u
#define LARGEST_MM (255u * STEP_MM)

/* Holds the radius, which ends at the wall's face, against the true distance between the cells'
 * centres, to a step. */
static void check_radius(const run *r, const uint32_t *walls2, const roomseg_room *room)
{
    uint64_t distance2 = walls2[(size_t)room->interior_y * r->grid.width + room->interior_x];
    uint64_t resolution = r->grid.resolution_mm;
    uint64_t true2 = distance2 * resolution * resolution;
    uint64_t low = room->inscribed_radius_mm + resolution / 2;
    uint64_t high = low + STEP_MM + 1;
    if ((low > STEP_MM && low * low > true2) || (low < LARGEST_MM && high * high < true2)) {
        fail_with("room %u: radius %u mm, but the wall's centre is sqrt(%llu) mm away",
                  room->label, (unsigned)room->inscribed_radius_mm, (unsigned long long)true2);
    }
}

/* No other cell of the room is more than a step further from the walls. */
static void check_interior_is_best(const run *r, const uint32_t *walls2,
                                   const roomseg_room *room)
{
    uint64_t resolution = r->grid.resolution_mm;
    uint64_t limit = room->inscribed_radius_mm + resolution / 2 + STEP_MM + 1;
    if (limit > LARGEST_MM) {
        return; /* farther cells are not told apart */
    }
    for (uint32_t y = room->min_y; y <= room->max_y; y++) {
        for (uint32_t x = room->min_x; x <= room->max_x; x++) {
            uint64_t distance2 = walls2[(size_t)y * r->grid.width + x];
            if (run_label(r, x, y) == room->label &&
                distance2 * resolution * resolution >= limit * limit) {
                fail_with("room %u: %u, %u is farther from walls than its interior point",
                          room->label, (unsigned)x, (unsigned)y);
            }
        }
    }
}

void check_rooms(const run *r, const uint8_t *kinds)
{
    tally *tallies = count_cells(r);
    uint32_t *walls2 =
        kinds == NULL ? NULL
                      : reference_wall_distances2(kinds, r->grid.width, r->grid.height);
    for (uint32_t i = 0; i < r->result.room_count; i++) {
        const roomseg_room *room = &r->result.rooms[i];
        const tally *t = &tallies[i + 1];
        TEST_ASSERT_EQUAL_UINT(i + 1, room->label);
        TEST_ASSERT_GREATER_THAN_UINT64(0, t->cells);
        if (i > 0 && (t[-1].cells < t->cells ||
                      (t[-1].cells == t->cells && t[-1].first > t->first))) {
            fail_with("rooms %u and %u are in the wrong order", (unsigned)i, (unsigned)i + 1);
        }
        check_record(r, room, t);
        if (walls2 != NULL) {
            check_radius(r, walls2, room);
            check_interior_is_best(r, walls2, room);
        }
    }
    free(walls2);
    free(tallies);
}
