#include "config_fields.h"

#include <stddef.h>
#include <string.h>

#define FIELD(name, low, high) \
    {#name, offsetof(roomseg_config, name), sizeof(((roomseg_config *)0)->name), low, high}

const config_field config_fields[] = {
    FIELD(free_max, 0, 203),     /* below occupied_min, which is 204 by default */
    FIELD(occupied_min, 52, 255), /* above free_max, 51 */
    FIELD(speck_mm2, 0, ROOMSEG_MAX_SPECK_MM2),
    FIELD(clutter_mm, 0, ROOMSEG_MAX_CLUTTER_MM),
    FIELD(smallest_room_mm2, 0, ROOMSEG_MAX_SMALLEST_ROOM_MM2),
    FIELD(isolated_permille, 0, 1000),
    FIELD(niche_mm2, 0, ROOMSEG_MAX_SMALLEST_ROOM_MM2),
    FIELD(room_opening_percent, 1, 100),
    FIELD(passage_opening_percent, 1, 100),
    FIELD(passage_min_neighbours, 2, 8),
    FIELD(shared_wall_mm, ROOMSEG_MIN_SHARED_WALL_MM, ROOMSEG_MAX_SHARED_WALL_MM),
    FIELD(lived_in_permille, 0, 1000),
    FIELD(open_plan_percent, 1, 100),
    FIELD(door_mm, 0, ROOMSEG_MAX_DOOR_MM),
    FIELD(hall_mm, 0, ROOMSEG_MAX_HALL_MM),
    FIELD(unwalled_percent, 0, 100),
    FIELD(dilation_mm, 0, ROOMSEG_MAX_DILATION_MM),
    FIELD(seed_obstacle_permille, 0, 499),
    FIELD(longest_border_mm, 0, ROOMSEG_MAX_BORDER_MM),
    FIELD(max_regions, 1, ROOMSEG_MAX_REGIONS),
    FIELD(max_rooms, 1, 1024), /* at most max_regions, which is 1024 by default */
};
const size_t config_field_count = sizeof config_fields / sizeof *config_fields;

void config_field_set(roomseg_config *config, const config_field *field, uint32_t value)
{
    unsigned char *at = (unsigned char *)config + field->offset;
    if (field->size == 1) {
        *at = (unsigned char)value;
    } else {
        memcpy(at, &value, sizeof value);
    }
}

static void visit_with(void (*visit)(const roomseg_config *config, const char *field),
                       const config_field *field, uint32_t value)
{
    roomseg_config config = roomseg_config_default();
    config_field_set(&config, field, value);
    if (config.max_regions >= 1 && config.max_regions < config.max_rooms &&
        strcmp(field->name, "max_regions") == 0) {
        config.max_rooms = config.max_regions;
    }
    visit(&config, field->name);
}

void config_each_invalid(void (*visit)(const roomseg_config *config, const char *field))
{
    for (size_t i = 0; i < config_field_count; i++) {
        const config_field *field = &config_fields[i];
        if (field->low > 0) {
            visit_with(visit, field, field->low - 1);
        }
        if (field->size > 1 || field->high < UINT8_MAX) {
            visit_with(visit, field, field->high + 1);
            visit_with(visit, field, field->size == 1 ? UINT8_MAX : UINT32_MAX);
        }
    }
}

void config_each_extreme(void (*visit)(const roomseg_config *config, const char *field))
{
    for (size_t i = 0; i < config_field_count; i++) {
        visit_with(visit, &config_fields[i], config_fields[i].low);
        visit_with(visit, &config_fields[i], config_fields[i].high);
    }
}
