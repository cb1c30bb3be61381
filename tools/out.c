#define _POSIX_C_SOURCE 200809L

#include "out.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int make_one_folder(const char *path, tool_error *error) {
    if (mkdir(path, 0777) == 0) {
        return 0;
    }
    int cause = errno;
    struct stat info;
    if (stat(path, &info) == 0) {
        if (S_ISDIR(info.st_mode)) {
            return 0;
        }
        cause = ENOTDIR;
    }
    tool_error_set(error, "%s: cannot make the folder: %s", path, strerror(cause));
    return -1;
}

int out_make_folder(const char *path, tool_error *error) {
    char *copy = out_join(path, "");
    if (copy == NULL) {
        tool_error_set(error, "%s: out of memory", path);
        return -1;
    }
    int rc = 0;
    for (char *slash = strchr(copy + 1, '/'); slash != NULL && rc == 0;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        rc = make_one_folder(copy, error);
        *slash = '/';
    }
    free(copy);
    return rc;
}

char *out_join(const char *folder, const char *name) {
    size_t size = strlen(folder) + strlen(name) + 2;
    char *path = malloc(size);
    if (path != NULL) {
        snprintf(path, size, "%s/%s", folder, name);
    }
    return path;
}

/* Opens NAME.N.tmp for writing, N being the first number for which no file exists. */
static FILE *open_temp(const char *path, char *temp, size_t size) {
    for (unsigned n = 0; n < 1000; n++) {
        snprintf(temp, size, "%s.%u.tmp", path, n);
        /* Exclusive, so that two runs stay out of each other's files. */
        int descriptor = open(temp, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (descriptor >= 0) {
            FILE *stream = fdopen(descriptor, "wb");
            if (stream == NULL) {
                close(descriptor);
                remove(temp);
            }
            return stream;
        }
        if (errno != EEXIST) {
            return NULL;
        }
    }
    return NULL;
}

int out_open(out_file *file, const char *path, tool_error *error) {
    size_t length = strlen(path);
    size_t temp_size = length + sizeof ".999.tmp";
    *file = (out_file){NULL, malloc(length + 1), malloc(temp_size)};
    if (file->path == NULL || file->temp == NULL) {
        tool_error_set(error, "%s: out of memory", path);
    } else {
        memcpy(file->path, path, length + 1);
        file->stream = open_temp(path, file->temp, temp_size);
        if (file->stream != NULL) {
            return 0;
        }
        tool_error_set(error, "%s: cannot write: %s", path, strerror(errno));
    }
    free(file->path);
    free(file->temp);
    *file = (out_file){NULL, NULL, NULL};
    return -1;
}

int out_open_in(out_file *file, const char *folder, const char *name, tool_error *error) {
    char *path = out_join(folder, name);
    if (path == NULL) {
        tool_error_set(error, "%s/%s: out of memory", folder, name);
        *file = (out_file){NULL, NULL, NULL};
        return -1;
    }
    int rc = out_open(file, path, error);
    free(path);
    return rc;
}

/* Flushes; 0, or the errno of what could not be written now or before. */
static int flush_stream(FILE *stream) {
    errno = 0;
    if (fflush(stream) == 0 && !ferror(stream)) {
        return 0;
    }
    return errno != 0 ? errno : EIO;
}

int out_flush(out_file *file, tool_error *error) {
    int cause = flush_stream(file->stream);
    if (cause != 0) {
        tool_error_set(error, "%s: cannot write: %s", file->path, strerror(cause));
    }
    return cause == 0 ? 0 : -1;
}

int out_commit(out_file *file, tool_error *error) {
    int cause = flush_stream(file->stream);
    if (fclose(file->stream) != 0 && cause == 0) {
        cause = errno;
    }
    if (cause == 0 && rename(file->temp, file->path) != 0) {
        cause = errno;
    }
    if (cause != 0) {
        remove(file->temp);
        tool_error_set(error, "%s: cannot write: %s", file->path, strerror(cause));
    }
    free(file->path);
    free(file->temp);
    *file = (out_file){NULL, NULL, NULL};
    return cause == 0 ? 0 : -1;
}

void out_discard(out_file *file) {
    if (file->stream != NULL) {
        fclose(file->stream);
        remove(file->temp);
    }
    free(file->path);
    free(file->temp);
    *file = (out_file){NULL, NULL, NULL};
}

int out_end_all(out_file *files, size_t count, int rc, tool_error *error) {
    for (size_t i = 0; i < count; i++) {
        if (rc == 0 && files[i].stream != NULL) {
            rc = out_commit(&files[i], error);
        } else {
            out_discard(&files[i]);
        }
    }
    return rc;
}
