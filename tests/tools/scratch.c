#define _POSIX_C_SOURCE 200809L

#include "scratch.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "unity.h"

#define MAX_PATHS 64

static char folder[64];
static char paths[MAX_PATHS][160];
static int path_count;

void scratch_open(void) {
    path_count = 0;
    strcpy(folder, "roomseg_test_XXXXXX");
    TEST_ASSERT_NOT_NULL_MESSAGE(mkdtemp(folder), "cannot make a folder here");
}

void scratch_close(void) {
    for (int i = path_count - 1; i >= 0; i--) {
        remove(paths[i]);
    }
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, rmdir(folder), "files were left behind");
}

const char *scratch_folder(void) {
    return folder;
}

const char *scratch_path(const char *name) {
    TEST_ASSERT_TRUE(path_count < MAX_PATHS);
    snprintf(paths[path_count], sizeof paths[0], "%s/%s", folder, name);
    return paths[path_count++];
}

const char *scratch_write(const char *name, const void *bytes, size_t size) {
    const char *path = scratch_path(name);
    FILE *stream = fopen(path, "wb");
    TEST_ASSERT_NOT_NULL(stream);
    TEST_ASSERT_EQUAL_size_t(size, fwrite(bytes, 1, size, stream));
    TEST_ASSERT_EQUAL_INT(0, fclose(stream));
    return path;
}

const char *scratch_write_text(const char *name, const char *text) {
    return scratch_write(name, text, strlen(text));
}

int scratch_read(const char *name, char *text, size_t size) {
    FILE *stream = fopen(scratch_path(name), "rb");
    if (stream == NULL) {
        return 0;
    }
    text[fread(text, 1, size - 1, stream)] = '\0';
    fclose(stream);
    return 1;
}

int scratch_count(void) {
    DIR *directory = opendir(folder);
    int count = 0;
    TEST_ASSERT_NOT_NULL(directory);
    while (readdir(directory) != NULL) {
        count++;
    }
    closedir(directory);
    return count - 2; /* . and .. */
}
