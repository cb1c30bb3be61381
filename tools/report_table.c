#include "report.h"

#define Q8 256.0 /* one cell in the fixed point of centroids */

/* "2 (0.86 m), 5 (1.02 m)": each neighbour with the width of the way to it. */
static void write_neighbours(const roomseg_result *r, const roomseg_room *room, FILE *stream) {
    for (uint32_t k = 0; k < room->link_count; k++) {
        const roomseg_doorway *d = &r->doorways[r->links[room->link_first + k]];
        unsigned other = d->room_a == room->label ? d->room_b : d->room_a;
        fprintf(stream, "%s%u (%.2f m)", k > 0 ? ", " : "", other, d->width_mm / 1000.0);
    }
    fputs(room->link_count > 0 ? "\n" : "-\n", stream);
}

void report_table(const map *m, const segmentation *s, FILE *stream) {
    const roomseg_result *r = &s->result;
    double cell_m = m->resolution_m;
    double total_m2 = 0;
    fputs(" room  area m2     centre x, y m      box m           neighbours (doorway)\n", stream);
    for (uint32_t i = 0; i < r->room_count; i++) {
        const roomseg_room *room = &r->rooms[i];
        double area_m2 = room->area_cells * cell_m * cell_m;
        double x;
        double y;
        map_cell_to_world(m, room->centroid_x_q8 / Q8, room->centroid_y_q8 / Q8, &x, &y);
        fprintf(stream, "%5u  %7.2f  %8.2f, %8.2f  %5.2f x %5.2f     ", (unsigned)room->label,
                area_m2, x, y, (room->max_x - room->min_x + 1) * cell_m,
                (room->max_y - room->min_y + 1) * cell_m);
        write_neighbours(r, room, stream);
        total_m2 += area_m2;
    }
    fprintf(stream, "%u room%s, %.2f m2, %u doorway%s\n", (unsigned)r->room_count,
            r->room_count == 1 ? "" : "s", total_m2, (unsigned)r->doorway_count,
            r->doorway_count == 1 ? "" : "s");
}
