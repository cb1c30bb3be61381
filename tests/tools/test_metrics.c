/* Metrics, contingency table, truth labelling. The figures of the small tables were worked
 * out with scikit-learn 1.9 or by hand. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contingency.h"
#include "expected_mi.h"
#include "metrics.h"
#include "score.h"
#include "truth.h"
#include "unity.h"

#define TOLERANCE 1e-12
#define ASSERT_NEAR(expected, actual) TEST_ASSERT_DOUBLE_WITHIN(TOLERANCE, expected, actual)

void setUp(void) {
}

void tearDown(void) {
}

/* An image from rows of digits, each closed by '/'. */
static label_image draw(const char *rows) {
    label_image image = {NULL, (uint32_t)strcspn(rows, "/"), 0};
    image.values = calloc(strlen(rows), sizeof *image.values);
    TEST_ASSERT_NOT_NULL(image.values);
    size_t count = 0;
    for (const char *c = rows; *c != '\0'; c++) {
        if (*c == '/') {
            image.height++;
        } else {
            image.values[count++] = (uint32_t)(*c - '0');
        }
    }
    return image;
}

static contingency table_of(const char *truth_rows, const char *label_rows) {
    label_image truth = draw(truth_rows);
    label_image labels = draw(label_rows);
    contingency table;
    TEST_ASSERT_EQUAL_INT(0, contingency_count(&truth, &labels, &table));
    label_image_free(&truth);
    label_image_free(&labels);
    return table;
}

static metrics metrics_of(const char *truth_rows, const char *label_rows) {
    contingency table = table_of(truth_rows, label_rows);
    metrics m;
    TEST_ASSERT_EQUAL_INT(0, metrics_compute(&table, &m));
    contingency_free(&table);
    return m;
}

/* A table whose rooms and labels are numbered from 1. */
static metrics metrics_of_counts(const uint64_t *cells, uint32_t rooms, uint32_t labels) {
    overlap overlaps[32];
    contingency table = {overlaps, 0};
    metrics m;
    for (uint32_t i = 0; i < rooms; i++) {
        for (uint32_t j = 0; j < labels; j++) {
            if (cells[i * labels + j] > 0) {
                overlaps[table.count++] = (overlap){i + 1, j + 1, cells[i * labels + j]};
            }
        }
    }
    TEST_ASSERT_EQUAL_INT(0, metrics_compute(&table, &m));
    return m;
}

static void test_equal_partitions_score_one_whatever_the_numbers(void) {
    metrics m = metrics_of("1122/1122/0333/", "9944/9944/0222/");
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        double expected = i == METRIC_UNDER_PAINTING ? 0.0 : 1.0;
        TEST_ASSERT_DOUBLE_WITHIN_MESSAGE(TOLERANCE, expected, metrics_get(&m, i),
                                          metric_fields[i].name);
    }
    TEST_ASSERT_EQUAL_UINT(3, m.rooms_true);
    TEST_ASSERT_EQUAL_UINT(3, m.rooms_found);
    TEST_ASSERT_EQUAL_UINT(3, m.rooms_matched);
}

static void test_figures_of_a_small_table(void) {
    /* Two of the eight true cells are under-painted, one labelled cell is outside. */
    metrics m = metrics_of("11112/22200/", "11122/20020/");
    ASSERT_NEAR(0.25, m.under_painting);
    ASSERT_NEAR((3.0 / 4.0 + 1.0) / 2.0, m.recall);
    ASSERT_NEAR((1.0 + 2.0 / 3.0) / 2.0, m.precision);
    ASSERT_NEAR(0.459147917027245, m.completeness);
    ASSERT_NEAR(0.5, m.homogeneity);
    ASSERT_NEAR(0.478703971385680, m.v);
    ASSERT_NEAR(0.355245321275764, m.ami);
    ASSERT_NEAR(0.478703971385680, m.nmi);
    ASSERT_NEAR(12.0 / 37.0, m.ari);
    ASSERT_NEAR(0.617213399848368, m.fmi);
    ASSERT_NEAR((3.0 / 4.0 + 2.0 / 3.0) / 2.0, m.iou);
    ASSERT_NEAR(0.511962411241863, m.strict_v);
    /* Room 1 and label 1 share 3 of 4 cells; room 2 and label 2 share 2 of 6. */
    TEST_ASSERT_EQUAL_UINT(1, m.rooms_matched);
    ASSERT_NEAR(0.5, m.room_recall);
    ASSERT_NEAR(0.5, m.room_precision);
    ASSERT_NEAR(0.5, m.room_f1);
}

static void test_figures_of_a_larger_table(void) {
    static const uint64_t cells[] = {50, 3, 0, 0, 40, 7, 2, 0, 30, 0, 11, 0};
    metrics m = metrics_of_counts(cells, 4, 3);
    ASSERT_NEAR((50.0 / 53.0 + 40.0 / 47.0 + 30.0 / 32.0 + 1.0) / 4.0, m.recall);
    ASSERT_NEAR((50.0 / 52.0 + 40.0 / 54.0 + 30.0 / 37.0) / 3.0, m.precision);
    ASSERT_NEAR(0.750084055054294, m.completeness);
    ASSERT_NEAR(0.643134706645884, m.homogeneity);
    ASSERT_NEAR(0.692504439314911, m.v);
    ASSERT_NEAR(0.686658722871579, m.ami);
    ASSERT_NEAR(0.692504439314911, m.nmi);
    ASSERT_NEAR(0.683654027265808, m.ari);
    ASSERT_NEAR(0.785079872764587, m.fmi);
    ASSERT_NEAR((50.0 / 55.0 + 40.0 / 61.0 + 30.0 / 39.0 + 11.0 / 54.0) / 4.0, m.iou);
    ASSERT_NEAR(m.v, m.strict_v);
}

static void test_iou_takes_the_lowest_of_equally_large_labels(void) {
    /* Label 2 covers as much of room 1 as label 1 does, and room 2 besides. */
    metrics m = metrics_of("1111/2222/", "2211/2222/");
    ASSERT_NEAR((2.0 / 4.0 + 4.0 / 6.0) / 2.0, m.iou);
}

static void test_half_in_common_is_no_match(void) {
    metrics m = metrics_of("1111/", "1100/");
    TEST_ASSERT_EQUAL_UINT(0, m.rooms_matched);
    m = metrics_of("1111/", "1110/");
    TEST_ASSERT_EQUAL_UINT(1, m.rooms_matched);
}

static void test_cells_outside_the_truth_count_for_matches_only(void) {
    metrics inside = metrics_of("11220000/", "11220000/");
    metrics leaking = metrics_of("11220000/", "11222230/");
    for (size_t i = 0; i < METRIC_ROOM_RECALL; i++) {
        ASSERT_NEAR(metrics_get(&inside, i), metrics_get(&leaking, i));
    }
    TEST_ASSERT_EQUAL_UINT(2, inside.rooms_matched);
    TEST_ASSERT_EQUAL_UINT(1, leaking.rooms_matched);
    TEST_ASSERT_EQUAL_UINT(3, leaking.rooms_found);
    ASSERT_NEAR(2.0 / 5.0, leaking.room_f1);
}

static void test_rooms_without_labels_lower_strict_v_and_matches_only(void) {
    metrics m = metrics_of("1122/3300/", "1122/0000/");
    ASSERT_NEAR(1.0, m.recall);
    ASSERT_NEAR(1.0, m.v);
    ASSERT_NEAR(1.0 / 3.0, m.under_painting);
    ASSERT_NEAR(1.0, m.strict_v); /* all of room 3 and nothing else is unlabelled */
    ASSERT_NEAR(2.0 / 3.0, m.room_recall);
    ASSERT_NEAR(1.0, m.room_precision);
    m = metrics_of("1122/3300/", "1102/0000/");
    ASSERT_NEAR(1.0, m.v);
    TEST_ASSERT_TRUE(m.strict_v < 0.9);
}

static void test_nothing_labelled_scores_zero(void) {
    metrics m = metrics_of("1122/", "0000/");
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        ASSERT_NEAR(i == METRIC_UNDER_PAINTING ? 1.0 : 0.0, metrics_get(&m, i));
    }
    TEST_ASSERT_EQUAL_UINT(2, m.rooms_true);
    TEST_ASSERT_EQUAL_UINT(0, m.rooms_found);
}

static void test_an_empty_table_scores_zero(void) {
    contingency table = {NULL, 0};
    metrics m;
    TEST_ASSERT_EQUAL_INT(0, metrics_compute(&table, &m));
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        ASSERT_NEAR(0.0, metrics_get(&m, i));
    }
}

static void test_one_room_cut_in_two(void) {
    metrics m = metrics_of("1111/", "1122/");
    ASSERT_NEAR(1.0, m.homogeneity);
    ASSERT_NEAR(0.0, m.completeness);
    ASSERT_NEAR(0.0, m.v);
    ASSERT_NEAR(0.0, m.ami);
    ASSERT_NEAR(0.0, m.nmi);
    ASSERT_NEAR(0.5, m.recall);
    ASSERT_NEAR(1.0, m.precision);
}

static void test_two_rooms_under_one_label(void) {
    metrics m = metrics_of("1122/", "1111/");
    ASSERT_NEAR(0.0, m.homogeneity);
    ASSERT_NEAR(1.0, m.completeness);
    ASSERT_NEAR(0.0, m.v);
    ASSERT_NEAR(0.0, m.ami);
    ASSERT_NEAR(1.0, m.recall);
    ASSERT_NEAR(0.5, m.precision);
}

static void test_rooms_of_one_cell(void) {
    metrics m = metrics_of("123/", "421/");
    ASSERT_NEAR(1.0, m.ami);
    m = metrics_of("1234/", "4321/");
    ASSERT_NEAR(1.0, m.ami);
    ASSERT_NEAR(1.0, m.ari);
    ASSERT_NEAR(0.0, m.fmi); /* no two cells belong together */
    ASSERT_NEAR(1.0, m.v);
}

static double log_choose(double n, double k) {
    return lgamma(n + 1.0) - lgamma(k + 1.0) - lgamma(n - k + 1.0);
}

/* The defining sum, every term of it. */
static double plain_expected_mi(const uint64_t *a, size_t a_count, const uint64_t *b,
                                size_t b_count, double total) {
    double sum = 0.0;
    for (size_t i = 0; i < a_count; i++) {
        for (size_t j = 0; j < b_count; j++) {
            double x = (double)a[i];
            double y = (double)b[j];
            for (double n = fmax(1.0, x + y - total); n <= fmin(x, y); n += 1.0) {
                double p = exp(log_choose(x, n) + log_choose(total - x, y - n) -
                               log_choose(total, y));
                sum += p * n / total * log(total * n / (x * y));
            }
        }
    }
    return sum;
}

static void test_expected_mutual_information_is_the_defining_sum(void) {
    static const uint64_t a[] = {1, 1, 4, 60, 934};
    static const uint64_t b[] = {500, 1, 300, 199};
    double expected = plain_expected_mi(a, 5, b, 4, 1000.0);
    TEST_ASSERT_TRUE(expected > 0.0);
    ASSERT_NEAR(expected, expected_mutual_information(a, 5, b, 4, 1000));
    ASSERT_NEAR(expected, expected_mutual_information(b, 4, a, 5, 1000));
}

static void test_chance_overlap_of_everything_is_certain(void) {
    static const uint64_t all[] = {1u << 28};
    static const uint64_t parts[] = {1u << 27, 1u << 27};
    ASSERT_NEAR(0.0, expected_mutual_information(all, 1, all, 1, 1u << 28));
    ASSERT_NEAR(0.0, expected_mutual_information(all, 1, parts, 2, 1u << 28));
}

/* Cells of the table with this truth and label. */
static uint64_t cells_of(const contingency *table, uint32_t truth, uint32_t label) {
    for (size_t i = 0; i < table->count; i++) {
        if (table->overlaps[i].truth == truth && table->overlaps[i].label == label) {
            return table->overlaps[i].cells;
        }
    }
    return 0;
}

static void test_contingency_counts_every_pair_in_order(void) {
    enum { SIDE = 200, TRUTHS = 61, LABELS = 67 };
    static uint32_t truth_values[SIDE * SIDE];
    static uint32_t label_values[SIDE * SIDE];
    static uint64_t expected[TRUTHS][LABELS];
    label_image truth = {truth_values, SIDE, SIDE};
    label_image labels = {label_values, SIDE, SIDE};
    uint32_t state = 1;
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        state = state * 1664525u + 1013904223u;
        truth_values[i] = (state >> 8) % TRUTHS;
        label_values[i] = (state >> 16) % LABELS;
        expected[truth_values[i]][label_values[i]]++;
    }
    contingency table;
    TEST_ASSERT_EQUAL_INT(0, contingency_count(&truth, &labels, &table));
    TEST_ASSERT_TRUE(table.count > 2048); /* the hash table has grown */
    for (size_t i = 0; i < table.count; i++) {
        const overlap *o = &table.overlaps[i];
        TEST_ASSERT_EQUAL_UINT64(expected[o->truth][o->label], o->cells);
        expected[o->truth][o->label] = 0;
        TEST_ASSERT_TRUE(i == 0 || o[-1].truth < o->truth ||
                         (o[-1].truth == o->truth && o[-1].label < o->label));
    }
    for (size_t i = 0; i < TRUTHS * LABELS; i++) {
        TEST_ASSERT_EQUAL_UINT64(0, expected[i / LABELS][i % LABELS]);
    }
    contingency_free(&table);
}

static void test_specks_leave_the_truth_with_all_their_cells(void) {
    contingency table = table_of("111122030/", "110021010/");
    contingency_drop_specks(&table, 2);
    TEST_ASSERT_EQUAL_UINT64(2, cells_of(&table, 1, 1));
    TEST_ASSERT_EQUAL_UINT64(1, cells_of(&table, 2, 2));
    TEST_ASSERT_EQUAL_UINT64(0, cells_of(&table, 3, 1));
    TEST_ASSERT_EQUAL_UINT64(1, cells_of(&table, 0, 1));
    TEST_ASSERT_EQUAL_UINT64(2, cells_of(&table, 0, 0));
    contingency_drop_specks(&table, 3); /* 2 cells are too few now, 4 are not */
    TEST_ASSERT_EQUAL_UINT64(0, cells_of(&table, 2, 2));
    TEST_ASSERT_EQUAL_UINT64(2, cells_of(&table, 0, 1));
    TEST_ASSERT_EQUAL_UINT64(2, cells_of(&table, 1, 0));
    contingency_free(&table);
}

static void assert_components(const char *mask, const char *expected) {
    label_image image = draw(mask);
    label_image wanted = draw(expected);
    TEST_ASSERT_EQUAL_INT(0, truth_label_components(&image));
    TEST_ASSERT_EQUAL_UINT32_ARRAY(wanted.values, image.values,
                                   (size_t)image.width * image.height);
    label_image_free(&image);
    label_image_free(&wanted);
}

static void test_components_join_by_corners_in_reading_order(void) {
    assert_components("00000/00000/", "00000/00000/");
    assert_components("9/", "1/");
    assert_components("10101/00000/10101/", "10203/00000/40506/");
    assert_components("10001/01010/00100/", "10001/01010/00100/");
    assert_components("10100/00001/00010/", "10200/00003/00030/");
    assert_components("01010/10101/", "01010/10101/");
}

static void test_components_meet_late(void) {
    assert_components("1010101/1010101/1111111/", "1010101/1010101/1111111/");
    assert_components("1111111/1000001/1011101/1010101/1000101/1111101/",
                      "1111111/1000001/1011101/1010101/1000101/1111101/");
    assert_components("0001/0101/1010/0000/0100/", "0001/0101/1010/0000/0200/");
}

static const char FILE_NAME[] = "metrics_test_truth.pgm";

/* Loads the text as a PGM; 0 or -1 as truth_load. */
static int load_text(const char *pgm, truth_kind kind, label_image *out, tool_error *error) {
    FILE *file = fopen(FILE_NAME, "wb");
    TEST_ASSERT_NOT_NULL(file);
    fputs(pgm, file);
    fclose(file);
    int rc = truth_load(FILE_NAME, kind, out, error);
    remove(FILE_NAME);
    return rc;
}

static void assert_truth(const char *pgm, truth_kind kind, const char *expected) {
    label_image image;
    label_image wanted = draw(expected);
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, load_text(pgm, kind, &image, &error), error.text);
    TEST_ASSERT_EQUAL_UINT(wanted.width, image.width);
    TEST_ASSERT_EQUAL_UINT(wanted.height, image.height);
    TEST_ASSERT_EQUAL_UINT32_ARRAY(wanted.values, image.values,
                                   (size_t)image.width * image.height);
    label_image_free(&image);
    label_image_free(&wanted);
}

static void test_truth_images(void) {
    assert_truth("P2 4 1 255 255 0 0 255", TRUTH_AUTO, "1002/");
    assert_truth("P2 4 1 255 255 127 127 255", TRUTH_AUTO, "1002/");
    assert_truth("P2 4 1 255 1 0 0 1", TRUTH_AUTO, "1002/");
    assert_truth("P2 4 1 255 1 0 0 1", TRUTH_LABELS, "1001/");
    assert_truth("P2 4 1 255 1 0 2 1", TRUTH_AUTO, "1021/");
    assert_truth("P2 4 1 255 1 0 2 1", TRUTH_MASK, "1022/");
    assert_truth("P2 4 1 255 7 7 7 7", TRUTH_AUTO, "1111/");
    label_image image;
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT(-1, load_text("P2 2 1 255 0 0", TRUTH_AUTO, &image, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, FILE_NAME));
    TEST_ASSERT_NULL(image.values);
}

static void test_images_of_other_sizes_are_refused(void) {
    label_image truth = draw("12/");
    label_image labels = draw("1/2/");
    score s;
    tool_error error = {""};
    TEST_ASSERT_EQUAL_INT(-1, score_labels(&truth, &labels, "labels.pgm", &s, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "labels.pgm"));
    label_image_free(&truth);
    label_image_free(&labels);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_equal_partitions_score_one_whatever_the_numbers);
    RUN_TEST(test_figures_of_a_small_table);
    RUN_TEST(test_figures_of_a_larger_table);
    RUN_TEST(test_iou_takes_the_lowest_of_equally_large_labels);
    RUN_TEST(test_half_in_common_is_no_match);
    RUN_TEST(test_cells_outside_the_truth_count_for_matches_only);
    RUN_TEST(test_rooms_without_labels_lower_strict_v_and_matches_only);
    RUN_TEST(test_nothing_labelled_scores_zero);
    RUN_TEST(test_an_empty_table_scores_zero);
    RUN_TEST(test_one_room_cut_in_two);
    RUN_TEST(test_two_rooms_under_one_label);
    RUN_TEST(test_rooms_of_one_cell);
    RUN_TEST(test_expected_mutual_information_is_the_defining_sum);
    RUN_TEST(test_chance_overlap_of_everything_is_certain);
    RUN_TEST(test_contingency_counts_every_pair_in_order);
    RUN_TEST(test_specks_leave_the_truth_with_all_their_cells);
    RUN_TEST(test_components_join_by_corners_in_reading_order);
    RUN_TEST(test_components_meet_late);
    RUN_TEST(test_truth_images);
    RUN_TEST(test_images_of_other_sizes_are_refused);
    return UNITY_END();
}
