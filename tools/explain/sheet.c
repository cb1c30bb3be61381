#define _POSIX_C_SOURCE 200809L

#include "sheet.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "colors.h"
#include "files.h"
#include "out.h"
#include "page.h"
#include "sheet_row.h"

/* The picture of a set [px]: a title row, and for each map its name above its pictures. */
enum { GAP = 16, TITLE = 56, NAME = 44, NOTE = 34, COLUMN_PX = SHEET_CELL_WIDTH + GAP };

#define TEXT_PX 17.0
#define TEXT_RADIUS 1.1
#define NAME_MAX 60

static const char *const titles[SHEET_COLUMNS] = {"map", "truth", "default", "paper",
                                                  "reference"};

typedef struct sheet {
    const sheet_request *q;
    album album;
    FILE *page;
    size_t maps;
    tool_error *error;
} sheet;

/* FOLDER/SET/NAME + ending when there is such a file; NULL else, or when memory runs out. */
static char *existing(const char *folder, const char *set, const char *name, size_t length,
                      const char *ending) {
    struct stat info;
    size_t size = strlen(folder) + strlen(set) + length + strlen(ending) + 3;
    char *path = malloc(size);
    if (path != NULL) {
        snprintf(path, size, "%s/%s/%.*s%s", folder, set, (int)length, name, ending);
        if (stat(path, &info) == 0 && S_ISREG(info.st_mode)) {
            return path;
        }
    }
    free(path);
    return NULL;
}

static char *find_reference(const char *folder, const char *set, const char *name) {
    size_t lengths[2] = {strlen(name), strspn(name, "0123456789")};
    for (int i = 0; folder != NULL && i < 2; i++) {
        char *path = NULL;
        if (lengths[i] > 0) {
            path = existing(folder, set, name, lengths[i], ".pgm");
            path = path != NULL ? path : existing(folder, set, name, lengths[i], ".png");
        }
        if (path != NULL) {
            return path;
        }
    }
    return NULL;
}

/* Text from x on, in the small letters that pictures have. */
static void write_text(canvas *c, int x, int y, const char *text, color paint) {
    char small[NAME_MAX + 1];
    size_t length = 0;
    for (; text[length] != '\0' && length < NAME_MAX; length++) {
        small[length] = (char)tolower((unsigned char)text[length]);
    }
    small[length] = '\0';
    draw_text(c, x + text_width(small, TEXT_PX) / 2, y, small, TEXT_PX, TEXT_RADIUS, paint);
}

static void copy_picture(canvas *to, const canvas *from, int left, int top) {
    for (uint32_t y = 0; y < from->height; y++) {
        memcpy(to->rgb + (((size_t)top + y) * to->width + (size_t)left) * 3,
               from->rgb + (size_t)y * from->width * 3, (size_t)from->width * 3);
    }
}

static void describe(const sheet_cell *cell, char *text, size_t size) {
    text[0] = '\0';
    if (cell->has_score) {
        snprintf(text, size, "v %.1f   %u rooms", 100 * cell->v, (unsigned)cell->rooms);
    } else if (cell->has_rooms) {
        snprintf(text, size, "%u rooms", (unsigned)cell->rooms);
    }
}

/* Height of a row: that of its tallest picture, and the texts. */
static int height_of(const sheet_row *row) {
    uint32_t tallest = 0;
    for (int column = 0; column < SHEET_COLUMNS; column++) {
        uint32_t height = row->cells[column].picture.height;
        tallest = height > tallest ? height : tallest;
    }
    return NAME + (int)tallest + NOTE + GAP;
}

/* Where a column begins; -1 when no map has it. */
static int left_of(const sheet_row *rows, size_t count, int column) {
    int left = GAP;
    for (int before = 0; before <= column; before++) {
        int used = 0;
        for (size_t i = 0; i < count; i++) {
            used |= rows[i].cells[before].picture.rgb != NULL;
        }
        if (before == column) {
            return used ? left : -1;
        }
        left += used ? COLUMN_PX : 0;
    }
    return -1;
}

static void put_row(canvas *c, const sheet_row *row, int column, int left, int top) {
    const sheet_cell *cell = &row->cells[column];
    char note[40];
    if (cell->picture.rgb != NULL) {
        copy_picture(c, &cell->picture, left, top + NAME);
        describe(cell, note, sizeof note);
        write_text(c, left, top + NAME + (int)cell->picture.height + NOTE / 2, note, PAINT_QUIET);
    }
}

/* The picture of a set. */
static int compose(const sheet_row *rows, size_t count, canvas *c) {
    int width = GAP, height = TITLE;
    for (int column = 0; column < SHEET_COLUMNS; column++) {
        width += left_of(rows, count, column) >= 0 ? COLUMN_PX : 0;
    }
    for (size_t i = 0; i < count; i++) {
        height += height_of(&rows[i]);
    }
    if (canvas_create(c, (uint32_t)width, (uint32_t)height, PAINT_FREE) != 0) {
        return -1;
    }
    for (int column = 0; column < SHEET_COLUMNS; column++) {
        int left = left_of(rows, count, column);
        int top = TITLE;
        for (size_t i = 0; left >= 0 && i < count; i++) {
            put_row(c, &rows[i], column, left, top);
            write_text(c, GAP, top + NAME / 2, column == 0 ? rows[i].name : "", PAINT_INK);
            top += height_of(&rows[i]);
        }
        write_text(c, left, TITLE / 2, left >= 0 ? titles[column] : "", PAINT_SIGNAL);
    }
    return 0;
}

static int tell_cell(FILE *page, const sheet_row *row, int column) {
    const sheet_cell *cell = &row->cells[column];
    encoded_png png;
    char note[40];
    if (cell->picture.rgb == NULL) {
        return 0;
    }
    int rc = png_encode(&cell->picture, &png);
    if (rc == 0) {
        fputs("<figure>", page);
        page_image(page, &png, titles[column]);
        describe(cell, note, sizeof note);
        fprintf(page, "\n<figcaption><b>%s</b> %s</figcaption></figure>\n", titles[column], note);
    }
    free(png.bytes);
    return rc;
}

static int tell_row(FILE *page, const sheet_row *row) {
    int rc = 0;
    fputs("<h3>", page);
    page_text(page, row->name);
    fputs("</h3>\n", page);
    page_figures_begin(page, SHEET_COLUMNS);
    for (int column = 0; column < SHEET_COLUMNS && rc == 0; column++) {
        rc = tell_cell(page, row, column);
    }
    page_figures_end(page);
    return rc;
}

static int add_row(sheet *s, const dataset_set *set, size_t i, sheet_row *row) {
    const sheet_request *q = s->q;
    char *reference = find_reference(q->reference, set->name, set->maps[i].name);
    int rc = sheet_row_make(&set->maps[i], reference, &q->options, &q->by_default, &q->by_paper,
                            row, s->error);
    free(reference);
    if (rc == 0 && tell_row(s->page, row) != 0) {
        tool_error_set(s->error, "%s: out of memory", set->maps[i].map);
        rc = -1;
    }
    s->maps++;
    return rc;
}

static int add_picture(sheet *s, const char *name, const sheet_row *rows, size_t count) {
    canvas c;
    if (compose(rows, count, &c) != 0 || album_add(&s->album, name, &c) != 0) {
        tool_error_set(s->error, "%s: out of memory", s->q->dataset);
        return -1;
    }
    return 0;
}

static int add_set(sheet *s, const dataset_set *set) {
    sheet_row *rows = calloc(set->count, sizeof *rows);
    int rc = 0;
    if (rows == NULL) {
        tool_error_set(s->error, "%s: out of memory", s->q->dataset);
        return -1;
    }
    fputs("<h2>", s->page);
    page_text(s->page, set->name);
    fputs("</h2>\n", s->page);
    for (size_t i = 0; i < set->count && rc == 0; i++) {
        rc = add_row(s, set, i, &rows[i]);
    }
    rc = rc == 0 ? add_picture(s, set->name, rows, set->count) : rc;
    for (size_t i = 0; i < set->count; i++) {
        sheet_row_free(&rows[i]);
    }
    free(rows);
    return rc;
}

static void tell_introduction(const sheet *s) {
    page_begin(s->page, "Maps and their rooms");
    fputs("<p>Each map with its rooms. A room has the colour of the true room with which it shares "
          "most cells, without a truth that of the default profile&#8217;s; dark seams separate "
          "rooms. So a true room that was cut in pieces shows as seams within one colour, rooms "
          "run together as a colour that is missing. <i>v</i>: V-measure in percent, as "
          "<code>roomseg bench</code> has it.</p>\n",
          s->page);
}

static int add_sets(sheet *s, const dataset *data) {
    tell_introduction(s);
    for (size_t i = 0; i < data->count; i++) {
        const dataset_set *set = &data->sets[i];
        if ((s->q->set == NULL || strcmp(s->q->set, set->name) == 0) && add_set(s, set) != 0) {
            return -1;
        }
    }
    page_end(s->page);
    if (s->maps == 0) {
        tool_error_set(s->error, "%s: has no set '%s'", s->q->dataset, s->q->set);
        return -1;
    }
    return 0;
}

int sheet_write(const sheet_request *q, const char *folder, size_t *maps, tool_error *error) {
    sheet s = {q, {NULL, 0}, NULL, 0, error};
    char *page = NULL;
    size_t size = 0;
    dataset data;
    if (dataset_open(q->dataset, &data, error) != 0) {
        return -1;
    }
    int rc = -1;
    s.page = open_memstream(&page, &size);
    if (s.page == NULL) {
        tool_error_set(error, "%s: out of memory", q->dataset);
    } else {
        rc = add_sets(&s, &data);
        int whole = !ferror(s.page);
        if ((fclose(s.page) != 0 || !whole) && rc == 0) {
            tool_error_set(error, "%s: out of memory", q->dataset);
            rc = -1;
        }
    }
    if (rc == 0) {
        rc = files_write(folder, &s.album, "sheet.html", page, size, error);
    }
    *maps = s.maps;
    free(page);
    album_free(&s.album);
    dataset_free(&data);
    return rc;
}
