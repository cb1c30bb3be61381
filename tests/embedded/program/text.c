#include "text.h"

#include "platform.h"

void text_string(const char *string)
{
    platform_write(string);
}

void text_number(uint32_t value)
{
    char digits[11]; /* ten of a 32-bit number, and the end */
    char *first = &digits[sizeof digits - 1];

    *first = '\0';
    do {
        *--first = (char)('0' + value % 10u);
        value /= 10u;
    } while (value > 0u);
    platform_write(first);
}

void text_signed(int32_t value)
{
    if (value < 0) {
        platform_write("-");
    }
    text_number(value < 0 ? 0u - (uint32_t)value : (uint32_t)value);
}

void text_hex(uint32_t value)
{
    char digits[9];

    for (int i = 0; i < 8; i++) {
        digits[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15u];
    }
    digits[8] = '\0';
    platform_write(digits);
}

void text_field(const char *name, uint32_t value)
{
    platform_write(" ");
    platform_write(name);
    text_next(value);
}

void text_next(uint32_t value)
{
    platform_write(" ");
    text_number(value);
}
