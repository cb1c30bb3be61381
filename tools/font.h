/* Shapes of the few characters that pictures need, as strokes of a pen. */
#ifndef ROOMSEG_TOOLS_FONT_H
#define ROOMSEG_TOOLS_FONT_H

/* Height of a digit and space between two characters, in font units. */
#define FONT_HEIGHT 12
#define FONT_GAP 4

/* Called for each straight piece of a stroke, from (x0, y0) to (x1, y1) in font units:
 * x to the right from the character's left edge, y down from the top of the digits. */
typedef void (*font_line_fn)(void *user, double x0, double y0, double x1, double y1);

/* Width of a character in font units; 0 when there is no shape for it. There are digits,
 * small letters, space, '.', '-', '_' and '^', which stands for a raised 2 as in m2. */
int font_width(char c);

/* Draws a character by its pieces; nothing when there is no shape for it. */
void font_draw(char c, font_line_fn line, void *user);

#endif
