/* Numbers that are the same on every machine. */
#ifndef SUPPORT_RANDOM_H
#define SUPPORT_RANDOM_H

#include <stdint.h>

/* The next number after *state, which it becomes: xorshift32 (Marsaglia 2003). Never 0, and
 * *state must not be. */
uint32_t random_next(uint32_t *state);

#endif
