#include "bench_json.h"

#include <inttypes.h>

#include "json.h"

/* Enough digits to read the same double back. */
static void print_number(FILE *out, const char *name, double value) {
    fprintf(out, "\"%s\": %.17g", name, value);
}

void bench_json_print_metrics(FILE *out, const metrics *m) {
    if (m->rooms_true == 0) {
        fputs("null", out);
        return;
    }
    fputc('{', out);
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        print_number(out, metric_fields[i].name, metrics_get(m, i));
        fputs(", ", out);
    }
    fprintf(out, "\"rooms_true\": %" PRIu32 ", \"rooms_found\": %" PRIu32, m->rooms_true,
            m->rooms_found);
    fprintf(out, ", \"rooms_matched\": %" PRIu32 "}", m->rooms_matched);
}

static void print_cost(FILE *out, const map_result *map) {
    double bytes_per_cell;
    fprintf(out, ", \"rooms_found\": %" PRIu32 ", ", map->rooms);
    print_number(out, "time_ms", map->time_ms);
    fprintf(out, ", \"arena_bytes\": %zu, \"crop_cells\": %" PRIu64, map->arena_bytes,
            map->crop_cells);
    if (result_value(map, RESULT_BYTES_PER_CELL, 0, &bytes_per_cell)) {
        fputs(", ", out);
        print_number(out, "bytes_per_crop_cell", bytes_per_cell);
    }
}

static void print_stages(FILE *out, const stage_costs *costs) {
    const char *comma = "";
    fputs(", \"stages\": {", out);
    for (int stage = 0; stage < ROOMSEG_STAGE_COUNT; stage++) {
        if (costs->ms[stage] > 0.0) {
            fprintf(out, "%s\"%s\": {", comma, roomseg_stage_name(stage));
            print_number(out, "time_ms", costs->ms[stage]);
            fprintf(out, ", \"visits\": %" PRIu64 "}", costs->visits[stage]);
            comma = ", ";
        }
    }
    fputc('}', out);
}

static void print_map(FILE *out, const map_result *map) {
    fputs("{\"name\": ", out);
    json_string(out, map->name);
    if (map->failure.text[0] != '\0') {
        fputs(", \"error\": ", out);
        json_string(out, map->failure.text);
        fputc('}', out);
        return;
    }
    if (map->has_cost) {
        print_cost(out, map);
    }
    if (map->has_stages) {
        print_stages(out, &map->stages);
    }
    if (map->has_score) {
        fputs(", \"scores\": ", out);
        bench_json_print_metrics(out, &map->score.all);
        fputs(", \"scores_without_specks\": ", out);
        bench_json_print_metrics(out, &map->score.without_specks);
    }
    if (map->has_reference) {
        fputs(", \"reference\": ", out);
        bench_json_print_metrics(out, &map->reference);
    }
    fputc('}', out);
}

static void print_spread(FILE *out, const set_result *set, const char *title,
                         int without_specks, int deviation) {
    const char *comma = "";
    fprintf(out, ",\n   \"%s\": {", title);
    for (size_t c = 0; c < RESULT_COLUMN_COUNT; c++) {
        spread s = result_spread(set, c, without_specks);
        if (s.count > 0) {
            fputs(comma, out);
            print_number(out, result_column_name(c), deviation ? s.deviation : s.mean);
            comma = ", ";
        }
    }
    fputc('}', out);
}

static void print_set(FILE *out, const set_result *set) {
    fputs("  {\"name\": ", out);
    json_string(out, set->name);
    fputs(", \"maps\": [", out);
    for (size_t i = 0; i < set->count; i++) {
        fputs(i > 0 ? ",\n    " : "\n    ", out);
        print_map(out, &set->maps[i]);
    }
    fputc(']', out);
    print_spread(out, set, "mean", 0, 0);
    print_spread(out, set, "deviation", 0, 1);
    if (result_has_scores(set)) {
        print_spread(out, set, "mean_without_specks", 1, 0);
        print_spread(out, set, "deviation_without_specks", 1, 1);
    }
    fputc('}', out);
}

void bench_json_print_sets(FILE *out, const set_result *sets, size_t count) {
    fputs("[\n", out);
    for (size_t i = 0; i < count; i++) {
        print_set(out, &sets[i]);
        fputs(i + 1 < count ? ",\n" : "\n", out);
    }
    fputs("]", out);
}
