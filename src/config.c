#include "config.h"

#include "join.h"

roomseg_config roomseg_config_default(void)
{
    roomseg_config config;

    config.profile = ROOMSEG_PROFILE_DEFAULT;
    config.align = NULL;
    config.free_max = 51;
    config.occupied_min = 204;
    config.speck_mm2 = 96000;
    config.clutter_mm = 1500;
    config.smallest_room_mm2 = 1000000;
    config.niche_mm2 = 3000000;
    config.isolated_permille = 10;
    config.room_opening_percent = 83;
    config.passage_opening_percent = 41;
    config.passage_min_neighbours = 3;
    config.shared_wall_mm = 1000;
    config.lived_in_permille = 3;
    config.open_plan_percent = 50;
    config.door_mm = 950;
    config.hall_mm = 1600;
    config.unwalled_percent = 50;
    config.dilation_mm = 120;
    config.seed_obstacle_permille = 50;
    config.longest_border_mm = 3000;
    config.max_regions = 1024;
    config.max_rooms = 255;
    config.progress = NULL;
    config.progress_user = NULL;
    return config;
}

int rs_config_check(const roomseg_config *config)
{
    bool good = config->profile != NULL && config->free_max < config->occupied_min &&
                config->speck_mm2 <= ROOMSEG_MAX_SPECK_MM2 &&
                config->clutter_mm <= ROOMSEG_MAX_CLUTTER_MM &&
                config->smallest_room_mm2 <= ROOMSEG_MAX_SMALLEST_ROOM_MM2 &&
                config->niche_mm2 <= ROOMSEG_MAX_SMALLEST_ROOM_MM2 &&
                config->isolated_permille <= 1000u && config->room_opening_percent >= 1u &&
                config->room_opening_percent <= 100u && config->passage_opening_percent >= 1u &&
                config->passage_opening_percent <= 100u &&
                config->passage_min_neighbours >= 2u &&
                config->passage_min_neighbours <= RS_JOIN_MAX_NEIGHBOURS &&
                config->open_plan_percent >= 1u && config->open_plan_percent <= 100u &&
                config->shared_wall_mm >= ROOMSEG_MIN_SHARED_WALL_MM &&
                config->shared_wall_mm <= ROOMSEG_MAX_SHARED_WALL_MM &&
                config->lived_in_permille <= 1000u && config->door_mm <= ROOMSEG_MAX_DOOR_MM &&
                config->hall_mm <= ROOMSEG_MAX_HALL_MM &&
                config->unwalled_percent <= 100u &&
                config->dilation_mm <= ROOMSEG_MAX_DILATION_MM &&
                config->seed_obstacle_permille <= 499u &&
                config->longest_border_mm <= ROOMSEG_MAX_BORDER_MM &&
                config->max_regions >= 1u && config->max_regions <= ROOMSEG_MAX_REGIONS &&
                config->max_rooms >= 1u && config->max_rooms <= ROOMSEG_MAX_ROOMS &&
                config->max_rooms <= config->max_regions;

    return good ? ROOMSEG_OK : ROOMSEG_ERR_CONFIG;
}

int rs_config_check_resolution(uint32_t resolution_mm)
{
    return resolution_mm >= ROOMSEG_MIN_RESOLUTION_MM &&
                   resolution_mm <= ROOMSEG_MAX_RESOLUTION_MM
               ? ROOMSEG_OK
               : ROOMSEG_ERR_RESOLUTION;
}

int rs_config_check_grid(const roomseg_grid *grid)
{
    if (grid->cells == NULL) {
        return ROOMSEG_ERR_NULL;
    }
    if (grid->width < 1u || grid->width > ROOMSEG_MAX_SIDE || grid->height < 1u ||
        grid->height > ROOMSEG_MAX_SIDE) {
        return ROOMSEG_ERR_GRID_SIZE;
    }
    if (grid->stride < grid->width) {
        return ROOMSEG_ERR_STRIDE;
    }
    return rs_config_check_resolution(grid->resolution_mm);
}
