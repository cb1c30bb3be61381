/* The platform of a C library: a desk, or a target with newlib or picolibc. */
#include "platform.h"

#include <stdio.h>
#include <stdlib.h>

#ifdef EMBEDDED_SEMIHOSTING
/* For the start-up code of port/baremetal. */
void platform_exit(int status);
void platform_fault(void);

void platform_exit(int status)
{
    exit(status);
}

void platform_fault(void)
{
    _Exit(99);
}
#endif

#if defined(EMBEDDED_SEMIHOSTING) && defined(__NEWLIB__) && !defined(__PICOLIBC__)
/* Newlib's own start-up code, which port/baremetal replaces, opens the streams and has these. */
void initialise_monitor_handles(void);
void _init(void);
void _fini(void);

void _init(void)
{
}

void _fini(void)
{
}

static void open_streams(void)
{
    static int open;

    if (!open) {
        initialise_monitor_handles();
        open = 1;
    }
}
#else
static void open_streams(void)
{
}
#endif

void platform_write(const char *text)
{
    open_streams();
    fputs(text, stdout);
}

/* Enough for every map of the tests. */
void *platform_memory(size_t *size)
{
    static void *block;
    const size_t bytes = (size_t)EMBEDDED_HEAP_BYTES;

    if (block == NULL) {
        block = malloc(bytes);
    }
    *size = block != NULL ? bytes : 0u;
    return block;
}

void platform_stack_paint(void)
{
}

size_t platform_stack_used(void)
{
    return 0;
}
