#include "sheet_row.h"

#include <stdlib.h>
#include <string.h>

#include "colors.h"
#include "picture.h"
#include "png.h"
#include "room_colors.h"
#include "score.h"
#include "threshold.h"
#include "truth.h"

#define NO_ROOM_IN_REFERENCE 255u

/* Labels of which a greater share lies on cells that are not free are those of a turned map. */
#define STRAY_PERCENT 5u

/* A map while its row is made. */
typedef struct making {
    map m;
    rs_frame frame;
    label_image labels[SHEET_COLUMNS];
    uint8_t *colors; /* of the labels that all columns follow; a pastel each */
    int leader;      /* their column */
    const char *name;
} making;

/* Labels of one column with what they look like. */
typedef struct labels_paint {
    const making *m;
    const label_image *labels;
    const uint32_t *shown_as; /* by label: the leader's; NULL: as they are */
    const uint8_t *colors;
    uint32_t reach;           /* thickness of a seam [cells] */
} labels_paint;

static uint32_t value_at(const labels_paint *p, uint32_t x, uint32_t y) {
    return x < p->labels->width && y < p->labels->height
               ? p->labels->values[(size_t)y * p->labels->width + x]
               : 0;
}

static color ground_color(const making *m, uint32_t x, uint32_t y) {
    uint8_t cell = m->m.cells[(size_t)y * m->m.width + x];
    roomseg_config config = roomseg_config_default();
    return cell <= config.free_max       ? PAINT_FREE
           : cell >= config.occupied_min ? PAINT_OBSTACLE
                                         : PAINT_UNKNOWN;
}

/* Whether another room is near in one direction, with nothing but free cells between. */
static int room_ahead(const labels_paint *p, uint32_t label, uint32_t x, uint32_t y,
                      uint32_t dx, uint32_t dy) {
    for (uint32_t k = 1; k <= p->reach; k++) {
        uint32_t other = value_at(p, x + k * dx, y + k * dy);
        if (other != 0 && other != label) {
            return 1;
        }
        if (other == label) {
            continue;
        }
        if (x + k * dx >= p->labels->width || y + k * dy >= p->labels->height ||
            (p->shown_as != NULL &&
             ground_color(p->m, x + k * dx, y + k * dy).r != PAINT_FREE.r)) {
            return 0;
        }
    }
    return 0;
}

/* (x, y): of the labels. */
static color label_color(const labels_paint *p, uint32_t x, uint32_t y) {
    uint32_t label = value_at(p, x, y);
    if (label == 0) {
        return p->shown_as != NULL ? ground_color(p->m, x, y) : PAINT_UNKNOWN;
    }
    if (room_ahead(p, label, x, y, 1, 0) || room_ahead(p, label, x, y, 0, 1)) {
        return PAINT_INK;
    }
    uint32_t shown = p->shown_as != NULL ? p->shown_as[label] : label;
    return shown == 0 ? PAINT_BACKGROUND : room_color(p->colors[shown]);
}

static uint32_t greatest(const label_image *labels) {
    size_t cells = (size_t)labels->width * labels->height;
    uint32_t most = 0;
    for (size_t i = 0; i < cells; i++) {
        most = labels->values[i] > most ? labels->values[i] : most;
    }
    return most;
}

/* Labels beyond 16 bits begin anew: a picture has no use for them. */
static void narrow(label_image *labels) {
    size_t cells = (size_t)labels->width * labels->height;
    for (size_t i = 0; i < cells; i++) {
        uint32_t value = labels->values[i];
        labels->values[i] = value == 0 ? 0 : (value - 1) % UINT16_MAX + 1;
    }
}

/* A pastel for each label; NULL when memory runs out. */
static uint8_t *choose_colors(const label_image *labels) {
    size_t cells = (size_t)labels->width * labels->height;
    uint32_t most = greatest(labels);
    uint16_t *copy = malloc(cells * sizeof *copy);
    uint8_t *colors = malloc((size_t)most + 1);
    int rc = -1;
    if (copy != NULL && colors != NULL) {
        for (size_t i = 0; i < cells; i++) {
            copy[i] = (uint16_t)labels->values[i];
        }
        rc = label_colors_choose(copy, labels->width, labels->height, most, colors);
    }
    free(copy);
    if (rc != 0) {
        free(colors);
        colors = NULL;
    }
    return colors;
}

/* For each label the one of `leader` that it shares most cells with; 0: none. NULL when memory
 * runs out. */
static uint32_t *follow(const label_image *labels, const label_image *leader) {
    uint32_t most = greatest(labels);
    uint32_t *shown_as = calloc((size_t)most + 1, sizeof *shown_as);
    uint64_t *cells = calloc((size_t)most + 1, sizeof *cells);
    contingency table = {NULL, 0};
    int rc = shown_as != NULL && cells != NULL ? contingency_count(leader, labels, &table) : -1;
    for (size_t i = 0; rc == 0 && i < table.count; i++) {
        const overlap *o = &table.overlaps[i];
        if (o->truth != 0 && o->label != 0 && o->cells > cells[o->label]) {
            cells[o->label] = o->cells;
            shown_as[o->label] = o->truth;
        }
    }
    contingency_free(&table);
    free(cells);
    if (rc != 0) {
        free(shown_as);
        shown_as = NULL;
    }
    return shown_as;
}

/* The box that is drawn, and a canvas of it with a pixel a cell. */
typedef struct full_size {
    uint32_t x, y, width, height;
    canvas c;
} full_size;

static int full_size_make(uint32_t x, uint32_t y, uint32_t width, uint32_t height,
                          full_size *out) {
    *out = (full_size){x, y, width, height, {NULL, 0, 0}};
    return canvas_create(&out->c, width, height, PAINT_UNKNOWN);
}

/* The full-size canvas, shrunk, is the cell's picture. */
static int finish(full_size *f, sheet_cell *cell) {
    int rc = canvas_shrink(&f->c, SHEET_CELL_WIDTH, SHEET_CELL_HEIGHT, &cell->picture);
    canvas_free(&f->c);
    return rc;
}

static int draw_map_cell(const making *m, sheet_cell *cell) {
    full_size f;
    if (full_size_make(m->frame.x, m->frame.y, m->frame.width, m->frame.height, &f) != 0) {
        return -1;
    }
    for (uint32_t y = 0; y < f.height; y++) {
        for (uint32_t x = 0; x < f.width; x++) {
            uint8_t gray = (uint8_t)(255 - m->m.cells[(size_t)(f.y + y) * m->m.width + f.x + x]);
            draw_pixel(&f.c, (int)x, (int)y, (color){gray, gray, gray});
        }
    }
    return finish(&f, cell);
}

/* The box of all cells with a label; without labels one cell. */
static full_size box_of(const label_image *labels) {
    full_size box = {labels->width, labels->height, 0, 0, {NULL, 0, 0}};
    uint32_t right = 0, bottom = 0;
    for (uint32_t y = 0; y < labels->height; y++) {
        for (uint32_t x = 0; x < labels->width; x++) {
            if (labels->values[(size_t)y * labels->width + x] != 0) {
                box.x = x < box.x ? x : box.x;
                box.y = y < box.y ? y : box.y;
                right = x + 1 > right ? x + 1 : right;
                bottom = y + 1;
            }
        }
    }
    box.width = right > box.x ? right - box.x : 1;
    box.height = bottom > box.y ? bottom - box.y : 1;
    return box;
}

static int draw_labels(const making *m, const labels_paint *paint, int own_box,
                       sheet_cell *cell) {
    full_size f = own_box ? box_of(paint->labels)
                          : (full_size){m->frame.x, m->frame.y, m->frame.width,
                                        m->frame.height, {NULL, 0, 0}};
    labels_paint p = *paint;
    uint32_t step = f.width / SHEET_CELL_WIDTH > f.height / SHEET_CELL_HEIGHT
                        ? f.width / SHEET_CELL_WIDTH
                        : f.height / SHEET_CELL_HEIGHT;
    p.reach = step + 1;
    if (full_size_make(f.x, f.y, f.width, f.height, &f) != 0) {
        return -1;
    }
    for (uint32_t y = 0; y < f.height; y++) {
        for (uint32_t x = 0; x < f.width; x++) {
            draw_pixel(&f.c, (int)x, (int)y, label_color(&p, f.x + x, f.y + y));
        }
    }
    return finish(&f, cell);
}

/* Whether the labels are those of the map as it lies. */
static int fits_map(const making *m, const label_image *labels) {
    size_t cells = (size_t)labels->width * labels->height;
    uint8_t free_max = roomseg_config_default().free_max;
    uint64_t labelled = 0, stray = 0;
    if (labels->width != m->m.width || labels->height != m->m.height) {
        return 0;
    }
    for (size_t i = 0; i < cells; i++) {
        labelled += labels->values[i] != 0;
        stray += labels->values[i] != 0 && m->m.cells[i] > free_max;
    }
    return stray * 100u <= labelled * STRAY_PERCENT;
}

/* Draws a column that has labels. */
static int draw_column(const making *m, int column, sheet_cell *cell) {
    const label_image *labels = &m->labels[column];
    int fits = column != SHEET_REFERENCE || fits_map(m, labels);
    uint32_t *shown_as = NULL;
    uint8_t *own = NULL;
    int rc = -1;
    if (fits) {
        shown_as = follow(labels, &m->labels[m->leader]);
    } else {
        own = choose_colors(labels);
    }
    if (shown_as != NULL || own != NULL) {
        labels_paint paint = {m, labels, shown_as, fits ? m->colors : own, 0};
        rc = draw_labels(m, &paint, !fits, cell);
    }
    free(shown_as);
    free(own);
    return rc;
}

static int segment_column(making *m, const roomseg_config *config, label_image *labels,
                          sheet_cell *cell, tool_error *error) {
    segmentation s;
    if (segment_map(&m->m, config, m->name, &s, error) != 0) {
        return -1;
    }
    size_t cells = (size_t)m->m.width * m->m.height;
    *labels = (label_image){malloc(cells * sizeof *labels->values), m->m.width, m->m.height};
    for (size_t i = 0; labels->values != NULL && i < cells; i++) {
        labels->values[i] = s.labels[i];
    }
    cell->has_rooms = 1;
    cell->rooms = s.result.room_count;
    segmentation_free(&s);
    if (labels->values == NULL) {
        tool_error_set(error, "%s: out of memory", m->name);
        return -1;
    }
    return 0;
}

static int score_column(const making *m, int column, const char *name, sheet_cell *cell,
                        tool_error *error) {
    const label_image *truth = &m->labels[SHEET_TRUTH];
    const label_image *labels = &m->labels[column];
    score s;
    int own_frame = column == SHEET_REFERENCE &&
                    (labels->width != m->m.width || labels->height != m->m.height);
    if (truth->values == NULL || labels->values == NULL || own_frame) {
        return 0;
    }
    if (score_labels(truth, labels, name, &s, error) != 0) {
        return -1;
    }
    cell->has_score = 1;
    cell->v = s.all.v;
    cell->has_rooms = 1;
    cell->rooms = s.all.rooms_found;
    return 0;
}

/* The labels that are in files. */
static int load_columns(making *m, const dataset_map *files, const char *reference,
                        tool_error *error) {
    int rc = 0;
    if (files->truth != NULL) {
        rc = truth_load(files->truth, TRUTH_AUTO, &m->labels[SHEET_TRUTH], error);
    }
    if (rc == 0 && reference != NULL) {
        rc = label_image_load(reference, &m->labels[SHEET_REFERENCE], error);
    }
    if (rc == 0 && m->labels[SHEET_REFERENCE].values != NULL) {
        label_image_clear(&m->labels[SHEET_REFERENCE], NO_ROOM_IN_REFERENCE);
    }
    return rc;
}

static int score_columns(const making *m, const dataset_map *files, sheet_row *row,
                         tool_error *error) {
    int rc = 0;
    for (int column = SHEET_DEFAULT; rc == 0 && column < SHEET_COLUMNS; column++) {
        rc = score_column(m, column, files->map, &row->cells[column], error);
    }
    return rc;
}

static int draw_row(making *m, sheet_row *row) {
    int has_truth = m->labels[SHEET_TRUTH].values != NULL;
    m->leader = has_truth ? SHEET_TRUTH : SHEET_DEFAULT;
    for (int column = 0; column < SHEET_COLUMNS; column++) {
        if (m->labels[column].values != NULL) {
            narrow(&m->labels[column]);
        }
    }
    m->colors = choose_colors(&m->labels[m->leader]);
    int rc = m->colors != NULL ? draw_map_cell(m, &row->cells[SHEET_MAP]) : -1;
    for (int column = SHEET_TRUTH; rc == 0 && column < SHEET_COLUMNS; column++) {
        if (m->labels[column].values != NULL) {
            rc = draw_column(m, column, &row->cells[column]);
        }
    }
    return rc;
}

static int find_crop(making *m, tool_error *error) {
    roomseg_grid grid = segment_grid(&m->m);
    rs_ticker silent = {NULL, NULL, ROOMSEG_STAGE_THRESHOLD, 0, 0, 0, 0};
    rs_threshold_crop(&grid, roomseg_config_default().free_max, &m->frame, &silent);
    if (m->frame.width == 0) {
        tool_error_set(error, "%s: no cell is free", m->name);
        return -1;
    }
    return 0;
}

int sheet_row_make(const dataset_map *files, const char *reference, const map_options *options,
                   const roomseg_config *by_default, const roomseg_config *by_paper,
                   sheet_row *out, tool_error *error) {
    making m;
    memset(&m, 0, sizeof m);
    memset(out, 0, sizeof *out);
    m.name = files->map;
    out->name = files->name;
    int rc = map_load(files->map, options, &m.m, error);
    rc = rc == 0 ? find_crop(&m, error) : rc;
    rc = rc == 0 ? load_columns(&m, files, reference, error) : rc;
    rc = rc == 0 ? segment_column(&m, by_default, &m.labels[SHEET_DEFAULT],
                                  &out->cells[SHEET_DEFAULT], error)
                 : rc;
    rc = rc == 0 ? segment_column(&m, by_paper, &m.labels[SHEET_PAPER],
                                  &out->cells[SHEET_PAPER], error)
                 : rc;
    rc = rc == 0 ? score_columns(&m, files, out, error) : rc;
    if (rc == 0 && draw_row(&m, out) != 0) {
        tool_error_set(error, "%s: out of memory", files->map);
        rc = -1;
    }
    for (int column = 0; column < SHEET_COLUMNS; column++) {
        label_image_free(&m.labels[column]);
    }
    free(m.colors);
    map_free(&m.m);
    if (rc != 0) {
        sheet_row_free(out);
    }
    return rc;
}

void sheet_row_free(sheet_row *row) {
    for (int column = 0; column < SHEET_COLUMNS; column++) {
        canvas_free(&row->cells[column].picture);
    }
    memset(row, 0, sizeof *row);
}
