#include "truth.h"

#include <stddef.h>
#include <stdlib.h>

/* Cells first..last of a row that belong to a component. */
typedef struct run {
    uint32_t first, last, row;
    size_t parent; /* index of a run of the same component, itself for its first run */
} run;

typedef struct run_list {
    run *runs;
    size_t count, capacity;
} run_list;

static int push_run(run_list *list, uint32_t first, uint32_t last, uint32_t row) {
    if (list->count == list->capacity) {
        size_t capacity = list->capacity > 0 ? list->capacity * 2 : 4096;
        run *runs = realloc(list->runs, capacity * sizeof *runs);
        if (runs == NULL) {
            return -1;
        }
        list->runs = runs;
        list->capacity = capacity;
    }
    list->runs[list->count] = (run){first, last, row, list->count};
    list->count++;
    return 0;
}

static size_t find_root(run *runs, size_t i) {
    while (runs[i].parent != i) {
        runs[i].parent = runs[runs[i].parent].parent;
        i = runs[i].parent;
    }
    return i;
}

/* The earlier run becomes the root, so that a root is the first run of its component. */
static void join_runs(run *runs, size_t i, size_t j) {
    size_t a = find_root(runs, i);
    size_t b = find_root(runs, j);
    if (a < b) {
        runs[b].parent = a;
    } else {
        runs[a].parent = b;
    }
}

/* Joins the runs from `row` on with those from `above` to `row` where they touch, by an
 * edge or a corner. */
static void join_rows(run_list *list, size_t above, size_t row) {
    for (size_t i = row; i < list->count; i++) {
        const run *r = &list->runs[i];
        while (above < row && list->runs[above].last + 1 < r->first) {
            above++;
        }
        for (size_t j = above; j < row && list->runs[j].first <= r->last + 1; j++) {
            join_runs(list->runs, i, j);
        }
    }
}

static int find_runs(const label_image *image, run_list *list) {
    size_t above = 0;
    for (uint32_t y = 0; y < image->height; y++) {
        const uint32_t *row = image->values + (size_t)y * image->width;
        size_t start = list->count;
        for (uint32_t x = 0; x < image->width; x++) {
            uint32_t first = x;
            while (x < image->width && row[x] != 0) {
                x++;
            }
            if (x > first && push_run(list, first, x - 1, y) != 0) {
                return -1;
            }
        }
        join_rows(list, above, start);
        above = start;
    }
    return 0;
}

/* A root comes before the other runs of its component and so has its number by then. */
static void write_labels(label_image *image, run_list *list) {
    uint32_t count = 0;
    for (size_t i = 0; i < list->count; i++) {
        const run *r = &list->runs[i];
        uint32_t *row = image->values + (size_t)r->row * image->width;
        size_t root = find_root(list->runs, i);
        uint32_t label;
        if (root == i) {
            label = ++count;
        } else {
            const run *first = &list->runs[root];
            label = image->values[(size_t)first->row * image->width + first->first];
        }
        for (uint32_t x = r->first; x <= r->last; x++) {
            row[x] = label;
        }
    }
}

int truth_label_components(label_image *image) {
    run_list list = {NULL, 0, 0};
    int rc = find_runs(image, &list);
    if (rc == 0) {
        write_labels(image, &list);
    }
    free(list.runs);
    return rc;
}

/* What TRUTH_AUTO decides by. */
typedef struct value_range {
    uint32_t low, high;
    int more; /* there are values between the two */
} value_range;

static value_range find_range(const label_image *image) {
    size_t cells = (size_t)image->width * image->height;
    value_range range = {image->values[0], image->values[0], 0};
    for (size_t i = 1; i < cells; i++) {
        uint32_t value = image->values[i];
        if (value == range.low || value == range.high) {
            continue;
        }
        range.more |= range.low != range.high;
        range.low = value < range.low ? value : range.low;
        range.high = value > range.high ? value : range.high;
    }
    return range;
}

/* The kind of an image that was not said to be of one; of two values the lower one
 * becomes 0. */
static truth_kind settle_kind(label_image *image, const value_range *range) {
    if (range->more) {
        return TRUTH_LABELS;
    }
    if (range->low != range->high) {
        label_image_clear(image, range->low);
    }
    return TRUTH_MASK;
}

int truth_load(const char *path, truth_kind kind, label_image *out, tool_error *error) {
    if (label_image_load(path, out, error) != 0) {
        return -1;
    }
    value_range range = find_range(out);
    if (kind == TRUTH_AUTO) {
        kind = settle_kind(out, &range);
    }
    const char *cause = range.high == 0 ? "holds no room: all values are 0" : NULL;
    if (cause == NULL && kind == TRUTH_MASK && truth_label_components(out) != 0) {
        cause = "out of memory";
    }
    if (cause != NULL) {
        tool_error_set(error, "%s: %s", path, cause);
        label_image_free(out);
        return -1;
    }
    return 0;
}
