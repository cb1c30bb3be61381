/* What the explain command writes: all files are there and whole, the page needs nothing else. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base64.h"
#include "commands.h"
#include "explain_flat.h"
#include "explanation.h"
#include "infile.h"
#include "out.h"
#include "page.h"
#include "png_check.h"
#include "scratch.h"
#include "sheet_row.h"
#include "unity.h"

static tool_error error;

void setUp(void) {
    error.text[0] = '\0';
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

/* The whole file, ended by a zero; to be freed. */
static char *read_whole(const char *path, size_t *size) {
    unsigned char *bytes;
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, infile_read(path, &bytes, size, &error), path);
    char *text = realloc(bytes, *size + 1);
    TEST_ASSERT_NOT_NULL(text);
    text[*size] = '\0';
    return text;
}

/* A PNG of the wanted size (0: any) that the page holds byte by byte. */
static void check_picture(const char *path, const char *page, uint32_t width, uint32_t height) {
    size_t size;
    png_info info;
    char *bytes = read_whole(path, &size);
    TEST_ASSERT_NULL_MESSAGE(png_check((unsigned char *)bytes, size, &info), path);
    TEST_ASSERT_TRUE(width == 0 || info.width == width);
    TEST_ASSERT_TRUE(height == 0 || info.height == height);
    const char *copy = scratch_path("base64");
    FILE *stream = fopen(copy, "wb");
    TEST_ASSERT_NOT_NULL(stream);
    base64_write(stream, bytes, size);
    fclose(stream);
    free(bytes);
    char *digits = read_whole(copy, &size);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(page, digits), path);
    free(digits);
    remove(copy);
}

/* Nothing on the page comes from elsewhere, and nothing runs. */
static void check_page(const char *page) {
    static const char *const banned[] = {"http", "<script", "<link", "url(", "@import", "href",
                                         "srcset", "<iframe", "onload"};
    static const char embedded[] = "src=\"data:image/png;base64,iVBOR";
    int images = 0;
    for (const char *at = strstr(page, "src="); at != NULL; at = strstr(at + 1, "src=")) {
        TEST_ASSERT_EQUAL_INT(0, strncmp(at, embedded, sizeof embedded - 1));
        images++;
    }
    TEST_ASSERT_TRUE(images > 5);
    for (size_t i = 0; i < sizeof banned / sizeof banned[0]; i++) {
        TEST_ASSERT_NULL_MESSAGE(strstr(page, banned[i]), banned[i]);
    }
    TEST_ASSERT_NOT_NULL(strstr(page, "prefers-color-scheme:dark"));
    TEST_ASSERT_NOT_NULL(strstr(page, "width=device-width"));
    TEST_ASSERT_NOT_NULL(strstr(page, "</html>"));
}

#define MAX_WORDS 16

/* Runs the command; words end with NULL. */
static int explain(const char *const *words) {
    char copies[MAX_WORDS][200];
    char *argv[MAX_WORDS + 1];
    int argc = 0;
    for (; words[argc] != NULL; argc++) {
        snprintf(copies[argc], sizeof copies[argc], "%s", words[argc]);
        argv[argc] = copies[argc];
    }
    argv[argc] = NULL;
    return cmd_explain(argc, argv);
}

/* Expected files of a folder: names, and no others. */
static void check_files(const char *folder, const char *const *names, const char *page_name,
                        uint32_t width, uint32_t height) {
    char path[64];
    size_t size;
    int count = 0;
    snprintf(path, sizeof path, "%s/%s", folder, page_name);
    char *page = read_whole(scratch_path(path), &size);
    check_page(page);
    for (; names[count] != NULL; count++) {
        int any = strstr(names[count], "rooms.png") != NULL ||
                  strstr(names[count], "directions") != NULL ||
                  strstr(names[count], "turned") != NULL;
        snprintf(path, sizeof path, "%s/%s", folder, names[count]);
        check_picture(scratch_path(path), page, any ? 0 : width, any ? 0 : height);
    }
    free(page);
}

/* The crop of the flat is 179 x 100 cells, with a margin of 4 on each side: 7 pixels a cell. */
enum { PICTURE_WIDTH = 7 * 187, PICTURE_HEIGHT = 7 * 108 };

static void test_default_profile_writes_all_files(void) {
    static const char *const names[] = {
        "01_map.png",    "02_threshold.png",    "03_small_obstacles.png", "04_distance.png",
        "05_regions.png", "06_shared_walls.png", "07_graph.png",           "08_merged.png",
        "09_dropped.png", "10_rooms.png",        "11_truth.png",
        "12_rooms_and_truth.png", NULL};
    map m = explain_flat();
    const char *path = explain_flat_write("flat.pgm", &m);
    explain_flat_truth(&m);
    const char *truth = explain_flat_write("truth.pgm", &m);
    const char *folder = scratch_path("out");
    const char *words[] = {"explain", path, "-o", folder, "--truth", truth, "--resolution",
                           "0.05", NULL};
    TEST_ASSERT_EQUAL_INT(EXIT_DONE, explain(words));
    check_files("out", names, "explain.html", PICTURE_WIDTH, PICTURE_HEIGHT);
    map_free(&m);
}

static void test_paper_profile_writes_all_files(void) {
    static const char *const names[] = {
        "01_map.png",         "02_edges.png",       "03_lines.png",      "04_directions.png",
        "05_turned.png",      "06_threshold.png",   "07_free_parts.png",
        "08_small_obstacles.png", "09_seed_map_1.png", "10_seed_map_2.png",
        "11_seed_map_3.png",  "12_seed_map_4.png",  "13_seed_map_5.png", "14_seed_map_6.png",
        "15_seed_map_7.png",  "16_seed_map_8.png",  "17_lifetime.png",   "18_seeds.png",
        "19_ridge.png",       "20_regions.png",     "21_graph_before.png",
        "22_graph_after.png", "23_rooms.png",       NULL};
    map m = explain_flat();
    const char *path = explain_flat_write("flat.pgm", &m);
    const char *folder = scratch_path("out");
    const char *words[] = {"explain", path, "-o", folder, "--profile", "paper", "--resolution",
                           "0.05", NULL};
    TEST_ASSERT_EQUAL_INT(EXIT_DONE, explain(words));
    check_files("out", names, "explain.html", PICTURE_WIDTH, PICTURE_HEIGHT);
    map_free(&m);
}

static void test_turned_map_is_explained_as_turned(void) {
    static const char *const names[] = {
        "01_map.png",      "02_edges.png",     "03_lines.png",
        "04_directions.png", "05_turned.png",  "06_threshold.png",
        "07_small_obstacles.png", "08_distance.png", "09_regions.png",
        "10_shared_walls.png", "11_graph.png", "12_merged.png",
        "13_dropped.png",  "14_rooms.png",     NULL};
    map m = explain_flat_turned(20);
    const char *path = explain_flat_write("flat.pgm", &m);
    const char *folder = scratch_path("out");
    const char *words[] = {"explain", path, "-o", folder, "--align", "--resolution", "0.05", NULL};
    explanation e;
    roomseg_config config = roomseg_config_default();
    map_options options = {0.05, 0};
    config.align = ROOMSEG_ALIGN_ON;
    TEST_ASSERT_EQUAL_INT(0, explanation_make(path, &options, &config, NULL, &e, &error));
    TEST_ASSERT_TRUE(e.is_turned);
    TEST_ASSERT_EQUAL_UINT32(3, e.s.result.room_count);
    TEST_ASSERT_EQUAL_UINT32(3, e.o.s.result.room_count);
    explanation_free(&e);
    TEST_ASSERT_EQUAL_INT(EXIT_DONE, explain(words));
    check_files("out", names, "explain.html", 0, 0);
    map_free(&m);
}

/* ---- sheet ---- */

static void test_sheet_of_a_data_set(void) {
    static const char *const names[] = {"01_set.png", NULL};
    char path[64];
    map m = explain_flat();
    const char *set = scratch_path("set");
    const char *keep = scratch_path("set/groundtruth");
    TEST_ASSERT_EQUAL_INT(0, out_make_folder(keep, &error));
    explain_flat_write("set/one.pgm", &m);
    explain_flat_write("set/two.pgm", &m);
    explain_flat_truth(&m);
    explain_flat_write("set/groundtruth/one.pgm", &m);
    const char *folder = scratch_path("out");
    const char *words[] = {"explain", "--sheet", set, "-o", folder, NULL};
    TEST_ASSERT_EQUAL_INT(EXIT_DONE, explain(words));
    snprintf(path, sizeof path, "out/%s", names[0]);
    size_t size;
    png_info info;
    char *bytes = read_whole(scratch_path(path), &size);
    TEST_ASSERT_NULL(png_check((unsigned char *)bytes, size, &info));
    TEST_ASSERT_EQUAL_UINT32(16 + 4 * (SHEET_CELL_WIDTH + 16), info.width);
    free(bytes);
    char *page = read_whole(scratch_path("out/sheet.html"), &size);
    check_page(page);
    TEST_ASSERT_NOT_NULL(strstr(page, "<h3>two</h3>"));
    TEST_ASSERT_NOT_NULL(strstr(page, "<b>default</b> v 100.0   3 rooms"));
    free(page);
    map_free(&m);
}

/* ---- pieces ---- */

/* RFC 4648, section 10. */
static void test_base64(void) {
    static const char *const vectors[][2] = {{"", ""},         {"f", "Zg=="},
                                             {"fo", "Zm8="},   {"foo", "Zm9v"},
                                             {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++) {
        char text[32] = "";
        const char *path = scratch_path("base64");
        FILE *stream = fopen(path, "wb");
        TEST_ASSERT_NOT_NULL(stream);
        base64_write(stream, vectors[i][0], strlen(vectors[i][0]));
        fclose(stream);
        scratch_read("base64", text, sizeof text);
        TEST_ASSERT_EQUAL_STRING(vectors[i][1], text);
    }
}

/* A name that looks like markup is text. */
static void test_names_are_no_markup(void) {
    char text[8192] = "";
    FILE *stream = fopen(scratch_path("page.html"), "wb");
    TEST_ASSERT_NOT_NULL(stream);
    page_begin(stream, "a<b>&\"c\xC3\xA9\xFF.pgm");
    fclose(stream);
    scratch_read("page.html", text, sizeof text);
    TEST_ASSERT_NOT_NULL(
        strstr(text, "<h1>a&#60;b&#62;&#38;&#34;c\xC3\xA9\xEF\xBF\xBD.pgm</h1>"));
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_default_profile_writes_all_files);
    RUN_TEST(test_paper_profile_writes_all_files);
    RUN_TEST(test_turned_map_is_explained_as_turned);
    RUN_TEST(test_sheet_of_a_data_set);
    RUN_TEST(test_base64);
    RUN_TEST(test_names_are_no_markup);
    return UNITY_END();
}
