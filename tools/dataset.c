#define _POSIX_C_SOURCE 200809L

#include "dataset.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "out.h"

static const char TRUTH_FOLDER[] = "groundtruth";

/* Endings of maps and truths, the one that says most about itself first. */
static const char *const MAP_ENDINGS[] = {".yaml", ".yml", ".pgm", ".png", NULL};
static const char *const TRUTH_ENDINGS[] = {".pgm", ".png", NULL};

/* What is in a folder, sorted. */
typedef struct name_list {
    char **names;
    size_t count, capacity;
} name_list;

static void name_list_free(name_list *list) {
    for (size_t i = 0; i < list->count; i++) {
        free(list->names[i]);
    }
    free(list->names);
    memset(list, 0, sizeof *list);
}

/* Makes room for one more element of a growing array. Returns the array, or NULL when
 * memory runs out; then the old one is still there. */
static void *reserve(void *array, size_t count, size_t *capacity, size_t element) {
    if (count < *capacity) {
        return array;
    }
    size_t larger = *capacity > 0 ? *capacity * 2 : 16;
    void *moved = realloc(array, larger * element);
    if (moved != NULL) {
        *capacity = larger;
    }
    return moved;
}

static int name_list_add(name_list *list, const char *name) {
    char **names = reserve(list->names, list->count, &list->capacity, sizeof *names);
    if (names == NULL) {
        return -1;
    }
    list->names = names;
    names[list->count] = strdup(name);
    return names[list->count] != NULL ? (list->count++, 0) : -1;
}

static int compare_names(const void *left, const void *right) {
    return strcmp(*(char *const *)left, *(char *const *)right);
}

static int list_folder(const char *folder, name_list *out, tool_error *error) {
    memset(out, 0, sizeof *out);
    DIR *dir = opendir(folder);
    if (dir == NULL) {
        tool_error_set(error, "%s: cannot read the folder: %s", folder, strerror(errno));
        return -1;
    }
    int rc = 0;
    for (struct dirent *entry = readdir(dir); entry != NULL && rc == 0; entry = readdir(dir)) {
        if (entry->d_name[0] != '.') {
            rc = name_list_add(out, entry->d_name);
        }
    }
    closedir(dir);
    if (rc != 0) {
        tool_error_set(error, "%s: out of memory", folder);
        name_list_free(out);
    } else if (out->count > 0) {
        qsort(out->names, out->count, sizeof *out->names, compare_names);
    }
    return rc;
}

int dataset_is_folder(const char *path) {
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* Path of the first file FOLDER/NAME + ending that exists; NULL when there is none (or no
 * memory: *failed is set). */
static char *find_file(const char *folder, const char *name, const char *const *endings,
                       int *failed) {
    for (; *endings != NULL; endings++) {
        struct stat info;
        char file[512];
        if (strlen(name) + strlen(*endings) >= sizeof file) {
            continue;
        }
        strcpy(file, name);
        strcat(file, *endings);
        char *path = out_join(folder, file);
        if (path == NULL) {
            *failed = 1;
            return NULL;
        }
        if (stat(path, &info) == 0 && S_ISREG(info.st_mode)) {
            return path;
        }
        free(path);
    }
    return NULL;
}

char *dataset_find_labels(const char *folder, const char *name, int *failed) {
    return find_file(folder, name, TRUTH_ENDINGS, failed);
}

static int has_map(const dataset_set *set, const char *name) {
    for (size_t i = 0; i < set->count; i++) {
        if (strcmp(set->maps[i].name, name) == 0) {
            return 1;
        }
    }
    return 0;
}

/* Takes map and truth over, also when it fails. */
static int set_add(dataset_set *set, const char *name, char *map, char *truth) {
    dataset_map entry = {strdup(name), map, truth};
    dataset_map *maps = reserve(set->maps, set->count, &set->capacity, sizeof *maps);
    if (maps != NULL) {
        set->maps = maps;
    }
    if (entry.name == NULL || maps == NULL) {
        free(entry.name);
        free(map);
        free(truth);
        return -1;
    }
    maps[set->count++] = entry;
    return 0;
}

/* Adds FOLDER/map.* under this name when there is one. Returns 1, 0 when there is none, or
 * -1 when memory runs out. */
static int add_map_folder(dataset_set *set, const char *folder, const char *name) {
    int failed = 0;
    char *map = find_file(folder, "map", MAP_ENDINGS, &failed);
    if (map == NULL) {
        return failed ? -1 : 0;
    }
    char *truth = find_file(folder, "truth", TRUTH_ENDINGS, &failed);
    if (failed) {
        free(map);
        return -1;
    }
    return set_add(set, name, map, truth) == 0 ? 1 : -1;
}

/* Adds FOLDER/FILE when it has this ending, is a file and has no namesake yet. */
static int add_file(dataset_set *set, const char *folder, const char *file,
                    const char *ending, const char *truth_folder) {
    size_t length = strlen(file);
    size_t tail = strlen(ending);
    if (length <= tail || strcmp(file + length - tail, ending) != 0) {
        return 0;
    }
    char *path = out_join(folder, file);
    char *name = strdup(file);
    if (path == NULL || name == NULL) {
        free(path);
        free(name);
        return -1;
    }
    name[length - tail] = '\0';
    int rc = 0;
    if (dataset_is_folder(path) || has_map(set, name)) {
        free(path);
    } else {
        int failed = 0;
        char *truth = find_file(truth_folder, name, TRUTH_ENDINGS, &failed);
        rc = set_add(set, name, path, truth);
        rc = failed ? -1 : rc;
    }
    free(name);
    return rc;
}

static int compare_maps(const void *left, const void *right) {
    const dataset_map *a = left;
    const dataset_map *b = right;
    return strcmp(a->name, b->name);
}

/* Adds all maps in the folder, in files of their own and in sub-folders. */
static int add_maps(dataset_set *set, const char *folder, const name_list *list,
                    const char *truth_folder) {
    int rc = 0;
    for (size_t i = 0; i < list->count && rc >= 0; i++) {
        char *path = out_join(folder, list->names[i]);
        rc = path == NULL ? -1 : 0;
        if (path != NULL && dataset_is_folder(path)) {
            rc = add_map_folder(set, path, list->names[i]);
        }
        free(path);
    }
    for (const char *const *ending = MAP_ENDINGS; *ending != NULL; ending++) {
        for (size_t i = 0; i < list->count && rc >= 0; i++) {
            rc = add_file(set, folder, list->names[i], *ending, truth_folder);
        }
    }
    if (set->count > 0) {
        qsort(set->maps, set->count, sizeof *set->maps, compare_maps);
    }
    return rc < 0 ? -1 : 0;
}

void dataset_set_free(dataset_set *set) {
    for (size_t i = 0; i < set->count; i++) {
        free(set->maps[i].name);
        free(set->maps[i].map);
        free(set->maps[i].truth);
    }
    free(set->maps);
    free(set->name);
    memset(set, 0, sizeof *set);
}

/* Appends the set unless it is empty; takes it over in any case. */
static int keep_set(dataset *data, dataset_set *set) {
    dataset_set *sets = data->sets;
    if (set->count > 0) {
        sets = reserve(data->sets, data->count, &data->capacity, sizeof *sets);
    }
    if (set->count == 0 || sets == NULL) {
        int rc = set->count == 0 ? 0 : -1;
        dataset_set_free(set);
        return rc;
    }
    data->sets = sets;
    sets[data->count++] = *set;
    return 0;
}

/* The last part of a path, without slashes behind it. Memory to be freed, or NULL. */
static char *base_name(const char *path) {
    size_t end = strlen(path);
    while (end > 1 && path[end - 1] == '/') {
        end--;
    }
    size_t start = end;
    while (start > 0 && path[start - 1] != '/') {
        start--;
    }
    return strndup(path + start, end - start);
}

/* Adds the set that this folder holds, if any. */
static int add_set(dataset *data, const char *folder, const char *truth_folder,
                   tool_error *error) {
    name_list list;
    dataset_set set = {base_name(folder), NULL, 0, 0};
    if (list_folder(folder, &list, error) != 0) {
        dataset_set_free(&set);
        return -1;
    }
    int rc = set.name != NULL ? add_map_folder(&set, folder, set.name) : -1;
    if (rc == 0) {
        rc = add_maps(&set, folder, &list, truth_folder);
    }
    name_list_free(&list);
    if (rc < 0) {
        dataset_set_free(&set);
    } else {
        rc = keep_set(data, &set);
    }
    if (rc < 0) {
        tool_error_set(error, "%s: out of memory", folder);
    }
    return rc;
}

/* Adds the sets in the sub-folders; those with a map.* have been taken as maps before. */
static int add_sub_sets(dataset *data, const char *folder, const char *truth_folder,
                        tool_error *error) {
    name_list list;
    if (list_folder(folder, &list, error) != 0) {
        return -1;
    }
    int rc = 0;
    for (size_t i = 0; i < list.count && rc == 0; i++) {
        int failed = 0;
        char *path = out_join(folder, list.names[i]);
        char *map = path != NULL ? find_file(path, "map", MAP_ENDINGS, &failed) : NULL;
        if (path == NULL || failed) {
            tool_error_set(error, "%s: out of memory", folder);
            rc = -1;
        } else if (map == NULL && dataset_is_folder(path) &&
                   strcmp(list.names[i], TRUTH_FOLDER) != 0) {
            rc = add_set(data, path, truth_folder, error);
        }
        free(map);
        free(path);
    }
    name_list_free(&list);
    return rc;
}

int dataset_pair(const char *folder, const char *truth_folder, dataset_set *out,
                 tool_error *error) {
    name_list list;
    memset(out, 0, sizeof *out);
    if (list_folder(folder, &list, error) != 0) {
        return -1;
    }
    out->name = base_name(folder);
    int rc = out->name != NULL ? 0 : -1;
    for (const char *const *ending = TRUTH_ENDINGS; *ending != NULL; ending++) {
        for (size_t i = 0; i < list.count && rc == 0; i++) {
            rc = add_file(out, folder, list.names[i], *ending, truth_folder);
        }
    }
    name_list_free(&list);
    if (rc != 0 || out->count == 0) {
        tool_error_set(error, "%s: %s", folder,
                       rc != 0 ? "out of memory" : "holds no images (.pgm or .png)");
        dataset_set_free(out);
        return -1;
    }
    qsort(out->maps, out->count, sizeof *out->maps, compare_maps);
    return 0;
}

int dataset_open(const char *folder, dataset *out, tool_error *error) {
    memset(out, 0, sizeof *out);
    char *truth_folder = out_join(folder, TRUTH_FOLDER);
    int rc = -1;
    if (truth_folder == NULL) {
        tool_error_set(error, "%s: out of memory", folder);
    } else {
        rc = add_set(out, folder, truth_folder, error);
    }
    if (rc == 0) {
        rc = add_sub_sets(out, folder, truth_folder, error);
    }
    free(truth_folder);
    if (rc == 0 && out->count == 0) {
        tool_error_set(error, "%s: holds no maps (.png, .pgm or .yaml)", folder);
        rc = -1;
    }
    if (rc != 0) {
        dataset_free(out);
    }
    return rc;
}

void dataset_free(dataset *data) {
    for (size_t i = 0; i < data->count; i++) {
        dataset_set_free(&data->sets[i]);
    }
    free(data->sets);
    memset(data, 0, sizeof *data);
}
