#include "rng.h"

/* A counter that is hashed: an odd step visits all 2^64 states, the finisher scatters
 * them. Any seed is as good as any other, 0 as well. */
static uint64_t scatter(uint64_t z) {
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static uint64_t next64(rng *r) {
    r->state += UINT64_C(0x9e3779b97f4a7c15);
    return scatter(r->state);
}

void rng_seed(rng *r, uint64_t seed, uint32_t stream) {
    r->state = scatter(seed) ^ scatter(~(uint64_t)stream);
}

uint32_t rng_next(rng *r) {
    return (uint32_t)(next64(r) >> 32);
}

int32_t rng_range(rng *r, int32_t low, int32_t high) {
    uint64_t span = (uint64_t)(high - low) + 1;
    return low + (int32_t)((rng_next(r) * span) >> 32);
}

int rng_chance(rng *r, int32_t permille) {
    return rng_range(r, 0, 999) < permille;
}

int32_t rng_normal(rng *r, int32_t sigma) {
    uint64_t bits = next64(r);
    int64_t sum = 0;
    for (int i = 0; i < 4; i++) {
        sum += (int64_t)(bits & 0xffff);
        bits >>= 16;
    }
    /* Mean 4 * 65535 / 2, standard deviation 65536 / sqrt(3). */
    return (int32_t)((sum - 131070) * sigma / 37837);
}
