#include "config_option.h"

#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "args.h"

static const char OPTION[] = "--config";

typedef struct numeric_field {
    const char *name;
    size_t offset, size; /* size: 1 or 4 bytes */
} numeric_field;

#define FIELD(member) \
    {#member, offsetof(roomseg_config, member), sizeof(((roomseg_config *)0)->member)}

static const numeric_field numeric_fields[] = {
    FIELD(free_max),
    FIELD(occupied_min),
    FIELD(speck_mm2),
    FIELD(clutter_mm),
    FIELD(smallest_room_mm2),
    FIELD(isolated_permille),
    FIELD(niche_mm2),
    FIELD(room_opening_percent),
    FIELD(passage_opening_percent),
    FIELD(passage_min_neighbours),
    FIELD(shared_wall_mm),
    FIELD(lived_in_permille),
    FIELD(open_plan_percent),
    FIELD(door_mm),
    FIELD(hall_mm),
    FIELD(unwalled_percent),
    FIELD(dilation_mm),
    FIELD(seed_obstacle_permille),
    FIELD(longest_border_mm),
    FIELD(max_regions),
    FIELD(max_rooms),
};

enum { NUMERIC_FIELD_COUNT = sizeof numeric_fields / sizeof numeric_fields[0] };

static uint32_t get_field(const roomseg_config *config, const numeric_field *field) {
    const unsigned char *at = (const unsigned char *)config + field->offset;
    uint32_t value;
    if (field->size == 1) {
        return *at;
    }
    memcpy(&value, at, sizeof value);
    return value;
}

static void set_field(roomseg_config *config, const numeric_field *field, uint32_t value) {
    unsigned char *at = (unsigned char *)config + field->offset;
    if (field->size == 1) {
        *at = (unsigned char)value;
    } else {
        memcpy(at, &value, sizeof value);
    }
}

static int assign(roomseg_config *config, const char *text, tool_error *error) {
    const char *equals = strchr(text, '=');
    size_t length = equals != NULL ? (size_t)(equals - text) : strlen(text);
    for (size_t i = 0; i < NUMERIC_FIELD_COUNT; i++) {
        const numeric_field *field = &numeric_fields[i];
        double value; /* holds every 32-bit number, also where long cannot */
        double high = field->size == 1 ? UINT8_MAX : UINT32_MAX;
        if (strlen(field->name) != length || strncmp(field->name, text, length) != 0) {
            continue;
        }
        if (equals == NULL || parse_real(equals + 1, &value) != 0 || value < 0.0 ||
            value > high || value != (double)(uint32_t)value) {
            tool_error_set(error, "option %s needs %s=N, a whole number from 0 to %.0f", OPTION,
                           field->name, high);
            return -1;
        }
        set_field(config, field, (uint32_t)value);
        return 0;
    }
    tool_error_set(error, "option %s: the configuration has no field '%.*s'", OPTION,
                   length < 64 ? (int)length : 64, text);
    return -1;
}

int config_take_options(int *argc, char **argv, roomseg_config *config, tool_error *error) {
    size_t length = sizeof OPTION - 1;
    int kept = 0;
    int i = 0;
    while (i < *argc && strcmp(argv[i], "--") != 0) {
        const char *text = argv[i++];
        if (strncmp(text, OPTION, length) != 0 ||
            (text[length] != '\0' && text[length] != '=')) {
            argv[kept++] = argv[i - 1];
            continue;
        }
        if (text[length] == '\0' && i == *argc) {
            tool_error_set(error, "option %s needs a value", OPTION);
            return -1;
        }
        const char *assignment = text[length] == '=' ? text + length + 1 : argv[i++];
        if (assign(config, assignment, error) != 0) {
            return -1;
        }
    }
    while (i < *argc) {
        argv[kept++] = argv[i++];
    }
    *argc = kept;
    return 0;
}

void config_print_json(FILE *out, const roomseg_config *config) {
    for (size_t i = 0; i < NUMERIC_FIELD_COUNT; i++) {
        fprintf(out, "%s\"%s\": %" PRIu32, i > 0 ? ", " : "{", numeric_fields[i].name,
                get_field(config, &numeric_fields[i]));
    }
    fputc('}', out);
}
