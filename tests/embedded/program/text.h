/* Text without a C library. */
#ifndef EMBEDDED_TEXT_H
#define EMBEDDED_TEXT_H

#include <stdint.h>

void text_string(const char *string);
void text_number(uint32_t value);
void text_signed(int32_t value);
void text_hex(uint32_t value); /* eight digits */

/* " NAME VALUE", and " VALUE" for a further number of the same name. */
void text_field(const char *name, uint32_t value);
void text_next(uint32_t value);

#endif
