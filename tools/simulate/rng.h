/* The simulator's random numbers: the same on every machine and compiler.
 * Two draws never stand in one expression, as C leaves their order open. */
#ifndef ROOMSEG_SIMULATE_RNG_H
#define ROOMSEG_SIMULATE_RNG_H

#include <stdint.h>

typedef struct rng {
    uint64_t state;
} rng;

/* Streams of one seed are independent: more draws in one leave the others alone. */
void rng_seed(rng *r, uint64_t seed, uint32_t stream);

uint32_t rng_next(rng *r);

/* Uniform in low..high, both ends inside; high >= low and high - low < 2^31. */
int32_t rng_range(rng *r, int32_t low, int32_t high);

/* 1 with a probability of permille / 1000. */
int rng_chance(rng *r, int32_t permille);

/* About normal, mean 0 (four uniform numbers added up: never beyond 3.5 sigma). */
int32_t rng_normal(rng *r, int32_t sigma);

#endif
