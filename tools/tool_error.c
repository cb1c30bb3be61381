#include "tool_error.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define KEPT_FRONT 160u /* characters of a text that is too long, before the "..." */

/* Replaces a text that was cut off at its end by one that lacks its middle. */
static void keep_both_ends(tool_error *error, size_t length, const char *format, va_list list) {
    char *whole = malloc(length + 1u);
    size_t kept_end = sizeof error->text - 1u - KEPT_FRONT - 3u;

    if (whole != NULL && vsnprintf(whole, length + 1u, format, list) == (int)length) {
        memcpy(error->text + KEPT_FRONT, "...", 3);
        memcpy(error->text + KEPT_FRONT + 3, whole + length - kept_end, kept_end + 1u);
    } else {
        memcpy(error->text + sizeof error->text - 4, "...", 4);
    }
    free(whole);
}

void tool_error_set(tool_error *error, const char *format, ...) {
    if (error == NULL) {
        return;
    }
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    int length = vsnprintf(error->text, sizeof error->text, format, list);
    if (length < 0) {
        error->text[0] = '\0';
    } else if ((size_t)length >= sizeof error->text) {
        keep_both_ends(error, (size_t)length, format, again);
    }
    va_end(again);
    va_end(list);
    for (char *c = error->text; *c != '\0'; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
}

void tool_error_print(const tool_error *error) {
    fprintf(stderr, "roomseg: %s\n", error->text);
}
