/* The golden maps give what tests/golden holds, to the bit, on every machine.
 *
 *   test_golden FOLDER    the folder with the texts */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "golden.h"
#include "unity.h"

static const char *folder;

void setUp(void)
{
}

void tearDown(void)
{
}

static void differ(const char *path, unsigned line, const char *expected, const char *got)
{
    char text[1300];
    snprintf(text, sizeof text,
             "%.250s, line %u\n  expected: %.450s\n  got:      %.450s\n"
             "  If this change is intended: tests/golden/update.sh",
             path, line, expected, got);
    TEST_FAIL_MESSAGE(text);
}

/* Reads a line without its end, "(end)" behind the last. */
static void read_line(FILE *stream, char *line, int size)
{
    if (fgets(line, size, stream) == NULL) {
        strcpy(line, "(end)");
    }
    line[strcspn(line, "\n")] = '\0';
}

static void compare(const char *path, FILE *expected, FILE *got)
{
    enum { LONGEST = 60000 };
    static char expected_line[LONGEST], got_line[LONGEST];
    for (unsigned line = 1;; line++) {
        read_line(expected, expected_line, LONGEST);
        read_line(got, got_line, LONGEST);
        if (strcmp(expected_line, got_line) != 0) {
            differ(path, line, expected_line, got_line);
        }
        if (strcmp(got_line, "(end)") == 0) {
            return;
        }
    }
}

static void check(int index)
{
    golden_map golden = golden_map_at(index);
    golden_run run;
    TEST_ASSERT_EQUAL_INT(0, golden_make(&golden, &run));
    FILE *got = tmpfile();
    TEST_ASSERT_NOT_NULL(got);
    golden_write(&golden, &run, got);
    rewind(got);
    char path[1000];
    snprintf(path, sizeof path, "%s/%s.txt", folder, golden.name);
    FILE *expected = fopen(path, "r");
    TEST_ASSERT_NOT_NULL_MESSAGE(expected, path);
    compare(path, expected, got);
    fclose(expected);
    fclose(got);
    golden_free(&run);
}

static void test_small_furnished(void)
{
    check(0);
}

static void test_medium_furnished(void)
{
    check(1);
}

static void test_medium_empty(void)
{
    check(2);
}

static void test_medium_cluttered(void)
{
    check(3);
}

static void test_medium_turned(void)
{
    check(4);
}

static void test_large_furnished(void)
{
    check(5);
}

static void test_paper(void)
{
    check(6);
}

static void test_paper_home(void)
{
    check(7);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fputs("usage: test_golden FOLDER\n", stderr);
        return 2;
    }
    folder = argv[1];
    UNITY_BEGIN();
    RUN_TEST(test_small_furnished);
    RUN_TEST(test_medium_furnished);
    RUN_TEST(test_medium_empty);
    RUN_TEST(test_medium_cluttered);
    RUN_TEST(test_medium_turned);
    RUN_TEST(test_large_furnished);
    RUN_TEST(test_paper);
    RUN_TEST(test_paper_home);
    return UNITY_END();
}
