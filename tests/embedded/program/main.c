/* The test program, the same on every target: segments all maps in each way and writes what it
 * found. Lines that begin with '#' are measurements, which differ between targets. */
#include "maps.h"
#include "platform.h"
#include "report.h"
#include "stages.h"
#include "text.h"

static const char *const variants[] = {"default", "aligned", "paper"};
#define VARIANT_COUNT (sizeof variants / sizeof variants[0])

/* False: this library has no such way. */
static int set_variant(unsigned variant, roomseg_config *config)
{
    switch (variant) {
    case 1:
        config->align = ROOMSEG_ALIGN_ON;
        return 1;
    case 2:
#ifdef ROOMSEG_PROFILE_PAPER
        *config = roomseg_config_paper();
        return 1;
#else
        return 0;
#endif
    default:
        return 1;
    }
}

static void write_failure(const test_map *map, const char *variant, const char *what)
{
    text_string("failed ");
    text_string(map->name);
    text_string(" ");
    text_string(variant);
    text_string(": ");
    text_string(what);
    text_string("\n");
}

/* Returns 0, or 1 after a failure. A map that does not fit is told of and is none. */
static int run_map(const test_map *map, unsigned variant)
{
    const roomseg_grid grid = {map->cells, map->width, map->height, map->width,
                               map->resolution_mm};
    roomseg_config config = roomseg_config_default();
    roomseg_result result;
    size_t memory, need = 0;
    uint8_t *block = platform_memory(&memory);
    size_t label_bytes = ((size_t)map->width * map->height * sizeof(uint16_t) + 7u) / 8u * 8u;
    size_t stack;
    int status;

    if (!set_variant(variant, &config)) {
        return 0;
    }
    if (map->max_regions > 0u) {
        config.max_regions = map->max_regions;
        config.max_rooms = map->max_regions < 1024u ? map->max_regions : 1024u;
    }
    config.progress = stages_hook;
    status = roomseg_arena_size_for_grid(&config, &grid, &need);
    if (status == ROOMSEG_OK && label_bytes + need > memory) {
        text_string("# too large for this memory: ");
        text_string(map->name);
        text_string(" ");
        text_string(variants[variant]);
        text_field("bytes", (uint32_t)(label_bytes + need));
        text_string("\n");
        return 0;
    }
    stages_begin();
    platform_stack_paint();
    if (status == ROOMSEG_OK) {
        status = roomseg_run(&config, &grid, (uint16_t *)(void *)block, map->width, &result,
                             block + label_bytes, need);
    }
    stack = platform_stack_used();
    stages_end();
    if (status != ROOMSEG_OK) {
        write_failure(map, variants[variant], roomseg_status_text(status));
        return 1;
    }
    report_write(map, variants[variant], (const uint16_t *)(const void *)block, &result);
    text_string("#");
    text_field("stack", (uint32_t)stack);
    text_field("usual", (uint32_t)ROOMSEG_ARENA_SIZE_USUAL(result.crop_width, result.crop_height,
                                                           map->resolution_mm));
    stages_write();
    return 0;
}

int main(void)
{
    int failures = 0;

    for (unsigned m = 0; m < test_map_count; m++) {
        for (unsigned v = 0; v < VARIANT_COUNT; v++) {
            failures += run_map(&test_maps[m], v);
        }
    }
    text_string("end");
    text_field("failures", (uint32_t)failures);
    text_string("\n");
    return failures > 0;
}
