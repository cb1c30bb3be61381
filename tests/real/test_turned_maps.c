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

#include "check.h"
#include "map.h"
#include "run.h"
#include "turn.h"
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

static roomseg_grid grid_of(const map *m)
{
    roomseg_grid grid = {m->cells, m->width, m->height, m->width,
                         (uint32_t)(m->resolution_m * 1000.0 + 0.5)};
    return grid;
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
    run r = run_unchecked(&config, grid);
    double angle = r.result.wall_angle / 100.0;
    run_free(&r);
    return angle;
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
        map m = load(paths[i]);
        roomseg_grid grid = grid_of(&m);
        double own = wall_angle(&grid);
        double worst = 0.0;
        for (int degrees = -40; degrees <= 40; degrees += 5) {
            roomseg_grid turned = turn_grid(&grid, degrees);
            double off = turn_difference(wall_angle(&turned), own + degrees, period_of(paths[i]));
            worst = fabs(off) > worst ? fabs(off) : worst;
            free((void *)turned.cells);
        }
        printf("%s: walls at %.2f degrees; turned, %.2f off at most\n", paths[i], own, worst);
        TEST_ASSERT_TRUE_MESSAGE(worst <= 1.0, paths[i]);
        map_free(&m);
    }
}

/* Labels and records are those of the turned grid, however it had to be turned back. */
static void test_results_of_turned_maps_are_consistent(void)
{
    const double angles[3] = {-31.0, 8.0, 44.0};
    for (int i = 0; i < MAPS; i++) {
        roomseg_config config = aligning();
        map m = load(paths[i]);
        roomseg_grid grid = grid_of(&m);
        roomseg_grid turned = turn_grid(&grid, angles[i % 3]);
        run r = run_checked(&config, &turned);
        printf("%s: %u rooms, %u regions\n", paths[i], (unsigned)r.result.room_count,
               (unsigned)r.result.region_count);
        TEST_ASSERT_GREATER_THAN_UINT(1, r.result.room_count);
        run_free(&r);
        free((void *)turned.cells);
        map_free(&m);
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
