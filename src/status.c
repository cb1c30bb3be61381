#include "roomseg/roomseg.h"

const char *roomseg_status_text(int status)
{
    switch (status) {
    case ROOMSEG_OK:
        return "done";
    case ROOMSEG_ERR_NULL:
        return "a required pointer is NULL";
    case ROOMSEG_ERR_GRID_SIZE:
        return "the grid's width or height is 0 or too large";
    case ROOMSEG_ERR_STRIDE:
        return "a stride is smaller than the width";
    case ROOMSEG_ERR_RESOLUTION:
        return "the resolution is outside 20 to 200 mm per cell";
    case ROOMSEG_ERR_CONFIG:
        return "a configuration field is out of range";
    case ROOMSEG_ERR_ARENA_ALIGN:
        return "the arena is not aligned to 8 bytes";
    case ROOMSEG_ERR_ARENA_SIZE:
        return "the arena is too small";
    case ROOMSEG_ERR_REGIONS:
        return "more regions than max_regions";
    case ROOMSEG_ERR_ROOMS:
        return "more rooms than max_rooms";
    case ROOMSEG_ERR_CANCELLED:
        return "cancelled by the progress hook";
    default:
        return "unknown status";
    }
}

const char *roomseg_stage_name(int stage)
{
    switch (stage) {
    case ROOMSEG_STAGE_THRESHOLD:
        return "threshold";
    case ROOMSEG_STAGE_ALIGN:
        return "align";
    case ROOMSEG_STAGE_COMPONENTS:
        return "components";
    case ROOMSEG_STAGE_SURFACE:
        return "surface";
    case ROOMSEG_STAGE_SEEDS:
        return "seeds";
    case ROOMSEG_STAGE_RIDGE:
        return "ridge";
    case ROOMSEG_STAGE_WATERSHED:
        return "watershed";
    case ROOMSEG_STAGE_GRAPH:
        return "graph";
    case ROOMSEG_STAGE_MERGE:
        return "merge";
    case ROOMSEG_STAGE_ROOMS:
        return "rooms";
    case ROOMSEG_STAGE_TURN_BACK:
        return "turn back";
    default:
        return "?";
    }
}
