/* Writes the golden texts anew and draws what has changed.
 *
 *   update_golden FOLDER PICTURES
 *
 * FOLDER holds the texts. Of each one that changes, PICTURES/NAME.png shows the old labels, the
 * new ones, and in red the cells that went to another room. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw.h"
#include "golden.h"
#include "image.h"
#include "out.h"
#include "room_colors.h"

/* The crop and a margin of cells around it; pixels a cell. */
enum { SCALE = 3, PANELS = 3, MARGIN = 3 };

static const color WALL = {60, 60, 70};
static const color UNKNOWN = {225, 228, 232};
static const color NO_ROOM = {255, 255, 255};
static const color CHANGED = {220, 30, 30};

/* Shared cells of each pair: shared[new label * old_count + old label]. */
static uint32_t *count_shared(const golden_run *run, const uint16_t *old, size_t cells,
                              size_t old_count)
{
    uint32_t *shared = calloc((run->result.room_count + 1u) * old_count, sizeof *shared);
    for (size_t i = 0; shared != NULL && i < cells; i++) {
        shared[run->labels[i] * old_count + old[i]]++;
    }
    return shared;
}

/* The old room that each new one continues, 0 for none: both share more cells with each other
 * than with any other room. Numbers change with every area; the colours should not. */
static uint16_t *match_rooms(const golden_run *run, const uint16_t *old, size_t cells)
{
    size_t new_count = run->result.room_count + 1u;
    size_t old_count = 1;
    for (size_t i = 0; i < cells; i++) {
        old_count = old[i] >= old_count ? old[i] + 1u : old_count;
    }
    uint16_t *match = calloc(new_count, sizeof *match);
    uint32_t *shared = count_shared(run, old, cells, old_count);
    for (size_t label = 1; match != NULL && shared != NULL && label < new_count; label++) {
        size_t best = 0;
        for (size_t k = 1; k < old_count; k++) {
            uint32_t most = best == 0 ? 0 : shared[label * old_count + best];
            best = shared[label * old_count + k] > most ? k : best;
        }
        match[label] = (uint16_t)best;
        for (size_t other = 1; other < new_count; other++) {
            if (shared[other * old_count + best] > shared[label * old_count + best]) {
                match[label] = 0;
            }
        }
    }
    free(shared);
    return match;
}

static color paint_of(uint8_t value, uint16_t label)
{
    if (label != 0) {
        return room_color((uint8_t)(label % ROOM_COLOR_COUNT));
    }
    return value >= 204 ? WALL : value > 51 ? UNKNOWN : NO_ROOM;
}

/* before: the old labels; match: from match_rooms. */
static void draw_panels(const golden_run *run, const uint16_t *before, const uint16_t *match,
                        canvas *c)
{
    const sim_map *m = &run->map;
    int pitch = SCALE * (int)(run->result.crop_width + 2 * MARGIN + 1);
    for (size_t i = 0; i < (size_t)m->width * m->height; i++) {
        int x = SCALE * ((int)(i % m->width) - run->result.crop_x + MARGIN);
        int y = SCALE * ((int)(i / m->width) - run->result.crop_y + MARGIN);
        if (x < 0 || x > pitch - 2 * SCALE) {
            continue;
        }
        uint16_t label = run->labels[i];
        uint16_t now = match[label] != 0 ? match[label] : label;
        bool changed = match[label] != before[i] || (label != 0 && match[label] == 0);
        draw_rectangle(c, x, y, SCALE, SCALE, paint_of(m->cells[i], before[i]));
        draw_rectangle(c, x + pitch, y, SCALE, SCALE, paint_of(m->cells[i], now));
        draw_rectangle(c, x + 2 * pitch, y, SCALE, SCALE,
                       changed ? CHANGED : paint_of(m->cells[i], 0));
    }
}

static int write_canvas(const canvas *c, const char *path)
{
    tool_error error;
    out_file file;
    if (out_open(&file, path, &error) == 0) {
        image_write_png(file.stream, c->rgb, c->width, c->height, 3);
        if (out_commit(&file, &error) == 0) {
            return 0;
        }
    }
    fprintf(stderr, "%s\n", error.text);
    return -1;
}

/* old: NULL when there was none of this size. */
static int draw(const golden_run *run, const uint16_t *old, const char *path)
{
    const sim_map *m = &run->map;
    size_t cells = (size_t)m->width * m->height;
    uint16_t *none = calloc(cells, sizeof *none);
    const uint16_t *before = old != NULL ? old : none;
    uint16_t *match = before != NULL ? match_rooms(run, before, cells) : NULL;
    uint32_t width = run->result.crop_width + 2u * MARGIN;
    uint32_t height = run->result.crop_height + 2u * MARGIN;
    canvas c = {NULL, 0, 0};
    int rc = -1;
    if (match != NULL &&
        canvas_create(&c, PANELS * SCALE * (width + 1), SCALE * height, NO_ROOM) == 0) {
        draw_panels(run, before, match, &c);
        rc = write_canvas(&c, path);
    }
    canvas_free(&c);
    free(match);
    free(none);
    return rc;
}

/* The labels in the text as it was, NULL when it held none of this size; to be freed. */
static uint16_t *read_old(const char *path, const golden_run *run)
{
    uint16_t *labels = calloc((size_t)run->map.width * run->map.height, sizeof *labels);
    FILE *stream = fopen(path, "r");
    int rc = -1;
    if (stream != NULL) {
        rc = labels == NULL ? -1
                            : golden_read_labels(stream, run->map.width, run->map.height, labels);
        fclose(stream);
    }
    if (rc != 0) {
        free(labels);
        labels = NULL;
    }
    return labels;
}

static int same_file(const char *path, const golden_map *golden, const golden_run *run)
{
    FILE *old = fopen(path, "r");
    FILE *fresh = tmpfile();
    int same = old != NULL && fresh != NULL;
    if (same) {
        golden_write(golden, run, fresh);
        rewind(fresh);
        int a, b;
        do {
            a = fgetc(old);
            b = fgetc(fresh);
        } while (a == b && a != EOF);
        same = a == b;
    }
    if (old != NULL) {
        fclose(old);
    }
    if (fresh != NULL) {
        fclose(fresh);
    }
    return same;
}

static int update(const golden_map *golden, const char *folder, const char *pictures)
{
    char path[1000], picture[1000];
    snprintf(path, sizeof path, "%s/%s.txt", folder, golden->name);
    snprintf(picture, sizeof picture, "%s/%s.png", pictures, golden->name);
    golden_run run;
    if (golden_make(golden, &run) != 0) {
        return -1;
    }
    int rc = 0;
    if (same_file(path, golden, &run)) {
        printf("%s: unchanged\n", golden->name);
    } else {
        uint16_t *old = read_old(path, &run);
        tool_error error;
        out_file file;
        rc = draw(&run, old, picture);
        if (rc == 0 && (rc = out_open(&file, path, &error)) == 0) {
            golden_write(golden, &run, file.stream);
            rc = out_commit(&file, &error);
        }
        if (rc == 0) {
            printf("%s: written anew; old, new, difference: %s\n", golden->name, picture);
        } else {
            fprintf(stderr, "%s: not written\n", path);
        }
        free(old);
    }
    golden_free(&run);
    return rc;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fputs("usage: update_golden FOLDER PICTURES\n", stderr);
        return 2;
    }
    tool_error error;
    if (out_make_folder(argv[2], &error) != 0) {
        fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    int failures = 0;
    for (int i = 0; i < GOLDEN_COUNT; i++) {
        golden_map golden = golden_map_at(i);
        failures += update(&golden, argv[1], argv[2]) != 0;
    }
    return failures > 0;
}
