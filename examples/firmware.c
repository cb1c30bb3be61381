#include <stdio.h>
#include "roomseg/roomseg.h"

enum { WIDTH = 160, HEIGHT = 96, RESOLUTION_MM = 50 };
static uint8_t map[HEIGHT][WIDTH]; /* from SLAM: 0 free, 127 unknown, 255 occupied */
static uint16_t labels[HEIGHT][WIDTH];
static uint64_t arena[ROOMSEG_ARENA_SIZE_DEFAULT(WIDTH, HEIGHT, RESOLUTION_MM) / 8];

int main(void)
{
    const roomseg_grid grid = {map[0], WIDTH, HEIGHT, WIDTH, RESOLUTION_MM};
    const roomseg_config config = roomseg_config_default();
    roomseg_result result;
    for (int y = 0; y < HEIGHT; y++) {
        map[y][WIDTH / 3] = y < 40 || y >= 56 ? 255 : 0; /* a wall with a door of 0.8 m */
    }
    int status = roomseg_run(&config, &grid, labels[0], WIDTH, &result, arena, sizeof arena);
    for (uint32_t i = 0; i < result.room_count; i++) {
        const roomseg_room *room = &result.rooms[i];
        printf("room %d: %ld cm2, centre %d, %d\n", room->label, (long)room->area_cm2,
               room->interior_x, room->interior_y);
    }
    return status;
}
