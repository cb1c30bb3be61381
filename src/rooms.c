#include "rooms.h"

#include <string.h>

#include "cluster.h"
#include "distance.h"

/* Roots in falling order of area; equal areas in reading order. The rooms' link_first
 * serves as a list of roots in reading order meanwhile. */
static int number_rooms(rs_graph *graph, rs_room_records *records, rs_heap_item *heap_items)
{
    rs_heap heap = {heap_items, 0};
    rs_region *regions = graph->regions;
    uint32_t count;

    for (uint32_t r = 1; r <= graph->region_count; r++) {
        if (regions[r].parent == r && regions[r].area > 0u) {
            rs_heap_push(&heap, UINT32_MAX - regions[r].first_cell, r);
        }
    }
    count = heap.count;
    if (count > records->max_rooms) {
        return ROOMSEG_ERR_ROOMS;
    }
    memset(records->rooms, 0, count * sizeof *records->rooms);
    memset(records->sums, 0, count * sizeof *records->sums);
    for (uint32_t i = 0; i < count; i++) {
        records->rooms[i].link_first = rs_heap_pop(&heap).item;
    }
    for (uint32_t i = 0; i < count; i++) {
        rs_heap_push(&heap, regions[records->rooms[i].link_first].area, i);
    }
    for (uint32_t i = 0; i < count; i++) {
        uint32_t root = records->rooms[rs_heap_pop(&heap).item].link_first;
        regions[root].room = (uint16_t)(i + 1u);
    }
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        regions[r].room = regions[rs_cluster_root(regions, (uint16_t)r)].room;
    }
    records->room_count = count;
    return ROOMSEG_OK;
}

/* Adds the run first..last of row y to a room. */
static void add_run(roomseg_room *room, rs_room_sum *sum, uint32_t first, uint32_t last,
                    uint32_t y)
{
    uint32_t length = last - first + 1u;

    if (room->area_cells == 0u) {
        room->min_x = (uint16_t)first;
        room->max_x = (uint16_t)last;
        room->min_y = (uint16_t)y;
    }
    room->min_x = room->min_x < first ? room->min_x : (uint16_t)first;
    room->max_x = room->max_x > last ? room->max_x : (uint16_t)last;
    room->max_y = (uint16_t)y;
    room->area_cells += length;
    sum->x += (uint64_t)(first + last) * length / 2u; /* one of the factors is even */
    sum->y += (uint64_t)y * length;
}

/* The cells first..end - 1 of a region become its room's, but for certain obstacles. */
static void label_run(const uint8_t *cells, uint8_t occupied_min, uint16_t room, uint16_t *labels,
                      uint32_t first, uint32_t end, uint32_t y, rs_room_records *records)
{
    while (first < end) {
        uint32_t x = first;

        while (x < end && cells[x] < occupied_min) {
            labels[x++] = room;
        }
        if (room != 0u && x > first) {
            add_run(&records->rooms[room - 1u], &records->sums[room - 1u], first, x - 1u, y);
        }
        while (x < end && cells[x] >= occupied_min) {
            labels[x++] = 0;
        }
        first = x;
    }
}

/* The same for a run without certain obstacles. */
static void label_clear_run(uint16_t room, uint16_t *labels, uint32_t first, uint32_t end,
                            uint32_t y, rs_room_records *records)
{
    for (uint32_t x = first; x < end; x++) {
        labels[x] = room;
    }
    if (room != 0u) {
        add_run(&records->rooms[room - 1u], &records->sums[room - 1u], first, end - 1u, y);
    }
}

static void label_row(const uint8_t *cells, uint8_t occupied_min, const rs_graph *graph,
                      uint16_t *labels, uint32_t width, uint32_t y, rs_room_records *records)
{
    uint32_t x = rs_skip_label(labels, 0, width, 0);

    while (x < width) {
        uint16_t region = labels[x], room = graph->regions[region].room;
        uint32_t end = rs_skip_label(labels, x + 1u, width, region);

        if (cells[x] < occupied_min &&
            rs_highest(cells + x + 1u, end - x - 1u) < occupied_min) {
            label_clear_run(room, labels, x, end, y, records);
        } else {
            label_run(cells, occupied_min, room, labels, x, end, y, records);
        }
        x = rs_skip_label(labels, end, width, 0);
    }
}

static uint32_t area_in_cm2(uint32_t cells, uint32_t resolution_mm)
{
    uint64_t mm2 = (uint64_t)cells * resolution_mm * resolution_mm;
    uint64_t limit = (uint64_t)UINT32_MAX * 100u;

    /* rs_divide_q8 scales by 256; 100 cm2 * 256 = 25600. */
    return mm2 >= limit ? UINT32_MAX : rs_divide_q8(mm2, 25600u);
}

/* Turns the sums and crop coordinates into what the caller gets. */
static void finish_room(const rs_frame *frame, uint32_t resolution_mm, const rs_region *region,
                        const rs_room_sum *sum, uint16_t label, roomseg_room *room)
{
    room->label = label;
    room->link_first = 0;
    room->area_cm2 = area_in_cm2(room->area_cells, resolution_mm);
    room->centroid_x_q8 = rs_divide_q8(sum->x, room->area_cells) + (frame->x << 8);
    room->centroid_y_q8 = rs_divide_q8(sum->y, room->area_cells) + (frame->y << 8);
    room->min_x = (uint16_t)(room->min_x + frame->x);
    room->max_x = (uint16_t)(room->max_x + frame->x);
    room->min_y = (uint16_t)(room->min_y + frame->y);
    room->max_y = (uint16_t)(room->max_y + frame->y);
    room->interior_x = (uint16_t)(region->peak_x + frame->x);
    room->interior_y = (uint16_t)(region->peak_y + frame->y);
    /* From the cell's centre to the obstacle cell's near edge; the rounding of the distance
     * is below one unit and the smallest distance one cell, so nothing falls below 0. */
    room->inscribed_radius_mm =
        (uint16_t)(rs_max_u32(region->peak * RS_DISTANCE_UNIT_MM, resolution_mm) -
                   resolution_mm / 2u);
}

static int label_rooms(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                       const rs_graph *graph, const rs_labels *labels, rs_room_records *records,
                       rs_ticker *ticker)
{
    for (uint32_t y = 0; y < frame->height; y++) {
        const uint8_t *cells = grid->cells + (size_t)(frame->y + y) * grid->stride + frame->x;

        if (rs_tick(ticker, frame->width, y, frame->height)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        label_row(cells, occupied_min, graph, labels->cells + (size_t)y * labels->stride,
                  frame->width, y, records);
    }
    for (uint32_t r = 1; r <= graph->region_count; r++) {
        const rs_region *region = &graph->regions[r];
        if (region->parent == r && region->room != 0u) {
            uint32_t i = region->room - 1u;
            finish_room(frame, grid->resolution_mm, region, &records->sums[i], region->room,
                        &records->rooms[i]);
        }
    }
    return ROOMSEG_OK;
}

/* One doorway for all edges between two rooms; edges come sorted by their pair of rooms. */
static bool add_edge_to_doorways(const rs_frame *frame, uint32_t resolution_mm,
                                 const rs_edge *edge, uint16_t room_a, uint16_t room_b,
                                 rs_room_records *records)
{
    roomseg_doorway *door = records->doorways + records->doorway_count;
    /* Distances run from centre to centre; one cell of them lies within the obstacles. */
    uint32_t width_mm =
        2u * rs_max_u32(edge->saddle * RS_DISTANCE_UNIT_MM, resolution_mm) - resolution_mm;
    bool same = records->doorway_count > 0u && door[-1].room_a == room_a &&
                door[-1].room_b == room_b;

    if (same) {
        door--;
    } else if (records->doorway_count == ROOMSEG_PLAN_EDGES(records->max_rooms)) {
        return false;
    } else {
        memset(door, 0, sizeof *door);
        door->room_a = room_a;
        door->room_b = room_b;
        records->doorway_count++;
    }
    door->border_cells += edge->border;
    if (width_mm > door->width_mm) {
        door->width_mm = width_mm;
        door->x = (uint16_t)(edge->x + frame->x);
        door->y = (uint16_t)(edge->y + frame->y);
    }
    return true;
}

/* links: the doorways of each room, grouped by counting. */
static void link_rooms(rs_room_records *records)
{
    uint32_t first = 0;

    for (uint32_t d = 0; d < records->doorway_count; d++) {
        records->rooms[records->doorways[d].room_a - 1u].link_count++;
        records->rooms[records->doorways[d].room_b - 1u].link_count++;
    }
    for (uint32_t i = 0; i < records->room_count; i++) {
        records->rooms[i].link_first = first;
        first += records->rooms[i].link_count;
        records->rooms[i].link_count = 0;
    }
    for (uint32_t d = 0; d < records->doorway_count; d++) {
        const uint16_t ends[2] = {records->doorways[d].room_a, records->doorways[d].room_b};
        for (uint32_t side = 0; side < 2u; side++) {
            roomseg_room *room = &records->rooms[ends[side] - 1u];
            records->links[room->link_first + room->link_count++] = (uint16_t)d;
        }
    }
}

int rs_rooms_connect(const rs_frame *frame, uint32_t resolution_mm, const rs_graph *graph,
                     rs_room_records *records, rs_heap_item *heap_items)
{
    rs_heap heap = {heap_items, 0};

    for (uint32_t e = 0; e < graph->edge_count; e++) {
        uint16_t a = graph->regions[graph->edges[e].a].room;
        uint16_t b = graph->regions[graph->edges[e].b].room;
        if (a != b && a != 0u && b != 0u && graph->edges[e].saddle > 0u) {
            uint32_t pair = a < b ? (uint32_t)a << 16 | b : (uint32_t)b << 16 | a;
            rs_heap_push(&heap, UINT32_MAX - pair, e);
        }
    }
    records->doorway_count = 0;
    while (heap.count > 0u) {
        rs_heap_item next = rs_heap_pop(&heap);
        uint32_t pair = UINT32_MAX - next.key;
        if (!add_edge_to_doorways(frame, resolution_mm, &graph->edges[next.item],
                                  (uint16_t)(pair >> 16), (uint16_t)(pair & 0xFFFFu), records)) {
            return ROOMSEG_ERR_ROOMS;
        }
    }
    link_rooms(records);
    return ROOMSEG_OK;
}

int rs_rooms_run(const rs_frame *frame, const roomseg_grid *grid, uint8_t occupied_min,
                 const rs_labels *labels, rs_graph *graph, rs_room_records *records,
                 rs_heap_item *heap, rs_ticker *ticker)
{
    int status = number_rooms(graph, records, heap);

    if (status == ROOMSEG_OK) {
        status = label_rooms(frame, grid, occupied_min, graph, labels, records, ticker);
    }
    return status == ROOMSEG_OK
               ? rs_rooms_connect(frame, grid->resolution_mm, graph, records, heap)
               : status;
}

void rs_rooms_report(const rs_room_records *records, roomseg_result *result)
{
    result->rooms = records->rooms;
    result->doorways = records->doorways;
    result->links = records->links;
    result->room_count = records->room_count;
    result->doorway_count = records->doorway_count;
}
