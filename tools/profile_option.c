#include "profile_option.h"

#include <string.h>

static const char OPTION[] = "--profile";

static int set_profile(const char *name, roomseg_config *config, tool_error *error) {
    if (name == NULL || *name == '\0') {
        tool_error_set(error, "option %s needs a value", OPTION);
        return -1;
    }
    if (strcmp(name, "default") == 0) {
        *config = roomseg_config_default();
    } else if (strcmp(name, "paper") == 0) {
        *config = roomseg_config_paper();
    } else if (strcmp(name, "paper-home") == 0) {
        *config = roomseg_config_paper_home();
    } else {
        tool_error_set(error, "unknown profile '%s'; there are %s", name, PROFILE_NAMES);
        return -1;
    }
    return 0;
}

int profile_take_option(int *argc, char **argv, roomseg_config *config, tool_error *error) {
    size_t length = sizeof OPTION - 1;
    int kept = 0;
    int i = 0;
    int given = 0;
    *config = roomseg_config_default();
    while (i < *argc && strcmp(argv[i], "--") != 0) {
        char *text = argv[i++];
        if (strncmp(text, OPTION, length) != 0 ||
            (text[length] != '\0' && text[length] != '=')) {
            argv[kept++] = text;
            continue;
        }
        const char *name = text[length] == '=' ? text + length + 1 : NULL;
        if (name == NULL && i < *argc) {
            name = argv[i++];
        }
        if (given) {
            tool_error_set(error, "option %s is given twice", OPTION);
            return -1;
        }
        if (set_profile(name, config, error) != 0) {
            return -1;
        }
        given = 1;
    }
    while (i < *argc) {
        argv[kept++] = argv[i++];
    }
    *argc = kept;
    return 0;
}

const char *profile_name(const roomseg_config *config) {
    return config->profile == ROOMSEG_PROFILE_PAPER ? "paper" : "default";
}
