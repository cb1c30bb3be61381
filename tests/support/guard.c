#include "guard.h"

#include <stdlib.h>
#include <string.h>

#include "unity.h"

#define ZONE 4096u /* bytes before and behind; a multiple of 64 */
#define ALIGN 64u

/* Differs from byte to byte, so that a block copied from elsewhere is seen too. */
static uint8_t pattern(size_t position)
{
    return (uint8_t)(0xA5u ^ (position * 151u) ^ (position >> 8));
}

static size_t block_size(const guard *g)
{
    return g->size + 2 * ZONE + 2 * ALIGN;
}

guard guard_make(size_t size, size_t shift)
{
    guard g;
    g.size = size;
    g.block = malloc(block_size(&g));
    TEST_ASSERT_NOT_NULL(g.block);
    size_t misfit = (size_t)((uintptr_t)g.block % ALIGN);
    g.memory = g.block + ZONE + (ALIGN - misfit) + shift;
    for (size_t i = 0; i < block_size(&g); i++) {
        g.block[i] = pattern(i);
    }
    return g;
}

static void check_range(const guard *g, size_t first, size_t end, const char *where)
{
    for (size_t i = first; i < end; i++) {
        if (g->block[i] != pattern(i)) {
            TEST_FAIL_MESSAGE(where);
        }
    }
}

void guard_check(const guard *g)
{
    size_t start = (size_t)(g->memory - g->block);
    check_range(g, 0, start, "a byte before the memory was written");
    check_range(g, start + g->size, block_size(g), "a byte behind the memory was written");
}

void guard_check_untouched(const guard *g)
{
    check_range(g, 0, block_size(g), "memory was written that should be untouched");
}

void guard_free(guard *g)
{
    free(g->block);
    g->block = NULL;
    g->memory = NULL;
}
