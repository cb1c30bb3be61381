#include "segment_batch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "out.h"
#include "segment_file.h"
#include "workers.h"

typedef struct batch_item {
    const char *path;
    char *name; /* of its folder, owned */
    tool_error failure; /* empty: none */
    unsigned rooms;
    double area_m2;
} batch_item;

typedef struct batch_state {
    const segment_batch *batch;
    batch_item *items;
    size_t failures;
} batch_state;

/* The file's name without folders and ending; NULL when memory runs out. */
static char *name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    const char *file = slash != NULL ? slash + 1 : path;
    const char *dot = strrchr(file, '.');
    size_t length = dot != NULL && dot > file ? (size_t)(dot - file) : strlen(file);
    char *name = malloc(length + 1);
    if (name != NULL) {
        memcpy(name, file, length);
        name[length] = '\0';
    }
    return name;
}

static int compare_names(const void *left, const void *right) {
    const batch_item *const *a = left;
    const batch_item *const *b = right;
    return strcmp((*a)->name, (*b)->name);
}

/* Results of maps with the same name would overwrite each other. */
static int check_names(batch_item *items, size_t count, tool_error *error) {
    batch_item **sorted = malloc(count * sizeof *sorted);
    int rc = 0;
    if (sorted == NULL) {
        tool_error_set(error, "segment: out of memory");
        return -1;
    }
    for (size_t i = 0; i < count; i++) {
        sorted[i] = &items[i];
    }
    qsort(sorted, count, sizeof *sorted, compare_names);
    for (size_t i = 1; i < count && rc == 0; i++) {
        if (strcmp(sorted[i - 1]->name, sorted[i]->name) == 0) {
            tool_error_set(error, "%s, %s: both would be written to the folder '%s'",
                           sorted[i - 1]->path, sorted[i]->path, sorted[i]->name);
            rc = -1;
        }
    }
    free(sorted);
    return rc;
}

static void segment_item(void *user, size_t index) {
    const batch_state *state = user;
    const segment_batch *batch = state->batch;
    batch_item *item = &state->items[index];
    map m;
    segmentation s;
    char *folder = out_join(batch->folder, item->name);
    if (folder == NULL) {
        tool_error_set(&item->failure, "%s: out of memory", item->path);
        return;
    }
    if (segment_file(item->path, folder, &batch->options, &batch->config, &m, &s,
                     &item->failure) == 0) {
        item->rooms = (unsigned)s.result.room_count;
        for (uint32_t i = 0; i < s.result.room_count; i++) {
            item->area_m2 += s.result.rooms[i].area_cm2 / 1e4;
        }
        segmentation_free(&s);
        map_free(&m);
    }
    free(folder);
}

static void show_item(void *user, size_t index) {
    batch_state *state = user;
    const batch_item *item = &state->items[index];
    if (item->failure.text[0] != '\0') {
        state->failures++;
        tool_error_print(&item->failure);
        return;
    }
    printf("[%zu/%zu] %s/%s: %u rooms, %.2f m2\n", index + 1, state->batch->count,
           state->batch->folder, item->name, item->rooms, item->area_m2);
    fflush(stdout);
}

int segment_batch_run(const segment_batch *batch, tool_error *error) {
    batch_state state = {batch, calloc(batch->count, sizeof *state.items), 0};
    int rc = state.items != NULL ? 0 : -1;
    for (size_t i = 0; i < batch->count && rc == 0; i++) {
        state.items[i].path = batch->paths[i];
        state.items[i].name = name_of(batch->paths[i]);
        rc = state.items[i].name != NULL ? 0 : -1;
    }
    if (rc != 0) {
        tool_error_set(error, "segment: out of memory");
    } else {
        rc = check_names(state.items, batch->count, error);
    }
    if (rc == 0) {
        workers_run(batch->count, batch->workers, segment_item, show_item, &state);
        if (state.failures > 0) {
            tool_error_set(error, "%s: %zu of %zu maps failed", batch->folder, state.failures,
                           batch->count);
            rc = -1;
        }
    }
    for (size_t i = 0; state.items != NULL && i < batch->count; i++) {
        free(state.items[i].name);
    }
    free(state.items);
    return rc;
}
