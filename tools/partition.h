/* The contingency table with rooms and labels numbered and summed up: what the formulas of
 * the metrics run over. */
#ifndef ROOMSEG_TOOLS_PARTITION_H
#define ROOMSEG_TOOLS_PARTITION_H

#include <stddef.h>
#include <stdint.h>

#include "contingency.h"

/* Which cells are taken in beside those that have both a room and a label. */
enum {
    KEEP_UNLABELLED = 1, /* those with label 0 */
    KEEP_OUTSIDE = 2     /* those with truth 0 */
};

typedef struct part {
    uint32_t value; /* truth or label */
    uint64_t cells; /* >= 1 */
} part;

/* Cells that row `row` and column `column` share. */
typedef struct shared {
    size_t row, column;
    uint64_t cells; /* >= 1 */
} shared;

/* Rows (rooms) and columns (labels) in rising order of their values; `pairs` in rising
 * order of row, then column. All owned. */
typedef struct partition {
    part *rows, *columns;
    shared *pairs;
    size_t row_count, column_count, pair_count;
    uint64_t total; /* cells taken in */
} partition;

/* keep: a sum of KEEP_ values. Fails iff: memory runs out. Returns 0, or -1 with *p zeroed. */
int partition_build(const contingency *table, unsigned keep, partition *p);

/* Frees the arrays and zeroes the record. */
void partition_free(partition *p);

#endif
