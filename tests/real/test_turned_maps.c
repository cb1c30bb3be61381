/* Alignment on real maps that are turned.
 *
 *   test_turned_maps FOLDER    a data set with furnished/ of PNG files
 *
 * Without the folder the test is skipped, and says so. */
#define _POSIX_C_SOURCE 200809L

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "align.h"
#include "map.h"
#include "run.h"
#include "sketch.h"
#include "threshold.h"
#include "unity.h"

#define SKIPPED 77
#define MAPS 20

static const char *data_set;
static char paths[MAPS][2000];

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

static void find_maps(void)
{
    char folder[1000];
    struct dirent **entries;
    snprintf(folder, sizeof folder, "%s/furnished", data_set);
    TEST_ASSERT_EQUAL_INT_MESSAGE(MAPS, scandir(folder, &entries, is_png, alphasort), folder);
    for (int i = 0; i < MAPS; i++) {
        snprintf(paths[i], sizeof paths[i], "%s/%s", folder, entries[i]->d_name);
        free(entries[i]);
    }
    free(entries);
}

static map load(const char *path)
{
    const map_options options = {0};
    tool_error error;
    map m;
    if (map_load(path, &options, &m, &error) != 0) {
        TEST_FAIL_MESSAGE(error.text);
    }
    return m;
}

/* The map around its free cells; turning the whole of it would take long. */
static sketch cut_out(const map *m)
{
    const uint32_t margin = 10;
    roomseg_grid grid = {m->cells, m->width, m->height, m->width,
                         (uint32_t)(m->resolution_m * 1000.0 + 0.5)};
    rs_ticker ticker = {0};
    rs_frame crop;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_threshold_crop(&grid, roomseg_config_default().free_max, &crop,
                                            &ticker));
    uint32_t left = crop.x > margin ? crop.x - margin : 0;
    uint32_t top = crop.y > margin ? crop.y - margin : 0;
    uint32_t right = rs_min_u32(crop.x + crop.width + margin, m->width);
    uint32_t bottom = rs_min_u32(crop.y + crop.height + margin, m->height);
    sketch s = sketch_blank(right - left, bottom - top, 0, grid.resolution_mm);
    for (uint32_t y = top; y < bottom; y++) {
        memcpy(s.memory + (size_t)(y - top) * s.grid.stride, m->cells + (size_t)y * m->width + left,
               right - left);
    }
    return s;
}

static sketch load_cut_out(const char *path)
{
    map m = load(path);
    sketch s = cut_out(&m);
    map_free(&m);
    return s;
}

static roomseg_config aligning(void)
{
    roomseg_config config = roomseg_config_default();
    config.align = ROOMSEG_ALIGN_ON;
    config.max_regions = 8192; /* ragged edges have many small peaks */
    return config;
}

/* Direction of the walls [degrees]. */
static double wall_angle(const roomseg_grid *grid)
{
    roomseg_config config = aligning();
    rs_ticker ticker = {0};
    rs_frame crop;
    size_t bytes;
    int32_t angle;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_threshold_crop(grid, config.free_max, &crop, &ticker));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, crop.width, crop.height,
                                                         grid->resolution_mm, &bytes));
    void *arena = malloc(bytes);
    TEST_ASSERT_NOT_NULL(arena);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_align_find(&config, grid, &crop, arena, &angle, &ticker));
    free(arena);
    return angle / 100.0;
}

/* The walls' directions repeat themselves after a quarter turn, but in the pentagon of
 * 16_office_e: there five directions are as good as each other. */
static double period_of(const char *path)
{
    return strstr(path, "16_office_e") != NULL ? 18.0 : 90.0;
}

static void test_the_angle_is_right_within_a_degree(void)
{
    for (int i = 0; i < MAPS; i++) {
        sketch straight = load_cut_out(paths[i]);
        double own = wall_angle(&straight.grid);
        double worst = 0.0;
        for (int degrees = -40; degrees <= 40; degrees += 5) {
            sketch turned = sketch_turned(&straight, degrees);
            double off = remainder(wall_angle(&turned.grid) - own - degrees, period_of(paths[i]));
            worst = fabs(off) > worst ? fabs(off) : worst;
            sketch_free(&turned);
        }
        printf("%s: walls at %.2f degrees; turned, %.2f off at most\n", paths[i], own, worst);
        TEST_ASSERT_TRUE_MESSAGE(worst <= 1.0, paths[i]);
        sketch_free(&straight);
    }
}

/* Labels and records are those of the turned grid, however it had to be turned back. */
static void test_results_of_turned_maps_are_consistent(void)
{
    const double angles[3] = {-31.0, 8.0, 44.0};
    for (int i = 0; i < MAPS; i++) {
        roomseg_config config = aligning();
        sketch straight = load_cut_out(paths[i]);
        sketch turned = sketch_turned(&straight, angles[i % 3]);
        run r = run_checked(&config, &turned.grid);
        printf("%s: %u rooms, %u regions\n", paths[i], (unsigned)r.result.room_count,
               (unsigned)r.result.region_count);
        TEST_ASSERT_GREATER_THAN_UINT(1, r.result.room_count);
        run_free(&r);
        sketch_free(&turned);
        sketch_free(&straight);
    }
}

int main(int argc, char **argv)
{
    if (argc != 2 || argv[1][0] == '\0') {
        puts("skipped: no real maps; configure with -DROOMSEG_BENCHMARK_DIR=FOLDER");
        return SKIPPED;
    }
    data_set = argv[1];
    UNITY_BEGIN();
    find_maps();
    RUN_TEST(test_the_angle_is_right_within_a_degree);
    RUN_TEST(test_results_of_turned_maps_are_consistent);
    return UNITY_END();
}
