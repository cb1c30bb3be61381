#include "files.h"

#include <stdlib.h>

#include "out.h"

static int open_and_write(const char *folder, const char *name, const char *bytes, size_t size,
                          out_file *file, tool_error *error) {
    if (out_open_in(file, folder, name, error) != 0) {
        return -1;
    }
    fwrite(bytes, 1, size, file->stream);
    return out_flush(file, error);
}

int files_write(const char *folder, const album *a, const char *page_name, const char *page,
                size_t page_size, tool_error *error) {
    size_t count = a->count + 1;
    out_file *files = calloc(count, sizeof *files);
    if (files == NULL) {
        tool_error_set(error, "%s: out of memory", folder);
        return -1;
    }
    int rc = out_make_folder(folder, error);
    for (size_t i = 0; i < a->count && rc == 0; i++) {
        const figure *f = &a->figures[i];
        rc = open_and_write(folder, f->file, f->full.bytes, f->full.size, &files[i], error);
    }
    if (rc == 0) {
        rc = open_and_write(folder, page_name, page, page_size, &files[a->count], error);
    }
    rc = out_end_all(files, count, rc, error);
    free(files);
    return rc;
}
