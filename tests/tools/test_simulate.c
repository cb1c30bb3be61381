/* The simulator: the same bits everywhere, a truth that fits its map, options that do what
 * they say, files that the tools read back. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "map.h"
#include "scratch.h"
#include "simulate/rng.h"
#include "simulate/simulate.h"
#include "simulate/turn.h"
#include "unity.h"

enum { FREE = 63 /* the truth covers cells up to this value */ };

static sim_map made;

void setUp(void) {
    memset(&made, 0, sizeof made);
    scratch_open();
}

void tearDown(void) {
    sim_map_free(&made);
    scratch_close();
}

static sim_options small_flat(uint64_t seed) {
    sim_options options = sim_options_default();
    options.seed = seed;
    options.size = FLAT_SMALL;
    return options;
}

static void make(const sim_options *options) {
    sim_map_free(&made);
    TEST_ASSERT_EQUAL_INT(0, sim_run(options, &made));
}

static size_t cell_count(void) {
    return (size_t)made.width * made.height;
}

/* FNV-1a over the size, the cells and the truth. */
static uint64_t hash_of_map(void) {
    const uint8_t size[4] = {(uint8_t)(made.width & 255), (uint8_t)(made.width >> 8),
                             (uint8_t)(made.height & 255), (uint8_t)(made.height >> 8)};
    const uint8_t *const parts[3] = {size, made.cells, made.truth};
    const size_t lengths[3] = {sizeof size, cell_count(), cell_count()};
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < 3; i++) {
        for (size_t k = 0; k < lengths[i]; k++) {
            hash = (hash ^ parts[i][k]) * UINT64_C(0x100000001b3);
        }
    }
    return hash;
}

static void assert_hash(const sim_options *options, const char *expected) {
    char text[20];
    make(options);
    snprintf(text, sizeof text, "%016" PRIx64, hash_of_map());
    TEST_ASSERT_EQUAL_STRING(expected, text);
}

/* These three change with every change of the simulator, and then only: take over what the
 * test prints, and make the golden maps anew. */
static void same_bits_on_every_machine(void) {
    sim_options options = small_flat(1);
    assert_hash(&options, "dbe7fed64c7faeda");
    options.furnished = 0;
    options.noise = 100;
    options.resolution_mm = 33;
    options.has_turn = 1;
    options.turn = TURN_DEGREES(-77);
    assert_hash(&options, "a2c5985fb851c432");
    options = sim_options_default();
    options.seed = UINT64_MAX;
    options.clutter = 100;
    assert_hash(&options, "4a913d55976fff4f");
}

static void seeds_differ(void) {
    sim_options options = small_flat(2);
    make(&options);
    uint64_t first = hash_of_map();
    options.seed = 3;
    make(&options);
    TEST_ASSERT_TRUE(hash_of_map() != first);
}

/* Cells of the largest 4-connected piece of a room; each cell is visited once and its
 * truth replaced by 0. */
static size_t largest_piece(uint8_t *truth, uint8_t room, size_t *queue) {
    size_t best = 0;
    size_t width = made.width;
    for (size_t start = 0; start < cell_count(); start++) {
        size_t head = 0;
        size_t tail = 0;
        if (truth[start] == room) {
            truth[start] = 0;
            queue[tail++] = start;
        }
        while (head < tail) {
            size_t cell = queue[head++];
            /* The border around a map is never free, so all neighbours exist. */
            const size_t next[4] = {cell - 1, cell + 1, cell - width, cell + width};
            for (int i = 0; i < 4; i++) {
                if (truth[next[i]] == room) {
                    truth[next[i]] = 0;
                    queue[tail++] = next[i];
                }
            }
        }
        best = tail > best ? tail : best;
    }
    return best;
}

static void assert_truth_fits(void) {
    size_t cells_of[256] = {0};
    size_t free_cells = 0;
    for (size_t i = 0; i < cell_count(); i++) {
        TEST_ASSERT_LESS_OR_EQUAL_INT(made.room_count, made.truth[i]);
        TEST_ASSERT_TRUE(made.truth[i] == 0 || made.cells[i] <= FREE);
        free_cells += made.cells[i] <= FREE;
        cells_of[made.truth[i]]++;
    }
    size_t in_rooms = cell_count() - cells_of[0];
    TEST_ASSERT_GREATER_THAN_size_t(free_cells * 7 / 10, in_rooms);
    uint8_t *copy = malloc(cell_count());
    size_t *queue = malloc(cell_count() * sizeof *queue);
    TEST_ASSERT_TRUE(copy != NULL && queue != NULL);
    memcpy(copy, made.truth, cell_count());
    size_t square_metre = (size_t)(1000000 / (made.resolution_mm * made.resolution_mm));
    for (int room = 1; room <= made.room_count; room++) {
        TEST_ASSERT_GREATER_THAN_size_t(square_metre * 8 / 10, cells_of[room]);
        TEST_ASSERT_GREATER_THAN_size_t(cells_of[room] * 8 / 10,
                                        largest_piece(copy, (uint8_t)room, queue));
    }
    free(copy);
    free(queue);
}

static void truth_fits_the_map(void) {
    for (uint64_t seed = 20; seed < 26; seed++) {
        sim_options options = small_flat(seed);
        options.size = seed % 3 == 0 ? FLAT_MEDIUM : FLAT_SMALL;
        options.furnished = seed % 2 == 0;
        make(&options);
        TEST_ASSERT_GREATER_OR_EQUAL_INT(2, made.room_count);
        assert_truth_fits();
    }
}

static void map_has_free_occupied_and_unknown_cells(void) {
    sim_options options = small_flat(4);
    make(&options);
    size_t count[3] = {0, 0, 0};
    for (size_t i = 0; i < cell_count(); i++) {
        count[0] += made.cells[i] == 0;
        count[1] += made.cells[i] == 255;
        count[2] += made.cells[i] == 128;
    }
    TEST_ASSERT_GREATER_THAN_size_t(cell_count() / 10, count[0]);
    TEST_ASSERT_GREATER_THAN_size_t(cell_count() / 100, count[1]);
    TEST_ASSERT_GREATER_THAN_size_t(cell_count() / 10, count[2]);
}

static size_t free_cells_of(const sim_options *options) {
    size_t count = 0;
    make(options);
    for (size_t i = 0; i < cell_count(); i++) {
        count += made.truth[i] != 0;
    }
    return count;
}

static void furniture_takes_floor_and_changes_no_room(void) {
    sim_options options = small_flat(5);
    size_t furnished = free_cells_of(&options);
    int rooms = made.room_count;
    options.furnished = 0;
    size_t empty = free_cells_of(&options);
    TEST_ASSERT_EQUAL_INT(rooms, made.room_count);
    TEST_ASSERT_LESS_THAN_size_t(empty * 95 / 100, furnished);
}

static void resolution_and_turn_keep_the_floor(void) {
    sim_options options = small_flat(6);
    options.furnished = 0;
    double area = (double)free_cells_of(&options) * 50 * 50;
    options.resolution_mm = 100;
    double coarse = (double)free_cells_of(&options) * 100 * 100;
    options.resolution_mm = 50;
    options.has_turn = 1;
    options.turn = TURN_DEGREES(61);
    double turned = (double)free_cells_of(&options) * 50 * 50;
    TEST_ASSERT_DOUBLE_WITHIN(area * 0.12, area, coarse);
    TEST_ASSERT_DOUBLE_WITHIN(area * 0.05, area, turned);
}

static void options_out_of_range_fail(void) {
    sim_options options = small_flat(1);
    options.resolution_mm = 19;
    TEST_ASSERT_EQUAL_INT(-1, sim_run(&options, &made));
    options = small_flat(1);
    options.clutter = 101;
    TEST_ASSERT_EQUAL_INT(-1, sim_run(&options, &made));
    options = small_flat(1);
    options.noise = -1;
    TEST_ASSERT_EQUAL_INT(-1, sim_run(&options, &made));
    TEST_ASSERT_NULL(made.cells);
}

static void sines_are_exact(void) {
    TEST_ASSERT_EQUAL_INT32(0, turn_sin(0));
    TEST_ASSERT_EQUAL_INT32(65536, turn_sin(TURN_QUARTER));
    TEST_ASSERT_EQUAL_INT32(-65536, turn_cos(TURN_FULL / 2));
    TEST_ASSERT_INT32_WITHIN(1, 46341, turn_sin(TURN_FULL / 8));
    TEST_ASSERT_INT32_WITHIN(1, -46341, turn_sin(-TURN_FULL / 8));
    for (int32_t angle = -TURN_FULL; angle <= 2 * TURN_FULL; angle += 37) {
        int64_t s = turn_sin(angle);
        int64_t c = turn_cos(angle);
        TEST_ASSERT_INT64_WITHIN(3 * 65536, INT64_C(65536) * 65536, s * s + c * c);
        TEST_ASSERT_EQUAL_INT64(s, turn_cos(angle - TURN_QUARTER));
    }
}

static void random_numbers_stay_in_range(void) {
    rng r;
    int64_t sum = 0;
    int64_t squares = 0;
    int seen[5] = {0, 0, 0, 0, 0};
    rng_seed(&r, 7, 3);
    for (int i = 0; i < 20000; i++) {
        int32_t n = rng_range(&r, -2, 2);
        int64_t z = rng_normal(&r, 1000);
        TEST_ASSERT_TRUE(n >= -2 && n <= 2);
        seen[n + 2]++;
        sum += z;
        squares += z * z;
    }
    for (int i = 0; i < 5; i++) {
        TEST_ASSERT_INT_WITHIN(300, 4000, seen[i]);
    }
    TEST_ASSERT_INT64_WITHIN(30, 0, sum / 20000);
    TEST_ASSERT_INT64_WITHIN(50000, 1000000, squares / 20000);
}

/* Runs `roomseg simulate` with up to 12 arguments, the list ends with NULL. */
static int command(const char *const *arguments) {
    static char name[] = "simulate";
    char texts[12][300];
    char *argv[14] = {name};
    int argc = 1;
    for (; arguments[argc - 1] != NULL; argc++) {
        snprintf(texts[argc - 1], sizeof texts[0], "%s", arguments[argc - 1]);
        argv[argc] = texts[argc - 1];
    }
    return cmd_simulate(argc, argv);
}

static void files_hold_map_truth_and_pose(void) {
    map_options as_it_says;
    tool_error error = {""};
    map read;
    const char *folder = scratch_path("out");
    const char *map_path = scratch_path("out/map.pgm");
    const char *truth_path = scratch_path("out/truth.pgm");
    sim_options options = small_flat(8);
    memset(&as_it_says, 0, sizeof as_it_says);
    options.resolution_mm = 80;
    make(&options);
    TEST_ASSERT_EQUAL_INT(EXIT_DONE, command((const char *const[]){
        "--seed", "8", "--size", "small", "--resolution", "0.08", "-o", folder, NULL}));
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, map_load(map_path, &as_it_says, &read, &error), error.text);
    TEST_ASSERT_EQUAL_UINT32(made.width, read.width);
    TEST_ASSERT_EQUAL_UINT32(made.height, read.height);
    TEST_ASSERT_EQUAL_UINT8_ARRAY(made.cells, read.cells, cell_count());
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.08, read.resolution_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, made.origin_x_mm / 1000.0, read.origin_x_m);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, made.origin_y_mm / 1000.0, read.origin_y_m);
    /* The robot starts at 0, 0: that cell is free. */
    int column = -made.origin_x_mm / made.resolution_mm;
    int row = (int)made.height - 1 + made.origin_y_mm / made.resolution_mm;
    TEST_ASSERT_LESS_OR_EQUAL_INT(FREE, made.cells[row * (int)made.width + column]);
    map_free(&read);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, map_load(truth_path, &as_it_says, &read, &error),
                                  error.text);
    TEST_ASSERT_EQUAL_UINT8_ARRAY(made.truth, read.cells, cell_count());
    map_free(&read);
}

static void wrong_usage_is_told(void) {
    const char *folder = scratch_path("none");
    const char *const wrong[][9] = {
        {NULL},
        {"--seed", "1", NULL},
        {"-o", folder, NULL},
        {"--seed", "-1", "-o", folder, NULL},
        {"--seed", "18446744073709551616", "-o", folder, NULL},
        {"--seed", "1", "-o", folder, "--size", "huge", NULL},
        {"--seed", "1", "-o", folder, "--resolution", "0.01", NULL},
        {"--seed", "1", "-o", folder, "--clutter", "101", NULL},
        {"--seed", "1", "-o", folder, "--noise", "half", NULL},
        {"--seed", "1", "-o", folder, "--rotate", "361", NULL},
        {"--seed", "1", "-o", folder, "--empty", "--furnished", NULL},
        {"--seed", "1", "-o", folder, "extra", NULL},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        TEST_ASSERT_EQUAL_INT(EXIT_WRONG_USAGE, command(wrong[i]));
    }
    TEST_ASSERT_EQUAL_INT(0, scratch_count());
}

static void unwritable_folder_is_told(void) {
    const char *file = scratch_write_text("file", "x");
    TEST_ASSERT_EQUAL_INT(EXIT_BAD_INPUT, command((const char *const[]){
        "--seed", "1", "--size", "small", "-o", file, NULL}));
    TEST_ASSERT_EQUAL_INT(1, scratch_count());
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(same_bits_on_every_machine);
    RUN_TEST(seeds_differ);
    RUN_TEST(truth_fits_the_map);
    RUN_TEST(map_has_free_occupied_and_unknown_cells);
    RUN_TEST(furniture_takes_floor_and_changes_no_room);
    RUN_TEST(resolution_and_turn_keep_the_floor);
    RUN_TEST(options_out_of_range_fail);
    RUN_TEST(sines_are_exact);
    RUN_TEST(random_numbers_stay_in_range);
    RUN_TEST(files_hold_map_truth_and_pose);
    RUN_TEST(wrong_usage_is_told);
    RUN_TEST(unwritable_folder_is_told);
    return UNITY_END();
}
