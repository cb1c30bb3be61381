/* What roomseg needs of the C library, for builds with -nostdlib; memory.c defines it. */
#ifndef ROOMSEG_PORT_STRING_H
#define ROOMSEG_PORT_STRING_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

#endif
