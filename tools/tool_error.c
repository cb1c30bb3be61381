#include "tool_error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void tool_error_set(tool_error *error, const char *format, ...) {
    if (error == NULL) {
        return;
    }
    va_list list;
    va_start(list, format);
    int length = vsnprintf(error->text, sizeof error->text, format, list);
    va_end(list);
    if (length < 0) {
        error->text[0] = '\0';
    } else if ((size_t)length >= sizeof error->text) {
        memcpy(error->text + sizeof error->text - 4, "...", 4);
    }
    for (char *c = error->text; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
}

void tool_error_print(const tool_error *error) {
    fprintf(stderr, "roomseg: %s\n", error->text);
}
