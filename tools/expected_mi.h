/* The mutual information that two partitions share by chance. */
#ifndef ROOMSEG_TOOLS_EXPECTED_MI_H
#define ROOMSEG_TOOLS_EXPECTED_MI_H

#include <stddef.h>
#include <stdint.h>

/* Mean mutual information [nat] of two partitions of `total` cells whose parts have these
 * sizes, over all equally likely ways to deal out the cells: for each pair of parts the
 * overlap n has the hypergeometric distribution P(n), so
 *     E = sum_ij sum_n P(n) n/N log(N n / (a(i) b(j))).
 * Exact to rounding: only terms whose probability is below 1e-20 of the likeliest are left
 * out. Sizes are >= 1 and each list adds up to total. */
double expected_mutual_information(const uint64_t *a, size_t a_count, const uint64_t *b,
                                   size_t b_count, uint64_t total);

#endif
