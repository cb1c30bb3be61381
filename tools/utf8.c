#include "utf8.h"

#include <stddef.h>

int utf8_length(const unsigned char *at) {
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
