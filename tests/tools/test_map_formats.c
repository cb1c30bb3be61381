/* Maps that must load: every format, its options and its odd but legal forms. */
#include <math.h>
#include <string.h>

#include "map.h"
#include "scratch.h"
#include "tiny_png.h"
#include "unity.h"

static map loaded;
static tool_error error;
static map_options options;

void setUp(void) {
    options = (map_options){0, 0};
    scratch_open();
}

void tearDown(void) {
    map_free(&loaded);
    scratch_close();
}

static void load(const char *path) {
    error.text[0] = '\0';
    int rc = map_load(path, &options, &loaded, &error);
    TEST_ASSERT_EQUAL_STRING("", error.text);
    TEST_ASSERT_EQUAL_INT(0, rc);
}

#define EXPECT_CELLS(w, h, ...)                                                                \
    do {                                                                                       \
        const uint8_t expected[] = {__VA_ARGS__};                                              \
        TEST_ASSERT_EQUAL_UINT32(w, loaded.width);                                             \
        TEST_ASSERT_EQUAL_UINT32(h, loaded.height);                                            \
        TEST_ASSERT_EQUAL_size_t((size_t)(w) * (h), sizeof expected);                          \
        TEST_ASSERT_EQUAL_UINT8_ARRAY(expected, loaded.cells, sizeof expected);                \
    } while (0)

static void expect_pose(double resolution_m, double x_m, double y_m, double yaw_rad) {
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, resolution_m, loaded.resolution_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, x_m, loaded.origin_x_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, y_m, loaded.origin_y_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, yaw_rad, loaded.origin_yaw_rad);
}

/* ---- PGM ---- */

static void test_binary_pgm_is_taken_as_it_stands(void) {
    const char bytes[] = "P5 3 2 255\n\x00\x7f\x80\xff\x33\x0a";
    load(scratch_write("a.pgm", bytes, sizeof bytes - 1));
    EXPECT_CELLS(3, 2, 0, 127, 128, 255, 51, 10);
    expect_pose(0.04, 0, 0, 0);
}

static void test_a_first_cell_that_is_a_blank_or_a_hash_belongs_to_the_cells(void) {
    const char bytes[] = "P5\n2 1\n255\n#\n";
    load(scratch_write("a.pgm", bytes, sizeof bytes - 1));
    EXPECT_CELLS(2, 1, '#', '\n');
}

static void test_wide_pgm_is_scaled_with_the_high_byte_first(void) {
    const char bytes[] = "P5 4 1 65535\n\x00\x00\x80\x00\xff\xff\x01\x01";
    load(scratch_write("a.pgm", bytes, sizeof bytes - 1));
    EXPECT_CELLS(4, 1, 0, 128, 255, 1);
}

static void test_text_pgm_with_comments_everywhere(void) {
    load(scratch_write_text("a.pgm", "P2#x\n# 9 9\n2 # width\n#height\n2\n100 #max\n0 50\n"
                                     "# between\n100 1# end\n"));
    EXPECT_CELLS(2, 2, 0, 128, 255, 3);
}

static void test_smallest_text_pgm_without_a_last_line_end(void) {
    load(scratch_write_text("a.pgm", "P2 1 1 1 1"));
    EXPECT_CELLS(1, 1, 255);
}

static void test_neato_comment_gives_resolution_and_origin(void) {
    load(scratch_write_text("a.pgm", "P5\n# Neato metadata: origin_x=-40000 origin_y=1250.5 "
                                     "resolution=50 alignment=1.535890\n1 1\n255\nA"));
    expect_pose(0.05, -40, 1.2505, 0);
    map_free(&loaded);
    options.resolution_m = 0.1;
    load(scratch_write_text("b.pgm", "P2 1 1 # Neato metadata: resolution=5\r\n255 7"));
    expect_pose(0.1, 0, 0, 0);
}

static void test_invert_makes_white_free(void) {
    options.invert = 1;
    load(scratch_write_text("a.pgm", "P2 3 1 255 0 100 255"));
    EXPECT_CELLS(3, 1, 255, 155, 0);
}

/* ---- PNG ---- */

static void load_png(tiny_png png) {
    load(scratch_write("a.png", png.bytes, png.size));
}

static void test_gray_png_of_each_depth(void) {
    const uint8_t row8[] = {0, 127, 255};
    load_png(tiny_png_make(3, 1, 8, PNG_GRAY, row8, 3, 1, NULL, 0));
    EXPECT_CELLS(3, 1, 0, 127, 255);
    map_free(&loaded);
    const uint8_t row16[] = {0, 0, 0x80, 0, 0xff, 0xff};
    load_png(tiny_png_make(3, 1, 16, PNG_GRAY, row16, 6, 1, NULL, 0));
    EXPECT_CELLS(3, 1, 0, 128, 255);
    map_free(&loaded);
    const uint8_t rows1[] = {0x40, 0xa0};
    load_png(tiny_png_make(3, 2, 1, PNG_GRAY, rows1, 1, 2, NULL, 0));
    EXPECT_CELLS(3, 2, 0, 255, 0, 255, 0, 255);
    map_free(&loaded);
    const uint8_t row2[] = {0x1b};
    load_png(tiny_png_make(4, 1, 2, PNG_GRAY, row2, 1, 1, NULL, 0));
    EXPECT_CELLS(4, 1, 0, 85, 170, 255);
}

static void test_png_whose_colours_are_all_gray(void) {
    const uint8_t palette[] = {0, 0, 0, 205, 205, 205, 254, 254, 254};
    const uint8_t indices[] = {2, 0, 1};
    load_png(tiny_png_make(3, 1, 8, PNG_PALETTE, indices, 3, 1, palette, 3));
    EXPECT_CELLS(3, 1, 254, 0, 205);
    map_free(&loaded);
    const uint8_t rgb[] = {9, 9, 9, 200, 200, 200};
    load_png(tiny_png_make(2, 1, 8, PNG_RGB, rgb, 6, 1, NULL, 0));
    EXPECT_CELLS(2, 1, 9, 200);
}

static void test_transparent_pixels_are_unknown(void) {
    const uint8_t row[] = {0, 255, 0, 254, 0, 0, 255, 255};
    load_png(tiny_png_make(4, 1, 8, PNG_GRAY_ALPHA, row, 8, 1, NULL, 0));
    EXPECT_CELLS(4, 1, 0, 127, 127, 255);
}

/* ---- map_server ---- */

#define YAML_HEAD "image: m.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0.5]\nnegate: 0\n"
#define YAML_THRESHOLDS "occupied_thresh: 0.65\nfree_thresh: 0.196\n"

/* 205 is what map_saver writes for unknown: p = 0.19608, just above free_thresh. */
static const char PIXELS[] = "P2 6 1 255 0 89 90 205 206 255";

static void load_yaml(const char *text) {
    scratch_write_text("m.pgm", PIXELS);
    load(scratch_write_text("m.yaml", text));
}

static void test_trinary_is_the_default(void) {
    load_yaml(YAML_HEAD YAML_THRESHOLDS);
    EXPECT_CELLS(6, 1, 255, 255, 127, 127, 0, 0);
    expect_pose(0.05, -1.5, 2, 0.5);
    map_free(&loaded);
    load_yaml(YAML_HEAD YAML_THRESHOLDS "mode: Trinary\n");
    EXPECT_CELLS(6, 1, 255, 255, 127, 127, 0, 0);
}

static void test_negate_turns_black_and_white_around(void) {
    load_yaml("image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: true\n" //
              YAML_THRESHOLDS);
    EXPECT_CELLS(6, 1, 0, 127, 127, 255, 255, 255);
}

static void test_scale_is_linear_between_the_thresholds(void) {
    load_yaml(YAML_HEAD "occupied_thresh: 0.8\nfree_thresh: 0.2\nmode: scale\n");
    /* p = 1, 0.65098, 0.64706, 0.19608, 0.19216, 0 */
    EXPECT_CELLS(6, 1, 255, 192, 190, 0, 0, 0);
}

static void test_scale_takes_transparency_as_unknown(void) {
    const uint8_t row[] = {0, 0, 100, 7, 100, 255};
    tiny_png png = tiny_png_make(3, 1, 8, PNG_GRAY_ALPHA, row, 6, 1, NULL, 0);
    scratch_write("m.pgm", png.bytes, png.size);
    load(scratch_write_text("m.yaml", YAML_HEAD "occupied_thresh: 1\nfree_thresh: 0\n"
                                                "mode: scale\n"));
    EXPECT_CELLS(3, 1, 127, 127, 155);
}

static void test_raw_pixels_are_percentages(void) {
    scratch_write_text("m.pgm", "P2 6 1 255 0 1 50 100 101 255");
    load(scratch_write_text("m.yaml", YAML_HEAD YAML_THRESHOLDS "mode: raw\n"));
    EXPECT_CELLS(6, 1, 0, 3, 128, 255, 127, 127);
}

static void test_yaml_forms(void) {
    static const char *const forms[] = {
        /* Quotes, comments, exponents, what nobody asked for. */
        "# map\nimage: 'm.pgm' # here\nresolution: 5.0e-02\norigin: [-1.5, 2., 0.5] # pose\n"
        "negate: 0\nvendor: {a: 1}\n" YAML_THRESHOLDS,
        /* A block list, a document mark, line ends of Windows, no last line end. */
        "---\r\nimage: \"m.pgm\"\r\nresolution: 0.05\r\norigin:\r\n- -1.5\r\n- 2\r\n- 0.5\r\n"
        "negate: false\r\noccupied_thresh: .65\r\nfree_thresh: 0.196\r\n...",
        /* Byte order mark, a list over several lines, indented items, a nested mapping. */
        "\xEF\xBB\xBFresolution : 0.05\norigin: [ -1.5,\n   2,\n 0.5 ]\nimage:   m.pgm  \n"
        "negate: 0\nextra:\n  deep: 1\n  deeper:\n    - x\nlist:\n  - a\n" YAML_THRESHOLDS,
    };
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        map_free(&loaded);
        load_yaml(forms[i]);
        EXPECT_CELLS(6, 1, 255, 255, 127, 127, 0, 0);
        expect_pose(0.05, -1.5, 2, 0.5);
    }
}

static void test_image_names_with_special_characters(void) {
    scratch_write_text("a b#c's.pgm", PIXELS);
    load(scratch_write_text("m.yaml", "image: 'a b#c''s.pgm'\nresolution: 0.05\n"
                                      "origin: [0, 0, 0]\nnegate: 0\n" YAML_THRESHOLDS));
    map_free(&loaded);
    load(scratch_write_text("m.yaml", "image: a b#c's.pgm\nresolution: 0.05\n"
                                      "origin: [0, 0, 0]\nnegate: 0\n" YAML_THRESHOLDS));
    EXPECT_CELLS(6, 1, 255, 255, 127, 127, 0, 0);
}

static void test_resolution_of_the_caller_wins(void) {
    options.resolution_m = 0.1;
    load_yaml(YAML_HEAD YAML_THRESHOLDS);
    expect_pose(0.1, -1.5, 2, 0.5);
}

static void test_resolutions_a_float_away_from_the_limits_are_within(void) {
    load_yaml("image: m.pgm\nresolution: 0.019999999553\norigin: [0, 0, 0]\nnegate: 0\n"
              YAML_THRESHOLDS);
    map_free(&loaded);
    load_yaml("image: m.pgm\nresolution: 0.20000000298\norigin: [0, 0, 0]\nnegate: 0\n"
              YAML_THRESHOLDS);
}

/* ---- the world ---- */

static void test_world_positions_count_from_the_lower_left_corner(void) {
    map m = {NULL, 10, 4, 0.5, 1, 2, 0};
    double x;
    double y;
    map_cell_to_world(&m, 0, 3, &x, &y); /* lower left cell */
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1.25, x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 2.25, y);
    map_cell_to_world(&m, 9, 0, &x, &y); /* upper right cell */
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 5.75, x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 3.75, y);
    m.origin_yaw_rad = acos(0); /* a quarter turn: right is up, up is left */
    map_cell_to_world(&m, 9, 3, &x, &y);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.75, x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 6.75, y);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_binary_pgm_is_taken_as_it_stands);
    RUN_TEST(test_a_first_cell_that_is_a_blank_or_a_hash_belongs_to_the_cells);
    RUN_TEST(test_wide_pgm_is_scaled_with_the_high_byte_first);
    RUN_TEST(test_text_pgm_with_comments_everywhere);
    RUN_TEST(test_smallest_text_pgm_without_a_last_line_end);
    RUN_TEST(test_neato_comment_gives_resolution_and_origin);
    RUN_TEST(test_invert_makes_white_free);
    RUN_TEST(test_gray_png_of_each_depth);
    RUN_TEST(test_png_whose_colours_are_all_gray);
    RUN_TEST(test_transparent_pixels_are_unknown);
    RUN_TEST(test_trinary_is_the_default);
    RUN_TEST(test_negate_turns_black_and_white_around);
    RUN_TEST(test_scale_is_linear_between_the_thresholds);
    RUN_TEST(test_scale_takes_transparency_as_unknown);
    RUN_TEST(test_raw_pixels_are_percentages);
    RUN_TEST(test_yaml_forms);
    RUN_TEST(test_image_names_with_special_characters);
    RUN_TEST(test_resolution_of_the_caller_wins);
    RUN_TEST(test_resolutions_a_float_away_from_the_limits_are_within);
    RUN_TEST(test_world_positions_count_from_the_lower_left_corner);
    return UNITY_END();
}
