/* The files of an explanation, all of them or none. */
#ifndef ROOMSEG_EXPLAIN_FILES_H
#define ROOMSEG_EXPLAIN_FILES_H

#include "album.h"
#include "tool_error.h"

/* Writes the page and the album's pictures into a folder, which is made when it is missing. All
 * are written under temporary names before any gets its own, so that a full disk leaves what was
 * there. Returns 0, or -1 with *error set. */
int files_write(const char *folder, const album *a, const char *page_name, const char *page,
                size_t page_size, tool_error *error);

#endif
