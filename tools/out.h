/* Output files that appear whole or not at all. */
#ifndef ROOMSEG_TOOLS_OUT_H
#define ROOMSEG_TOOLS_OUT_H

#include <stdio.h>

#include "tool_error.h"

/* A file under its temporary name, in the folder of its final one. Write to `stream` as
 * you like; out_commit looks at the stream's error flag. */
typedef struct out_file {
    FILE *stream;
    char *path; /* final name */
    char *temp; /* name until out_commit */
} out_file;

/* Makes a folder and the missing ones above it. Returns 0, or -1 with *error set.
 * A folder that exists is no error; another kind of file of that name is. */
int out_make_folder(const char *path, tool_error *error);

/* "FOLDER/NAME" in memory of its own, to be freed; NULL when there is none left. */
char *out_join(const char *folder, const char *name);

/* Opens the temporary file. Returns 0, or -1 with *error set and *file zeroed. */
int out_open(out_file *file, const char *path, tool_error *error);

/* The same for the file FOLDER/NAME. */
int out_open_in(out_file *file, const char *folder, const char *name, tool_error *error);

/* Writes out what the stream still holds, for a message before other files are committed.
 * Returns 0, or -1 with *error set; the file stays open in both cases. */
int out_flush(out_file *file, tool_error *error);

/* Flushes, closes and renames to the final name, which replaces what was there.
 * When anything has failed, the temporary file goes and what was there stays.
 * Returns 0, or -1 with *error set; *file is zeroed in both cases. */
int out_commit(out_file *file, tool_error *error);

/* Closes and removes the temporary file; does nothing to a zeroed record. */
void out_discard(out_file *file);

/* Commits files that belong together, in order, if rc is 0 and until one fails; discards the
 * others. Flush all before, so that a full disk leaves what was there. Passes over zeroed records.
 * Returns rc, or -1 with *error set; the files are zeroed in all cases. */
int out_end_all(out_file *files, size_t count, int rc, tool_error *error);

#endif
