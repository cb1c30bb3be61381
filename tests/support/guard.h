/* Memory between two guard zones. A write outside is found byte for byte. */
#ifndef SUPPORT_GUARD_H
#define SUPPORT_GUARD_H

#include <stddef.h>
#include <stdint.h>

typedef struct guard {
    uint8_t *memory;   /* size bytes between the zones */
    size_t size;
    uint8_t *block;    /* the whole of it, owned */
    uint8_t *expected; /* what the block was filled with, owned */
    size_t block_size;
} guard;

/* memory is a multiple of 64 plus `shift` (below 64), and filled with a pattern that no
 * run relies on. */
guard guard_make(size_t size, size_t shift);

/* Fails the test when a byte of either zone has changed. */
void guard_check(const guard *g);

/* The same, the zone behind beginning after the first `used` bytes of the memory. */
void guard_check_beyond(const guard *g, size_t used);

/* The same, no byte between the zones may have changed either. */
void guard_check_untouched(const guard *g);

void guard_free(guard *g);

#endif
