/* Scores and benchmark results as JSON. Shares from 0 to 1; missing numbers are left out. */
#ifndef ROOMSEG_TOOLS_BENCH_JSON_H
#define ROOMSEG_TOOLS_BENCH_JSON_H

#include <stdio.h>

#include "bench_result.h"

/* One object: every figure of metric_fields and the three counts of rooms; null
 * where the truth has no room (its specks left out). */
void bench_json_print_metrics(FILE *out, const metrics *m);

/* One array with an object per set:
 *   {"name", "maps": [...], "mean": {...}, "deviation": {...},
 *    "mean_without_specks": {...}, "deviation_without_specks": {...}}
 * and per map {"name", "error"} or {"name", "rooms_found", "time_ms", "arena_bytes",
 * "crop_cells", "bytes_per_crop_cell", "stages": {STAGE: {"time_ms", "visits"}},
 * "scores": {...}, "scores_without_specks": {...}}. */
void bench_json_print_sets(FILE *out, const set_result *sets, size_t count);

#endif
