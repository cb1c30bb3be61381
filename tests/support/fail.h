/* Failing with numbers in the message. */
#ifndef SUPPORT_FAIL_H
#define SUPPORT_FAIL_H

/* Fails the test with a message formatted as by printf. */
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
void fail_with(const char *format, ...);

#endif
