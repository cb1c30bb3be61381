#include "golden.h"

#include <stdlib.h>
#include <string.h>

#include "simulate/turn.h"

golden_map golden_map_at(int index)
{
    static const char *const names[GOLDEN_COUNT] = {"small_furnished", "medium_furnished",
                                                    "medium_empty",    "medium_cluttered",
                                                    "medium_turned",   "large_furnished",
                                                    "paper",           "paper_home"};
    golden_map golden = {names[index], sim_options_default(), roomseg_config_default};
    sim_options *options = &golden.options;
    options->seed = 100u + (unsigned)index;
    switch (index) {
    case 0:
        options->size = FLAT_SMALL;
        options->resolution_mm = 30;
        break;
    case 2:
        options->furnished = 0;
        break;
    case 3:
        options->clutter = 100;
        options->noise = 100;
        break;
    case 4:
        options->has_turn = 1;
        options->turn = TURN_FULL / 12;
        break;
    case 5:
        options->size = FLAT_LARGE;
        options->resolution_mm = 80;
        break;
    case 6:
        golden.config = roomseg_config_paper;
        break;
    case 7:
        golden.config = roomseg_config_paper_home; /* which aligns the map */
        break;
    default:
        break;
    }
    return golden;
}

int golden_make(const golden_map *golden, golden_run *run)
{
    memset(run, 0, sizeof *run);
    if (sim_run(&golden->options, &run->map) != 0) {
        fprintf(stderr, "%s: cannot simulate the map\n", golden->name);
        return -1;
    }
    roomseg_config config = golden->config();
    roomseg_grid grid = {run->map.cells, run->map.width, run->map.height, run->map.width,
                         (uint32_t)run->map.resolution_mm};
    size_t need = 0;
    int status = roomseg_arena_size_for_grid(&config, &grid, &need);
    run->labels = calloc((size_t)grid.width * grid.height, sizeof *run->labels);
    run->arena = malloc(need + 1);
    if (status == ROOMSEG_OK && run->labels != NULL && run->arena != NULL) {
        status = roomseg_run(&config, &grid, run->labels, grid.width, &run->result, run->arena,
                             need);
    }
    if (status != ROOMSEG_OK || run->labels == NULL || run->arena == NULL) {
        fprintf(stderr, "%s: %s\n", golden->name, roomseg_status_text(status));
        golden_free(run);
        return -1;
    }
    return 0;
}

void golden_free(golden_run *run)
{
    free(run->labels);
    free(run->arena);
    sim_map_free(&run->map);
    memset(run, 0, sizeof *run);
}

/* CRC-32 of IEEE 802.3, bit by bit. Start with 0. */
static uint32_t crc32(uint32_t crc, uint8_t byte)
{
    crc = ~crc ^ byte;
    for (int bit = 0; bit < 8; bit++) {
        crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

static void write_records(const roomseg_result *result, FILE *stream)
{
    fprintf(stream, "regions %u rooms %u doorways %u\n", (unsigned)result->region_count,
            (unsigned)result->room_count, (unsigned)result->doorway_count);
    fprintf(stream, "crop %u %u size %u %u\n", result->crop_x, result->crop_y,
            result->crop_width, result->crop_height);
    for (uint32_t i = 0; i < result->room_count; i++) {
        const roomseg_room *r = &result->rooms[i];
        fprintf(stream,
                "room %u cells %lu cm2 %lu centroid_q8 %lu %lu box %u %u %u %u "
                "interior %u %u radius_mm %u links %u\n",
                r->label, (unsigned long)r->area_cells, (unsigned long)r->area_cm2,
                (unsigned long)r->centroid_x_q8, (unsigned long)r->centroid_y_q8, r->min_x,
                r->min_y, r->max_x, r->max_y, r->interior_x, r->interior_y,
                r->inscribed_radius_mm, r->link_count);
    }
    for (uint32_t i = 0; i < result->doorway_count; i++) {
        const roomseg_doorway *d = &result->doorways[i];
        fprintf(stream, "doorway %u %u at %u %u width_mm %lu border %lu\n", d->room_a,
                d->room_b, d->x, d->y, (unsigned long)d->width_mm,
                (unsigned long)d->border_cells);
    }
}

static void write_row(const uint16_t *row, uint32_t width, FILE *stream)
{
    uint32_t start = 0;
    for (uint32_t x = 1; x <= width; x++) {
        if (x == width || row[x] != row[start]) {
            fprintf(stream, "%s%ux%u", start > 0 ? " " : "", (unsigned)(x - start), row[start]);
            start = x;
        }
    }
    fputc('\n', stream);
}

void golden_write(const golden_map *golden, const golden_run *run, FILE *stream)
{
    size_t cells = (size_t)run->map.width * run->map.height;
    uint32_t map_crc = 0;
    uint32_t label_crc = 0;
    for (size_t i = 0; i < cells; i++) {
        map_crc = crc32(map_crc, run->map.cells[i]);
        label_crc = crc32(label_crc, (uint8_t)(run->labels[i] & 255u));
        label_crc = crc32(label_crc, (uint8_t)(run->labels[i] >> 8));
    }
    fprintf(stream, "map %s %u x %u cells of %d mm crc32 %08lx\n", golden->name,
            (unsigned)run->map.width, (unsigned)run->map.height, run->map.resolution_mm,
            (unsigned long)map_crc);
    fprintf(stream, "labels crc32 %08lx\n", (unsigned long)label_crc);
    write_records(&run->result, stream);
    fputs("rows\n", stream);
    for (uint32_t y = 0; y < run->map.height; y++) {
        write_row(run->labels + (size_t)y * run->map.width, run->map.width, stream);
    }
}

int golden_read_labels(FILE *stream, uint32_t width, uint32_t height, uint16_t *labels)
{
    char line[200];
    do {
        if (fgets(line, sizeof line, stream) == NULL) {
            return -1;
        }
    } while (strcmp(line, "rows\n") != 0);
    size_t cells = (size_t)width * height;
    size_t filled = 0;
    unsigned length, label;
    while (filled < cells && fscanf(stream, "%ux%u", &length, &label) == 2) {
        for (; length > 0 && filled < cells; length--) {
            labels[filled++] = (uint16_t)label;
        }
    }
    return filled == cells ? 0 : -1;
}
