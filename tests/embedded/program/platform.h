/* What the test program asks of the place where it runs. */
#ifndef EMBEDDED_PLATFORM_H
#define EMBEDDED_PLATFORM_H

#include <stddef.h>

/* Writes a text. */
void platform_write(const char *text);

/* All the memory that there is, aligned to 8 bytes. *size: its length [bytes]. */
void *platform_memory(size_t *size);

/* Fills the free part of the stack with a pattern, so that platform_stack_used() can tell how
 * many bytes below the caller's frame were written since. 0 where the stack is not known. */
void platform_stack_paint(void);
size_t platform_stack_used(void);

#endif
