/* The subcommands. Each gets the arguments behind `roomseg`, argv[0] being its own name,
 * and returns the exit code of the program. */
#ifndef ROOMSEG_TOOLS_COMMANDS_H
#define ROOMSEG_TOOLS_COMMANDS_H

enum {
    EXIT_DONE = 0,
    EXIT_BAD_INPUT = 1,  /* a file, or what is in it; also: cannot write */
    EXIT_WRONG_USAGE = 2 /* unknown options, missing operands, values out of range */
};

int cmd_segment(int argc, char **argv);
int cmd_eval(int argc, char **argv);
int cmd_bench(int argc, char **argv);
int cmd_explain(int argc, char **argv);
int cmd_simulate(int argc, char **argv);
int cmd_vary(int argc, char **argv);

#endif
