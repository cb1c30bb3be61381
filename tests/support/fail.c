#include "fail.h"

#include <stdarg.h>
#include <stdio.h>

#include "unity.h"

void fail_with(const char *format, ...)
{
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    TEST_FAIL_MESSAGE(text);
}
