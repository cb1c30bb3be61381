/* A home of 400 x 300 cells of 5 cm in 512 KB of RAM, all of it: map, labels, arena, stack. The
 * linker script gives the program no more; what it found must be what `program` found. */
#include "maps.h"
#include "platform.h"
#include "report.h"
#include "text.h"

enum {
    WIDTH = 400,
    HEIGHT = 300,
    RESOLUTION_MM = 50,
    MAX_REGIONS = 256, /* homes of this size have 80 to 200 */
    MAX_ROOMS = 48
};

static uint8_t cells[HEIGHT][WIDTH]; /* as SLAM would fill it */
static uint16_t labels[HEIGHT][WIDTH];
static uint64_t arena[ROOMSEG_ARENA_SIZE(WIDTH, HEIGHT,
                                         ROOMSEG_PLAN_SMALL(96000u, 1500u, RESOLUTION_MM),
                                         MAX_REGIONS, MAX_ROOMS) / 8];

int main(void)
{
    const test_map *home = &test_maps[0];
    const roomseg_grid grid = {cells[0], WIDTH, HEIGHT, WIDTH, RESOLUTION_MM};
    roomseg_config config = roomseg_config_default();
    roomseg_result result;
    size_t stack;
    int status;

    if (home->width != WIDTH || home->height != HEIGHT || home->resolution_mm != RESOLUTION_MM) {
        text_string("failed: the first map is not the home\n");
        return 1;
    }
    for (uint32_t y = 0; y < HEIGHT; y++) {
        for (uint32_t x = 0; x < WIDTH; x++) {
            cells[y][x] = home->cells[y * WIDTH + x];
        }
    }
    config.max_regions = MAX_REGIONS;
    config.max_rooms = MAX_ROOMS;
    platform_stack_paint();
    status = roomseg_run(&config, &grid, labels[0], WIDTH, &result, arena, sizeof arena);
    stack = platform_stack_used();
    if (status != ROOMSEG_OK) {
        text_string("failed home: ");
        text_string(roomseg_status_text(status));
        text_string("\n");
        return 1;
    }
    report_write(home, "default", labels[0], &result);
    text_string("#");
    text_field("map", sizeof cells);
    text_field("labels", sizeof labels);
    text_field("arena", sizeof arena);
    text_field("stack", (uint32_t)stack);
    text_string("\nend failures 0\n");
    return 0;
}
