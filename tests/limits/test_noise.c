/* Random grids and random configurations: whatever comes, the result is consistent or the error
 * is a documented one, and nothing outside the arena is written. Seeded, so a failure repeats. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guard.h"
#include "random.h"
#include "run.h"
#include "sketch.h"
#include "unity.h"

static uint32_t state;
static uint32_t seed;

void setUp(void)
{
    state = 1;
}

void tearDown(void)
{
    if (Unity.CurrentTestFailed) {
        printf("seed %u\n", (unsigned)seed);
    }
}

static uint32_t random_in(uint32_t low, uint32_t high)
{
    return low + random_next(&state) % (high - low + 1);
}

/* Blobs of random values over a ground that is mostly free, then single cells. */
static sketch random_grid(void)
{
    static const uint8_t values[] = {0, 0, 0, 30, 51, 52, 127, 203, 204, 255, 255};
    uint32_t width = random_in(1, 70);
    uint32_t height = random_in(1, 70);
    sketch s = sketch_blank(width, height, values[random_in(0, 10)], random_in(20, 200));
    for (uint32_t blobs = random_in(0, 40); blobs > 0; blobs--) {
        uint32_t x = random_in(0, width - 1);
        uint32_t y = random_in(0, height - 1);
        uint32_t w = random_in(1, random_in(0, 3) == 0 ? width - x : 1 + (width - x) / 6);
        uint32_t h = random_in(1, random_in(0, 3) == 0 ? height - y : 1 + (height - y) / 6);
        sketch_fill(&s, x, y, w, h, values[random_in(0, 10)]);
    }
    if (random_in(0, 2) == 0) {
        uint32_t share = random_in(1, 60);
        for (size_t i = 0; i < (size_t)width * height; i++) {
            if (random_in(0, 99) < share) {
                s.memory[i] = values[random_in(0, 10)];
            }
        }
    }
    if (random_in(0, 3) == 0) {
        sketch straight = s;
        s = sketch_turned(&straight, random_in(0, 89));
        sketch_free(&straight);
    }
    return s;
}

static roomseg_config random_config(void)
{
    roomseg_config config = roomseg_config_default();
    config.unwalled_percent = 0; /* so that all of an area or nothing carries labels */
    if (random_in(0, 1) == 0) {
        config.speck_mm2 = random_in(0, 300000);
        config.clutter_mm = random_in(0, ROOMSEG_MAX_CLUTTER_MM);
        config.smallest_room_mm2 = random_in(0, 3000000);
        config.isolated_permille = random_in(0, 40);
        config.niche_mm2 = random_in(0, 3000000);
        config.room_opening_percent = random_in(1, 100);
        config.passage_opening_percent = random_in(1, 100);
        config.passage_min_neighbours = random_in(2, 8);
        config.free_max = (uint8_t)random_in(0, 210);
        config.occupied_min = (uint8_t)random_in(config.free_max + 1u, 255);
    }
    config.align = random_in(0, 2) == 0 ? ROOMSEG_ALIGN_ON : NULL;
    config.max_regions = random_in(0, 3) == 0 ? random_in(1, 60) : 12000;
    config.max_rooms = config.max_regions < 12000 ? random_in(1, config.max_regions) : 12000;
    return config;
}

static void check_one(void)
{
    sketch s = random_grid();
    run r;
    memset(&r, 0, sizeof r);
    r.config = random_config();
    r.grid = s.grid;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          roomseg_arena_size_for_grid(&r.config, &r.grid, &r.arena_size));
    size_t cells = (size_t)s.grid.width * s.grid.height;
    guard arena = guard_make(r.arena_size, 0);
    guard labels = guard_make(cells * sizeof(uint16_t), 0);
    r.arena = arena.memory;
    r.labels = (uint16_t *)labels.memory;
    int rc = roomseg_run(&r.config, &r.grid, r.labels, r.grid.width, &r.result, r.arena,
                         r.arena_size);
    guard_check(&arena);
    guard_check(&labels);
    if (rc == ROOMSEG_OK) {
        check_everything(&r);
    } else if (rc == ROOMSEG_ERR_REGIONS || rc == ROOMSEG_ERR_ROOMS) {
        TEST_ASSERT_TRUE(r.config.max_rooms < 12000);
        TEST_ASSERT_EACH_EQUAL_UINT16(0, r.labels, cells);
    } else {
        TEST_FAIL_MESSAGE(roomseg_status_text(rc));
    }
    guard_free(&labels);
    guard_free(&arena);
    sketch_free(&s);
}

static void test_random_grids(void)
{
    for (seed = 1; seed <= 1500; seed++) {
        state = seed * 2654435761u + 1u;
        check_one();
    }
}

/* Mazes of corridors one cell wide: every free cell is as close to a wall as the next. */
static void test_mazes(void)
{
    for (seed = 1; seed <= 20; seed++) {
        state = seed;
        sketch s = sketch_blank(101, 101, 255, 100);
        for (uint32_t y = 1; y < 100; y += 2) {
            for (uint32_t x = 1; x < 100; x += 2) {
                s.memory[y * 101 + x] = 0;
                /* One of the walls to the north and west, as in a binary tree. */
                bool north = y > 1 && (x == 1 || random_in(0, 1) == 0);
                if (north) {
                    s.memory[(y - 1) * 101 + x] = 0;
                } else if (x > 1) {
                    s.memory[y * 101 + x - 1] = 0;
                }
            }
        }
        roomseg_config config = roomseg_config_default();
        config.speck_mm2 = 0;
        config.clutter_mm = 0;
        run r = run_checked(&config, &s.grid);
        TEST_ASSERT_EQUAL_UINT(1, r.result.room_count);
        run_free(&r);
        sketch_free(&s);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_random_grids);
    RUN_TEST(test_mazes);
    return UNITY_END();
}
