/* The paper profile against the labels of the published implementation.
 *
 *   test_paper_maps FOLDER    a data set with furnished/, no_furniture/, neato/ of PNG files, and
 *                             the labels in reference/ under the same names; 255 = border line
 *
 * Without the folder, or without its labels, the test is skipped, and says so. */
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dataset.h"
#include "map.h"
#include "out.h"
#include "run.h"
#include "score.h"
#include "unity.h"

#define SKIPPED 77
#define BORDER_LINE 255u

static const char *data_set;
static tool_error error;

void setUp(void)
{
}

void tearDown(void)
{
}

static char *join(const char *folder, const char *name)
{
    char *path = out_join(folder, name);
    TEST_ASSERT_NOT_NULL(path);
    return path;
}

/* Maps of a set, paired with their labels. */
static dataset_set open_set(const char *name)
{
    dataset_set set;
    char *maps = join(data_set, name), *reference = join(data_set, "reference");
    char *labels = join(reference, name);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, dataset_pair(maps, labels, &set, &error), error.text);
    for (size_t i = 0; i < set.count; i++) {
        TEST_ASSERT_NOT_NULL_MESSAGE(set.maps[i].truth, set.maps[i].map);
    }
    free(maps);
    free(reference);
    free(labels);
    return set;
}

static label_image load_reference(const char *path)
{
    label_image out;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, label_image_load(path, &out, &error), error.text);
    label_image_clear(&out, BORDER_LINE);
    return out;
}

static run run_map(const roomseg_config *config, const char *path)
{
    const map_options options = {0};
    map m;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, map_load(path, &options, &m, &error), error.text);
    const roomseg_grid grid = {m.cells, m.width, m.height, m.width,
                               (uint32_t)(m.resolution_m * 1000.0 + 0.5)};
    run r = run_unchecked(config, &grid);
    r.grid.cells = NULL; /* they go with the map */
    map_free(&m);
    return r;
}

static metrics compare(const roomseg_config *config, const dataset_map *files)
{
    label_image reference = load_reference(files->truth);
    run r = run_map(config, files->map);
    label_image labels = {NULL, r.grid.width, r.grid.height};
    size_t cells = (size_t)labels.width * labels.height;
    score s;
    labels.values = malloc(cells * sizeof *labels.values);
    TEST_ASSERT_NOT_NULL(labels.values);
    for (size_t i = 0; i < cells; i++) {
        labels.values[i] = r.labels[i];
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, score_labels(&reference, &labels, files->map, &s, &error),
                                  error.text);
    run_free(&r);
    label_image_free(&labels);
    label_image_free(&reference);
    return s.all;
}

static double mean_agreement(const char *name)
{
    const roomseg_config config = roomseg_config_paper();
    dataset_set set = open_set(name);
    double sum = 0.0;
    for (size_t i = 0; i < set.count; i++) {
        metrics m = compare(&config, &set.maps[i]);
        printf("%s/%s: adjusted Rand index %.2f %%, no label on %.2f %%, %u rooms for %u\n", name,
               set.maps[i].name, m.ari * 100.0, m.under_painting * 100.0,
               (unsigned)m.rooms_found, (unsigned)m.rooms_true);
        /* Single borders are longer or shorter than the limit by a few cells, no more. */
        TEST_ASSERT_TRUE_MESSAGE(m.ari >= 0.88, set.maps[i].name);
        TEST_ASSERT_TRUE_MESSAGE(m.under_painting <= 0.02, set.maps[i].name);
        sum += m.ari;
    }
    sum /= (double)set.count;
    printf("%s: mean %.2f %%\n", name, sum * 100.0);
    dataset_set_free(&set);
    return sum;
}

static void test_labels_agree(void)
{
    TEST_ASSERT_TRUE(mean_agreement("furnished") >= 0.97);
    TEST_ASSERT_TRUE(mean_agreement("no_furniture") >= 0.97);
}

/* The reference lies in a frame of its own, so rooms are counted alone. */
static void test_homes_have_as_many_rooms(void)
{
    const roomseg_config config = roomseg_config_paper_home();
    dataset_set set = open_set("neato");
    int off = 0;
    for (size_t i = 0; i < set.count; i++) {
        metrics m = compare(&config, &set.maps[i]);
        int more = (int)m.rooms_found - (int)m.rooms_true;
        printf("neato/%s: %u rooms for %u\n", set.maps[i].name, (unsigned)m.rooms_found,
               (unsigned)m.rooms_true);
        TEST_ASSERT_INT_WITHIN_MESSAGE(2, 0, more, set.maps[i].name);
        off += abs(more);
    }
    TEST_ASSERT_LESS_OR_EQUAL_INT(8, off);
    dataset_set_free(&set);
}

int main(int argc, char **argv)
{
    if (argc != 2 || argv[1][0] == '\0') {
        puts("skipped: no real maps; configure with -DROOMSEG_BENCHMARK_DIR=FOLDER");
        return SKIPPED;
    }
    data_set = argv[1];
    char *reference = out_join(data_set, "reference");
    if (reference == NULL || !dataset_is_folder(reference)) {
        printf("skipped: %s has no folder 'reference'\n", data_set);
        return SKIPPED;
    }
    free(reference);
    UNITY_BEGIN();
    RUN_TEST(test_labels_agree);
    RUN_TEST(test_homes_have_as_many_rooms);
    return UNITY_END();
}
