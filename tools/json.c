#include "json.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>

#include "utf8.h"

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
