#include "partition.h"

#include <stdlib.h>
#include <string.h>

void partition_free(partition *p) {
    free(p->rows);
    free(p->columns);
    free(p->pairs);
    memset(p, 0, sizeof *p);
}

static int compare_parts(const void *left, const void *right) {
    const part *a = left;
    const part *b = right;
    return a->value < b->value ? -1 : a->value > b->value;
}

static int is_kept(const overlap *o, unsigned keep) {
    return (o->truth != 0 || (keep & KEEP_OUTSIDE) != 0) &&
           (o->label != 0 || (keep & KEEP_UNLABELLED) != 0);
}

/* Fills the columns: sorts the labels of the kept overlaps and drops repetitions. */
static void collect_columns(const contingency *table, unsigned keep, partition *p) {
    size_t count = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (is_kept(&table->overlaps[i], keep)) {
            p->columns[count++] = (part){table->overlaps[i].label, 0};
        }
    }
    if (count > 0) {
        qsort(p->columns, count, sizeof *p->columns, compare_parts);
    }
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || p->columns[i].value != p->columns[i - 1].value) {
            p->columns[p->column_count++] = p->columns[i];
        }
    }
}

static void add_pair(partition *p, const overlap *o) {
    part key = {o->label, 0};
    part *column =
        bsearch(&key, p->columns, p->column_count, sizeof *p->columns, compare_parts);
    if (p->row_count == 0 || p->rows[p->row_count - 1].value != o->truth) {
        p->rows[p->row_count++] = (part){o->truth, 0};
    }
    column->cells += o->cells;
    p->rows[p->row_count - 1].cells += o->cells;
    p->total += o->cells;
    p->pairs[p->pair_count++] =
        (shared){p->row_count - 1, (size_t)(column - p->columns), o->cells};
}

int partition_build(const contingency *table, unsigned keep, partition *p) {
    size_t room = table->count > 0 ? table->count : 1;
    memset(p, 0, sizeof *p);
    p->rows = malloc(room * sizeof *p->rows);
    p->columns = malloc(room * sizeof *p->columns);
    p->pairs = malloc(room * sizeof *p->pairs);
    if (p->rows == NULL || p->columns == NULL || p->pairs == NULL) {
        partition_free(p);
        return -1;
    }
    collect_columns(table, keep, p);
    for (size_t i = 0; i < table->count; i++) {
        if (is_kept(&table->overlaps[i], keep)) {
            add_pair(p, &table->overlaps[i]);
        }
    }
    return 0;
}
