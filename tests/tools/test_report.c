/* What the segment command makes of a map: labels, JSON, the table, the picture. */
#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "font.h"
#include "image.h"
#include "report.h"
#include "room_colors.h"
#include "rooms_png.h"
#include "scratch.h"
#include "segment.h"
#include "unity.h"

static tool_error error;

void setUp(void) {
    error.text[0] = '\0';
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

/* ---- a segmented map ---- */

#define PLAN_WIDTH 150u
#define PLAN_HEIGHT 80u

/* Two rooms of 65 x 70 cells with a door of 20 cells between them. */
static map make_plan(void) {
    map m = {malloc(PLAN_WIDTH * PLAN_HEIGHT), PLAN_WIDTH, PLAN_HEIGHT, 0.05, -1, 2, 0};
    TEST_ASSERT_NOT_NULL(m.cells);
    memset(m.cells, 255, PLAN_WIDTH * PLAN_HEIGHT);
    for (size_t y = 5; y < 75; y++) {
        memset(m.cells + y * PLAN_WIDTH + 5, 0, 65);
        memset(m.cells + y * PLAN_WIDTH + 75, 0, 70);
        if (y >= 30 && y < 50) {
            memset(m.cells + y * PLAN_WIDTH + 70, 0, 5);
        }
    }
    return m;
}

static void with_plan(void (*check)(const map *m, const segmentation *s)) {
    roomseg_config config = roomseg_config_default();
    segmentation s;
    map m = make_plan();
    TEST_ASSERT_EQUAL_INT(0, segment_map(&m, &config, "plan", &s, &error));
    check(&m, &s);
    segmentation_free(&s);
    map_free(&m);
}

static void check_labels_file(const map *m, const segmentation *s) {
    image img;
    const char *path = scratch_path("labels.pgm");
    FILE *stream = fopen(path, "wb");
    TEST_ASSERT_NOT_NULL(stream);
    report_labels_pgm(m, s, stream);
    fclose(stream);
    TEST_ASSERT_EQUAL_INT(0, image_load(path, &img, &error));
    TEST_ASSERT_EQUAL_UINT32(s->result.room_count > 255 ? 65535 : 255, img.maxval);
    TEST_ASSERT_EQUAL_UINT32(m->width, img.width);
    TEST_ASSERT_EQUAL_UINT32(m->height, img.height);
    TEST_ASSERT_EQUAL_UINT16_ARRAY(s->labels, img.gray, (size_t)m->width * m->height);
    image_free(&img);
}

static void test_labels_file(void) {
    with_plan(check_labels_file);
}

static void test_labels_above_255_take_two_bytes(void) {
    uint16_t labels[4] = {0, 1, 256, 300};
    map m = {NULL, 2, 2, 0.05, 0, 0, 0};
    segmentation s;
    memset(&s, 0, sizeof s);
    s.labels = labels;
    s.result.room_count = 300;
    check_labels_file(&m, &s);
}

static void check_json_file(const map *m, const segmentation *s) {
    static char text[8192];
    FILE *stream = fopen(scratch_path("rooms.json"), "wb");
    TEST_ASSERT_NOT_NULL(stream);
    report_json(m, s, "a \"plan\".png", stream);
    fclose(stream);
    scratch_read("rooms.json", text, sizeof text);
    static const char *const parts[] = {
        "\"version\": 1,",
        "\"file\": \"a \\\"plan\\\".png\", \"width\": 150, \"height\": 80, ",
        "80, \"resolution_m\": 0.05,",
        "\"origin\": {\"m\": [-1, 2], \"yaw_rad\": 0}",
        "\"crop\": {\"x\": 5, \"y\": 5, \"width\": 140, \"height\": 70}",
        "{\"label\": 1, \"area_m2\": ",
        "\"neighbours\": [2], \"doorways\": [0]}",
        "{\"rooms\": [1, 2], \"position\": {\"cells\": [",
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, parts[i]), parts[i]);
    }
    int depth = 0;
    for (const char *at = text; *at != '\0'; at++) {
        depth += (*at == '{' || *at == '[') - (*at == '}' || *at == ']');
    }
    TEST_ASSERT_EQUAL_INT(0, depth);
}

static void test_json_file(void) {
    with_plan(check_json_file);
}

/* Any locale of the machine with a decimal comma would do; where there is none, the plain
 * one is tested again. */
static void test_json_file_in_another_locale(void) {
    (void)(setlocale(LC_ALL, "de_DE.UTF-8") || setlocale(LC_ALL, "fr_FR.UTF-8"));
    with_plan(check_json_file);
    setlocale(LC_ALL, "C");
}

static void check_table(const map *m, const segmentation *s) {
    char text[1024];
    FILE *stream = fopen(scratch_path("table"), "wb");
    TEST_ASSERT_NOT_NULL(stream);
    report_table(m, s, stream);
    fclose(stream);
    scratch_read("table", text, sizeof text);
    TEST_ASSERT_NOT_NULL(strstr(text, " room  area m2"));
    TEST_ASSERT_NOT_NULL(strstr(text, "     2 ("));
    TEST_ASSERT_NOT_NULL(strstr(text, "\n2 rooms, "));
    TEST_ASSERT_NOT_NULL(strstr(text, ", 1 doorway\n"));
}

static void test_table(void) {
    with_plan(check_table);
}

static void check_picture(const map *m, const segmentation *s) {
    const char *path = scratch_path("rooms.png");
    FILE *stream = fopen(path, "wb");
    canvas c;
    image img;
    TEST_ASSERT_NOT_NULL(stream);
    TEST_ASSERT_EQUAL_INT(0, rooms_png_draw(m, s, "plan", &c, &error));
    TEST_ASSERT_EQUAL_INT(0, image_write_png(stream, c.rgb, c.width, c.height, 3));
    canvas_free(&c);
    fclose(stream);
    TEST_ASSERT_EQUAL_INT(-1, image_load(path, &img, &error)); /* a whole PNG, but ... */
    TEST_ASSERT_NOT_NULL(strstr(error.text, "colours"));
}

static void test_picture(void) {
    with_plan(check_picture);
}

static void test_capacities_grow_with_the_map(void) {
    roomseg_config config = roomseg_config_default();
    segmentation s;
    map m = make_plan();
    config.max_regions = 1;
    config.max_rooms = 1;
    TEST_ASSERT_EQUAL_INT(0, segment_map(&m, &config, "plan", &s, &error));
    TEST_ASSERT_EQUAL_UINT32(2, s.result.room_count);
    TEST_ASSERT_EQUAL_UINT32(2, s.config.max_rooms);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, segment_again(&m, &s));
    TEST_ASSERT_EQUAL_UINT32(2, s.result.room_count);
    segmentation_free(&s);
    config.free_max = 255;
    TEST_ASSERT_EQUAL_INT(-1, segment_map(&m, &config, "plan", &s, &error));
    TEST_ASSERT_EQUAL_INT(0, strncmp(error.text, "plan: cannot be segmented: ", 27));
    TEST_ASSERT_NULL(s.labels);
    map_free(&m);
}

static void test_a_map_without_a_free_cell(void) {
    uint8_t cells[6] = {255, 127, 255, 127, 255, 127};
    roomseg_config config = roomseg_config_default();
    segmentation s;
    map m = {cells, 3, 2, 0.05, 0, 0, 0};
    TEST_ASSERT_EQUAL_INT(0, segment_map(&m, &config, "walls", &s, &error));
    TEST_ASSERT_EQUAL_UINT32(0, s.result.room_count);
    TEST_ASSERT_EQUAL_size_t(0, s.arena_bytes);
    check_labels_file(&m, &s);
    check_picture(&m, &s);
    segmentation_free(&s);
}

/* ---- colours, font ---- */

#define RING 40

/* A small room in the middle of a ring of larger ones, as a corridor among offices: every
 * colour would be gone if the ring came first and took a new one each time. */
static void test_neighbours_never_share_a_colour(void) {
    static roomseg_room rooms[RING + 1];
    static roomseg_doorway doors[2 * RING];
    static uint16_t links[4 * RING];
    uint8_t index[RING + 1];
    roomseg_result r;
    memset(&r, 0, sizeof r);
    uint32_t count = 0;
    for (int i = 0; i <= RING; i++) {
        rooms[i].label = (uint16_t)(i + 1);
        rooms[i].min_x = rooms[i].max_x = (uint16_t)(i * 3);
        rooms[i].link_first = count;
        for (int k = 0; k < RING; k++) {
            int next = (k + 1) % RING;
            doors[k] = (roomseg_doorway){(uint16_t)(k + 1), RING + 1, 0, 0, 900, 9};
            doors[RING + k] = (roomseg_doorway){(uint16_t)((k < next ? k : next) + 1),
                                                (uint16_t)((k < next ? next : k) + 1), 0, 0, 9, 9};
            if (i == RING || i == k) {
                links[count++] = (uint16_t)k;
            }
            if (i != RING && (i == k || i == next)) {
                links[count++] = (uint16_t)(RING + k);
            }
        }
        rooms[i].link_count = (uint16_t)(count - rooms[i].link_first);
    }
    r.rooms = rooms;
    r.doorways = doors;
    r.links = links;
    r.room_count = RING + 1;
    r.doorway_count = 2 * RING;
    TEST_ASSERT_EQUAL_INT(0, room_colors_choose(&r, index));
    for (int k = 0; k < 2 * RING; k++) {
        uint8_t a = index[doors[k].room_a - 1];
        uint8_t b = index[doors[k].room_b - 1];
        TEST_ASSERT_TRUE(a < ROOM_COLOR_COUNT && b < ROOM_COLOR_COUNT);
        TEST_ASSERT_NOT_EQUAL(a, b);
    }
}

static void test_drawing_beyond_the_canvas_is_cut_off(void) {
    const color black = {0, 0, 0};
    canvas c;
    TEST_ASSERT_EQUAL_INT(0, canvas_create(&c, 4, 3, (color){255, 255, 255}));
    draw_pixel(&c, -1, 0, black);
    draw_pixel(&c, 4, 2, black);
    draw_rectangle(&c, 2, 2, 100, 100, black);
    draw_rectangle(&c, -100, -100, 101, 101, black);
    draw_line(&c, 1e12, 1, 1e12, 5, 2, black);
    draw_text(&c, -1e6, 1, "12", 10, 1, black);
    for (int i = 0; i < 12; i++) {
        int is_black = i == 0 || i == 10 || i == 11;
        TEST_ASSERT_EQUAL_UINT8(is_black ? 0 : 255, c.rgb[3 * i]);
    }
    canvas_free(&c);
}

static void count_line(void *user, double x0, double y0, double x1, double y1) {
    (void)(x0 + y0);
    TEST_ASSERT_TRUE(x1 >= 0 && x1 <= 12 && y1 >= -1 && y1 <= 12);
    ++*(int *)user;
}

static void test_every_digit_has_a_shape(void) {
    for (const char *at = "0123456789.m^"; *at != '\0'; at++) {
        int lines = 0;
        font_draw(*at, count_line, &lines);
        TEST_ASSERT_TRUE(lines > 0 && font_width(*at) > 0);
    }
    TEST_ASSERT_EQUAL_INT(0, font_width('~'));
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_labels_file);
    RUN_TEST(test_labels_above_255_take_two_bytes);
    RUN_TEST(test_json_file);
    RUN_TEST(test_json_file_in_another_locale);
    RUN_TEST(test_table);
    RUN_TEST(test_picture);
    RUN_TEST(test_capacities_grow_with_the_map);
    RUN_TEST(test_a_map_without_a_free_cell);
    RUN_TEST(test_neighbours_never_share_a_colour);
    RUN_TEST(test_drawing_beyond_the_canvas_is_cut_off);
    RUN_TEST(test_every_digit_has_a_shape);
    return UNITY_END();
}
