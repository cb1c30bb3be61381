/* Command-line arguments and the numbers in them. */
#ifndef ROOMSEG_TOOLS_ARGS_H
#define ROOMSEG_TOOLS_ARGS_H

#include "tool_error.h"

/* One option of a command. Exactly one of `value` and `flag` is set. */
typedef struct arg_option {
    const char *name;   /* with its dashes: "--resolution" */
    const char *letter; /* short form, "-o"; NULL when there is none */
    const char **value; /* receives the text behind the option; left alone when absent */
    int *flag;          /* set to 1 when the option is given */
} arg_option;

/* Sorts arguments 1..argc-1 into options and operands. Understood: `--name TEXT`,
 * `--name=TEXT`, `-o TEXT`, `--` before operands that begin with a dash; a lone `-` is
 * an operand.
 * options: ends with a record whose name is NULL.
 * operands: room for max_operands; *operand_count receives how many there were.
 * Fails iff: an option is unknown, is given twice, lacks its text or has text though it
 * is a flag, or there are too many operands. Returns 0, or -1 with *error set. */
int args_parse(int argc, char **argv, const arg_option *options, const char **operands,
               int max_operands, int *operand_count, tool_error *error);

/* Reads a whole text as a decimal number: digits, sign, point, exponent, nothing else.
 * Fails iff: there is other text, or it is not finite. Returns 0 or -1, no message. */
int parse_real(const char *text, double *out);

/* Reads a whole text as a decimal integer with a sign at most. Fails iff: there is other
 * text, or it is outside low..high. Returns 0 or -1, no message. */
int parse_integer(const char *text, long low, long high, long *out);

/* The same for the value of an option, with a message that names option and range. */
int args_real(const char *option, const char *text, double low, double high, double *out,
              tool_error *error);
int args_integer(const char *option, const char *text, long low, long high, long *out,
                 tool_error *error);

/* Prints the error and the usage text on standard error; returns EXIT_WRONG_USAGE. */
int args_usage_error(const tool_error *error, const char *usage);

#endif
