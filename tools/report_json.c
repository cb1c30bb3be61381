#include "json.h"
#include "report.h"

#define Q8 256.0 /* one cell in the fixed point of centroids */

/* Digits behind the point. */
#define METRES_DECIMALS 3
#define CELLS_DECIMALS 2
#define AREA_DECIMALS 3
#define POSE_DECIMALS 6

typedef struct writer {
    const map *m;
    const segmentation *s;
    FILE *stream;
} writer;

static void number(const writer *w, const char *key, double value, int decimals) {
    fprintf(w->stream, "\"%s\": ", key);
    json_number(w->stream, value, decimals);
}

static void pair(const writer *w, const char *key, double a, double b, int decimals) {
    fprintf(w->stream, "\"%s\": [", key);
    json_number(w->stream, a, decimals);
    fputs(", ", w->stream);
    json_number(w->stream, b, decimals);
    putc(']', w->stream);
}

/* A position in cells and in metres. */
static void position(const writer *w, const char *key, double x, double y) {
    double world_x;
    double world_y;
    map_cell_to_world(w->m, x, y, &world_x, &world_y);
    fprintf(w->stream, "\"%s\": {", key);
    pair(w, "cells", x, y, CELLS_DECIMALS);
    fputs(", ", w->stream);
    pair(w, "m", world_x, world_y, METRES_DECIMALS);
    putc('}', w->stream);
}

static void write_map(const writer *w, const char *file) {
    fputs("  \"map\": {\"file\": ", w->stream);
    json_string(w->stream, file);
    fprintf(w->stream, ", \"width\": %u, \"height\": %u, ", (unsigned)w->m->width,
            (unsigned)w->m->height);
    number(w, "resolution_m", w->m->resolution_m, POSE_DECIMALS);
    fputs(",\n          \"origin\": {", w->stream);
    pair(w, "m", w->m->origin_x_m, w->m->origin_y_m, POSE_DECIMALS);
    fputs(", ", w->stream);
    number(w, "yaw_rad", w->m->origin_yaw_rad, POSE_DECIMALS);
    fputs("}},\n", w->stream);
}

/* The numbers at the other end of a room's doorways, or the doorways' indices. */
static void write_links(const writer *w, const roomseg_room *room, int neighbours) {
    const roomseg_result *r = &w->s->result;
    fprintf(w->stream, "\"%s\": [", neighbours ? "neighbours" : "doorways");
    for (uint32_t k = 0; k < room->link_count; k++) {
        unsigned link = r->links[room->link_first + k];
        const roomseg_doorway *d = &r->doorways[link];
        unsigned other = d->room_a == room->label ? d->room_b : d->room_a;
        fprintf(w->stream, "%s%u", k > 0 ? ", " : "", neighbours ? other : link);
    }
    putc(']', w->stream);
}

static void write_room(const writer *w, const roomseg_room *room) {
    double cell_m2 = w->m->resolution_m * w->m->resolution_m;
    fprintf(w->stream, "    {\"label\": %u, ", (unsigned)room->label);
    number(w, "area_m2", room->area_cells * cell_m2, AREA_DECIMALS);
    fprintf(w->stream, ", \"area_cells\": %u,\n     ", (unsigned)room->area_cells);
    position(w, "centroid", room->centroid_x_q8 / Q8, room->centroid_y_q8 / Q8);
    fputs(",\n     ", w->stream);
    position(w, "interior", room->interior_x, room->interior_y);
    fputs(",\n     ", w->stream);
    number(w, "inscribed_radius_m", room->inscribed_radius_mm / 1000.0, METRES_DECIMALS);
    fprintf(w->stream, ", \"bounding_box\": {\"min\": [%u, %u], \"max\": [%u, %u]},\n     ",
            (unsigned)room->min_x, (unsigned)room->min_y, (unsigned)room->max_x,
            (unsigned)room->max_y);
    write_links(w, room, 1);
    fputs(", ", w->stream);
    write_links(w, room, 0);
    putc('}', w->stream);
}

static void write_doorway(const writer *w, const roomseg_doorway *d) {
    fprintf(w->stream, "    {\"rooms\": [%u, %u], ", (unsigned)d->room_a, (unsigned)d->room_b);
    position(w, "position", d->x, d->y);
    fputs(", ", w->stream);
    number(w, "width_m", d->width_mm / 1000.0, METRES_DECIMALS);
    fprintf(w->stream, ", \"border_cells\": %u}", (unsigned)d->border_cells);
}

void report_json(const map *m, const segmentation *s, const char *file, FILE *stream) {
    const roomseg_result *r = &s->result;
    writer w = {m, s, stream};
    fprintf(stream, "{\n  \"version\": %d,\n", REPORT_JSON_VERSION);
    fprintf(stream, "  \"generator\": \"roomseg %d.%d.%d\",\n", ROOMSEG_VERSION_MAJOR,
            ROOMSEG_VERSION_MINOR, ROOMSEG_VERSION_PATCH);
    write_map(&w, file);
    fprintf(stream, "  \"crop\": {\"x\": %u, \"y\": %u, \"width\": %u, \"height\": %u},\n",
            (unsigned)r->crop_x, (unsigned)r->crop_y, (unsigned)r->crop_width,
            (unsigned)r->crop_height);
    fprintf(stream, "  \"arena_bytes\": %lu,\n  \"regions\": %u,\n",
            (unsigned long)r->arena_used, (unsigned)r->region_count);
    fputs("  \"rooms\": [", stream);
    for (uint32_t i = 0; i < r->room_count; i++) {
        fputs(i > 0 ? ",\n" : "\n", stream);
        write_room(&w, &r->rooms[i]);
    }
    fputs(r->room_count > 0 ? "\n  ],\n  \"doorways\": [" : "],\n  \"doorways\": [", stream);
    for (uint32_t i = 0; i < r->doorway_count; i++) {
        fputs(i > 0 ? ",\n" : "\n", stream);
        write_doorway(&w, &r->doorways[i]);
    }
    fputs(r->doorway_count > 0 ? "\n  ]\n}\n" : "]\n}\n", stream);
}
