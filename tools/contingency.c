#include "contingency.h"

#include <stdlib.h>
#include <string.h>

/* Open addressing, linear probing; a slot with no cells is empty. */
typedef struct overlap_table {
    overlap *slots;
    size_t capacity; /* a power of two, kept at least half empty */
    size_t used;
} overlap_table;

static overlap *find_slot(const overlap_table *table, uint32_t truth, uint32_t label) {
    uint64_t key = (uint64_t)truth << 32 | label;
    /* Multiplying by an odd number near 2^64 / golden ratio spreads neighbouring keys. */
    size_t i = (size_t)((key * 0x9E3779B97F4A7C15u) >> 32) & (table->capacity - 1);
    while (table->slots[i].cells != 0 &&
           (table->slots[i].truth != truth || table->slots[i].label != label)) {
        i = (i + 1) & (table->capacity - 1);
    }
    return &table->slots[i];
}

static int table_grow(overlap_table *table) {
    overlap_table larger = {NULL, table->capacity * 2, table->used};
    larger.slots = calloc(larger.capacity, sizeof *larger.slots);
    if (larger.slots == NULL) {
        return -1;
    }
    for (size_t i = 0; i < table->capacity; i++) {
        const overlap *old = &table->slots[i];
        if (old->cells != 0) {
            *find_slot(&larger, old->truth, old->label) = *old;
        }
    }
    free(table->slots);
    *table = larger;
    return 0;
}

static int table_add(overlap_table *table, uint32_t truth, uint32_t label, uint64_t cells) {
    overlap *slot = find_slot(table, truth, label);
    if (slot->cells == 0) {
        slot->truth = truth;
        slot->label = label;
        table->used++;
    }
    slot->cells += cells;
    return table->used * 2 > table->capacity ? table_grow(table) : 0;
}

/* Adds the cells in runs of equal pairs: neighbours mostly agree. */
static int count_runs(const label_image *truth, const label_image *labels,
                      overlap_table *table) {
    size_t cells = (size_t)truth->width * truth->height;
    size_t start = 0;
    for (size_t i = 1; i <= cells; i++) {
        if (i < cells && truth->values[i] == truth->values[start] &&
            labels->values[i] == labels->values[start]) {
            continue;
        }
        if (table_add(table, truth->values[start], labels->values[start], i - start) != 0) {
            return -1;
        }
        start = i;
    }
    return 0;
}

static int compare_overlaps(const void *left, const void *right) {
    const overlap *a = left;
    const overlap *b = right;
    if (a->truth != b->truth) {
        return a->truth < b->truth ? -1 : 1;
    }
    return a->label < b->label ? -1 : a->label > b->label;
}

static void sort_overlaps(contingency *table) {
    if (table->count > 0) {
        qsort(table->overlaps, table->count, sizeof *table->overlaps, compare_overlaps);
    }
}

int contingency_count(const label_image *truth, const label_image *labels, contingency *out) {
    overlap_table table = {NULL, 1024, 0};
    memset(out, 0, sizeof *out);
    table.slots = calloc(table.capacity, sizeof *table.slots);
    if (table.slots == NULL || count_runs(truth, labels, &table) != 0) {
        free(table.slots);
        return -1;
    }
    out->overlaps = table.slots;
    for (size_t i = 0; i < table.capacity; i++) {
        if (table.slots[i].cells != 0) {
            out->overlaps[out->count++] = table.slots[i];
        }
    }
    sort_overlaps(out);
    return 0;
}

/* Joins neighbouring entries of the same pair. */
static void join_equal(contingency *table) {
    size_t kept = 0;
    for (size_t i = 0; i < table->count; i++) {
        const overlap *next = &table->overlaps[i];
        overlap *last = kept > 0 ? &table->overlaps[kept - 1] : NULL;
        if (last != NULL && last->truth == next->truth && last->label == next->label) {
            last->cells += next->cells;
        } else {
            table->overlaps[kept++] = *next;
        }
    }
    table->count = kept;
}

void contingency_drop_specks(contingency *table, uint64_t min_cells) {
    size_t end;
    for (size_t start = 0; start < table->count; start = end) {
        uint32_t room = table->overlaps[start].truth;
        uint64_t cells = 0;
        for (end = start; end < table->count && table->overlaps[end].truth == room; end++) {
            cells += table->overlaps[end].cells;
        }
        for (size_t i = start; i < end && cells < min_cells; i++) {
            table->overlaps[i].truth = 0;
        }
    }
    sort_overlaps(table);
    join_equal(table);
}

void contingency_free(contingency *table) {
    free(table->overlaps);
    memset(table, 0, sizeof *table);
}
