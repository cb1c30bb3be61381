#include "guard.h"

#include <stdlib.h>
#include <string.h>

#include "fail.h"
#include "unity.h"

#define ZONE 4096u /* bytes before and behind; a multiple of 64 */
#define ALIGN 64u

/* Differs from byte to byte, so that a block copied from elsewhere is seen too. */
static uint8_t pattern(size_t position)
{
    return (uint8_t)(0xA5u ^ (position * 151u) ^ (position >> 8));
}

guard guard_make(size_t size, size_t shift)
{
    guard g;
    g.size = size;
    g.block_size = size + 2 * ZONE + 2 * ALIGN;
    g.block = malloc(g.block_size);
    g.expected = malloc(g.block_size);
    TEST_ASSERT_TRUE(g.block != NULL && g.expected != NULL);
    size_t misfit = (size_t)((uintptr_t)g.block % ALIGN);
    g.memory = g.block + ZONE + (ALIGN - misfit) + shift;
    for (size_t i = 0; i < g.block_size; i++) {
        g.expected[i] = pattern(i);
    }
    memcpy(g.block, g.expected, g.block_size);
    return g;
}

static void check_range(const guard *g, size_t first, size_t end)
{
    if (memcmp(g->block + first, g->expected + first, end - first) == 0) {
        return;
    }
    size_t i = first;
    while (g->block[i] == g->expected[i]) {
        i++;
    }
    fail_with("byte %ld of %ld bytes was written", (long)(i - (size_t)(g->memory - g->block)),
              (long)g->size);
}

void guard_check_beyond(const guard *g, size_t used)
{
    size_t start = (size_t)(g->memory - g->block);
    check_range(g, 0, start);
    check_range(g, start + used, g->block_size);
}

void guard_check(const guard *g)
{
    guard_check_beyond(g, g->size);
}

void guard_check_untouched(const guard *g)
{
    check_range(g, 0, g->block_size);
}

void guard_free(guard *g)
{
    free(g->block);
    free(g->expected);
    g->block = NULL;
    g->expected = NULL;
    g->memory = NULL;
}
