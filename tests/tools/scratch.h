/* A folder of its own for the files of a test. */
#ifndef TESTS_TOOLS_SCRATCH_H
#define TESTS_TOOLS_SCRATCH_H

#include <stddef.h>

/* Makes the folder. Fails the test when it cannot. */
void scratch_open(void);

/* Removes the folder with the files that scratch_path has named. */
void scratch_close(void);

/* Path of the folder. */
const char *scratch_folder(void);

/* Path of a file in the folder; valid until scratch_close. At most 64 names a test. */
const char *scratch_path(const char *name);

/* Writes a file and returns its path. */
const char *scratch_write(const char *name, const void *bytes, size_t size);
const char *scratch_write_text(const char *name, const char *text);

/* 1 when a file of that name is there; its first bytes go to text, ended by a zero. */
int scratch_read(const char *name, char *text, size_t size);

/* Number of entries in the folder. */
int scratch_count(void);

#endif
