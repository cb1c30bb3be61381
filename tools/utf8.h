/* UTF-8 in texts that may be anything, such as a file's name. */
#ifndef ROOMSEG_TOOLS_UTF8_H
#define ROOMSEG_TOOLS_UTF8_H

/* Length of the UTF-8 character at `at`, 0 when there is none: no overlong forms, no
 * surrogates, nothing above U+10FFFF. Stops at the string's end, as a zero byte is no
 * continuation. */
int utf8_length(const unsigned char *at);

#endif
