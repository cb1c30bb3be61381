/* The paper profile from the seed maps to the rooms. */
#include <inttypes.h>
#include <stdio.h>

#include "facts.h"
#include "page.h"
#include "profile_paper.h"
#include "seed_map.h"
#include "tell.h"
#include "watershed_lines.h"

static double sigma_mm(int scale) {
    return RS_SIGMA_START_MM + (scale - 1) * (double)RS_SIGMA_STEP_MM;
}

static void tell_seed_maps(const explanation *e, FILE *page) {
    page_figures_begin(page, 4);
    for (int i = 0; i < seed_map_count(&e->o); i++) {
        char name[24];
        int scale = seed_map_scale(&e->o, i);
        snprintf(name, sizeof name, "seed_map_%d", i + 1);
        if (page_figure_begin(page, &e->album, name, "Seed map of one scale")) {
            fprintf(page, "Scale %d: &#963; = %.0f mm, %.3g cells", scale, sigma_mm(scale),
                    sigma_mm(scale) / cell_mm(e));
            page_figure_end(page);
        }
    }
    page_figures_end(page);
}

static void tell_lifetime(const explanation *e, FILE *page, int *section) {
    int last = (int)plane_most(&e->o, PLANE_LIFETIME); /* 1 also when there is no seed */
    page_section(page, section, "Seeds at many scales");
    fprintf(page, "<p>The obstacles are grown, which closes doors, and then blurred more and more. "
                  "A cell belongs to the seed map of a scale while the blur leaves it hardly any "
                  "share of obstacles. Seeds shrink, divide at narrows, and die out, the largest "
                  "hall last: here at scale %d, &#963; = %.2f m.</p>\n",
            last, sigma_mm(last) / 1000.0);
    page_parameters_begin(page);
    page_length(page, "dilation_mm", e->config.dilation_mm, cell_mm(e));
    page_parameter(page, "seed_obstacle_permille", e->config.seed_obstacle_permille, " / 1000");
    page_length(page, "sigma, first scale", RS_SIGMA_START_MM, cell_mm(e));
    page_length(page, "sigma, step", RS_SIGMA_STEP_MM, cell_mm(e));
    page_parameters_end(page);
    tell_seed_maps(e, page);
    fputs("<p>No seed map is stored. One byte a cell is enough: the last scale at which it is in "
          "a seed map, its lifetime. The maps above are drawn from it.</p>\n",
          page);
    page_figures_begin(page, 1);
    if (page_figure_begin(page, &e->album, "lifetime", "Lifetime of each cell")) {
        fputs("Lifetime: ", page);
        page_swatch(page, paint_heat(1.0 / last));
        fputs("1 scale to ", page);
        page_swatch(page, paint_heat(1));
        fprintf(page, "%d. White: free, but in no seed map.", last);
        page_figure_end(page);
    }
    page_figures_end(page);
}

static void tell_seeds(const explanation *e, FILE *page, int *section) {
    page_section(page, section, "Leaf seeds, superposed");
    fprintf(page, "<p>Seeds that divide are the parents of those that they divide into. Those that "
                  "never divide again are the leaves, %" PRIu32 " of them: each is put down with "
                  "the shape that it had at its birth, the scale at which it came off its "
                  "neighbours. The grown obstacles, shrunk again by %u mm, are the seed of the "
                  "background.</p>\n",
            e->o.before.region_count, RS_BACKGROUND_EROSION_MM);
    page_figures_begin(page, 1);
    if (page_figure_begin(page, &e->album, "seeds", "Leaf seeds and background seed")) {
        fputs("Leaf seeds, each in a colour, and ", page);
        page_swatch(page, PAINT_QUIET);
        page_swatch(page, PAINT_BACKGROUND);
        fprintf(page, "the background&#8217;s: obstacles, and free cells beside them (%.1f "
                      "m&#178; in all).",
                area_m2(e, count_label(&e->o, LABELS_SEEDS, RS_BACKGROUND)));
        page_figure_end(page);
    }
    page_figures_end(page);
}

static void tell_flood(const explanation *e, FILE *page, int *section) {
    page_section(page, section, "Over-segmentation along ridges");
    fprintf(page, "<p>Where are the narrows? A ridge filter (Meijering; Gaussian of %u mm, %.3g "
                  "cells) on the obstacle map is high close to obstacles, and so all across "
                  "a door. The ridge map is flooded from the seeds and the background, lowest "
                  "cells first. Where two basins meet, a line of one cell stays, and what the "
                  "background takes beside walls is lost.</p>\n",
            RS_RIDGE_SIGMA_MM, (double)RS_RIDGE_SIGMA_MM / cell_mm(e));
    page_figures_begin(page, 2);
    if (page_figure_begin(page, &e->album, "ridge", "Ridge map")) {
        page_swatch(page, paint_ridge(0));
        fputs("no ridge to ", page);
        page_swatch(page, paint_ridge(1));
        fputs("the highest; ", page);
        page_swatch(page, PAINT_BACKGROUND);
        fputs("obstacles.", page);
        page_figure_end(page);
    }
    if (page_figure_begin(page, &e->album, "regions", "Regions of the watershed")) {
        fprintf(page, "%" PRIu32 " region%s; ", e->o.before.region_count,
                plural(e->o.before.region_count));
        page_swatch(page, PAINT_INK);
        fprintf(page, "%" PRIu64 " cells of lines between basins; ",
                count_label(&e->o, LABELS_REGIONS, RS_LINE));
        page_swatch(page, PAINT_BACKGROUND);
        fputs("free, but taken by the background.", page);
        page_figure_end(page);
    }
    page_figures_end(page);
}

static void tell_merging(const explanation *e, FILE *page, int *section) {
    edge_counts n = count_edges_of(e);
    const roomseg_config *c = &e->config;
    page_section(page, section, "The connectivity graph, and what joins it");
    fprintf(page, "<p>Regions are the nodes, and %" PRIu32 " shared border%s the edges. Three "
                  "rules make rooms of them. A region without neighbour goes when it is smaller "
                  "than A<sub>0</sub>, or than its share of the whole. One smaller than "
                  "A<sub>0</sub> joins the neighbour with which it shares the longest border; "
                  "those with the fewest neighbours come first. Then regions join whose border is "
                  "longer than L<sub>0</sub>, which no door is: %" PRIu32 " at the start, the "
                  "longest first.</p>\n",
            n.touching, plural(n.touching), n.long_border);
    page_parameters_begin(page);
    page_area(page, "smallest_room_mm2 (A0)", c->smallest_room_mm2, cell_mm(e));
    page_parameter(page, "isolated_permille", c->isolated_permille, " / 1000");
    page_length(page, "longest_border_mm (L0)", c->longest_border_mm, cell_mm(e));
    page_parameters_end(page);
    page_figures_begin(page, 2);
    if (page_figure_begin(page, &e->album, "graph_before", "The graph before merging")) {
        fprintf(page, "Before: %" PRIu32 " region%s. Dots: the larger the more area. Strokes: "
                      "shared borders, the thicker the longer; ",
                e->fates.regions, plural(e->fates.regions));
        page_swatch(page, PAINT_SIGNAL);
        fputs("longer than L<sub>0</sub>, ", page);
        page_swatch(page, PAINT_SECOND);
        fputs("shorter.", page);
        page_figure_end(page);
    }
    if (page_figure_begin(page, &e->album, "graph_after", "The graph after merging")) {
        fprintf(page, "After: %" PRIu32 " room%s; %" PRIu32 " isolated region%s (%.1f m&#178;) "
                      "dropped.",
                e->fates.roots[FATE_ROOM], plural(e->fates.roots[FATE_ROOM]),
                e->fates.roots[FATE_ALONE], plural(e->fates.roots[FATE_ALONE]),
                area_m2(e, e->fates.cells[FATE_ALONE]));
        page_figure_end(page);
    }
    page_figures_end(page);
}

void tell_paper(const explanation *e, FILE *page, int *section) {
    tell_lifetime(e, page, section);
    tell_seeds(e, page, section);
    tell_flood(e, page, section);
    tell_merging(e, page, section);
}
