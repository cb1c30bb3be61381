#include "json.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>

/* Length of the UTF-8 character at `at`, 0 when there is none: no overlong forms, no
 * surrogates, nothing above U+10FFFF. Stops at the string's end, as a zero byte is no
 * continuation. */
static int utf8_length(const unsigned char *at) {
    static const struct {
        unsigned char first_low, first_high, second_low, second_high;
        int length;
    } forms[] = {
        {0x01, 0x7F, 0x00, 0xFF, 1}, {0xC2, 0xDF, 0x80, 0xBF, 2}, {0xE0, 0xE0, 0xA0, 0xBF, 3},
        {0xE1, 0xEC, 0x80, 0xBF, 3}, {0xED, 0xED, 0x80, 0x9F, 3}, {0xEE, 0xEF, 0x80, 0xBF, 3},
        {0xF0, 0xF0, 0x90, 0xBF, 4}, {0xF1, 0xF3, 0x80, 0xBF, 4}, {0xF4, 0xF4, 0x80, 0x8F, 4},
    };
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        if (at[0] < forms[i].first_low || at[0] > forms[i].first_high) {
            continue;
        }
        int good = forms[i].length == 1 ||
                   (at[1] >= forms[i].second_low && at[1] <= forms[i].second_high);
        for (int k = 2; good && k < forms[i].length; k++) {
            good = (at[k] & 0xC0) == 0x80;
        }
        return good ? forms[i].length : 0;
    }
    return 0;
}

void json_string(FILE *stream, const char *text) {
    const unsigned char *at = (const unsigned char *)text;
    putc('"', stream);
    while (*at != '\0') {
        int length = utf8_length(at);
        if (length == 0) {
            fputs("\\ufffd", stream);
            length = 1;
        } else if (*at == '"' || *at == '\\') {
            fprintf(stream, "\\%c", *at);
        } else if (*at < 0x20 || *at == 0x7F) {
            fprintf(stream, "\\u%04x", (unsigned)*at);
        } else {
            fwrite(at, 1, (size_t)length, stream);
        }
        at += length;
    }
    putc('"', stream);
}

void json_number(FILE *stream, double value, int decimals) {
    int64_t unit = 1;
    for (int i = 0; i < decimals; i++) {
        unit *= 10;
    }
    if (!(fabs(value) <= 1e9)) {
        fputs("null", stream);
        return;
    }
    int64_t scaled = llround(fabs(value) * (double)unit);
    int64_t fraction = scaled % unit;
    while (decimals > 0 && fraction % 10 == 0) {
        fraction /= 10;
        decimals--;
    }
    fprintf(stream, "%s%" PRId64, value < 0 && scaled != 0 ? "-" : "", scaled / unit);
    if (decimals > 0) {
        fprintf(stream, ".%0*" PRId64, decimals, fraction);
    }
}
