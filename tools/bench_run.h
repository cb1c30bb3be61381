/* One map of a benchmark: run, time, score. */
#ifndef ROOMSEG_TOOLS_BENCH_RUN_H
#define ROOMSEG_TOOLS_BENCH_RUN_H

#include "bench_reference.h"
#include "bench_result.h"
#include "dataset.h"
#include "map.h"
#include "roomseg/roomseg.h"
#include "tool_error.h"

#define BENCH_MAX_REPETITIONS 1000

typedef struct bench_settings {
    map_options map;
    roomseg_config config;
    bench_reference reference;
    int repetitions;           /* 1..BENCH_MAX_REPETITIONS */
    int stages;                /* measure each stage too */
    const char *labels_folder; /* where FOLDER/SET/NAME.pgm go; NULL: nowhere */
} bench_settings;

/* Segments the map once for its rooms, then `repetitions` times for the time: CPU time of
 * this thread in roomseg_run alone, with the arena already touched. Scores the labels when
 * the map has a truth, and against the reference's when that has the map.
 * Fails iff: map, truth or reference cannot be read, their sizes differ, the library refuses
 * the map, the labels cannot be written, or memory runs out. Returns 0, or -1 with *error set. */
int bench_run_map(const bench_settings *settings, const dataset_set *set,
                  const dataset_map *files, map_result *out, tool_error *error);

#endif
