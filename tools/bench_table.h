/* Benchmark results as text tables. */
#ifndef ROOMSEG_TOOLS_BENCH_TABLE_H
#define ROOMSEG_TOOLS_BENCH_TABLE_H

#include <stdio.h>

#include "bench_result.h"

/* The paper's Table I for a set: a line per map, mean and deviation with and without
 * specks in the truth, and the published means where the set bears a published set's
 * name. Sets without truth: rooms and cost alone. Shares in percent. */
void bench_table_print(FILE *out, const set_result *set);

/* The cost of each stage, mean of a set's maps; nothing when it was not measured. */
void bench_table_print_stages(FILE *out, const set_result *set);

/* The paper's Table II: recall and precision of the sets with truth, mean and deviation,
 * beside the published means. Prints nothing when no set has truth. */
void bench_table_print_summary(FILE *out, const set_result *sets, size_t count);

#endif
