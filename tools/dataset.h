/* Finding the maps of a benchmark in a folder. */
#ifndef ROOMSEG_TOOLS_DATASET_H
#define ROOMSEG_TOOLS_DATASET_H

#include <stddef.h>

#include "tool_error.h"

typedef struct dataset_map {
    char *name;  /* file name without its ending, or the sub-folder's name */
    char *map;   /* path */
    char *truth; /* path; NULL when there is none */
} dataset_map;

typedef struct dataset_set {
    char *name;
    dataset_map *maps; /* sorted by name */
    size_t count, capacity;
} dataset_set;

typedef struct dataset {
    dataset_set *sets; /* sorted by name; none is empty */
    size_t count, capacity;
} dataset;

/* Looks for maps:
 *   FOLDER/SET/NAME.png|.pgm|.yaml    a set per sub-folder; truth in FOLDER/groundtruth/
 *                                     under the same NAME, .png or .pgm
 *   FOLDER/NAME/map.png|.pgm|.yaml    one set, called as FOLDER; truth beside the map as
 *                                     truth.png or truth.pgm
 *   FOLDER/NAME.png|.pgm|.yaml        one set, called as FOLDER; truth as in the first
 * Where a YAML file names an image of the same NAME, the image is no map of its own.
 * Hidden files and the folder groundtruth are passed over.
 * Fails iff: a folder cannot be read, no map is found, or memory runs out. Returns 0, or
 * -1 with *error set and *out zeroed. */
int dataset_open(const char *folder, dataset *out, tool_error *error);

/* Pairs the images (.pgm, .png) of one folder with those of the same NAME in another; what
 * has no partner has no truth. Fails iff: the first folder cannot be read or holds no image,
 * or memory runs out. Returns 0, or -1 with *error set and *out zeroed. */
int dataset_pair(const char *folder, const char *truth_folder, dataset_set *out,
                 tool_error *error);

/* Path of FOLDER/NAME.pgm or .png, whichever exists first. Memory to be freed; NULL when there
 * is none, or when memory runs out: then *failed is set. */
char *dataset_find_labels(const char *folder, const char *name, int *failed);

/* 1 when the path leads to a folder. */
int dataset_is_folder(const char *path);

/* Free the names and zero the record. */
void dataset_free(dataset *data);
void dataset_set_free(dataset_set *set);

#endif
