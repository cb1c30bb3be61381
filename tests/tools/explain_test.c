/* The explain command: what it observes is what the library computes, its files are whole, its
 * page needs nothing else. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base64.h"
#include "commands.h"
#include "explanation.h"
#include "infile.h"
#include "out.h"
#include "page.h"
#include "png_check.h"
#include "scratch.h"
#include "seed_map.h"
#include "shared_walls.h"
#include "sheet_row.h"
#include "threshold.h"
#include "unity.h"

enum { WIDTH = 220, HEIGHT = 140, FREE = 0, UNKNOWN = 127, WALL = 255 };

static tool_error error;

void setUp(void) {
    error.text[0] = '\0';
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

/* ---- a flat: two rooms above a corridor, doors, a speck, a box, a fan of light outside ---- */

static void fill(uint8_t *cells, int x0, int y0, int x1, int y1, uint8_t value) {
    for (int y = y0; y < y1; y++) {
        memset(cells + y * WIDTH + x0, value, (size_t)(x1 - x0));
    }
}

static void draw_flat(uint8_t *cells) {
    memset(cells, UNKNOWN, WIDTH * HEIGHT);
    fill(cells, 18, 18, 182, 122, WALL);
    fill(cells, 20, 20, 98, 88, FREE);
    fill(cells, 101, 20, 180, 88, FREE);
    fill(cells, 20, 91, 180, 120, FREE);
    fill(cells, 50, 88, 66, 91, FREE);
    fill(cells, 130, 88, 146, 91, FREE);
    fill(cells, 40, 40, 43, 43, WALL);
    fill(cells, 140, 50, 150, 60, UNKNOWN);
    fill(cells, 195, 60, 199, 64, FREE);
}

static map make_flat(void) {
    map m = {malloc(WIDTH * HEIGHT), WIDTH, HEIGHT, 0.05, 0, 0, 0};
    TEST_ASSERT_NOT_NULL(m.cells);
    draw_flat(m.cells);
    return m;
}

/* The flat turned clockwise by so many degrees, around a middle that stays inside. */
static map make_turned_flat(double degrees) {
    enum { SIDE = 280 };
    static uint8_t flat[WIDTH * HEIGHT];
    map m = {malloc(SIDE * SIDE), SIDE, SIDE, 0.05, 0, 0, 0};
    double c = cos(degrees * 3.14159265 / 180), s = sin(degrees * 3.14159265 / 180);
    TEST_ASSERT_NOT_NULL(m.cells);
    draw_flat(flat);
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            int dx = x - SIDE / 2, dy = y - SIDE / 2;
            int from_x = (int)lround(c * dx + s * dy) + WIDTH / 2;
            int from_y = (int)lround(c * dy - s * dx) + HEIGHT / 2;
            int inside = from_x >= 0 && from_x < WIDTH && from_y >= 0 && from_y < HEIGHT;
            m.cells[y * SIDE + x] = inside ? flat[from_y * WIDTH + from_x] : UNKNOWN;
        }
    }
    return m;
}

/* The true rooms of the flat in place of its cells: white, with the doors shut. */
static void make_truth(map *m) {
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        m->cells[i] = m->cells[i] == FREE ? 255 : 0;
    }
    fill(m->cells, 18, 88, 182, 91, 0);
    fill(m->cells, 195, 60, 199, 64, 0);
}

static const char *write_map(const char *name, const map *m) {
    static char text[280 * 280 + 40];
    int head = snprintf(text, sizeof text, "P5\n%u %u\n255\n", (unsigned)m->width,
                        (unsigned)m->height);
    memcpy(text + head, m->cells, (size_t)m->width * m->height);
    return scratch_write(name, text, (size_t)head + (size_t)m->width * m->height);
}

static roomseg_config config_of(int paper) {
    return paper ? roomseg_config_paper() : roomseg_config_default();
}

/* ---- observation ---- */

static void check_planes(const observation *o, const roomseg_config *config) {
    for (uint32_t y = 0; y < o->frame.height; y++) {
        for (uint32_t x = 0; x < o->frame.width; x++) {
            uint8_t cell = o->m->cells[(o->frame.y + y) * o->m->width + o->frame.x + x];
            TEST_ASSERT_EQUAL_INT(cell <= config->free_max, plane_at(o, PLANE_FREE, x, y));
        }
    }
    /* The speck (40, 40) has become free; the wall has not. */
    TEST_ASSERT_EQUAL_INT(1, plane_at(o, PLANE_CLEARED, 41 - o->frame.x, 41 - o->frame.y));
    TEST_ASSERT_EQUAL_INT(0, plane_at(o, PLANE_CLEARED, 99 - o->frame.x, 41 - o->frame.y));
}

/* Rooms as the library returns them are what the regions were merged to. */
static void check_regions(const observation *o) {
    uint32_t rooms = 0;
    for (uint32_t r = 1; r <= o->before.region_count; r++) {
        rooms += root_of(o, (uint16_t)r) == r && o->after.regions[r].area > 0;
    }
    TEST_ASSERT_EQUAL_UINT32(o->s.result.room_count, rooms);
    for (uint32_t y = 0; y < o->frame.height; y++) {
        for (uint32_t x = 0; x < o->frame.width; x++) {
            uint16_t label = label_at(o, LABELS_REGIONS, x, y);
            if (label == 0 || label > o->before.region_count || room_at(o, x, y) == 0) {
                continue;
            }
            const roomseg_room *room = &o->s.result.rooms[room_at(o, x, y) - 1];
            uint16_t inside = label_at(o, LABELS_REGIONS, room->interior_x - o->frame.x,
                                       room->interior_y - o->frame.y);
            TEST_ASSERT_EQUAL_UINT16(root_of(o, inside), root_of(o, label));
        }
    }
}

/* The paper profile cuts the corridor at its doors. */
static void check_observation(int paper, uint32_t rooms) {
    map m = make_flat();
    roomseg_config config = config_of(paper);
    segmentation s;
    observation o;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    TEST_ASSERT_EQUAL_INT(0, segment_map(&m, &config, "flat", &s, &error));
    TEST_ASSERT_EQUAL_UINT16_ARRAY(s.labels, o.s.labels, WIDTH * HEIGHT);
    TEST_ASSERT_EQUAL_UINT32(rooms, o.s.result.room_count);
    check_planes(&o, &config);
    check_regions(&o);
    segmentation_free(&s);
    observation_free(&o);
    map_free(&m);
}

static void test_default_profile_is_observed(void) {
    check_observation(0, 3);
}

static void test_paper_profile_is_observed(void) {
    check_observation(1, 6);
}

/* Every plane and label image of a profile is there, and none of the other's. */
static void test_each_profile_has_its_own_stages(void) {
    static const int wanted[2][PLANE_COUNT] = {{1, 1, 1, 0, 0}, {1, 1, 0, 1, 1}};
    static const int wanted_labels[2][LABELS_COUNT] = {{0, 0, 1}, {1, 1, 1}};
    for (int paper = 0; paper < 2; paper++) {
        map m = make_flat();
        roomseg_config config = config_of(paper);
        observation o;
        TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
        for (int i = 0; i < PLANE_COUNT; i++) {
            TEST_ASSERT_EQUAL_INT(wanted[paper][i], o.planes[i] != NULL);
        }
        for (int i = 0; i < LABELS_COUNT; i++) {
            TEST_ASSERT_EQUAL_INT(wanted_labels[paper][i], o.labels[i] != NULL);
        }
        observation_free(&o);
        map_free(&m);
    }
}

/* Capacities that grow while the map is segmented move everything in the arena. */
static void test_observation_survives_growing_capacities(void) {
    map m = make_flat();
    roomseg_config config = roomseg_config_default();
    observation small, large;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &large, &error));
    config.max_regions = config.max_rooms = 1;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &small, &error));
    TEST_ASSERT_EQUAL_UINT32(large.before.region_count, small.before.region_count);
    TEST_ASSERT_EQUAL_UINT32(large.before.edge_count, small.before.edge_count);
    TEST_ASSERT_EQUAL_MEMORY(large.after.regions + 1, small.after.regions + 1,
                             large.before.region_count * sizeof *large.after.regions);
    check_regions(&small);
    observation_free(&small);
    observation_free(&large);
    map_free(&m);
}

/* Cells of long walls. */
static uint64_t check_walls(const observation *o) {
    size_t cells = (size_t)o->frame.width * o->frame.height;
    uint64_t crossings, counted = 0, marked = 0;
    uint8_t *marks = calloc(cells, 1);
    TEST_ASSERT_NOT_NULL(marks);
    TEST_ASSERT_EQUAL_INT(0, shared_walls_mark(o, 20, marks, &crossings));
    for (uint32_t e = 0; e < o->before.edge_count; e++) {
        counted += o->before.edges[e].wall;
    }
    for (size_t i = 0; i < cells; i++) {
        marked += marks[i] == WALL_LONG;
    }
    TEST_ASSERT_EQUAL_UINT64(counted, crossings);
    free(marks);
    return marked;
}

static void test_wall_cells_are_those_the_graph_counts(void) {
    map m = make_flat();
    roomseg_config config = roomseg_config_default();
    observation o;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    TEST_ASSERT_TRUE(check_walls(&o) > 3 * 150);
    observation_free(&o);
    map_free(&m);
}

static void test_seed_maps_shrink_and_end_in_the_leaf_seeds(void) {
    map m = make_flat();
    roomseg_config config = roomseg_config_paper();
    observation o;
    uint32_t count, first = 0;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    size_t cells = (size_t)o.frame.width * o.frame.height;
    uint16_t *seeds = malloc(cells * sizeof *seeds);
    TEST_ASSERT_NOT_NULL(seeds);
    TEST_ASSERT_EQUAL_INT(SEED_MAPS_SHOWN, seed_map_count(&o));
    TEST_ASSERT_EQUAL_INT(1, seed_map_scale(&o, 0));
    uint64_t before = UINT64_MAX;
    for (int i = 0; i < SEED_MAPS_SHOWN; i++) {
        uint64_t left = 0;
        TEST_ASSERT_EQUAL_INT(0, seed_map_make(&o, seed_map_scale(&o, i), seeds, &count));
        for (size_t k = 0; k < cells; k++) {
            left += seeds[k] != 0;
            TEST_ASSERT_TRUE(seeds[k] <= count);
        }
        TEST_ASSERT_TRUE(left > 0 && left < before);
        before = left;
        first = i == 0 ? count : first;
    }
    TEST_ASSERT_EQUAL_UINT32(1, first); /* all of the flat, through its doors */
    TEST_ASSERT_TRUE(o.before.region_count >= 3);
    free(seeds);
    observation_free(&o);
    map_free(&m);
}

/* ---- rules and fates ---- */

static void test_rules_tell_what_joins(void) {
    map m = make_flat();
    roomseg_config config = roomseg_config_default();
    observation o;
    uint8_t *joins;
    uint32_t by_rule[JOIN_COUNT] = {0};
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    TEST_ASSERT_EQUAL_INT(0, rules_find(&o, "flat", &joins, &error));
    for (uint32_t e = 0; e < o.before.edge_count; e++) {
        const rs_edge *edge = &o.before.edges[e];
        int together = root_of(&o, edge->a) == root_of(&o, edge->b);
        TEST_ASSERT_TRUE(joins[e] < JOIN_COUNT);
        TEST_ASSERT_TRUE(!together || joins[e] != JOIN_NONE);
        TEST_ASSERT_TRUE(together || joins[e] == JOIN_NONE);
        by_rule[joins[e]] += edge->border > 0;
    }
    TEST_ASSERT_TRUE(by_rule[JOIN_NONE] >= 2); /* the doors */
    free(joins);
    observation_free(&o);
    map_free(&m);
}

static void test_island_is_dropped_alone(void) {
    map m = make_flat();
    roomseg_config config = roomseg_config_default();
    config.smallest_room_mm2 = 0; /* smaller islands go before there are regions */
    observation o;
    fates f;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    TEST_ASSERT_EQUAL_INT(0, fates_find(&o, &f));
    uint16_t island = label_at(&o, LABELS_REGIONS, 196 - o.frame.x, 61 - o.frame.y);
    TEST_ASSERT_EQUAL_INT(FATE_ALONE, f.of[island]);
    TEST_ASSERT_EQUAL_UINT32(3, f.roots[FATE_ROOM]);
    TEST_ASSERT_EQUAL_UINT32(1, f.roots[FATE_ALONE]);
    TEST_ASSERT_EQUAL_UINT64(16, f.cells[FATE_ALONE]);
    TEST_ASSERT_EQUAL_UINT32(0, f.roots[FATE_UNWALLED]);
    fates_free(&f);
    observation_free(&o);
    map_free(&m);
}

/* ---- walls ---- */

static void test_walls_have_the_angle_that_the_library_finds(void) {
    static const double turns[] = {0, 20, -33};
    for (size_t i = 0; i < sizeof turns / sizeof turns[0]; i++) {
        map m = make_turned_flat(turns[i]);
        roomseg_config config = roomseg_config_paper();
        segmentation s;
        walls w;
        rs_frame frame;
        rs_ticker silent = {NULL, NULL, ROOMSEG_STAGE_THRESHOLD, 0, 0, 0, 0};
        roomseg_grid grid = segment_grid(&m);
        config.align = ROOMSEG_ALIGN_ON;
        rs_threshold_crop(&grid, config.free_max, &frame, &silent);
        TEST_ASSERT_EQUAL_INT(0, segment_map(&m, &config, "flat", &s, &error));
        TEST_ASSERT_EQUAL_INT(0, walls_find(&m, &config, &frame, "flat", &w, &error));
        TEST_ASSERT_EQUAL_INT32(s.result.wall_angle, w.angle);
        TEST_ASSERT_INT_WITHIN(100, (int)(turns[i] * 100), w.angle);
        TEST_ASSERT_TRUE(w.line_count > 4 && w.edge_cells > 400);
        walls_free(&w);
        segmentation_free(&s);
        map_free(&m);
    }
}

/* ---- real maps ---- */

static const char *benchmark; /* folder of them; NULL: not here */

static void check_real_map(const char *name) {
    char path[1024];
    map m;
    map_options options = {0, 0};
    snprintf(path, sizeof path, "%s/%s", benchmark, name);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, map_load(path, &options, &m, &error), error.text);
    for (int paper = 0; paper < 2; paper++) {
        roomseg_config config = config_of(paper);
        observation o;
        TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, path, &o, &error));
        check_regions(&o);
        if (!paper) {
            check_walls(&o);
        }
        observation_free(&o);
    }
    map_free(&m);
}

static void test_real_maps_are_observed(void) {
    if (benchmark == NULL) {
        TEST_IGNORE_MESSAGE("no folder with real maps was given");
    }
    check_real_map("neato/05.png");
    check_real_map("furnished/09_lab_intel.png");
}

/* ---- files ---- */

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
    map m = make_flat();
    const char *path = write_map("flat.pgm", &m);
    make_truth(&m);
    const char *truth = write_map("truth.pgm", &m);
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
    map m = make_flat();
    const char *path = write_map("flat.pgm", &m);
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
    map m = make_turned_flat(20);
    const char *path = write_map("flat.pgm", &m);
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
    map m = make_flat();
    const char *set = scratch_path("set");
    const char *keep = scratch_path("set/groundtruth");
    TEST_ASSERT_EQUAL_INT(0, out_make_folder(keep, &error));
    write_map("set/one.pgm", &m);
    write_map("set/two.pgm", &m);
    make_truth(&m);
    write_map("set/groundtruth/one.pgm", &m);
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

int main(int argc, char **argv) {
    benchmark = argc > 1 && dataset_is_folder(argv[1]) ? argv[1] : NULL;
    UNITY_BEGIN();
    RUN_TEST(test_default_profile_is_observed);
    RUN_TEST(test_paper_profile_is_observed);
    RUN_TEST(test_each_profile_has_its_own_stages);
    RUN_TEST(test_observation_survives_growing_capacities);
    RUN_TEST(test_wall_cells_are_those_the_graph_counts);
    RUN_TEST(test_seed_maps_shrink_and_end_in_the_leaf_seeds);
    RUN_TEST(test_rules_tell_what_joins);
    RUN_TEST(test_island_is_dropped_alone);
    RUN_TEST(test_walls_have_the_angle_that_the_library_finds);
    RUN_TEST(test_real_maps_are_observed);
    RUN_TEST(test_default_profile_writes_all_files);
    RUN_TEST(test_paper_profile_writes_all_files);
    RUN_TEST(test_turned_map_is_explained_as_turned);
    RUN_TEST(test_sheet_of_a_data_set);
    RUN_TEST(test_base64);
    RUN_TEST(test_names_are_no_markup);
    return UNITY_END();
}
