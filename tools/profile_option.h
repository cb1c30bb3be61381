/* The option --profile, which decides what all other options start from. */
#ifndef ROOMSEG_TOOLS_PROFILE_OPTION_H
#define ROOMSEG_TOOLS_PROFILE_OPTION_H

#include "roomseg/roomseg.h"
#include "tool_error.h"

/* Names of the profiles as they are shown to users. */
#define PROFILE_NAMES "default, paper or paper-home"

/* Takes `--profile NAME` or `--profile=NAME` before a lone `--` out of the arguments and sets
 * all of *config to the ready set of that profile; to the default one without the option.
 * Fails iff: there is no such profile, no name, or the option is given twice. Returns 0, or -1
 * with *error set. */
int profile_take_option(int *argc, char **argv, roomseg_config *config, tool_error *error);

/* The name of a config's profile, static storage. */
const char *profile_name(const roomseg_config *config);

#endif
