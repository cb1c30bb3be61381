#include "../../src/plan.c"
#include "proof.h"

/* What the entry points let through. */
static void any_sizes(uint32_t *width, uint32_t *height, size_t *small, uint32_t *regions,
                      uint32_t *rooms)
{
    *width = nondet_u32();
    *height = nondet_u32();
    *small = nondet_u32();
    *regions = nondet_u32();
    *rooms = nondet_u32();
    ASSUME(*width >= 1u && *width <= ROOMSEG_MAX_SIDE && *height >= 1u &&
           *height <= ROOMSEG_MAX_SIDE &&
           (uint64_t)*width * *height <= ROOMSEG_MAX_CROP_CELLS);
    ASSUME(*small <= 10001u && *regions >= 1u && *regions <= ROOMSEG_MAX_REGIONS);
    ASSUME(*rooms >= 1u && *rooms <= ROOMSEG_MAX_ROOMS && *rooms <= *regions);
}

/* The sizes of all buffers together, alive or not, are no more than the address space of 32 bits:
 * so no offset and no sum of the plan overflows. */
#define SUM(S, name, element, count, first, last) +ROOMSEG_PLAN_ALIGN((uint64_t)(element) * (count))

void prove_plan(void)
{
    uint32_t w, h, regions, rooms;
    size_t small;
    any_sizes(&w, &h, &small, &regions, &rooms);
    uint64_t all = 0 ROOMSEG_PLAN_TABLE(SUM, , w, h, small, regions, rooms);
    PROVE(all <= UINT32_MAX);
}

void prove_plan_small(void)
{
    uint32_t speck = nondet_u32(), clutter = nondet_u32(), mm = nondet_u32();
    ASSUME(speck <= ROOMSEG_MAX_SPECK_MM2 && clutter <= ROOMSEG_MAX_CLUTTER_MM);
    ASSUME(mm >= ROOMSEG_MIN_RESOLUTION_MM && mm <= ROOMSEG_MAX_RESOLUTION_MM);
    PROVE(ROOMSEG_PLAN_SMALL(speck, clutter, mm) <= 10001u);
}
