/* The smallest program of each kind, for its size: a firmware's one call. */
#include "roomseg/roomseg.h"

int budget_run(const roomseg_grid *grid, uint16_t *labels, roomseg_result *result, void *arena,
               size_t arena_size);

int budget_run(const roomseg_grid *grid, uint16_t *labels, roomseg_result *result, void *arena,
               size_t arena_size)
{
#ifdef SIZE_PAPER
    roomseg_config config = roomseg_config_paper();
#else
    roomseg_config config = roomseg_config_default();
#endif
#ifdef SIZE_ALIGNED
    config.align = ROOMSEG_ALIGN_ON;
#endif
    return roomseg_run(&config, grid, labels, grid->width, result, arena, arena_size);
}
