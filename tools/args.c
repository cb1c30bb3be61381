#include "args.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"

/* Position in argv and what has been found so far. */
typedef struct parser {
    int argc;
    char **argv;
    int next;
    const arg_option *options;
    unsigned long given; /* bit i: option i was there */
    tool_error *error;
} parser;

/* Index of the option in `text`, or -1. *attached receives the text behind '=' or NULL. */
static int find_option(const arg_option *options, const char *text, const char **attached) {
    const char *equals = strchr(text, '=');
    size_t length = equals != NULL ? (size_t)(equals - text) : strlen(text);
    *attached = NULL;
    for (int i = 0; options[i].name != NULL; i++) {
        if (strlen(options[i].name) == length && strncmp(options[i].name, text, length) == 0) {
            *attached = equals != NULL ? equals + 1 : NULL;
            return i;
        }
        if (options[i].letter != NULL && strcmp(options[i].letter, text) == 0) {
            return i;
        }
    }
    return -1;
}

static int take_option(parser *p, const char *text) {
    const char *attached;
    int i = find_option(p->options, text, &attached);
    if (i < 0) {
        tool_error_set(p->error, "unknown option '%s'", text);
        return -1;
    }
    const arg_option *option = &p->options[i];
    if ((p->given >> i & 1u) != 0) {
        tool_error_set(p->error, "option %s is given twice", option->name);
        return -1;
    }
    p->given |= 1ul << i;
    if (option->flag != NULL) {
        if (attached != NULL) {
            tool_error_set(p->error, "option %s takes no value", option->name);
            return -1;
        }
        *option->flag = 1;
        return 0;
    }
    if (attached == NULL && p->next < p->argc) {
        attached = p->argv[p->next++];
    }
    if (attached == NULL || *attached == '\0') {
        tool_error_set(p->error, "option %s needs a value", option->name);
        return -1;
    }
    *option->value = attached;
    return 0;
}

int args_parse(int argc, char **argv, const arg_option *options, const char **operands,
               int max_operands, int *operand_count, tool_error *error) {
    parser p = {argc, argv, 1, options, 0, error};
    int only_operands = 0;
    *operand_count = 0;
    while (p.next < argc) {
        const char *text = argv[p.next++];
        if (!only_operands && strcmp(text, "--") == 0) {
            only_operands = 1;
        } else if (!only_operands && text[0] == '-' && text[1] != '\0') {
            if (take_option(&p, text) != 0) {
                return -1;
            }
        } else if (*operand_count == max_operands) {
            tool_error_set(error, "unexpected argument '%s'", text);
            return -1;
        } else {
            operands[(*operand_count)++] = text;
        }
    }
    return 0;
}

int parse_real(const char *text, double *out) {
    /* strtod would also take blanks in front, hexadecimal, inf and nan. */
    if (*text == '\0' || text[strspn(text, "0123456789+-.eE")] != '\0') {
        return -1;
    }
    char *end;
    double value = strtod(text, &end);
    if (*end != '\0' || !isfinite(value)) {
        return -1;
    }
    *out = value;
    return 0;
}

int parse_integer(const char *text, long low, long high, long *out) {
    if (*text == '\0' || text[strspn(text, "0123456789+-")] != '\0') {
        return -1;
    }
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    if (*end != '\0' || errno != 0 || value < low || value > high) {
        return -1;
    }
    *out = value;
    return 0;
}

int args_real(const char *option, const char *text, double low, double high, double *out,
              tool_error *error) {
    double value;
    if (parse_real(text, &value) != 0 || value < low || value > high) {
        tool_error_set(error, "option %s needs a number from %g to %g, not '%s'", option, low,
                       high, text);
        return -1;
    }
    *out = value;
    return 0;
}

int args_integer(const char *option, const char *text, long low, long high, long *out,
                 tool_error *error) {
    if (parse_integer(text, low, high, out) != 0) {
        tool_error_set(error, "option %s needs a whole number from %ld to %ld, not '%s'", option,
                       low, high, text);
        return -1;
    }
    return 0;
}

int args_usage_error(const tool_error *error, const char *usage) {
    tool_error_print(error);
    fputs(usage, stderr);
    return EXIT_WRONG_USAGE;
}
