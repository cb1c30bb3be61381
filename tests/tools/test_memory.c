/* The most memory that the command line holds: the arena, the buffers of its files, and what any
 * program takes. */
#define _DEFAULT_SOURCE /* wait4 */

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include "roomseg/roomseg.h"
#include "scratch.h"
#include "unity.h"

#define SIDE 2000u /* cells */
#define SKIPPED 77

/* The program with its libraries, stacks and small blocks. */
#define PROGRAM_BYTES (4u << 20)

/* What the PNG encoder holds beside its copy of the picture: tables and compressed bytes. */
#define ENCODER_BYTES (2u << 20)

static const char *cli;
static char text[65536];

void setUp(void) {
    scratch_open();
}

void tearDown(void) {
    scratch_close();
}

/* A building of rooms of 198 x 198 cells, each with a door of 20 cells to the right and below. */
static const char *write_map(void) {
    static uint8_t cells[SIDE * SIDE + 32];
    int head = snprintf((char *)cells, 32, "P5\n%u %u\n255\n", SIDE, SIDE);
    for (uint32_t y = 0; y < SIDE; y++) {
        for (uint32_t x = 0; x < SIDE; x++) {
            uint32_t across = x % 200, down = y % 200;
            int wall = (across < 2 && !(down > 90 && down < 111 && x > 2)) ||
                       (down < 2 && !(across > 90 && across < 111 && y > 2));
            cells[(size_t)head + y * SIDE + x] = wall ? 255 : 0;
        }
    }
    return scratch_write("map.pgm", cells, (size_t)head + SIDE * SIDE);
}

/* Runs the command line; what it prints goes to `text`. Returns its largest resident size. */
static size_t resident_bytes(char *const arguments[]) {
    const char *answer = scratch_path("answer");
    struct rusage usage;
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        int out = open(answer, O_WRONLY | O_CREAT | O_TRUNC, 0666);
        dup2(out, STDOUT_FILENO);
        execv(cli, arguments);
        _exit(127);
    }
    TEST_ASSERT_TRUE(child > 0);
    TEST_ASSERT_EQUAL_INT(child, wait4(child, &status, 0, &usage));
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(0, WEXITSTATUS(status));
    TEST_ASSERT_EQUAL_INT(1, scratch_read("answer", text, sizeof text - 1));
    return (size_t)usage.ru_maxrss * 1024u;
}

static void check(const char *what, size_t arena, size_t files, size_t measured) {
    char message[160];
    snprintf(message, sizeof message, "%s: %lu KiB resident; arena %lu, files %lu, program %u",
             what, (unsigned long)(measured / 1024), (unsigned long)(arena / 1024),
             (unsigned long)(files / 1024), PROGRAM_BYTES / 1024);
    TEST_MESSAGE(message);
    TEST_ASSERT_TRUE_MESSAGE(measured > arena + files, message); /* else it measures nothing */
    TEST_ASSERT_TRUE_MESSAGE(measured <= arena + files + PROGRAM_BYTES, message);
}

/* Bytes of the canvas of a PNG, 3 a pixel. */
static size_t picture_bytes(const char *name) {
    char head[25];
    size_t sides[2] = {0, 0};
    TEST_ASSERT_EQUAL_INT(1, scratch_read(name, head, sizeof head));
    for (int i = 0; i < 8; i++) {
        sides[i / 4] = sides[i / 4] << 8 | (unsigned char)head[16 + i];
    }
    return sides[0] * sides[1] * 3;
}

static size_t arena_of_answer(const char *mark) {
    const char *at = strstr(text, mark);
    TEST_ASSERT_NOT_NULL_MESSAGE(at, text);
    return (size_t)strtoul(at + strlen(mark), NULL, 10);
}

/* First cells, labels and picture are there at once, then the picture and its encoder. */
static void test_segment(void) {
    char program[] = "roomseg", segment[] = "segment", output[] = "-o";
    char *map = strdup(write_map()), *folder = strdup(scratch_folder());
    char *const arguments[] = {program, segment, map, output, folder, NULL};
    const char *files[] = {"labels.pgm", "rooms.json", "rooms.png"};
    size_t measured = resident_bytes(arguments);
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        scratch_path(files[i]); /* to be removed */
    }
    size_t picture = picture_bytes("rooms.png");
    size_t drawing = SIDE * SIDE * 3 + picture, encoding = 2 * picture + ENCODER_BYTES;
    check("segment", arena_of_answer("arena: "), drawing > encoding ? drawing : encoding,
          measured);
    free(map);
    free(folder);
}

/* Without a picture and without truth: cells and labels. */
static void test_bench(void) {
    char program[] = "roomseg", bench[] = "bench", json[] = "--json";
    char *folder = strdup(scratch_folder());
    char *const arguments[] = {program, bench, folder, json, NULL};
    write_map();
    size_t measured = resident_bytes(arguments);
    check("bench", arena_of_answer("\"arena_bytes\": "), SIDE * SIDE * 3, measured);
    free(folder);
}

int main(int argc, char **argv) {
    if (argc < 2 || access(argv[1], X_OK) != 0) {
        printf("skipped: the command line is not given\n");
        return SKIPPED;
    }
    cli = argv[1];
    UNITY_BEGIN();
    RUN_TEST(test_segment);
    RUN_TEST(test_bench);
    return UNITY_END();
}
