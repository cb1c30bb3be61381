/* A map that is moved, turned, mirrored, doubled or drawn finer has the rooms that it had.
 *
 *   test_metamorphic [FOLDER]    simulated maps, and the real ones in furnished/, no_furniture/
 *                                and neato/ of a data set; without the folder these are left
 *                                out, and the test says so
 *
 * Rooms are compared as partitions, by the adjusted Rand index over the cells that carry a label
 * in one of both; "no room" counts as one more room. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contingency.h"
#include "dataset.h"
#include "golden.h"
#include "metrics.h"
#include "run.h"
#include "segment.h"
#include "transform.h"
#include "unity.h"

/* Least index of any map, and of the mean over the maps. Shifted and padded maps have the same
 * rooms exactly. In the others ties are decided by the reading order, distances are rounded
 * otherwise, and what is dropped depends on the area of the whole. */
typedef struct bound {
    double least, mean;
} bound;

static const bound bounds[TRANSFORM_COUNT] = {
    [TRANSFORM_SHIFT] = {1.0, 1.0},      [TRANSFORM_PAD] = {1.0, 1.0},
    [TRANSFORM_MIRROR] = {0.80, 0.985},   [TRANSFORM_TURN_90] = {0.80, 0.985},
    [TRANSFORM_TURN_180] = {0.80, 0.985}, [TRANSFORM_TURN_270] = {0.80, 0.985},
    [TRANSFORM_TWICE] = {0.70, 0.985},    [TRANSFORM_FINER] = {0.55, 0.92},
};

typedef struct tally {
    uint32_t maps, equal; /* equal: exactly the same partition */
    double sum, least;
    char worst[64];
} tally;

static tally tallies[TRANSFORM_COUNT];
static const char *data_set;

void setUp(void)
{
    memset(tallies, 0, sizeof tallies);
}

void tearDown(void)
{
}

static void *get(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    TEST_ASSERT_NOT_NULL(memory);
    return memory;
}

/* The default config with room for a second building. */
static segmentation run_grid(const roomseg_grid *grid)
{
    roomseg_config config = roomseg_config_default();
    segmentation s;
    config.max_regions = 8192;
    config.max_rooms = 1024;
    memset(&s, 0, sizeof s);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_arena_size_for_grid(&config, grid, &s.arena_bytes));
    s.arena = get(s.arena_bytes + 1, 1);
    s.labels = get((size_t)grid->width * grid->height, sizeof *s.labels);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, roomseg_run(&config, grid, s.labels, grid->width, &s.result,
                                                  s.arena, s.arena_bytes));
    return s;
}

static double index_of(const label_image *a, const label_image *b)
{
    contingency table;
    metrics m;
    TEST_ASSERT_EQUAL_INT(0, contingency_count(a, b, &table));
    TEST_ASSERT_EQUAL_INT(0, metrics_compute(&table, &m));
    contingency_free(&table);
    return m.ari;
}

static double compare(transform t, const roomseg_grid *grid, const segmentation *original)
{
    roomseg_grid changed = transform_apply(t, grid);
    segmentation s = run_grid(&changed);
    size_t cells = (size_t)changed.width * changed.height;
    label_image wanted = {get(cells, sizeof(uint32_t)), changed.width, changed.height};
    label_image found = {get(cells, sizeof(uint32_t)), changed.width, changed.height};
    for (size_t i = 0; i < cells; i++) {
        uint32_t copy;
        size_t from = transform_source(t, grid, (uint32_t)(i % changed.width),
                                       (uint32_t)(i / changed.width), &copy);
        uint32_t label = from == SIZE_MAX ? 0 : original->labels[from];
        label += label != 0 ? copy * original->result.room_count : 0;
        if (label != 0 || s.labels[i] != 0) {
            wanted.values[i] = label + 1;
            found.values[i] = s.labels[i] + 1u;
        }
    }
    double index = index_of(&wanted, &found);
    label_image_free(&wanted);
    label_image_free(&found);
    segmentation_free(&s);
    free((void *)(uintptr_t)changed.cells);
    return index;
}

static void add(tally *t, double index, const char *name)
{
    if (t->maps == 0 || index < t->least) {
        t->least = index;
        snprintf(t->worst, sizeof t->worst, "%s", name);
    }
    t->maps++;
    t->equal += index == 1.0;
    t->sum += index;
}

static void add_grid(const roomseg_grid *grid, const char *name)
{
    segmentation original = run_grid(grid);
    for (int t = 0; t < TRANSFORM_COUNT; t++) {
        if (t != TRANSFORM_FINER || (grid->resolution_mm % 2 == 0 &&
                                     grid->resolution_mm >= 2 * ROOMSEG_MIN_RESOLUTION_MM)) {
            add(&tallies[t], compare((transform)t, grid, &original), name);
        }
    }
    segmentation_free(&original);
}

static void report(const char *title)
{
    printf("%-12s%8s%8s%10s%10s  %s\n", title, "maps", "equal", "mean", "worst", "worst map");
    for (int t = 0; t < TRANSFORM_COUNT; t++) {
        const tally *a = &tallies[t];
        printf("%-12s%8u%8u%10.4f%10.4f  %s\n", transform_name((transform)t), (unsigned)a->maps,
               (unsigned)a->equal, a->sum / a->maps, a->least, a->worst);
    }
    for (int t = 0; t < TRANSFORM_COUNT; t++) {
        const tally *a = &tallies[t];
        TEST_ASSERT_TRUE_MESSAGE(a->least >= bounds[t].least, transform_name((transform)t));
        TEST_ASSERT_TRUE_MESSAGE(a->sum >= bounds[t].mean * a->maps,
                                 transform_name((transform)t));
    }
}

static void test_simulated_maps(void)
{
    for (int i = 0; i < GOLDEN_DEFAULT_COUNT; i++) {
        golden_map golden = golden_map_at(i);
        sim_map made;
        TEST_ASSERT_EQUAL_INT(0, sim_run(&golden.options, &made));
        roomseg_grid grid = {made.cells, made.width, made.height, made.width,
                             (uint32_t)made.resolution_mm};
        add_grid(&grid, golden.name);
        sim_map_free(&made);
    }
    report("simulated");
}

static void add_real(const char *set, const dataset_map *file)
{
    const map_options options = {0, 0};
    tool_error error;
    map m;
    char name[64];
    if (map_load(file->map, &options, &m, &error) != 0) {
        TEST_FAIL_MESSAGE(error.text);
    }
    roomseg_grid grid = segment_grid(&m);
    snprintf(name, sizeof name, "%s/%s", set, file->name);
    add_grid(&grid, name);
    map_free(&m);
}

static void test_real_maps(void)
{
    static const char *const sets[] = {"furnished", "no_furniture", "neato"};
    dataset data;
    tool_error error;
    if (dataset_open(data_set, &data, &error) != 0) {
        TEST_FAIL_MESSAGE(error.text);
    }
    for (size_t i = 0; i < data.count; i++) {
        for (size_t k = 0; k < 3; k++) {
            for (size_t j = 0; strcmp(data.sets[i].name, sets[k]) == 0 && j < data.sets[i].count;
                 j++) {
                add_real(sets[k], &data.sets[i].maps[j]);
            }
        }
    }
    dataset_free(&data);
    TEST_ASSERT_EQUAL_UINT(52, tallies[0].maps);
    report("real");
}

int main(int argc, char **argv)
{
    UNITY_BEGIN();
    RUN_TEST(test_simulated_maps);
    if (argc == 2 && argv[1][0] != '\0') {
        data_set = argv[1];
        RUN_TEST(test_real_maps);
    } else {
        puts("real maps left out; configure with -DROOMSEG_BENCHMARK_DIR=FOLDER");
    }
    return UNITY_END();
}
