/* The text of the page: what each step does and why, with the parameters in force and what
 * came out. */
#ifndef ROOMSEG_EXPLAIN_TELL_H
#define ROOMSEG_EXPLAIN_TELL_H

#include <stdio.h>

#include "explanation.h"

/* The whole page. Returns 0, or -1 when memory runs out; what the stream could not take shows
 * in its error flag. */
int tell_page(const explanation *e, FILE *page);

/* The part that is the profile's own; *section counts the headings. */
void tell_default(const explanation *e, FILE *page, int *section);
void tell_paper(const explanation *e, FILE *page, int *section);

/* Area of so many cells [m2]. */
double area_m2(const explanation *e, uint64_t cells);

/* "s" unless it is one of them. */
const char *plural(uint64_t count);

#endif
