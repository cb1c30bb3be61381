/* What the explain command observes of a run is what the library computes. */
#include <stdio.h>
#include <stdlib.h>

#include "dataset.h"
#include "explain_flat.h"
#include "fates.h"
#include "observe.h"
#include "rules.h"
#include "seed_map.h"
#include "shared_walls.h"
#include "threshold.h"
#include "unity.h"
#include "walls.h"

static tool_error error;

void setUp(void) {
    error.text[0] = '\0';
}

void tearDown(void) {
}

static roomseg_config config_of(int paper) {
    return paper ? roomseg_config_paper() : roomseg_config_default();
}

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
    map m = explain_flat();
    roomseg_config config = config_of(paper);
    segmentation s;
    observation o;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    TEST_ASSERT_EQUAL_INT(0, segment_map(&m, &config, "flat", &s, &error));
    TEST_ASSERT_EQUAL_UINT16_ARRAY(s.labels, o.s.labels, EXPLAIN_FLAT_WIDTH * EXPLAIN_FLAT_HEIGHT);
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
        map m = explain_flat();
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
    map m = explain_flat();
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
    map m = explain_flat();
    roomseg_config config = roomseg_config_default();
    observation o;
    TEST_ASSERT_EQUAL_INT(0, observe_run(&m, &config, "flat", &o, &error));
    TEST_ASSERT_TRUE(check_walls(&o) > 3 * 150);
    observation_free(&o);
    map_free(&m);
}

static void test_seed_maps_shrink_and_end_in_the_leaf_seeds(void) {
    map m = explain_flat();
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
    map m = explain_flat();
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
    map m = explain_flat();
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
        map m = explain_flat_turned(turns[i]);
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
    return UNITY_END();
}
