#include "bench_table.h"

#include <string.h>

#include "truth.h"

/* A column of the table. */
typedef struct table_column {
    size_t value; /* index for result_value */
    const char *title;
    int width, decimals;
    double scale; /* number shown = value * scale */
} table_column;

enum { NAME_MIN_WIDTH = 24, NAME_MAX_WIDTH = 40, LEAST_SHOWN = 5 };

static const table_column table_columns[] = {
    {METRIC_UNDER_PAINTING, "under", 6, 2, 100.0},
    {METRIC_RECALL, "recall", 7, 2, 100.0},
    {METRIC_COMPLETENESS, "compl", 7, 2, 100.0},
    {METRIC_PRECISION, "prec", 7, 2, 100.0},
    {METRIC_HOMOGENEITY, "homog", 7, 2, 100.0},
    {METRIC_V, "V", 7, 2, 100.0},
    {METRIC_AMI, "AMI", 7, 2, 100.0},
    {METRIC_NMI, "NMI", 7, 2, 100.0},
    {METRIC_ARI, "ARI", 7, 2, 100.0},
    {METRIC_FMI, "FMI", 7, 2, 100.0},
    {METRIC_IOU, "IoU", 7, 2, 100.0},
    {METRIC_STRICT_V, "strictV", 8, 2, 100.0},
    {METRIC_ROOM_F1, "roomF1", 7, 2, 100.0},
    {RESULT_ROOMS_FOUND, "rooms", 7, 0, 1.0},
    {RESULT_ROOMS_TRUE, "true", 6, 0, 1.0},
    {RESULT_TIME_MS, "ms", 8, 1, 1.0},
    {RESULT_ARENA_BYTES, "KiB", 7, 0, 1.0 / 1024.0},
    {RESULT_BYTES_PER_CELL, "B/cell", 7, 2, 1.0},
    {RESULT_REFERENCE_ROOMS, "refrooms", 9, 0, 1.0},
    {RESULT_REFERENCE_ARI, "refARI", 7, 2, 100.0},
};

enum { TABLE_COLUMN_COUNT = sizeof table_columns / sizeof table_columns[0] };

/* Means that Sharif, Mohan, Suvarna (2023) published for their own implementation on the
 * maps of Bormann et al. (2016), in the order of metric_fields [%]. */
typedef struct paper_row {
    const char *set;
    double percent[METRIC_PAPER_COUNT];
    double recall_deviation, precision_deviation; /* of what their public implementation gives */
} paper_row;

static const paper_row paper_table[] = {
    {"furnished",
     {14.41, 94.05, 86.00, 98.11, 98.41, 91.59, 91.58, 91.59, 70.20, 75.41, 90.58},
     4.10, 2.88},
    {"no_furniture",
     {10.35, 94.76, 86.82, 98.18, 98.39, 92.06, 92.05, 92.06, 71.86, 76.69, 91.36},
     3.40, 2.97},
};

/* Their time per map. */
static const double PAPER_TIME_MS = 10300.0;

static const paper_row *find_paper_row(const char *set) {
    for (size_t i = 0; i < sizeof paper_table / sizeof paper_table[0]; i++) {
        if (strcmp(paper_table[i].set, set) == 0) {
            return &paper_table[i];
        }
    }
    return NULL;
}

static int name_width(const set_result *set) {
    size_t width = NAME_MIN_WIDTH;
    for (size_t i = 0; i < set->count; i++) {
        size_t length = strlen(set->maps[i].name);
        width = length > width ? length : width;
    }
    return width < NAME_MAX_WIDTH ? (int)width : NAME_MAX_WIDTH;
}

/* Columns that hold a number for at least one map. */
static int is_shown(const set_result *set, const table_column *column) {
    return result_spread(set, column->value, 0).count > 0;
}

static void print_head(FILE *out, const set_result *set, int width) {
    fprintf(out, "%-*s", width, "map");
    for (size_t c = 0; c < TABLE_COLUMN_COUNT; c++) {
        if (is_shown(set, &table_columns[c])) {
            fprintf(out, "%*s", table_columns[c].width, table_columns[c].title);
        }
    }
    fputc('\n', out);
}

static void print_number(FILE *out, const table_column *column, double value) {
    fprintf(out, "%*.*f", column->width, column->decimals, value * column->scale);
}

static void print_map(FILE *out, const set_result *set, const map_result *map, int width) {
    fprintf(out, "%-*.*s", width, width, map->name);
    if (map->failure.text[0] != '\0') {
        fputs("  failed\n", out);
        return;
    }
    for (size_t c = 0; c < TABLE_COLUMN_COUNT; c++) {
        double value;
        if (!is_shown(set, &table_columns[c])) {
            continue;
        }
        if (result_value(map, table_columns[c].value, 0, &value)) {
            print_number(out, &table_columns[c], value);
        } else {
            fprintf(out, "%*s", table_columns[c].width, "-");
        }
    }
    fputc('\n', out);
}

static void print_spread(FILE *out, const set_result *set, const char *title, int width,
                         int without_specks, int deviation) {
    fprintf(out, "%-*s", width, title);
    for (size_t c = 0; c < TABLE_COLUMN_COUNT; c++) {
        const table_column *column = &table_columns[c];
        if (is_shown(set, column)) {
            spread s = result_spread(set, column->value, without_specks);
            /* Mean numbers of rooms are no whole numbers. */
            table_column shown = *column;
            shown.decimals += column->value == RESULT_ROOMS_FOUND ||
                              column->value == RESULT_ROOMS_TRUE ||
                              column->value == RESULT_REFERENCE_ROOMS;
            print_number(out, &shown, deviation ? s.deviation : s.mean);
        }
    }
    fputc('\n', out);
}

static void print_paper(FILE *out, const set_result *set, const paper_row *paper, int width) {
    fprintf(out, "%-*s", width, "paper, published means");
    for (size_t c = 0; c < TABLE_COLUMN_COUNT; c++) {
        const table_column *column = &table_columns[c];
        if (!is_shown(set, column)) {
            continue;
        }
        if (column->value < METRIC_PAPER_COUNT) {
            print_number(out, column, paper->percent[column->value] / column->scale);
        } else if (column->value == RESULT_TIME_MS) {
            print_number(out, column, PAPER_TIME_MS / column->scale);
        } else {
            fprintf(out, "%*s", column->width, "");
        }
    }
    fputc('\n', out);
}

void bench_table_print(FILE *out, const set_result *set) {
    int width = name_width(set);
    size_t failures = result_failures(set);
    const paper_row *paper = find_paper_row(set->name);
    fprintf(out, "%s: %zu map%s", set->name, set->count, set->count == 1 ? "" : "s");
    if (failures > 0) {
        fprintf(out, ", %zu failed and left out of the means", failures);
    }
    fputs(result_has_scores(set) ? " (scores in %)\n" : "\n", out);
    print_head(out, set, width);
    for (size_t i = 0; i < set->count; i++) {
        print_map(out, set, &set->maps[i], width);
    }
    if (failures < set->count) {
        print_spread(out, set, "mean", width, 0, 0);
        print_spread(out, set, "deviation", width, 0, 1);
    }
    if (result_has_scores(set)) {
        char title[NAME_MIN_WIDTH + 1];
        snprintf(title, sizeof title, "mean, truth >= %u cells", TRUTH_SPECK_CELLS);
        print_spread(out, set, title, width, 1, 0);
        print_spread(out, set, "deviation", width, 1, 1);
        if (paper != NULL) {
            print_paper(out, set, paper, width);
        }
    }
    fputc('\n', out);
}

static void print_plus_minus(FILE *out, double mean, double deviation) {
    fprintf(out, "%9.2f +- %5.2f", mean, deviation);
}

static void print_own(FILE *out, const set_result *set, size_t column) {
    spread s = result_spread(set, column, 0);
    print_plus_minus(out, s.mean * 100.0, s.deviation * 100.0);
}

/* Table II: recall and precision, the paper's beside ours. */
static void print_recall_and_precision(FILE *out, const set_result *sets, size_t count) {
    int head = 0;
    for (size_t i = 0; i < count; i++) {
        const paper_row *paper = find_paper_row(sets[i].name);
        if (!result_has_scores(&sets[i])) {
            continue;
        }
        if (!head) {
            fprintf(out, "%-*s%18s%18s%18s%18s\n", NAME_MIN_WIDTH, "mean +- deviation, %",
                    "recall", "precision", "paper: recall", "paper: precision");
            head = 1;
        }
        fprintf(out, "%-*.*s", NAME_MIN_WIDTH, NAME_MAX_WIDTH, sets[i].name);
        print_own(out, &sets[i], METRIC_RECALL);
        print_own(out, &sets[i], METRIC_PRECISION);
        if (paper != NULL) {
            print_plus_minus(out, paper->percent[METRIC_RECALL], paper->recall_deviation);
            print_plus_minus(out, paper->percent[METRIC_PRECISION], paper->precision_deviation);
        }
        fputc('\n', out);
    }
}

/* The map that agrees least among those that agree better than `above`; NULL: none is left.
 * Maps that agree equally well count as one. */
static const map_result *find_least(const set_result *sets, size_t count, double above,
                                    const char **set) {
    const map_result *least = NULL;
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < sets[i].count; k++) {
            const map_result *map = &sets[i].maps[k];
            if (map->has_reference && map->failure.text[0] == '\0' &&
                map->reference.ari > above &&
                (least == NULL || map->reference.ari < least->reference.ari)) {
                least = map;
                *set = sets[i].name;
            }
        }
    }
    return least;
}

static void print_agreement(FILE *out, const set_result *sets, size_t count) {
    double sum = 0.0;
    double above = -2.0; /* below any adjusted Rand index */
    size_t maps = 0;
    for (size_t i = 0; i < count; i++) {
        spread s = result_spread(&sets[i], RESULT_REFERENCE_ARI, 0);
        sum += s.mean * (double)s.count;
        maps += s.count;
    }
    if (maps == 0) {
        return;
    }
    fprintf(out, "adjusted Rand index with the reference, %%: mean of %zu maps %.2f; least", maps,
            sum / (double)maps * 100.0);
    for (int i = 0; i < LEAST_SHOWN; i++) {
        const char *set = "";
        const map_result *map = find_least(sets, count, above, &set);
        if (map == NULL) {
            break;
        }
        fprintf(out, "%s %s/%s %.2f", i > 0 ? "," : "", set, map->name, map->reference.ari * 100.0);
        above = map->reference.ari;
    }
    fputc('\n', out);
}

void bench_table_print_summary(FILE *out, const set_result *sets, size_t count) {
    print_recall_and_precision(out, sets, count);
    print_agreement(out, sets, count);
}
