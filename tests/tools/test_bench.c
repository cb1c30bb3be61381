/* What a benchmark is made of: finding maps, setting fields, means and deviations. */
#include <stdio.h>
#include <string.h>

#include "bench_result.h"
#include "config_option.h"
#include "dataset.h"
#include "out.h"
#include "scratch.h"
#include "unity.h"

void setUp(void) {
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

static void make_folder(const char *place) {
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, out_make_folder(scratch_path(place), &error), error.text);
}

static void make_file(const char *place) {
    scratch_write_text(place, "");
}

static void assert_map(const dataset_set *set, size_t index, const char *name,
                       const char *map, const char *truth) {
    TEST_ASSERT_LESS_THAN_size_t(set->count, index);
    TEST_ASSERT_EQUAL_STRING(name, set->maps[index].name);
    TEST_ASSERT_EQUAL_STRING(scratch_path(map), set->maps[index].map);
    if (truth == NULL) {
        TEST_ASSERT_NULL(set->maps[index].truth);
    } else {
        TEST_ASSERT_EQUAL_STRING(scratch_path(truth), set->maps[index].truth);
    }
}

static dataset open_top(void) {
    dataset data;
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, dataset_open(scratch_folder(), &data, &error), error.text);
    return data;
}

static void test_sets_in_folders_share_the_groundtruth(void) {
    make_folder("groundtruth");
    make_file("groundtruth/a.png");
    make_file("groundtruth/b.pgm");
    make_folder("one");
    make_file("one/a.png");
    make_file("one/b.yaml");
    make_file("one/b.pgm");
    make_file("one/notes.txt");
    make_file("one/.c.png");
    make_folder("two");
    make_file("two/a.pgm");
    dataset data = open_top();
    TEST_ASSERT_EQUAL_size_t(2, data.count);
    TEST_ASSERT_EQUAL_STRING("one", data.sets[0].name);
    TEST_ASSERT_EQUAL_size_t(2, data.sets[0].count);
    assert_map(&data.sets[0], 0, "a", "one/a.png", "groundtruth/a.png");
    assert_map(&data.sets[0], 1, "b", "one/b.yaml", "groundtruth/b.pgm");
    TEST_ASSERT_EQUAL_STRING("two", data.sets[1].name);
    TEST_ASSERT_EQUAL_size_t(1, data.sets[1].count);
    assert_map(&data.sets[1], 0, "a", "two/a.pgm", "groundtruth/a.png");
    dataset_free(&data);
}

static void test_a_folder_per_map_holds_its_truth(void) {
    make_folder("s1");
    make_file("s1/map.pgm");
    make_file("s1/map.png");
    make_file("s1/truth.pgm");
    make_folder("s2");
    make_file("s2/map.png");
    make_file("x.pgm");
    dataset data = open_top();
    TEST_ASSERT_EQUAL_size_t(1, data.count);
    TEST_ASSERT_EQUAL_STRING(scratch_folder(), data.sets[0].name);
    TEST_ASSERT_EQUAL_size_t(3, data.sets[0].count);
    assert_map(&data.sets[0], 0, "s1", "s1/map.pgm", "s1/truth.pgm");
    assert_map(&data.sets[0], 1, "s2", "s2/map.png", NULL);
    assert_map(&data.sets[0], 2, "x", "x.pgm", NULL);
    dataset_free(&data);
}

static void test_the_folder_of_one_map_is_a_set_of_its_own(void) {
    make_folder("s1");
    make_file("s1/map.pgm");
    make_file("s1/truth.pgm");
    dataset data;
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT(0, dataset_open(scratch_path("s1"), &data, &error));
    TEST_ASSERT_EQUAL_size_t(1, data.count);
    TEST_ASSERT_EQUAL_STRING("s1", data.sets[0].name);
    TEST_ASSERT_EQUAL_size_t(1, data.sets[0].count);
    assert_map(&data.sets[0], 0, "s1", "s1/map.pgm", "s1/truth.pgm");
    dataset_free(&data);
}

static void test_folders_without_maps_are_refused(void) {
    dataset data;
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT(-1, dataset_open(scratch_folder(), &data, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, scratch_folder()));
    TEST_ASSERT_EQUAL_INT(-1, dataset_open(scratch_path("missing"), &data, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, scratch_path("missing")));
    TEST_ASSERT_NULL(data.sets);
}

static void test_images_are_paired_by_name(void) {
    make_folder("groundtruth");
    make_file("groundtruth/a.png");
    make_folder("one");
    make_file("one/a.png");
    make_file("one/b.pgm");
    dataset_set set;
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT(0, dataset_pair(scratch_path("one"), scratch_path("groundtruth"), &set,
                                          &error));
    TEST_ASSERT_EQUAL_size_t(2, set.count);
    assert_map(&set, 0, "a", "one/a.png", "groundtruth/a.png");
    assert_map(&set, 1, "b", "one/b.pgm", NULL);
    dataset_set_free(&set);
}

static void test_config_options_leave_the_other_arguments(void) {
    char words[][24] = {"bench",  "--config",          "clutter_mm=500", "folder", "--json",
                        "--config=free_max=7", "--", "--config"};
    char *argv[8];
    int argc = 8;
    for (int i = 0; i < argc; i++) {
        argv[i] = words[i];
    }
    roomseg_config config = roomseg_config_default();
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT(0, config_take_options(&argc, argv, &config, &error));
    TEST_ASSERT_EQUAL_INT(5, argc);
    TEST_ASSERT_EQUAL_STRING("folder", argv[1]);
    TEST_ASSERT_EQUAL_STRING("--json", argv[2]);
    TEST_ASSERT_EQUAL_STRING("--config", argv[4]);
    TEST_ASSERT_EQUAL_UINT(500, config.clutter_mm);
    TEST_ASSERT_EQUAL_UINT(7, config.free_max);
    TEST_ASSERT_EQUAL_UINT(roomseg_config_default().max_rooms, config.max_rooms);
}

static void assert_refused(const char *text) {
    char word[64];
    snprintf(word, sizeof word, "--config=%s", text);
    char *argv[1] = {word};
    int argc = 1;
    roomseg_config config = roomseg_config_default();
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT_MESSAGE(-1, config_take_options(&argc, argv, &config, &error), text);
    TEST_ASSERT_NOT_NULL(strstr(error.text, "--config"));
}

static void test_config_options_that_make_no_sense_are_refused(void) {
    assert_refused("");
    assert_refused("=1");
    assert_refused("progress=1");
    assert_refused("max_room=1");
    assert_refused("max_roomss=1");
    assert_refused("max_rooms");
    assert_refused("max_rooms=");
    assert_refused("max_rooms=x");
    assert_refused("max_rooms=1.5");
    assert_refused("max_rooms=-1");
    assert_refused("max_rooms=4294967296");
    assert_refused("free_max=256");
}

static void test_means_leave_failed_maps_out(void) {
    set_result set;
    TEST_ASSERT_EQUAL_INT(0, set_result_open(&set, "set"));
    for (int i = 0; i < 40; i++) { /* more than the first allocation holds */
        map_result *result = set_result_add(&set, "map");
        TEST_ASSERT_NOT_NULL(result);
        result->has_score = i < 2;
        result->score.all.rooms_true = 1;
        result->score.all.v = i == 0 ? 0.25 : 0.75;
        result->has_cost = i < 3;
        result->time_ms = 3.0 * i;
        result->arena_bytes = 100;
        result->crop_cells = i == 2 ? 0 : 50;
        if (i >= 3) {
            result->has_score = 1;
            tool_error_set(&result->failure, "broken");
        }
    }
    spread v = result_spread(&set, METRIC_V, 0);
    TEST_ASSERT_EQUAL_size_t(2, v.count);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.5, v.mean);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.353553390593274, v.deviation);
    spread time = result_spread(&set, RESULT_TIME_MS, 0);
    TEST_ASSERT_EQUAL_size_t(3, time.count);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 3.0, time.mean);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 3.0, time.deviation);
    TEST_ASSERT_EQUAL_size_t(2, result_spread(&set, RESULT_BYTES_PER_CELL, 0).count);
    TEST_ASSERT_EQUAL_size_t(0, result_spread(&set, METRIC_V, 1).count); /* specks alone */
    TEST_ASSERT_EQUAL_size_t(37, result_failures(&set));
    set_result_free(&set);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_sets_in_folders_share_the_groundtruth);
    RUN_TEST(test_a_folder_per_map_holds_its_truth);
    RUN_TEST(test_the_folder_of_one_map_is_a_set_of_its_own);
    RUN_TEST(test_folders_without_maps_are_refused);
    RUN_TEST(test_images_are_paired_by_name);
    RUN_TEST(test_config_options_leave_the_other_arguments);
    RUN_TEST(test_config_options_that_make_no_sense_are_refused);
    RUN_TEST(test_means_leave_failed_maps_out);
    return UNITY_END();
}
