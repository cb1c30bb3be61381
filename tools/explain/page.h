/* A page of HTML that needs no other file: pictures are inside of it, and nothing runs. */
#ifndef ROOMSEG_EXPLAIN_PAGE_H
#define ROOMSEG_EXPLAIN_PAGE_H

#include <stdio.h>

#include "album.h"
#include "draw.h"

/* Everything up to the text; and what closes the page. title: any text. */
void page_begin(FILE *page, const char *title);
void page_end(FILE *page);

/* A text as HTML shows it: nothing in it is markup. Bytes that are no UTF-8 become U+FFFD. */
void page_text(FILE *page, const char *text);

/* A heading with the next number of *count. */
void page_section(FILE *page, int *count, const char *title);

/* Figures side by side where there is space, at most so many (1, 2, 4 or 5). */
void page_figures_begin(FILE *page, int columns);
void page_figures_end(FILE *page);

/* A figure of the album; what is written next is its caption, HTML. alt: says in plain words
 * what is shown. Returns 0, and writes nothing, when the album does not have it. */
int page_figure_begin(FILE *page, const album *a, const char *name, const char *alt);
void page_figure_end(FILE *page);

/* The same with a caption that is ready. */
void page_figure(FILE *page, const album *a, const char *name, const char *alt,
                 const char *caption);

/* A picture alone. alt: as above. */
void page_image(FILE *page, const encoded_png *png, const char *alt);

/* The pipeline: a box for each step with thumbnail and title. */
void page_pipeline_begin(FILE *page);
void page_pipeline_box(FILE *page, const album *a, const char *name, const char *title);
void page_pipeline_end(FILE *page);

/* A table of parameters: field of roomseg_config, value in force, what it is in cells. */
void page_parameters_begin(FILE *page);
void page_parameters_end(FILE *page);
void page_parameter(FILE *page, const char *field, double value, const char *unit);
void page_length(FILE *page, const char *field, double mm, double cell_mm);
void page_area(FILE *page, const char *field, double mm2, double cell_mm);

/* A coloured square, for legends. */
void page_swatch(FILE *page, color paint);

#endif
