#include "bench_result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *result_column_name(size_t column) {
    static const char *const names[RESULT_COLUMN_COUNT - METRIC_COUNT] = {
        "rooms_found", "rooms_true", "time_ms", "arena_bytes", "bytes_per_crop_cell",
        "reference_rooms", "reference_ari"};
    return column < METRIC_COUNT ? metric_fields[column].name : names[column - METRIC_COUNT];
}

static int cost_value(const map_result *map, size_t column, double *value) {
    if (!map->has_cost || (column == RESULT_BYTES_PER_CELL && map->crop_cells == 0)) {
        return 0;
    }
    if (column == RESULT_TIME_MS) {
        *value = map->time_ms;
    } else if (column == RESULT_ARENA_BYTES) {
        *value = (double)map->arena_bytes;
    } else {
        *value = (double)map->arena_bytes / (double)map->crop_cells;
    }
    return 1;
}

int result_value(const map_result *map, size_t column, int without_specks, double *value) {
    const metrics *m = without_specks ? &map->score.without_specks : &map->score.all;
    if (map->failure.text[0] != '\0') {
        return 0;
    }
    if (column == RESULT_ROOMS_FOUND && map->has_cost) {
        *value = map->rooms;
        return 1;
    }
    if (column == RESULT_REFERENCE_ROOMS || column == RESULT_REFERENCE_ARI) {
        *value = column == RESULT_REFERENCE_ARI ? map->reference.ari : map->reference.rooms_true;
        return map->has_reference;
    }
    if (column > RESULT_ROOMS_TRUE) {
        return cost_value(map, column, value);
    }
    if (!map->has_score || m->rooms_true == 0) {
        return 0;
    }
    if (column < METRIC_COUNT) {
        *value = metrics_get(m, column);
    } else {
        *value = column == RESULT_ROOMS_TRUE ? m->rooms_true : m->rooms_found;
    }
    return 1;
}

spread result_spread(const set_result *set, size_t column, int without_specks) {
    spread s = {0, 0.0, 0.0};
    double value;
    for (size_t i = 0; i < set->count; i++) {
        if (result_value(&set->maps[i], column, without_specks, &value)) {
            s.mean += value;
            s.count++;
        }
    }
    if (s.count > 0) {
        s.mean /= (double)s.count;
    }
    double squares = 0.0;
    for (size_t i = 0; i < set->count; i++) {
        if (result_value(&set->maps[i], column, without_specks, &value)) {
            squares += (value - s.mean) * (value - s.mean);
        }
    }
    if (s.count > 1) {
        s.deviation = sqrt(squares / (double)(s.count - 1));
    }
    return s;
}

int result_has_scores(const set_result *set) {
    return result_spread(set, 0, 0).count > 0;
}

size_t result_failures(const set_result *set) {
    size_t failures = 0;
    for (size_t i = 0; i < set->count; i++) {
        failures += set->maps[i].failure.text[0] != '\0';
    }
    return failures;
}

static char *copy_text(const char *text) {
    size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    if (copy != NULL) {
        memcpy(copy, text, size);
    }
    return copy;
}

int set_result_open(set_result *set, const char *name) {
    memset(set, 0, sizeof *set);
    set->name = copy_text(name);
    return set->name != NULL ? 0 : -1;
}

map_result *set_result_add(set_result *set, const char *map_name) {
    if (set->count == set->capacity) {
        size_t capacity = set->capacity > 0 ? set->capacity * 2 : 32;
        map_result *maps = realloc(set->maps, capacity * sizeof *maps);
        if (maps == NULL) {
            return NULL;
        }
        set->maps = maps;
        set->capacity = capacity;
    }
    map_result *map = &set->maps[set->count];
    memset(map, 0, sizeof *map);
    map->name = copy_text(map_name);
    if (map->name == NULL) {
        return NULL;
    }
    set->count++;
    return map;
}

void set_result_free(set_result *set) {
    for (size_t i = 0; i < set->count; i++) {
        free(set->maps[i].name);
    }
    free(set->maps);
    free(set->name);
    memset(set, 0, sizeof *set);
}
