/* Setting fields of roomseg_config from the command line, for studies. */
#ifndef ROOMSEG_TOOLS_CONFIG_OPTION_H
#define ROOMSEG_TOOLS_CONFIG_OPTION_H

#include <stdio.h>

#include "roomseg/roomseg.h"
#include "tool_error.h"

/* Takes every `--config FIELD=VALUE` and `--config=FIELD=VALUE` before a lone `--` out of
 * the arguments and sets the field. Of several values for one field the last counts.
 * Fails iff: there is no such field, the value is no whole number or does not fit the
 * field's type. Whether it is in the field's range, the library says when it runs.
 * Returns 0, or -1 with *error set. */
int config_take_options(int *argc, char **argv, roomseg_config *config, tool_error *error);

/* Writes the numeric fields as a JSON object. */
void config_print_json(FILE *out, const roomseg_config *config);

#endif
