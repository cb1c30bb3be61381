/* What a benchmark found: records per map and set, means and deviations. */
#ifndef ROOMSEG_TOOLS_BENCH_RESULT_H
#define ROOMSEG_TOOLS_BENCH_RESULT_H

#include <stddef.h>
#include <stdint.h>

#include "score.h"
#include "stage_costs.h"
#include "tool_error.h"

typedef struct map_result {
    char *name;         /* owned */
    tool_error failure; /* empty text: all went well; else nothing below holds */

    int has_score;
    score score;

    int has_reference;
    metrics reference;    /* another program's labels as truth */

    int has_cost;         /* the library was run here */
    uint32_t rooms;       /* rooms it found */
    double time_ms;       /* CPU time of one roomseg_run, median of the repetitions */
    size_t arena_bytes;
    uint64_t crop_cells;  /* width * height of the free cells' bounding box */

    int has_stages;
    stage_costs stages;
} map_result;

typedef struct set_result {
    char *name; /* owned */
    map_result *maps;
    size_t count, capacity;
} set_result;

/* One number per map: first the figures of metric_fields, then these. */
enum {
    RESULT_ROOMS_FOUND = METRIC_COUNT,
    RESULT_ROOMS_TRUE,
    RESULT_TIME_MS,
    RESULT_ARENA_BYTES,
    RESULT_BYTES_PER_CELL, /* arena bytes per cell of the crop */
    RESULT_REFERENCE_ROOMS,
    RESULT_REFERENCE_ARI,
    RESULT_COLUMN_COUNT
};

/* Its name in JSON. */
const char *result_column_name(size_t column);

/* 1 and *value when the map has such a number, else 0. */
int result_value(const map_result *map, size_t column, int without_specks, double *value);

typedef struct spread {
    size_t count;      /* maps that have the number */
    double mean;       /* 0 when there are none */
    double deviation;  /* sample standard deviation (n - 1); 0 below two */
} spread;

spread result_spread(const set_result *set, size_t column, int without_specks);

/* 1 when a map of the set has a score. */
int result_has_scores(const set_result *set);

/* Number of maps that failed. */
size_t result_failures(const set_result *set);

/* Starts an empty set. Returns 0, or -1 when memory runs out. */
int set_result_open(set_result *set, const char *name);

/* Appends a zeroed record for a map; NULL when memory runs out. It stays where it is until
 * the next call. */
map_result *set_result_add(set_result *set, const char *map_name);

/* Frees the records and zeroes the set. */
void set_result_free(set_result *set);

#endif
