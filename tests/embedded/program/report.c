#include "report.h"

#include "text.h"

/* CRC-32 of IEEE 802.3 with a table of 16, as the golden files have it. */
static uint32_t crc32_byte(uint32_t crc, uint32_t byte)
{
    static const uint32_t nibbles[16] = {
        0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
        0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
        0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};

    crc ^= byte;
    crc = crc >> 4 ^ nibbles[crc & 15u];
    return crc >> 4 ^ nibbles[crc & 15u];
}

/* Little-endian, whatever the target is. */
static uint32_t crc32_labels(const uint16_t *labels, uint32_t count)
{
    uint32_t crc = UINT32_MAX;

    for (uint32_t i = 0; i < count; i++) {
        crc = crc32_byte(crc, labels[i] & 255u);
        crc = crc32_byte(crc, (uint32_t)labels[i] >> 8);
    }
    return ~crc;
}

static void write_room(const roomseg_room *room, const uint16_t *links)
{
    text_field("room", room->label);
    text_field("cells", room->area_cells);
    text_field("cm2", room->area_cm2);
    text_field("centroid_q8", room->centroid_x_q8);
    text_next(room->centroid_y_q8);
    text_field("box", room->min_x);
    text_next(room->min_y);
    text_next(room->max_x);
    text_next(room->max_y);
    text_field("interior", room->interior_x);
    text_next(room->interior_y);
    text_field("radius_mm", room->inscribed_radius_mm);
    text_string(" links");
    for (uint32_t i = 0; i < room->link_count; i++) {
        text_next(links[room->link_first + i]);
    }
    text_string("\n");
}

static void write_doorway(const roomseg_doorway *doorway)
{
    text_field("doorway", doorway->room_a);
    text_next(doorway->room_b);
    text_field("at", doorway->x);
    text_next(doorway->y);
    text_field("width_mm", doorway->width_mm);
    text_field("border", doorway->border_cells);
    text_string("\n");
}

void report_write(const test_map *map, const char *variant, const uint16_t *labels,
                  const roomseg_result *result)
{
    text_string("run ");
    text_string(map->name);
    text_string(" ");
    text_string(variant);
    text_string(" labels ");
    text_hex(crc32_labels(labels, (uint32_t)map->width * map->height));
    text_field("rooms", result->room_count);
    text_field("doorways", result->doorway_count);
    text_field("regions", result->region_count);
    text_field("cells", (uint32_t)result->crop_width * result->crop_height);
    text_field("arena", (uint32_t)result->arena_used);
    text_string(" wall_angle ");
    text_signed(result->wall_angle);
    text_string("\n");
    for (uint32_t i = 0; i < result->room_count; i++) {
        write_room(&result->rooms[i], result->links);
    }
    for (uint32_t i = 0; i < result->doorway_count; i++) {
        write_doorway(&result->doorways[i]);
    }
}
