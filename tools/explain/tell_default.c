/* The default profile from the distance map to the rooms. */
#include <inttypes.h>

#include "distance.h"
#include "facts.h"
#include "page.h"
#include "tell.h"

static void tell_distance(const explanation *e, FILE *page, int *section) {
    double deepest_m = plane_most(&e->o, PLANE_DISTANCE) * RS_DISTANCE_UNIT_MM / 1000.0;
    page_section(page, section, "How deep inside is each cell?");
    fputs("<p>Each free cell gets its distance to the nearest obstacle. In the middle of a room it "
          "is large, in a door half the door&#8217;s width: rooms become hills, and doors the "
          "saddles between them.</p>\n",
          page);
    page_figures_begin(page, 1);
    if (page_figure_begin(page, &e->album, "distance", "Distance to the nearest obstacle")) {
        page_swatch(page, paint_heat(0));
        fputs("0 m to ", page);
        page_swatch(page, paint_heat(1));
        fprintf(page, "%.2f m, in steps of %u mm.", deepest_m, RS_DISTANCE_UNIT_MM);
        page_figure_end(page);
    }
    page_figures_end(page);
}

static void tell_watershed(const explanation *e, FILE *page, int *section) {
    page_section(page, section, "One region for each hilltop");
    fprintf(page, "<p>The distance map is flooded from above: each peak founds a region, and the "
                  "cells, highest first, join the region that reaches them first. That cuts at "
                  "every narrowing, far too often: %" PRIu32 " regions touch each other here. "
                  "What follows is the choice of the cuts that are to stay. Besides there "
                  "are %" PRIu32 " islands that touch nothing, most of them a few free cells "
                  "behind a wall; together that takes %" PRIu32 " of the %" PRIu32 " regions that "
                  "<code>max_regions</code> leaves room for.</p>\n",
            e->fates.regions - e->fates.islands, e->fates.islands, e->o.before.region_count,
            e->o.s.config.max_regions);
    page_figures_begin(page, 1);
    page_figure(page, &e->album, "regions", "Regions of the watershed",
                "The regions, each with a dot on its peak.");
    page_figures_end(page);
}

static void tell_walls_between(const explanation *e, FILE *page, int *section) {
    edge_counts n = count_edges_of(e);
    page_section(page, section, "Which regions share a wall?");
    fprintf(page, "<p>A wall between two regions tells more than the width of the opening beside "
                  "it. Rows and columns that cross an obstacle of at most %u mm from one region "
                  "into another are counted: they are the length of the wall that the two share. "
                  "%" PRIu32 " pair%s of regions share%s a wall, %" PRIu32 " of them so long that "
                  "they are two rooms whatever the opening.</p>\n",
            RS_GRAPH_WALL_MM, n.walled, plural(n.walled), n.walled == 1 ? "s" : "",
            n.long_walled);
    page_parameters_begin(page);
    page_length(page, "shared_wall_mm", e->config.shared_wall_mm, cell_mm(e));
    page_parameters_end(page);
    page_figures_begin(page, 1);
    if (page_figure_begin(page, &e->album, "shared_walls", "Walls between regions")) {
        page_swatch(page, PAINT_SIGNAL);
        fputs("walls that keep two regions apart, ", page);
        page_swatch(page, PAINT_SECOND);
        fputs("walls that are shorter, by themselves.", page);
        page_figure_end(page);
    }
    page_figures_end(page);
}

/* What the rules say, by join_rule; the number of edges follows. */
static const char *const rule_texts[JOIN_COUNT] = {
    "They stay apart.",
    "The opening is wide in proportion to the two regions: at least "
    "<code>room_opening_percent</code> of their own width, or 72 % when there is no wall between "
    "them.",
    "Both are passages, with <code>passage_min_neighbours</code> neighbours or more, and the "
    "opening is at least <code>passage_opening_percent</code> of their width.",
    "One is smaller than <code>niche_mm2</code> and open on nine tenths of its own width.",
    "The floor is cluttered (<code>lived_in_permille</code>), and either they share no wall and the "
    "opening is at least <code>open_plan_percent</code> of their width, or their border is longer "
    "than <code>door_mm</code> and than twice the wall they share.",
    "The floor is cluttered, and both together are still as narrow as a hall, "
    "<code>hall_mm</code>.",
    "One is smaller than <code>smallest_room_mm2</code>: it joins the neighbour with the widest "
    "opening.",
};

static void tell_rule_table(const explanation *e, FILE *page) {
    edge_counts n = count_edges_of(e);
    fputs("<table><tr><th>Two regions become one when</th><th class=\"number\">Pairs</th></tr>\n",
          page);
    for (int rule = JOIN_ROOM; rule < JOIN_COUNT; rule++) {
        fputs("<tr><td>", page);
        page_swatch(page, rule_paint(rule));
        fprintf(page, "%s</td><td class=\"number\">%" PRIu32 "</td></tr>\n", rule_texts[rule],
                n.by_rule[rule]);
    }
    fputs("<tr><td>", page);
    page_swatch(page, rule_paint(JOIN_NONE));
    fprintf(page, "%s</td><td class=\"number\">%" PRIu32 "</td></tr>\n</table>\n",
            rule_texts[JOIN_NONE], n.by_rule[JOIN_NONE]);
}

static void tell_graph(const explanation *e, FILE *page, int *section) {
    edge_counts n = count_edges_of(e);
    const roomseg_config *c = &e->config;
    page_section(page, section, "The region graph, and what joins it");
    fprintf(page, "<p>The regions become the nodes of a graph and their %" PRIu32 " opening%s its "
                  "edges. Widths are measured on the distance map: of a region at its peak, of an "
                  "opening at its widest place. The best edge is joined first, and again, until no "
                  "rule applies; two regions that share a long wall never join. The table tells "
                  "which rule it took: the rules are switched on one after the other in this "
                  "order, and a pair counts for the first with which it ends in one room.</p>\n",
            n.touching, plural(n.touching));
    page_parameters_begin(page);
    page_parameter(page, "room_opening_percent", c->room_opening_percent, " %");
    page_parameter(page, "passage_opening_percent", c->passage_opening_percent, " %");
    page_parameter(page, "passage_min_neighbours", c->passage_min_neighbours, "");
    page_area(page, "niche_mm2", c->niche_mm2, cell_mm(e));
    page_parameter(page, "lived_in_permille", c->lived_in_permille, " &permil;");
    page_parameter(page, "open_plan_percent", c->open_plan_percent, " %");
    page_length(page, "door_mm", c->door_mm, cell_mm(e));
    page_length(page, "hall_mm", c->hall_mm, cell_mm(e));
    page_area(page, "smallest_room_mm2", c->smallest_room_mm2, cell_mm(e));
    page_parameters_end(page);
    tell_rule_table(e, page);
    page_figures_begin(page, 2);
    page_figure(page, &e->album, "graph", "The region graph over the regions",
                "Dots: regions, the larger the more area. Strokes: openings, the thicker the "
                "wider, in the colour of the rule that joins them.");
    if (page_figure_begin(page, &e->album, "merged", "Merged regions")) {
        uint32_t roots = e->fates.roots[FATE_ROOM] + e->fates.roots[FATE_ALONE] +
                         e->fates.roots[FATE_UNWALLED];
        fprintf(page, "After merging: %" PRIu32 " regions are %" PRIu32 ", islands left aside. "
                      "Seams show where regions were joined; ",
                e->fates.regions - e->fates.islands, roots - e->fates.islands);
        page_swatch(page, PAINT_BACKGROUND);
        fputs("what will be dropped.", page);
        page_figure_end(page);
    }
    page_figures_end(page);
}

static void tell_dropped(const explanation *e, FILE *page, int *section) {
    const fates *f = &e->fates;
    page_section(page, section, "What is free, but no room");
    fputs("<p>A region that touches no other is dropped below "
          "<code>smallest_room_mm2</code> or <code>isolated_permille</code> of the free area, "
          "whichever is more. So is what was only seen through a window or an open door: fans of "
          "rays, whose border consists of walls by less than <code>unwalled_percent</code> of the "
          "share that walls have in the border of the whole map.</p>\n",
          page);
    page_parameters_begin(page);
    page_parameter(page, "isolated_permille", e->config.isolated_permille, " / 1000");
    page_parameter(page, "unwalled_percent", e->config.unwalled_percent, " %");
    page_parameters_end(page);
    page_figures_begin(page, 1);
    if (page_figure_begin(page, &e->album, "dropped", "Dropped regions")) {
        page_swatch(page, dropped_paint(FATE_ALONE));
        fprintf(page, "%" PRIu32 " dropped that touch%s nothing else (%.1f m&#178;), ",
                f->roots[FATE_ALONE], f->roots[FATE_ALONE] == 1 ? "es" : "",
                area_m2(e, f->cells[FATE_ALONE]));
        page_swatch(page, dropped_paint(FATE_UNWALLED));
        fprintf(page, "%" PRIu32 " with too little wall (%.1f m&#178;). %" PRIu32 " remain.",
                f->roots[FATE_UNWALLED], area_m2(e, f->cells[FATE_UNWALLED]),
                f->roots[FATE_ROOM]);
        page_figure_end(page);
    }
    page_figures_end(page);
}

void tell_default(const explanation *e, FILE *page, int *section) {
    tell_distance(e, page, section);
    tell_watershed(e, page, section);
    tell_walls_between(e, page, section);
    tell_graph(e, page, section);
    tell_dropped(e, page, section);
}
