/* Bytes as text, for pictures inside of a page (RFC 4648). */
#ifndef ROOMSEG_EXPLAIN_BASE64_H
#define ROOMSEG_EXPLAIN_BASE64_H

#include <stddef.h>
#include <stdio.h>

void base64_write(FILE *stream, const char *bytes, size_t size);

#endif
