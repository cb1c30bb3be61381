/* The page, with what both profiles share: beginning, walls, threshold, result. */
#include <inttypes.h>
#include <stddef.h>
#include <string.h>

#include "align.h"
#include "facts.h"
#include "page.h"
#include "tell.h"

double area_m2(const explanation *e, uint64_t cells) {
    double side_m = cell_mm(e) / 1000.0;
    return (double)cells * side_m * side_m;
}

const char *plural(uint64_t count) {
    return count == 1 ? "" : "s";
}

typedef struct box {
    const char *figure, *title;
} box;

static void tell_pipeline(const explanation *e, FILE *page) {
    const char *turned = e->is_turned ? "Map turned"
                         : e->config.align != NULL ? "Aligned already: not turned"
                                                   : "Map turned (off in this run)";
    const box by_default[] = {
        {"map", "Occupancy grid"},
        {"lines", "Direction of the walls"},
        {"turned", turned},
        {"threshold", "Free space"},
        {"small_obstacles", "Small obstacles made transparent"},
        {"distance", "Distance map"},
        {"regions", "One region for each peak"},
        {"shared_walls", "Shared walls"},
        {"graph", "Region graph"},
        {"merged", "Regions merged"},
        {"dropped", "What is no room is dropped"},
        {"rooms", "Rooms and doorways"},
    };
    const box by_paper[] = {
        {"map", "Occupancy grid"},
        {"lines", "Edges and lines"},
        {"turned", turned},
        {"threshold", "Binary threshold"},
        {"small_obstacles", "Small components removed"},
        {"lifetime", "Seed maps at all scales"},
        {"seeds", "Leaf seeds superposed"},
        {"ridge", "Ridge map"},
        {"regions", "Over-segmentation"},
        {"graph_before", "Connectivity graph"},
        {"graph_after", "Regions merged"},
        {"rooms", "Rooms"},
    };
    const box *boxes = is_paper(e) ? by_paper : by_default;
    size_t count = (is_paper(e) ? sizeof by_paper : sizeof by_default) / sizeof *boxes;
    page_pipeline_begin(page);
    for (size_t i = 0; i < count; i++) {
        page_pipeline_box(page, &e->album, boxes[i].figure, boxes[i].title);
    }
    page_pipeline_end(page);
}

static const char *file_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash != NULL && slash[1] != '\0' ? slash + 1 : path;
}

static void tell_start(const explanation *e, FILE *page) {
    cell_counts n = count_cells(e);
    page_begin(page, file_name(e->name));
    fprintf(page, "<p>How roomseg %d.%d.%d cuts this map into rooms, step by step, with the "
                  "%s. ",
            ROOMSEG_VERSION_MAJOR, ROOMSEG_VERSION_MINOR, ROOMSEG_VERSION_PATCH,
            is_paper(e) ? "paper profile: the system of Sharif, Mohan, Suvarna, &#8220;2D Floor "
                          "Plan Segmentation Based on Down-sampling&#8221; (2023), as published"
                        : "default profile");
    fprintf(page, "The pictures show what the library held in memory after each stage of one "
                  "run; they found %" PRIu32 " room%s.</p>\n",
            e->s.result.room_count, plural(e->s.result.room_count));
    tell_pipeline(e, page);
    fprintf(page, "<p>The map has %" PRIu32 " &#215; %" PRIu32 " cells of %" PRIu32 " mm. Work "
                  "is done on the crop, the box around the free cells, with %" PRIu32 " &#215; %"
                  PRIu32 " cells, and takes %.0f kB of memory beside the map and the labels. In "
                  "the crop %.0f m&#178; are free, %.0f m&#178; are obstacles for sure, and of "
                  "%.0f m&#178; the map does not tell.</p>\n",
            e->m.width, e->m.height, cell_mm(e), e->frame.width, e->frame.height,
            (double)e->s.result.arena_used / 1000.0, area_m2(e, n.free), area_m2(e, n.occupied),
            area_m2(e, n.unsure));
    page_figures_begin(page, 1);
    page_figure(page, &e->album, "map", "The map as the robot made it",
                "The crop as it is in the file: white is 0, certainly free; black is 255, "
                "certainly occupied; gray is between.");
    page_figures_end(page);
}

static void tell_wall_figures(const explanation *e, FILE *page) {
    page_figures_begin(page, 2);
    if (page_figure_begin(page, &e->album, "edges", "Edges of the free space")) {
        fprintf(page, "Edges of the free space (Canny, Gaussian of 2 cells), specks left out: %"
                      PRIu32 " cells.", e->walls.edge_cells);
        page_figure_end(page);
    }
    if (page_figure_begin(page, &e->album, "lines", "Straight lines among the edges")) {
        fprintf(page, "%zu straight lines (probabilistic Hough transform: %u votes, %u cells "
                      "long at least, gaps of %u). ",
                e->walls.line_count, RS_HOUGH_VOTES, RS_HOUGH_LENGTH, RS_HOUGH_GAP);
        page_swatch(page, PAINT_SIGNAL);
        fputs("along the direction found, ", page);
        page_swatch(page, PAINT_SECOND);
        fputs("others.", page);
        page_figure_end(page);
    }
    if (page_figure_begin(page, &e->album, "directions", "Histogram of directions")) {
        fprintf(page, "Length of the lines by direction in degrees, modulo 90. In the window of "
                      "%u degrees that holds most of it the mean direction, in which long "
                      "pieces count most, is %.2f&#176;.",
                2 * RS_DIRECTION_HALF_WINDOW + 1, e->walls.angle / 100.0);
        page_figure_end(page);
    }
    page_figure(page, &e->album, "turned", "The map turned by the angle found",
                e->is_turned ? "The map turned by that angle. All steps below are of this map; "
                               "labels and records are turned back at the end."
                             : "The map as it would be turned. In this run it was not.");
    page_figures_end(page);
}

static void tell_walls(const explanation *e, FILE *page, int *section) {
    if (album_find(&e->album, "lines") == NULL) {
        return;
    }
    page_section(page, section, "The direction of the walls");
    fputs("<p>Walls of a building are mostly at right angles. Their common direction comes from "
          "the edges of the free space: straight pieces of them vote with their length for their "
          "direction, walls a quarter turn apart for the same one. ",
          page);
    if (e->config.align == NULL) {
        fputs("This is off in this run, as the paper has it for the benchmark; "
              "<code>--align</code> turns it on.</p>\n",
              page);
    } else if (!e->is_turned) {
        fprintf(page, "Here the walls lie along the axes within %.2g degree, so the map is left as "
                      "it is: the direction is not known better, and turning blurs.</p>\n",
                RS_ALIGN_LEAST / 100.0);
    } else {
        fputs("Then the map is turned until its walls lie along the rows and columns of the "
              "grid.</p>\n",
              page);
    }
    tell_wall_figures(e, page);
}

static void tell_small_default(const explanation *e, FILE *page, const change *small) {
    if (!page_figure_begin(page, &e->album, "small_obstacles", "Small obstacles")) {
        return;
    }
    fprintf(page, "%" PRIu64 " small obstacle%s with %" PRIu64 " cells no longer count. Their "
                  "cells ",
            small->parts, plural(small->parts), small->cells);
    page_swatch(page, PAINT_AMBER);
    fputs("get the label of the room around, unless they are ", page);
    page_swatch(page, PAINT_SIGNAL);
    fprintf(page, "obstacles for sure (<code>occupied_min</code> %u), which never get one.",
            e->config.occupied_min);
    page_figure_end(page);
}

static void tell_small_paper(const explanation *e, FILE *page, const change *small,
                             const change *parts) {
    if (page_figure_begin(page, &e->album, "free_parts", "Small free parts removed")) {
        page_swatch(page, PAINT_SECOND);
        fprintf(page, "%" PRIu64 " free part%s below the mean area of all free parts, %.1f "
                      "m&#178; together, %s now obstacle%s.",
                parts->parts, plural(parts->parts), area_m2(e, parts->cells),
                parts->parts == 1 ? "is" : "are", plural(parts->parts));
        page_figure_end(page);
    }
    if (page_figure_begin(page, &e->album, "small_obstacles", "Small obstacles removed")) {
        page_swatch(page, PAINT_SIGNAL);
        page_swatch(page, PAINT_AMBER);
        fprintf(page, "%" PRIu64 " obstacle%s of too few cells, %" PRIu64 " cells together, %s "
                      "now free.",
                small->parts, plural(small->parts), small->cells,
                small->parts == 1 ? "is" : "are");
        page_figure_end(page);
    }
}

static int tell_threshold(const explanation *e, FILE *page, int *section) {
    change small, parts;
    if (count_change(&e->o, 1, &small) != 0 || count_change(&e->o, 0, &parts) != 0) {
        return -1;
    }
    page_section(page, section, "Free space without what is small");
    fputs("<p>A cell is free when the map is fairly sure of it; whatever is unknown counts as an "
          "obstacle. Then goes what is too small to shape a room: noise, legs of tables and "
          "chairs",
          page);
    fputs(is_paper(e) ? "; and free cells that no way leads to, such as what the laser saw "
                        "through a window.</p>\n"
                      : ", and compact things that stand free, such as a table or a pillar.</p>\n",
          page);
    page_parameters_begin(page);
    page_parameter(page, "free_max", e->config.free_max, "");
    page_area(page, "speck_mm2", e->config.speck_mm2, cell_mm(e));
    if (!is_paper(e)) {
        page_length(page, "clutter_mm", e->config.clutter_mm, cell_mm(e));
    }
    page_parameters_end(page);
    page_figures_begin(page, 2);
    page_figure(page, &e->album, "threshold", "Free cells and obstacles",
                is_paper(e) ? "White: free. Dark: occupied or unknown."
                            : "White: free. Dark: obstacles for sure. Gray: not known to be "
                              "free, an obstacle as well.");
    if (is_paper(e)) {
        tell_small_paper(e, page, &small, &parts);
    } else {
        tell_small_default(e, page, &small);
    }
    page_figures_end(page);
    return 0;
}

static void tell_score(const explanation *e, FILE *page) {
    fputs("<p>How far the rooms agree with the ground truth; the measures are those of the "
          "paper&#8217;s Table I, in percent. The second column leaves out pieces of the truth "
          "below 60 cells.</p>\n<table><tr><th>Measure</th><th class=\"number\">All</th>"
          "<th class=\"number\">Without specks</th></tr>\n",
          page);
    for (size_t i = 0; i < METRIC_PAPER_COUNT; i++) {
        fprintf(page, "<tr><td>%s</td><td class=\"number\">%.1f</td><td class=\"number\">%.1f"
                      "</td></tr>\n",
                metric_fields[i].title, 100 * metrics_get(&e->score.all, i),
                100 * metrics_get(&e->score.without_specks, i));
    }
    fprintf(page, "<tr><td>rooms found of rooms true</td><td class=\"number\">%u / %u</td>"
                  "<td class=\"number\">%u / %u</td></tr>\n</table>\n",
            (unsigned)e->score.all.rooms_found, (unsigned)e->score.all.rooms_true,
            (unsigned)e->score.without_specks.rooms_found,
            (unsigned)e->score.without_specks.rooms_true);
}

static void tell_result(const explanation *e, FILE *page, int *section) {
    const roomseg_result *r = &e->s.result;
    uint64_t cells = 0;
    for (uint32_t i = 0; i < r->room_count; i++) {
        cells += r->rooms[i].area_cells;
    }
    page_section(page, section, "The result");
    fprintf(page, "<p>%" PRIu32 " room%s with %.1f m&#178; together, and %" PRIu32 " doorway%s. "
                  "Rooms are numbered from the largest on; each has its area, its bounding box, "
                  "a cell deep inside and its neighbours, each doorway its place and width%s."
                  "</p>\n",
            r->room_count, plural(r->room_count), area_m2(e, cells), r->doorway_count,
            plural(r->doorway_count),
            e->is_turned ? "; all of it in the frame of the map as it came" : "");
    page_figures_begin(page, 1);
    page_figure(page, &e->album, "rooms", "The rooms with their numbers and areas",
                "Rooms with number and area, doorways as strokes from wall to wall. White: free, "
                "but no room.");
    page_figures_end(page);
    if (e->has_truth) {
        page_figures_begin(page, 2);
        page_figure(page, &e->album, "truth", "The true rooms", "The ground truth.");
        if (page_figure_begin(page, &e->album, "rooms_and_truth", "Rooms and true outlines")) {
            fputs("The rooms, and on top of them ", page);
            page_swatch(page, PAINT_SIGNAL);
            fputs("the outlines of the true ones.", page);
            page_figure_end(page);
        }
        page_figures_end(page);
        tell_score(e, page);
    }
}

int tell_page(const explanation *e, FILE *page) {
    int section = 0;
    tell_start(e, page);
    tell_walls(e, page, &section);
    if (tell_threshold(e, page, &section) != 0) {
        return -1;
    }
    (is_paper(e) ? tell_paper : tell_default)(e, page, &section);
    tell_result(e, page, &section);
    page_end(page);
    return 0;
}
