/* How the tools report a failure: one line for the user. */
#ifndef ROOMSEG_TOOLS_TOOL_ERROR_H
#define ROOMSEG_TOOLS_TOOL_ERROR_H

/* One line for the user: what went wrong with which file. Empty when nothing did. */
typedef struct tool_error {
    char text[512];
} tool_error;

/* Formats a message as printf does; the file's name belongs in front: "FILE: cause".
 * Control characters become '?', so that a file's name cannot break the line; a text that is
 * too long loses its middle to "...", so that the cause stays. error may be NULL. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void tool_error_set(tool_error *error, const char *format, ...);

/* Prints "roomseg: TEXT" as one line on standard error. */
void tool_error_print(const tool_error *error);

#endif
