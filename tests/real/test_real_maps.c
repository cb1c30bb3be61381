/* The main job on real maps: each result must be consistent, by the words of roomseg.h.
 *
 *   test_real_maps FOLDER    a data set with furnished/, no_furniture/, neato/ of PNG files and
 *                              samples/neato_sample_1.pgm
 *
 * Without the folder the test is skipped, and says so. */
#define _POSIX_C_SOURCE 200809L

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "map.h"
#include "run.h"
#include "unity.h"

#define SKIPPED 77

static const char *data_set;

void setUp(void)
{
}

void tearDown(void)
{
}

static int is_png(const struct dirent *entry)
{
    size_t length = strlen(entry->d_name);
    return length > 4 && strcmp(entry->d_name + length - 4, ".png") == 0;
}

/* At most 4 bytes a cell of the crop, and 2.5 with the usual capacities, which give the same. */
static void check_memory(const run *r)
{
    uint32_t width = r->result.crop_width, height = r->result.crop_height;
    uint32_t resolution_mm = r->grid.resolution_mm;
    size_t cells = (size_t)width * height;
    roomseg_config config = r->config;
    config.max_regions = ROOMSEG_USUAL_REGIONS(width, height, resolution_mm);
    config.max_rooms = ROOMSEG_USUAL_ROOMS(width, height, resolution_mm);
    run compact = run_unchecked(&config, &r->grid);
    run_assert_same(r, &compact);
    printf("    bytes a cell: %.2f, usual capacities %.2f\n",
           (double)r->arena_size / (double)cells, (double)compact.arena_size / (double)cells);
    TEST_ASSERT_EQUAL_size_t(ROOMSEG_ARENA_SIZE_USUAL(width, height, resolution_mm),
                             compact.arena_size);
    TEST_ASSERT_LESS_OR_EQUAL_size_t(4 * cells, r->arena_size);
    TEST_ASSERT_LESS_OR_EQUAL_size_t(5 * cells, 2 * compact.arena_size);
    run_free(&compact);
}

static void check_map(const char *path)
{
    const map_options options = {0};
    tool_error error;
    map m;
    if (map_load(path, &options, &m, &error) != 0) {
        TEST_FAIL_MESSAGE(error.text);
    }
    roomseg_config config = roomseg_config_default();
    roomseg_grid grid = {m.cells, m.width, m.height, m.width,
                         (uint32_t)(m.resolution_m * 1000.0 + 0.5)};
    run r = run_checked(&config, &grid);
    printf("%s: %u rooms, %u doorways, %u regions, arena %lu\n", path,
           (unsigned)r.result.room_count, (unsigned)r.result.doorway_count,
           (unsigned)r.result.region_count, (unsigned long)r.arena_size);
    TEST_ASSERT_GREATER_THAN_UINT(1, r.result.room_count);
    check_memory(&r);
    run_free(&r);
    map_free(&m);
}

static void check_folder(const char *name, int expected)
{
    char folder[1000];
    snprintf(folder, sizeof folder, "%s/%s", data_set, name);
    struct dirent **entries;
    int count = scandir(folder, &entries, is_png, alphasort);
    TEST_ASSERT_EQUAL_INT_MESSAGE(expected, count, folder);
    for (int i = 0; i < count; i++) {
        char path[2000];
        snprintf(path, sizeof path, "%s/%s", folder, entries[i]->d_name);
        check_map(path);
        free(entries[i]);
    }
    free(entries);
}

static void test_furnished(void)
{
    check_folder("furnished", 20);
}

static void test_no_furniture(void)
{
    check_folder("no_furniture", 20);
}

static void test_neato(void)
{
    check_folder("neato", 12);
}

/* A robot's own file, with the resolution in its header. */
static void test_robots_own_file(void)
{
    char path[1000];
    snprintf(path, sizeof path, "%s/samples/neato_sample_1.pgm", data_set);
    check_map(path);
}

int main(int argc, char **argv)
{
    if (argc != 2 || argv[1][0] == '\0') {
        puts("skipped: no real maps; configure with -DROOMSEG_BENCHMARK_DIR=FOLDER");
        return SKIPPED;
    }
    data_set = argv[1];
    UNITY_BEGIN();
    RUN_TEST(test_furnished);
    RUN_TEST(test_no_furniture);
    RUN_TEST(test_neato);
    RUN_TEST(test_robots_own_file);
    return UNITY_END();
}
