#include "font.h"

#include <stddef.h>

/* strokes: points as two letters each, x then y, 'a' = 0. Strokes are separated by a
 * blank. A stroke that begins with '~' is a quadratic B-spline, which begins and ends at
 * its end points and keeps within the corners that the others span. */
typedef struct glyph {
    char character;
    int width;
    const char *strokes;
} glyph;

static const glyph glyphs[] = {
    {'0', 8, "~eaiaimamaaea"},
    {'1', 5, "adeaem"},
    {'2', 8, "~adaaiaifgham amim"},
    {'3', 8, "~abaaiaigdf ~dfigimamak"},
    {'4', 8, "gmgaaiii"},
    {'5', 8, "haabag ~agceieimamak"},
    {'6', 8, "~habaamimieaeai"},
    {'7', 8, "aaiacm"},
    {'8', 8, "~efafaaiaifef ~efafamimifef"},
    {'9', 8, "~bmhmiaaaaiiiie"},
    {' ', 3, ""},
    {'.', 1, "alam"},
    {'-', 5, "ahfh"},
    {'_', 8, "aoio"},
    {'a', 8, "ifim ~ihifafamimik"},
    {'b', 8, "aaam ~ahafifimamak"},
    {'c', 8, "~ihifafamimik"},
    {'d', 8, "iaim ~ihifafamimik"},
    {'e', 8, "ajij ~ijifafamimil"},
    {'f', 6, "~gacacecm afff"},
    {'g', 8, "~ihifafamimik ~ifiqaqap"},
    {'h', 7, "aaam ~ahafhfhihm"},
    {'i', 1, "afam acac"},
    {'j', 3, "~dfdqaq dcdc"},
    {'k', 7, "aaam hfaj cihm"},
    {'l', 1, "aaam"},
    {'m', 12, "afam ~ahafgfgigm ~ghgfmfmimm"},
    {'n', 7, "afam ~ahafhfhihm"},
    {'o', 8, "~efafamimifef"},
    {'p', 8, "afaq ~ahafifimamak"},
    {'q', 8, "ifiq ~ihifafamimik"},
    {'r', 5, "afam ~aiafcfff"},
    {'s', 7, "~hghfafajhihmamal"},
    {'t', 6, "~cbcmgm afgf"},
    {'u', 7, "hfhm ~afamhmhj"},
    {'v', 8, "afemif"},
    {'w', 12, "afdmggjmmf"},
    {'x', 7, "afhm hfam"},
    {'y', 8, "afem ifcq"},
    {'z', 7, "afhfamhm"},
    {'^', 5, "~abaaeaedag agfg"},
};

#define GLYPH_COUNT (sizeof glyphs / sizeof glyphs[0])

static const glyph *find_glyph(char c) {
    for (size_t i = 0; i < GLYPH_COUNT; i++) {
        if (glyphs[i].character == c) {
            return &glyphs[i];
        }
    }
    return NULL;
}

typedef struct point {
    double x, y;
} point;

static point point_at(const char *stroke, int i) {
    point p = {stroke[2 * i] - 'a', stroke[2 * i + 1] - 'a'};
    return p;
}

static point middle(point a, point b) {
    point p = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    return p;
}

/* A quadratic Bezier curve from a to c with the control point b. */
static void draw_curve(point a, point b, point c, font_line_fn line, void *user) {
    enum { PIECES = 8 };
    point last = a;
    for (int i = 1; i <= PIECES; i++) {
        double t = (double)i / PIECES;
        double u = 1 - t;
        point next = {u * u * a.x + 2 * u * t * b.x + t * t * c.x,
                      u * u * a.y + 2 * u * t * b.y + t * t * c.y};
        line(user, last.x, last.y, next.x, next.y);
        last = next;
    }
}

static void draw_stroke(const char *stroke, int count, int curved, font_line_fn line,
                        void *user) {
    point from = point_at(stroke, 0);
    for (int i = 1; i < count; i++) {
        point to = point_at(stroke, i);
        if (curved && i + 1 < count) {
            point next = point_at(stroke, i + 1);
            point end = i + 2 < count ? middle(to, next) : next;
            draw_curve(from, to, end, line, user);
            from = end;
        } else if (!curved) {
            line(user, from.x, from.y, to.x, to.y);
            from = to;
        }
    }
}

int font_width(char c) {
    const glyph *g = find_glyph(c);
    return g != NULL ? g->width : 0;
}

void font_draw(char c, font_line_fn line, void *user) {
    const glyph *g = find_glyph(c);
    for (const char *at = g != NULL ? g->strokes : ""; *at != '\0';) {
        int curved = *at == '~';
        at += curved;
        int length = 0;
        while (at[length] != '\0' && at[length] != ' ') {
            length++;
        }
        draw_stroke(at, length / 2, curved, line, user);
        at += length + (at[length] == ' ');
    }
}
