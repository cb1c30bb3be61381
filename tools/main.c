/* roomseg COMMAND ...: finds the command and hands it the arguments. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "args.h"
#include "commands.h"
#include "roomseg/roomseg.h"
#include "tool_error.h"

typedef struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *purpose;
} command;

static const command commands[] = {
    {"segment", cmd_segment, "cut a map into rooms"},
    {"eval", cmd_eval, "compare labels with the truth"},
    {"bench", cmd_bench, "run a data set, print quality, time and memory"},
    {"explain", cmd_explain, "draw every step from a map to its rooms, as one page"},
    {"simulate", cmd_simulate, "make a map of a furnished flat, with the true rooms"},
    {"vary", cmd_vary, "turn, resample, clutter or spoil the maps of a data set"},
};

#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

static const char usage[] = "usage: roomseg COMMAND [ARGUMENT]...; roomseg --help lists them\n";

static void print_help(void) {
    printf("roomseg cuts a robot's occupancy grid into rooms.\n\nusage: roomseg COMMAND "
           "[ARGUMENT]...\n\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        printf("  %-10s %s\n", commands[i].name, commands[i].purpose);
    }
    printf("\nroomseg COMMAND --help says more. Exit code: 0 done, 1 bad input, 2 wrong usage.\n");
}

static int run(int argc, char **argv) {
    tool_error error;
    if (argc < 2) {
        tool_error_set(&error, "which command?");
        return args_usage_error(&error, usage);
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        print_help();
        return EXIT_DONE;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("roomseg %d.%d.%d\n", ROOMSEG_VERSION_MAJOR, ROOMSEG_VERSION_MINOR,
               ROOMSEG_VERSION_PATCH);
        return EXIT_DONE;
    }
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(argv[1], commands[i].name) == 0) {
            return commands[i].run(argc - 1, argv + 1);
        }
    }
    tool_error_set(&error, "unknown command '%s'", argv[1]);
    return args_usage_error(&error, usage);
}

/* Blocks from this size on, images that is, go back to the system when they are freed. By
 * itself the GNU library keeps those up to the size of the largest that was ever freed. */
#define LARGE_BLOCK_BYTES (256 * 1024)

int main(int argc, char **argv) {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, LARGE_BLOCK_BYTES);
#endif
    int code = run(argc, argv);
    errno = 0;
    if ((fflush(stdout) != 0 || ferror(stdout)) && code == EXIT_DONE) {
        tool_error error;
        tool_error_set(&error, "standard output: cannot write: %s",
                       errno != 0 ? strerror(errno) : "an earlier write failed");
        tool_error_print(&error);
        return EXIT_BAD_INPUT;
    }
    return code;
}
