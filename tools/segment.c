#include "segment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

roomseg_grid segment_grid(const map *m) {
    roomseg_grid grid = {m->cells, m->width, m->height, m->width,
                         (uint32_t)lround(m->resolution_m * 1000.0)};
    return grid;
}

/* Doubles the capacity that the status complains about; 0 when it can grow no more. */
static int grow(roomseg_config *config, int status) {
    int regions = status == ROOMSEG_ERR_REGIONS;
    uint32_t *capacity = regions ? &config->max_regions : &config->max_rooms;
    uint32_t limit = regions ? ROOMSEG_MAX_REGIONS : ROOMSEG_MAX_ROOMS;
    if (*capacity >= limit) {
        return 0;
    }
    *capacity = *capacity > limit / 2 ? limit : *capacity * 2;
    if (config->max_regions < config->max_rooms) {
        config->max_regions = config->max_rooms;
    }
    return 1;
}

/* One run in a fresh arena. Returns a roomseg_status; 1 when memory runs out. */
static int run_once(const map *m, segmentation *s) {
    roomseg_grid grid = segment_grid(m);
    free(s->arena);
    s->arena = NULL;
    int status = roomseg_arena_size_for_grid(&s->config, &grid, &s->arena_bytes);
    if (status != ROOMSEG_OK) {
        return status;
    }
    if (s->arena_bytes > 0) {
        s->arena = malloc(s->arena_bytes);
        if (s->arena == NULL) {
            return 1;
        }
    }
    return segment_again(m, s);
}

int segment_map(const map *m, const roomseg_config *config, const char *name,
                segmentation *out, tool_error *error) {
    memset(out, 0, sizeof *out);
    out->config = *config;
    int status = 1;
    out->labels = malloc((size_t)m->width * m->height * sizeof *out->labels);
    if (out->labels != NULL) {
        do {
            status = run_once(m, out);
        } while ((status == ROOMSEG_ERR_REGIONS || status == ROOMSEG_ERR_ROOMS) &&
                 grow(&out->config, status));
    }
    if (status == ROOMSEG_OK) {
        return 0;
    }
    tool_error_set(error, "%s: cannot be segmented: %s", name,
                   status == 1 ? "out of memory" : roomseg_status_text(status));
    segmentation_free(out);
    return -1;
}

int segment_again(const map *m, segmentation *s) {
    roomseg_grid grid = segment_grid(m);
    return roomseg_run(&s->config, &grid, s->labels, m->width, &s->result, s->arena,
                       s->arena_bytes);
}

void segmentation_free_labels(segmentation *s) {
    free(s->labels);
    s->labels = NULL;
}

void segmentation_free(segmentation *s) {
    segmentation_free_labels(s);
    free(s->arena);
    memset(s, 0, sizeof *s);
}
