// Two rooms and a door: the rooms come out on the serial port.
#include <roomseg.h>

enum { WIDTH = 64, HEIGHT = 40, RESOLUTION_MM = 100, MAX_REGIONS = 64, MAX_ROOMS = 16 };
static uint8_t map_cells[HEIGHT][WIDTH];  // from SLAM: 0 free, 127 unknown, 255 occupied
static uint16_t labels[HEIGHT][WIDTH];
static uint64_t arena[2048];  // 16 KB

void setup() {
  Serial.begin(115200);
  for (int y = 0; y < HEIGHT; y++) {
    map_cells[y][WIDTH / 3] = y < 16 || y >= 24 ? 255 : 0;
  }
  const roomseg_grid grid = {map_cells[0], WIDTH, HEIGHT, WIDTH, RESOLUTION_MM};
  roomseg_config config = roomseg_config_default();
  config.max_regions = MAX_REGIONS;
  config.max_rooms = MAX_ROOMS;
  roomseg_result result;
  int status = roomseg_run(&config, &grid, labels[0], WIDTH, &result, arena, sizeof arena);
  Serial.println(roomseg_status_text(status));
  for (uint32_t i = 0; i < result.room_count; i++) {
    Serial.println(result.rooms[i].area_cm2);
  }
}

void loop() {}
