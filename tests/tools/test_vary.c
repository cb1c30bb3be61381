/* Changed maps: what a turn, other cells, clutter and salt do to a map and its truth, and
 * that they do the same everywhere. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "scratch.h"
#include "unity.h"
#include "vary/vary.h"

enum { FREE_MAX = 51, WALL = 255 };

static scene made;
static tool_error error;

void setUp(void) {
    memset(&made, 0, sizeof made);
    error.text[0] = '\0';
    scratch_open();
}

void tearDown(void) {
    scene_free(&made);
    scratch_close();
}

static size_t cell_count(void) {
    return (size_t)made.m.width * made.m.height;
}

/* A scene of unknown cells without rooms. */
static void make(uint32_t width, uint32_t height, int resolution_mm) {
    size_t count = (size_t)width * height;
    scene_free(&made);
    made.m.cells = malloc(count);
    made.truth.values = calloc(count, sizeof *made.truth.values);
    TEST_ASSERT_NOT_NULL(made.m.cells);
    TEST_ASSERT_NOT_NULL(made.truth.values);
    memset(made.m.cells, MAP_UNKNOWN, count);
    made.m.width = made.truth.width = width;
    made.m.height = made.truth.height = height;
    made.m.resolution_m = resolution_mm / 1000.0;
}

static void fill(uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1, uint8_t value,
                 uint32_t room) {
    for (uint32_t y = y0; y < y1; y++) {
        for (uint32_t x = x0; x < x1; x++) {
            made.m.cells[(size_t)y * made.m.width + x] = value;
            made.truth.values[(size_t)y * made.m.width + x] = room;
        }
    }
}

/* Two rooms of 5 x 6 m with a wall of one cell and a door between them. */
static void make_two_rooms(void) {
    make(280, 170, 40);
    fill(9, 9, 271, 161, WALL, 0);
    fill(10, 10, 139, 160, 0, 1);
    fill(140, 10, 270, 160, 0, 2);
    fill(139, 70, 140, 90, 0, 1);
}

static uint8_t cell(uint32_t x, uint32_t y) {
    return made.m.cells[(size_t)y * made.m.width + x];
}

static uint32_t room(uint32_t x, uint32_t y) {
    return made.truth.values[(size_t)y * made.m.width + x];
}

static size_t count_cells(uint8_t value) {
    size_t count = 0;
    for (size_t i = 0; i < cell_count(); i++) {
        count += made.m.cells[i] == value;
    }
    return count;
}

static size_t count_room(uint32_t value) {
    size_t count = 0;
    for (size_t i = 0; i < cell_count(); i++) {
        count += made.truth.values[i] == value;
    }
    return count;
}

/* FNV-1a over the cells and the rooms. */
static uint32_t hash_of_scene(void) {
    uint32_t hash = 2166136261u;
    for (size_t i = 0; i < cell_count(); i++) {
        hash = (hash ^ made.m.cells[i]) * 16777619u;
        hash = (hash ^ made.truth.values[i]) * 16777619u;
    }
    return hash;
}

static void test_maps_are_cut_to_what_is_known(void) {
    static const uint8_t map_file[] = "P5 6 4 255\n\177\177\177\177\177\177"
                                      "\177\177\0\0\177\177"
                                      "\177\177\0\377\177\177"
                                      "\177\177\177\177\177\177";
    static const uint8_t truth_file[] = "P5 6 4 255\n\0\0\0\0\0\0"
                                        "\0\0\377\0\0\0"
                                        "\0\0\0\0\377\0"
                                        "\0\0\0\0\0\0";
    const map_options options = {0.05, 0};
    const char *map_path = scratch_write("m.pgm", map_file, sizeof map_file - 1);
    const char *truth_path = scratch_write("t.pgm", truth_file, sizeof truth_file - 1);
    TEST_ASSERT_EQUAL_INT(0, scene_load(map_path, truth_path, &options, &made, &error));
    TEST_ASSERT_EQUAL_UINT32(5, made.m.width);
    TEST_ASSERT_EQUAL_UINT32(4, made.m.height);
    TEST_ASSERT_EQUAL_INT(50, scene_resolution_mm(&made));
    TEST_ASSERT_EQUAL_UINT8(MAP_UNKNOWN, cell(0, 1));
    TEST_ASSERT_EQUAL_UINT8(0, cell(1, 1));
    TEST_ASSERT_EQUAL_UINT8(255, cell(2, 2));
    TEST_ASSERT_EQUAL_UINT32(1, room(1, 1));
    TEST_ASSERT_EQUAL_UINT32(2, room(3, 2)); /* a room on an unknown cell counts */
}

static void test_a_truth_of_another_size_is_refused(void) {
    const map_options options = {0.05, 0};
    const char *map_path = scratch_write_text("m.pgm", "P2 2 2 255 0 0 0 0");
    const char *truth_path = scratch_write_text("t.pgm", "P2 2 1 255 255 255");
    TEST_ASSERT_EQUAL_INT(-1, scene_load(map_path, truth_path, &options, &made, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "t.pgm: 2x1 cells, but the map has 2x2"));
    TEST_ASSERT_NULL(made.m.cells);
}

static void test_files_read_back_as_they_were(void) {
    char text[64];
    const map_options options = {0.0, 0};
    make_two_rooms();
    scratch_path("out/map.pgm");
    scratch_path("out/truth.pgm");
    const char *folder = scratch_path("out");
    TEST_ASSERT_EQUAL_INT(0, scene_write(&made, folder, &error));
    TEST_ASSERT_EQUAL_INT(1, scratch_read("out/map.pgm", text, sizeof text));
    TEST_ASSERT_EQUAL_INT(0, strncmp(text, "P5\n# Neato metadata: resolution=40\n", 35));
    scene_free(&made);
    TEST_ASSERT_EQUAL_INT(0, scene_load(scratch_path("out/map.pgm"),
                                        scratch_path("out/truth.pgm"), &options, &made,
                                        &error));
    TEST_ASSERT_EQUAL_UINT32(264, made.m.width);
    TEST_ASSERT_EQUAL_UINT32(154, made.m.height);
    TEST_ASSERT_EQUAL_INT(40, scene_resolution_mm(&made));
    TEST_ASSERT_EQUAL_UINT32(1, room(2, 2));
    TEST_ASSERT_EQUAL_UINT32(2, room(261, 151));
    TEST_ASSERT_EQUAL_UINT8(WALL, cell(1, 1));
}

static void test_quarter_turns_are_exact(void) {
    make(3, 2, 50);
    fill(0, 0, 1, 1, 10, 1);
    fill(2, 0, 3, 1, 20, 2);
    uint32_t before = hash_of_scene();
    TEST_ASSERT_EQUAL_INT(0, vary_turn(&made, 16384)); /* clockwise */
    TEST_ASSERT_EQUAL_UINT32(2, made.m.width);
    TEST_ASSERT_EQUAL_UINT32(3, made.truth.height);
    TEST_ASSERT_EQUAL_UINT8(10, cell(1, 0));
    TEST_ASSERT_EQUAL_UINT8(20, cell(1, 2));
    TEST_ASSERT_EQUAL_UINT32(2, room(1, 2));
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_INT(0, vary_turn(&made, 16384));
    }
    TEST_ASSERT_EQUAL_UINT32(before, hash_of_scene());
}

static void test_a_turn_keeps_areas_and_truth_together(void) {
    make_two_rooms();
    size_t free_cells = count_cells(0);
    size_t first = count_room(1);
    TEST_ASSERT_EQUAL_INT(0, vary_turn(&made, 16384 / 3));
    TEST_ASSERT_GREATER_THAN_UINT32(310, made.m.width); /* 280 cos 30 + 170 sin 30 = 327 */
    TEST_ASSERT_size_t_WITHIN(free_cells / 200, free_cells, count_cells(0));
    TEST_ASSERT_size_t_WITHIN(first / 200, first, count_room(1));
    for (size_t i = 0; i < cell_count(); i++) {
        TEST_ASSERT_EQUAL_INT(made.m.cells[i] == 0, made.truth.values[i] != 0);
    }
}

static void test_coarser_cells_keep_thin_walls_closed(void) {
    static const int coarser[] = {50, 65, 80, 100, 200};
    for (size_t i = 0; i < sizeof coarser / sizeof *coarser; i++) {
        make_two_rooms();
        TEST_ASSERT_EQUAL_INT(0, vary_resample(&made, coarser[i]));
        TEST_ASSERT_EQUAL_INT(coarser[i], scene_resolution_mm(&made));
        uint32_t wall_x = (2 * 139 + 1) * 40 / (2 * (uint32_t)coarser[i]);
        uint32_t top = 10 * 40 / (uint32_t)coarser[i];
        uint32_t door = 70 * 40 / (uint32_t)coarser[i];
        for (uint32_t y = top; y < door; y++) {
            TEST_ASSERT_EQUAL_UINT8(WALL, cell(wall_x, y));
        }
        TEST_ASSERT_EQUAL_UINT8(0, cell(wall_x, 80 * 40 / (uint32_t)coarser[i]));
        TEST_ASSERT_EQUAL_UINT32(1, room(wall_x - 1, door));
        TEST_ASSERT_EQUAL_UINT32(2, room(wall_x + 1, door));
    }
}

static void test_finer_cells_take_the_cell_they_lie_in(void) {
    make_two_rooms();
    size_t walls = count_cells(WALL);
    TEST_ASSERT_EQUAL_INT(0, vary_resample(&made, 40));
    TEST_ASSERT_EQUAL_size_t(walls, count_cells(WALL));
    TEST_ASSERT_EQUAL_INT(0, vary_resample(&made, 20));
    TEST_ASSERT_EQUAL_UINT32(560, made.m.width);
    TEST_ASSERT_EQUAL_size_t(4 * walls, count_cells(WALL));
    make_two_rooms();
    TEST_ASSERT_EQUAL_INT(0, vary_resample(&made, 25));
    TEST_ASSERT_EQUAL_UINT32(448, made.m.width);
    /* The wall from 139 to 140 cells of 40 mm covers 5560 to 5600 mm. */
    TEST_ASSERT_EQUAL_UINT8(0, cell(221, 30));
    TEST_ASSERT_EQUAL_UINT8(WALL, cell(222, 30));
    TEST_ASSERT_EQUAL_UINT8(WALL, cell(223, 30));
    TEST_ASSERT_EQUAL_UINT8(0, cell(224, 30));
}

static void test_salt_falls_on_known_cells_alone(void) {
    rng r;
    make_two_rooms();
    size_t unknown = count_cells(MAP_UNKNOWN);
    size_t rooms = count_room(2);
    uint32_t before = hash_of_scene();
    rng_seed(&r, 5, 2);
    vary_salt(&made, 0, &r);
    TEST_ASSERT_EQUAL_UINT32(before, hash_of_scene());
    size_t walls = count_cells(WALL);
    vary_salt(&made, 20000, &r);
    size_t known = cell_count() - unknown;
    TEST_ASSERT_size_t_WITHIN(known / 500, walls + known / 100, count_cells(WALL));
    vary_salt(&made, 1000000, &r);
    TEST_ASSERT_EQUAL_size_t(unknown, count_cells(MAP_UNKNOWN));
    TEST_ASSERT_size_t_WITHIN(known / 50, known / 2, count_cells(WALL));
    TEST_ASSERT_EQUAL_size_t(rooms, count_room(2));
}

static void test_clutter_stands_free_on_the_floor(void) {
    rng r;
    make_two_rooms();
    size_t floor_cells = count_cells(0);
    size_t walls = count_cells(WALL);
    rng_seed(&r, 1, 1);
    TEST_ASSERT_EQUAL_UINT32(0, vary_clutter(&made, FREE_MAX, 0, &r));
    TEST_ASSERT_EQUAL_size_t(walls, count_cells(WALL));
    uint32_t pieces = vary_clutter(&made, FREE_MAX, 300, &r);
    TEST_ASSERT_EQUAL_UINT32(floor_cells * 16 * 3 / 100000, pieces); /* 0.3 a m2 */
    size_t covered = count_cells(WALL) - walls;
    TEST_ASSERT_GREATER_OR_EQUAL_size_t(pieces * 6u * 6u, covered);
    TEST_ASSERT_LESS_OR_EQUAL_size_t(pieces * 14u * 14u, covered);
    for (uint32_t y = 10; y < 160; y++) { /* three cells along the outer walls stay free */
        TEST_ASSERT_EQUAL_UINT8(0, cell(12, y));
        TEST_ASSERT_EQUAL_UINT8(0, cell(267, y));
    }
    TEST_ASSERT_EQUAL_size_t(floor_cells, count_room(1) + count_room(2));
    /* More than fits ends all the same. */
    TEST_ASSERT_LESS_THAN_UINT32(2000, vary_clutter(&made, FREE_MAX, 50000, &r));
}

static void test_the_same_bits_everywhere(void) {
    rng r;
    make_two_rooms();
    rng_seed(&r, 7, 1);
    vary_clutter(&made, FREE_MAX, 300, &r);
    TEST_ASSERT_EQUAL_INT(0, vary_turn(&made, 3095));
    TEST_ASSERT_EQUAL_INT(0, vary_resample(&made, 65));
    vary_salt(&made, 10000, &r);
    TEST_ASSERT_EQUAL_HEX32(0x9ae59921, hash_of_scene());
}

static void test_scenes_that_would_be_too_large(void) {
    make(60000, 20, 200);
    TEST_ASSERT_EQUAL_INT(-1, vary_resample(&made, 20));
    TEST_ASSERT_EQUAL_UINT32(60000, made.m.width);
    TEST_ASSERT_EQUAL_INT(200, scene_resolution_mm(&made));
    TEST_ASSERT_EQUAL_INT(-1, vary_turn(&made, 8192));
    TEST_ASSERT_EQUAL_UINT32(20, made.m.height);
}

static int vary(const char *option, const char *value, const char *folder) {
    char texts[6][256];
    char *argv[7] = {NULL};
    const char *const words[] = {"vary", folder, "-o", scratch_path("out"), option, value};
    for (int i = 0; i < 6; i++) {
        snprintf(texts[i], sizeof texts[i], "%s", words[i]);
        argv[i] = texts[i];
    }
    return cmd_vary(6, argv);
}

static void test_the_command(void) {
    static const char MAP[] = "P2 3 2 255 0 0 255 0 0 127";
    char text[64];
    char folder[256];
    scratch_path("out"); /* removed in reverse order */
    scratch_path("out/a");
    snprintf(folder, sizeof folder, "%s", scratch_write_text("a.pgm", MAP));
    *strrchr(folder, '/') = '\0';
    TEST_ASSERT_EQUAL_INT(EXIT_WRONG_USAGE, vary("--turn", "400", folder));
    TEST_ASSERT_EQUAL_INT(EXIT_WRONG_USAGE, vary("--cells", "0.3", folder));
    TEST_ASSERT_EQUAL_INT(EXIT_WRONG_USAGE, vary("--salt", "101", folder));
    TEST_ASSERT_EQUAL_INT(EXIT_WRONG_USAGE, vary("--clutter", "-1", folder));
    TEST_ASSERT_EQUAL_INT(EXIT_WRONG_USAGE, vary("--seed", "x", folder));
    TEST_ASSERT_EQUAL_INT(EXIT_BAD_INPUT, vary("--set", "b", folder));
    TEST_ASSERT_EQUAL_INT(EXIT_BAD_INPUT, vary("--turn", "5", scratch_path("missing")));
    TEST_ASSERT_EQUAL_INT(0, scratch_read("out/a/map.pgm", text, sizeof text));
    TEST_ASSERT_EQUAL_INT(EXIT_DONE, vary("--cells", "0.08", folder));
    TEST_ASSERT_EQUAL_INT(1, scratch_read("out/a/map.pgm", text, sizeof text));
    TEST_ASSERT_EQUAL_INT(0, strncmp(text, "P5\n# Neato metadata: resolution=80\n", 35));
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_maps_are_cut_to_what_is_known);
    RUN_TEST(test_a_truth_of_another_size_is_refused);
    RUN_TEST(test_files_read_back_as_they_were);
    RUN_TEST(test_quarter_turns_are_exact);
    RUN_TEST(test_a_turn_keeps_areas_and_truth_together);
    RUN_TEST(test_coarser_cells_keep_thin_walls_closed);
    RUN_TEST(test_finer_cells_take_the_cell_they_lie_in);
    RUN_TEST(test_salt_falls_on_known_cells_alone);
    RUN_TEST(test_clutter_stands_free_on_the_floor);
    RUN_TEST(test_the_same_bits_everywhere);
    RUN_TEST(test_scenes_that_would_be_too_large);
    RUN_TEST(test_the_command);
    return UNITY_END();
}
