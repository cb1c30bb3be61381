/* Alignment on real maps that are turned.
 *
 *   test_turned_maps FOLDER [SET]    a data set whose folder SET, else furnished/, holds PNG files
 *
 * Without the folder the test is skipped, and says so. */
#define _POSIX_C_SOURCE 200809L

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "align.h"
#include "check.h"
#include "map.h"
#include "run.h"
#include "score.h"
#include "sketch.h"
#include "threshold.h"
#include "unity.h"

#define SKIPPED 77
#define MOST_MAPS 100

static const char *data_set, *set_name;
static char paths[MOST_MAPS][2000];
static int map_count;

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
    snprintf(folder, sizeof folder, "%s/%s", data_set, set_name);
    map_count = scandir(folder, &entries, is_png, alphasort);
    TEST_ASSERT_TRUE_MESSAGE(map_count >= 1 && map_count <= MOST_MAPS, folder);
    for (int i = 0; i < map_count; i++) {
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

static roomseg_config ready(bool paper, bool align)
{
    roomseg_config config = paper ? roomseg_config_paper() : roomseg_config_default();
    config.align = align ? ROOMSEG_ALIGN_ON : NULL;
    config.max_regions = 8192; /* ragged edges have many small peaks */
    return config;
}

/* Directions of the walls [degrees]: the one found, and those that rival it. */
typedef struct directions {
    double angles[18];
    int count;
} directions;

static double apart(double angle, const directions *d)
{
    double nearest = 90.0;
    for (int i = 0; i < d->count; i++) {
        nearest = fmin(nearest, fabs(remainder(angle - d->angles[i], 90.0)));
    }
    return nearest;
}

/* Mean direction and length of the segments in five bins from `first` on. */
static double window(const rs_direction_bin *bins, uint32_t first, double *mean)
{
    double length = 0.0, weight = 0.0, sum = 0.0;
    for (uint32_t i = 0; i < 5; i++) {
        const rs_direction_bin *bin = &bins[(first + i) % ROOMSEG_DIRECTION_BINS];
        length += bin->length;
        weight += (double)bin->weight;
        sum += (double)bin->excess / 100.0 + (double)bin->weight * (first + i);
    }
    *mean = sum / weight;
    return length;
}

/* Directions along which at least two fifths as much wall lies: in a building with five wings,
 * any of five may come out first on a turned map, by how the cells happen to lie. */
static void add_rivals(const rs_direction_bin *bins, directions *d)
{
    const double strong = 0.4;
    double most = 0.0, mean;
    for (uint32_t first = 0; first < ROOMSEG_DIRECTION_BINS; first++) {
        most = fmax(most, window(bins, first, &mean));
    }
    for (uint32_t first = 0; first < ROOMSEG_DIRECTION_BINS; first++) {
        if (window(bins, first, &mean) >= strong * most && apart(mean, d) > 5.0) {
            d->angles[d->count++] = mean;
        }
    }
}

static directions find_directions(const roomseg_grid *grid)
{
    roomseg_config config = ready(false, true);
    rs_ticker ticker = {0};
    rs_find_buffers b;
    rs_frame crop;
    size_t bytes;
    int32_t angle;
    directions d = {{0.0}, 1};
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_threshold_crop(grid, config.free_max, &crop, &ticker));
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size(&config, crop.width, crop.height,
                                                         grid->resolution_mm, &bytes));
    void *arena = malloc(bytes);
    TEST_ASSERT_NOT_NULL(arena);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK,
                          rs_align_find(&config, grid, &crop, arena, &angle, &ticker));
    d.angles[0] = angle / 100.0;
    rs_align_place_find(&config, &crop, grid->resolution_mm, arena, &b);
    add_rivals(b.bins, &d);
    free(arena);
    return d;
}

static void test_the_angle_is_right_within_a_degree(void)
{
    int missed = 0;
    for (int i = 0; i < map_count; i++) {
        sketch straight = load_cut_out(paths[i]);
        directions own = find_directions(&straight.grid);
        double worst = 0.0;
        int rivals = 0;
        for (int degrees = -40; degrees <= 40; degrees += 5) {
            sketch turned = sketch_turned(&straight, degrees);
            double found = find_directions(&turned.grid).angles[0] - degrees;
            double off = apart(found, &own);
            worst = fmax(worst, off);
            rivals += fabs(remainder(found - own.angles[0], 90.0)) > 1.0 && off <= 1.0;
            missed += off > 1.0;
            sketch_free(&turned);
        }
        printf("%s: walls at %.2f degrees", paths[i], own.angles[0]);
        for (int k = 1; k < own.count; k++) {
            printf(" and %.2f", own.angles[k]);
        }
        printf("; turned 17 times, %.2f off at most, %d times along another of these\n", worst,
               rivals);
        sketch_free(&straight);
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, missed, "turned maps off by more than a degree");
}

/* Labels as an image. */
static label_image image_of(const uint16_t *labels, uint32_t width, uint32_t height)
{
    label_image out = {NULL, width, height};
    out.values = malloc((size_t)width * height * sizeof *out.values);
    TEST_ASSERT_NOT_NULL(out.values);
    for (size_t i = 0; i < (size_t)width * height; i++) {
        out.values[i] = labels[i];
    }
    return out;
}

/* The labels of the map as it lies, then turned as sketch_turned() turns it. Rooms are told
 * apart by a byte, as a sketch holds no more. */
static label_image turned_labels(const roomseg_config *config, const sketch *straight,
                                 double degrees)
{
    run r = run_unchecked(config, &straight->grid);
    sketch labels = sketch_blank(straight->grid.width, straight->grid.height, 0, 50);
    TEST_ASSERT_LESS_THAN_UINT(127, r.result.room_count);
    for (uint32_t y = 0; y < labels.grid.height; y++) {
        for (uint32_t x = 0; x < labels.grid.width; x++) {
            labels.memory[(size_t)y * labels.grid.stride + x] = (uint8_t)run_label(&r, x, y);
        }
    }
    sketch turned = sketch_turned(&labels, degrees);
    label_image out = {NULL, turned.grid.width, turned.grid.height};
    out.values = malloc((size_t)out.width * out.height * sizeof *out.values);
    TEST_ASSERT_NOT_NULL(out.values);
    for (size_t i = 0; i < (size_t)out.width * out.height; i++) {
        out.values[i] = turned.memory[i] == 127 ? 0 : turned.memory[i];
    }
    run_free(&r);
    sketch_free(&labels);
    sketch_free(&turned);
    return out;
}

/* Rooms of a turned map, aligned, against those of the map as it lies: the same places of the
 * caller's grid. Returns the adjusted Rand index. */
static double compare_frames(const sketch *straight, double degrees, bool paper, const char *path)
{
    roomseg_config plain = ready(paper, false), aligning = ready(paper, true);
    sketch turned = sketch_turned(straight, degrees);
    tool_error error = {""};
    score s;
    run r = paper ? run_unchecked(&aligning, &turned.grid) : run_checked(&aligning, &turned.grid);
    check_rooms(&r, NULL);
    label_image expected = turned_labels(&plain, straight, degrees);
    label_image found = image_of(r.labels, turned.grid.width, turned.grid.height);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, score_labels(&expected, &found, path, &s, &error), error.text);
    printf("%s: %s, turned by %.0f: %u rooms for %u, adjusted Rand index %.2f %%, no room on "
           "%.2f %% of them\n",
           path, paper ? "paper" : "default", degrees, (unsigned)r.result.room_count,
           (unsigned)s.all.rooms_true, s.all.ari * 100.0, s.all.under_painting * 100.0);
    label_image_free(&expected);
    label_image_free(&found);
    run_free(&r);
    sketch_free(&turned);
    return s.all.ari;
}

static void test_rooms_of_turned_maps_come_back(void)
{
    const double angles[3] = {-31.0, 8.0, 44.0};
    for (int paper = 0; paper < 2; paper++) {
        double sum = 0.0;
        for (int i = 0; i < map_count; i++) {
            sketch straight = load_cut_out(paths[i]);
            sum += compare_frames(&straight, angles[i % 3], paper, paths[i]);
            sketch_free(&straight);
        }
        printf("%s: mean adjusted Rand index %.2f %%\n", paper ? "paper" : "default",
               sum / map_count * 100.0);
        TEST_ASSERT_TRUE(sum / map_count >= 0.75);
    }
}

int main(int argc, char **argv)
{
    if (argc < 2 || argc > 3 || argv[1][0] == '\0') {
        puts("skipped: no real maps; configure with -DROOMSEG_BENCHMARK_DIR=FOLDER");
        return SKIPPED;
    }
    data_set = argv[1];
    set_name = argc == 3 ? argv[2] : "furnished";
    UNITY_BEGIN();
    find_maps();
    RUN_TEST(test_the_angle_is_right_within_a_degree);
    RUN_TEST(test_rooms_of_turned_maps_come_back);
    return UNITY_END();
}
