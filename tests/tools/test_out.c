/* What the commands share: files that appear whole, arguments, JSON. */
#include <math.h>
#include <string.h>

#include "args.h"
#include "json.h"
#include "out.h"
#include "scratch.h"
#include "unity.h"

static tool_error error;

void setUp(void) {
    error.text[0] = '\0';
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

/* ---- out ---- */

static void test_a_file_appears_when_it_is_committed(void) {
    char text[16];
    out_file file;
    TEST_ASSERT_EQUAL_INT(0, out_open(&file, scratch_path("a"), &error));
    fputs("new", file.stream);
    TEST_ASSERT_EQUAL_INT(0, out_flush(&file, &error));
    TEST_ASSERT_EQUAL_INT(0, scratch_read("a", text, sizeof text));
    TEST_ASSERT_EQUAL_INT(0, out_commit(&file, &error));
    TEST_ASSERT_EQUAL_INT(1, scratch_read("a", text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("new", text);
    TEST_ASSERT_EQUAL_INT(1, scratch_count());
    out_discard(&file); /* harmless now */
}

static void test_a_discarded_file_leaves_the_old_one(void) {
    char text[16];
    out_file file;
    TEST_ASSERT_EQUAL_INT(0, out_open(&file, scratch_write_text("a", "old"), &error));
    fputs("new", file.stream);
    out_discard(&file);
    scratch_read("a", text, sizeof text);
    TEST_ASSERT_EQUAL_STRING("old", text);
    TEST_ASSERT_EQUAL_INT(1, scratch_count());
}

static void test_two_writers_of_one_file_do_not_meet(void) {
    char text[16];
    out_file a;
    out_file b;
    const char *path = scratch_path("a");
    TEST_ASSERT_EQUAL_INT(0, out_open(&a, path, &error));
    TEST_ASSERT_EQUAL_INT(0, out_open(&b, path, &error));
    fputs("aaaa", a.stream);
    fputs("bb", b.stream);
    TEST_ASSERT_EQUAL_INT(0, out_commit(&b, &error));
    TEST_ASSERT_EQUAL_INT(0, out_commit(&a, &error));
    scratch_read("a", text, sizeof text);
    TEST_ASSERT_EQUAL_STRING("aaaa", text);
    TEST_ASSERT_EQUAL_INT(1, scratch_count());
}

static void test_files_that_cannot_be_written(void) {
    out_file file;
    TEST_ASSERT_EQUAL_INT(-1, out_open(&file, scratch_path("no/such/a"), &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "no/such/a: cannot write: No such file"));
    TEST_ASSERT_NULL(file.stream);
    /* A folder has the name. */
    TEST_ASSERT_EQUAL_INT(0, out_make_folder(scratch_path("folder"), &error));
    TEST_ASSERT_EQUAL_INT(0, out_open(&file, scratch_path("folder"), &error));
    TEST_ASSERT_EQUAL_INT(-1, out_commit(&file, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "folder: cannot write: Is a directory"));
    TEST_ASSERT_EQUAL_INT(1, scratch_count());
}

/* Those before the one that fails have their names, none is left unfinished. */
static void test_files_that_belong_together(void) {
    out_file files[4] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}, {NULL, NULL, NULL},
                         {NULL, NULL, NULL}};
    char text[8];
    TEST_ASSERT_EQUAL_INT(0, out_make_folder(scratch_path("c"), &error));
    TEST_ASSERT_EQUAL_INT(0, out_open_in(&files[0], scratch_folder(), "a", &error));
    TEST_ASSERT_EQUAL_INT(0, out_open_in(&files[2], scratch_folder(), "c", &error));
    TEST_ASSERT_EQUAL_INT(0, out_open_in(&files[3], scratch_folder(), "d", &error));
    fputs("new", files[0].stream);
    TEST_ASSERT_EQUAL_INT(-1, out_end_all(files, 4, 0, &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "c: cannot write: Is a directory"));
    TEST_ASSERT_TRUE(scratch_read("a", text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("new", text);
    TEST_ASSERT_EQUAL_INT(2, scratch_count());
    TEST_ASSERT_EQUAL_INT(0, out_open_in(&files[1], scratch_folder(), "d", &error));
    TEST_ASSERT_EQUAL_INT(-1, out_end_all(files, 4, -1, &error));
    TEST_ASSERT_EQUAL_INT(2, scratch_count());
    TEST_ASSERT_NULL(files[1].stream);
    TEST_ASSERT_EQUAL_INT(-1, out_open_in(&files[0], scratch_path("no"), "a", &error));
}

static void test_folders(void) {
    scratch_path("x");
    scratch_path("x/y");
    TEST_ASSERT_EQUAL_INT(0, out_make_folder(scratch_path("x/y/z"), &error));
    TEST_ASSERT_EQUAL_INT(0, out_make_folder(scratch_path("x/y/z//"), &error));
    TEST_ASSERT_EQUAL_INT(0, out_make_folder("/", &error));
    scratch_write_text("f", "");
    TEST_ASSERT_EQUAL_INT(-1, out_make_folder(scratch_path("f"), &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "Not a directory"));
    TEST_ASSERT_EQUAL_INT(-1, out_make_folder(scratch_path("f/g"), &error));
    TEST_ASSERT_NOT_NULL(strstr(error.text, "Not a directory"));
}

/* ---- arguments ---- */

static const char *name;
static int flag;
static const char *operand[2];
static int operands;

static int parse(char *a, char *b, char *c, char *d) {
    char *argv[] = {"test", a, b, c, d, NULL};
    const arg_option options[] = {
        {"--name", "-n", &name, NULL}, {"--flag", NULL, NULL, &flag}, {NULL, NULL, NULL, NULL}};
    int argc = 1;
    while (argv[argc] != NULL) {
        argc++;
    }
    name = NULL;
    flag = 0;
    return args_parse(argc, argv, options, operand, 2, &operands, &error);
}

static void test_arguments(void) {
    TEST_ASSERT_EQUAL_INT(0, parse("a", "--name", "--flag", "b"));
    TEST_ASSERT_EQUAL_STRING("--flag", name);
    TEST_ASSERT_EQUAL_INT(2, operands);
    TEST_ASSERT_EQUAL_STRING("b", operand[1]);
    TEST_ASSERT_EQUAL_INT(0, parse("--name=x=y", "-", "--", "--flag"));
    TEST_ASSERT_EQUAL_STRING("x=y", name);
    TEST_ASSERT_EQUAL_INT(0, flag);
    TEST_ASSERT_EQUAL_STRING("--flag", operand[1]);
    TEST_ASSERT_EQUAL_INT(0, parse("-n", "x", "--flag", NULL));
    TEST_ASSERT_EQUAL_INT(1, flag);
}

static void test_wrong_arguments(void) {
    TEST_ASSERT_EQUAL_INT(-1, parse("--nam", "x", NULL, NULL));
    TEST_ASSERT_EQUAL_STRING("unknown option '--nam'", error.text);
    TEST_ASSERT_EQUAL_INT(-1, parse("-nx", NULL, NULL, NULL));
    TEST_ASSERT_EQUAL_STRING("unknown option '-nx'", error.text);
    TEST_ASSERT_EQUAL_INT(-1, parse("--name", NULL, NULL, NULL));
    TEST_ASSERT_EQUAL_STRING("option --name needs a value", error.text);
    TEST_ASSERT_EQUAL_INT(-1, parse("--name=", NULL, NULL, NULL));
    TEST_ASSERT_EQUAL_STRING("option --name needs a value", error.text);
    TEST_ASSERT_EQUAL_INT(-1, parse("--flag=1", NULL, NULL, NULL));
    TEST_ASSERT_EQUAL_STRING("option --flag takes no value", error.text);
    TEST_ASSERT_EQUAL_INT(-1, parse("--flag", "--flag", NULL, NULL));
    TEST_ASSERT_EQUAL_STRING("option --flag is given twice", error.text);
    TEST_ASSERT_EQUAL_INT(-1, parse("a", "b", "c", NULL));
    TEST_ASSERT_EQUAL_STRING("unexpected argument 'c'", error.text);
}

static void test_numbers_in_arguments(void) {
    static const char *const none[] = {"",    " 1",  "1 ", "1x", "nan", "inf", "0x10",
                                       "1e9999", "--1", ".",  "e5", "1,5", "1.5.2"};
    double real;
    long whole;
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        TEST_ASSERT_EQUAL_INT_MESSAGE(-1, parse_real(none[i], &real), none[i]);
        TEST_ASSERT_EQUAL_INT_MESSAGE(-1, parse_integer(none[i], -9, 99, &whole), none[i]);
    }
    TEST_ASSERT_EQUAL_INT(0, parse_real("-1.5e-1", &real));
    TEST_ASSERT_EQUAL_DOUBLE(-0.15, real);
    TEST_ASSERT_EQUAL_INT(0, parse_integer("-9", -9, 99, &whole));
    TEST_ASSERT_EQUAL_INT(-9, whole);
    TEST_ASSERT_EQUAL_INT(-1, parse_integer("100", -9, 99, &whole));
    TEST_ASSERT_EQUAL_INT(-1, parse_integer("99999999999999999999", 0, 99, &whole));
    TEST_ASSERT_EQUAL_INT(-1, args_real("--x", "0.3", 0.02, 0.2, &real, &error));
    TEST_ASSERT_EQUAL_STRING("option --x needs a number from 0.02 to 0.2, not '0.3'", error.text);
}

/* ---- JSON ---- */

static void expect_json_string(const char *expected, const char *text) {
    char written[128];
    FILE *stream = fopen(scratch_path("s"), "wb");
    TEST_ASSERT_NOT_NULL(stream);
    json_string(stream, text);
    fclose(stream);
    scratch_read("s", written, sizeof written);
    TEST_ASSERT_EQUAL_STRING(expected, written);
}

static void expect_json_number(const char *expected, double value, int decimals) {
    char written[64];
    FILE *stream = fopen(scratch_path("n"), "wb");
    TEST_ASSERT_NOT_NULL(stream);
    json_number(stream, value, decimals);
    fclose(stream);
    scratch_read("n", written, sizeof written);
    TEST_ASSERT_EQUAL_STRING(expected, written);
}

static void test_json_strings(void) {
    expect_json_string("\"\"", "");
    expect_json_string("\"a\\\\b\\\"c/\"", "a\\b\"c/");
    expect_json_string("\"\\u0009\\u000a\\u007f\"", "\t\n\x7f");
    expect_json_string("\"K\xC3\xBC" "che \xE2\x82\xAC \xF0\x9F\x8F\xA0\"",
                       "K\xC3\xBC" "che \xE2\x82\xAC \xF0\x9F\x8F\xA0");
    /* Latin 1; overlong; a surrogate; beyond U+10FFFF; cut off at the end. */
    expect_json_string("\"K\\ufffdche\"", "K\xFC" "che");
    expect_json_string("\"\\ufffd\\ufffd\"", "\xC0\xAF");
    expect_json_string("\"\\ufffd\\ufffd\\ufffd\"", "\xED\xA0\x80");
    expect_json_string("\"\\ufffd\\ufffd\\ufffd\\ufffd\"", "\xF4\x90\x80\x80");
    expect_json_string("\"\\ufffd\\ufffd\"", "\xE2\x82");
}

static void test_json_numbers(void) {
    expect_json_number("0", 0, 3);
    expect_json_number("0", -0.0004, 3);
    expect_json_number("-0.001", -0.0006, 3);
    expect_json_number("1.5", 1.5, 3);
    expect_json_number("0.05", 0.05, 6);
    expect_json_number("12", 11.9996, 3);
    expect_json_number("-40", -40, 6);
    expect_json_number("3", 2.6, 0);
    expect_json_number("999999999.123456", 999999999.123456, 6);
    expect_json_number("null", 1e10, 3);
    expect_json_number("null", NAN, 3);
    expect_json_number("null", -INFINITY, 3);
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(test_a_file_appears_when_it_is_committed);
    RUN_TEST(test_a_discarded_file_leaves_the_old_one);
    RUN_TEST(test_two_writers_of_one_file_do_not_meet);
    RUN_TEST(test_files_that_cannot_be_written);
    RUN_TEST(test_files_that_belong_together);
    RUN_TEST(test_folders);
    RUN_TEST(test_arguments);
    RUN_TEST(test_wrong_arguments);
    RUN_TEST(test_numbers_in_arguments);
    RUN_TEST(test_json_strings);
    RUN_TEST(test_json_numbers);
    return UNITY_END();
}
