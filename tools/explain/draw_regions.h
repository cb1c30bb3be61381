/* Regions in pastel, for the pictures that draw on top of them. */
#ifndef ROOMSEG_EXPLAIN_DRAW_REGIONS_H
#define ROOMSEG_EXPLAIN_DRAW_REGIONS_H

#include "colors.h"
#include "explanation.h"

#define REGION_PALE 0.55 /* share of white in regions under a drawing */

typedef struct region_paint {
    const explanation *e;
    int labels;          /* LABELS_REGIONS or LABELS_SEEDS */
    uint8_t *index;      /* a pastel for each label; owned */
    double pale;         /* share of white in it */
} region_paint;

/* Chooses pastels that tell neighbours apart. Returns 0, or -1 when memory runs out. */
int region_paint_make(const explanation *e, int labels, region_paint *out);

void region_paint_free(region_paint *p);

/* The regions as the watershed left them; user: a region_paint. Lines are dark. */
color region_color(const void *user, uint32_t x, uint32_t y);

/* Regions in the colours of the rooms that they became, with a seam where regions were joined;
 * gray where a region became no room. user: a region_paint made by merged_paint_make. */
color merged_color(const void *user, uint32_t x, uint32_t y);
int merged_paint_make(const explanation *e, region_paint *out);

/* 1 when the label is one of a region, neither 0 nor a line nor background. */
int is_region(const observation *o, uint16_t label);

#endif
