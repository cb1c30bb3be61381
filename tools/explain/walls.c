#include "walls.h"

#include <stdlib.h>
#include <string.h>

#include "align.h"
#include "canny.h"
#include "rotate.h"
#include "segment.h"

static const rs_ticker no_ticker;

/* The free cells with small obstacles taken out, in w->edges. */
static int make_mask(const roomseg_grid *grid, const roomseg_config *config,
                     const rs_frame *frame, walls *w) {
    rs_component_limits limits = rs_components_limits(config, grid->resolution_mm);
    rs_ticker ticker = no_ticker;
    size_t small =
        ROOMSEG_PLAN_SMALL(config->speck_mm2, config->clutter_mm, grid->resolution_mm);
    void *scratch = malloc(ROOMSEG_PLAN_SMALL_BYTES(frame->width, small));
    int status = 1;
    limits.clutter_cells = 0;
    if (scratch != NULL) {
        status = rs_align_mask(config, grid, frame, limits, w->edges, scratch, &ticker);
    }
    free(scratch);
    return status;
}

static int find_edges(const rs_frame *frame, uint32_t *points, walls *w) {
    rs_ticker ticker = no_ticker;
    uint16_t *rows =
        malloc(ROOMSEG_CANNY_ROWS * ((size_t)frame->stride + 2) * sizeof *rows);
    int status = 1;
    if (rows != NULL) {
        status = rs_canny_run(frame, w->edges, points, &w->edge_cells, rows, &ticker);
    }
    free(rows);
    return status;
}

static int add_line(walls *w, const rs_line *line) {
    if ((w->line_count & (w->line_count - 1)) == 0) { /* a power of two: full */
        size_t capacity = w->line_count > 0 ? 2 * w->line_count : 1;
        rs_line *lines = realloc(w->lines, capacity * sizeof *lines);
        if (lines == NULL) {
            return 1;
        }
        w->lines = lines;
    }
    w->lines[w->line_count++] = *line;
    rs_direction_add(w->bins, line);
    return 0;
}

/* Uses up the points and a copy of the edges. */
static int find_lines(const rs_frame *frame, uint32_t *points, walls *w) {
    size_t cells = ROOMSEG_PLAN_CELLS(frame->width, frame->height);
    rs_ticker ticker = no_ticker;
    uint8_t *edges = malloc(cells);
    uint16_t *votes = malloc(ROOMSEG_HOUGH_ANGLES *
                             ROOMSEG_PLAN_DISTANCES(frame->width, frame->height) *
                             sizeof *votes);
    rs_normal *normals = malloc(ROOMSEG_HOUGH_ANGLES * sizeof *normals);
    bool found = true;
    rs_hough hough;
    int status = edges == NULL || votes == NULL || normals == NULL;
    rs_direction_clear(w->bins);
    if (status == 0) {
        memcpy(edges, w->edges, cells);
        rs_hough_init(&hough, frame, edges, points, w->edge_cells, votes, normals);
    }
    while (status == 0 && found) {
        rs_line line;
        status = rs_hough_next(&hough, &line, &found, &ticker);
        if (status == 0 && found) {
            status = add_line(w, &line);
        }
    }
    w->angle = rs_direction_find(w->bins);
    free(edges);
    free(votes);
    free(normals);
    return status;
}

int walls_find(const map *m, const roomseg_config *config, const rs_frame *frame,
               const char *name, walls *out, tool_error *error) {
    roomseg_grid grid = segment_grid(m);
    memset(out, 0, sizeof *out);
    uint32_t *points = malloc((size_t)frame->width * frame->height * sizeof *points);
    out->edges = malloc(ROOMSEG_PLAN_CELLS(frame->width, frame->height));
    int status = points == NULL || out->edges == NULL;
    if (status == 0) {
        status = make_mask(&grid, config, frame, out);
    }
    if (status == 0) {
        status = find_edges(frame, points, out);
    }
    if (status == 0) {
        status = find_lines(frame, points, out);
    }
    free(points);
    if (status != 0) {
        tool_error_set(error, "%s: out of memory", name);
        walls_free(out);
        return -1;
    }
    return 0;
}

void walls_free(walls *w) {
    free(w->edges);
    free(w->lines);
    memset(w, 0, sizeof *w);
}

int walls_turn(const map *m, const roomseg_config *config, const rs_frame *frame, int32_t angle,
               const char *name, map *out, tool_error *error) {
    roomseg_grid grid = segment_grid(m);
    rs_ticker ticker = no_ticker;
    rs_rotation rotation;
    memset(out, 0, sizeof *out);
    rs_rotate_init(frame, &grid, config->free_max, angle, &rotation, &ticker);
    out->cells = malloc((size_t)rotation.width * rotation.height);
    if (out->cells == NULL) {
        tool_error_set(error, "%s: out of memory", name);
        return -1;
    }
    out->width = rotation.width;
    out->height = rotation.height;
    out->resolution_m = m->resolution_m;
    rs_rotate_grid(&rotation, &grid, rs_align_mixture(config), out->cells, rotation.width,
                   &ticker);
    return 0;
}
