#include "bench_stages.h"

#include <string.h>

/* Sums of the maps whose stages were measured. */
typedef struct stage_sums {
    size_t maps;
    uint64_t crop_cells;
    double ms; /* of all stages */
    stage_costs costs;
} stage_sums;

static stage_sums sum_stages(const set_result *set) {
    stage_sums sums;
    memset(&sums, 0, sizeof sums);
    for (size_t i = 0; i < set->count; i++) {
        const map_result *map = &set->maps[i];
        if (map->failure.text[0] != '\0' || !map->has_stages) {
            continue;
        }
        sums.maps++;
        sums.crop_cells += map->crop_cells;
        for (size_t stage = 0; stage < ROOMSEG_STAGE_COUNT; stage++) {
            sums.ms += map->stages.ms[stage];
            sums.costs.ms[stage] += map->stages.ms[stage];
            sums.costs.visits[stage] += map->stages.visits[stage];
        }
    }
    return sums;
}

void bench_stages_print(FILE *out, const set_result *set) {
    stage_sums sums = sum_stages(set);
    double cells = (double)sums.crop_cells;
    if (sums.maps == 0 || sums.crop_cells == 0) {
        return;
    }
    fprintf(out, "%s: cost by stage, mean of %zu maps; visits as the progress hook tells them\n",
            set->name, sums.maps);
    fprintf(out, "%-12s%9s%9s%9s%13s\n", "stage", "ms", "share %", "ns/cell", "visits/cell");
    for (int stage = 0; stage < ROOMSEG_STAGE_COUNT; stage++) {
        double ms = sums.costs.ms[stage];
        if (ms > 0.0) {
            fprintf(out, "%-12s%9.3f%9.1f%9.2f%13.1f\n", roomseg_stage_name(stage),
                    ms / (double)sums.maps, ms / sums.ms * 100.0, ms * 1e6 / cells,
                    (double)sums.costs.visits[stage] / cells);
        }
    }
    fprintf(out, "%-12s%9.3f%9.1f%9.2f\n\n", "all", sums.ms / (double)sums.maps, 100.0,
            sums.ms * 1e6 / cells);
}
