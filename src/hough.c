#include "hough.h"

#include <string.h>

#include "trig.h"

/* What an edge byte says. */
#define EDGE 1u
#define VOTED 2u /* an edge whose votes are in the accumulator */

/* Distances are rounded to whole cells. */
#define NORMAL_SHIFT 14
#define HALF_STEP (1 << (NORMAL_SHIFT - 1))

void rs_hough_init(rs_hough *hough, const rs_frame *frame, uint8_t *edges, uint32_t *points,
                   uint32_t point_count, uint16_t *votes, rs_normal *normals)
{
    hough->frame = frame;
    hough->edges = edges;
    hough->points = points;
    hough->left = point_count;
    hough->total = point_count;
    hough->votes = votes;
    hough->normals = normals;
    hough->distances = (uint32_t)ROOMSEG_PLAN_DISTANCES(frame->width, frame->height);
    hough->random = 2463534242u;
    memset(votes, 0, (size_t)ROOMSEG_HOUGH_ANGLES * hough->distances * sizeof *votes);
    for (uint32_t i = 0; i < ROOMSEG_HOUGH_ANGLES; i++) {
        rs_direction d = rs_trig_direction((int32_t)i * (180 * RS_DEGREE) /
                                           (int32_t)ROOMSEG_HOUGH_ANGLES);
        normals[i].cos = (int16_t)(d.cos / (RS_TRIG_ONE >> NORMAL_SHIFT));
        normals[i].sin = (int16_t)(d.sin / (RS_TRIG_ONE >> NORMAL_SHIFT));
    }
}

/* Marsaglia's xorshift: every 32-bit number but 0 once in a period. */
static uint32_t next_random(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

/* Takes one of the points that are left, all equally likely. */
static uint32_t draw_point(rs_hough *hough)
{
    uint32_t at = (uint32_t)(((uint64_t)next_random(&hough->random) * hough->left) >> 32);
    uint32_t point = hough->points[at];

    hough->points[at] = hough->points[--hough->left];
    return point;
}

/* Index into the votes of one angle. The middle of the crop is at half of the distances, and
 * no cell is further from it than that, so the sum is positive. */
static inline uint32_t distance_of(const rs_hough *hough, const rs_normal *normal, uint32_t x,
                                   uint32_t y)
{
    int32_t dx = (int32_t)x - (int32_t)(hough->frame->width / 2u);
    int32_t dy = (int32_t)y - (int32_t)(hough->frame->height / 2u);
    int32_t middle = (int32_t)(hough->distances / 2u) << NORMAL_SHIFT;

    return (uint32_t)(dx * normal->cos + dy * normal->sin + middle + HALF_STEP) >> NORMAL_SHIFT;
}

/* Votes for all lines through a cell. Returns the votes of the strongest, *angle its own. */
static uint32_t vote(rs_hough *hough, uint32_t x, uint32_t y, uint32_t *angle)
{
    uint16_t *votes = hough->votes;
    uint32_t most = 0;

    for (uint32_t i = 0; i < ROOMSEG_HOUGH_ANGLES; i++, votes += hough->distances) {
        uint16_t *count = &votes[distance_of(hough, &hough->normals[i], x, y)];
        *count = (uint16_t)(*count + (*count < UINT16_MAX));
        if (*count > most) {
            most = *count;
            *angle = i;
        }
    }
    return most;
}

static void take_back_votes(rs_hough *hough, uint32_t x, uint32_t y)
{
    uint16_t *votes = hough->votes;

    for (uint32_t i = 0; i < ROOMSEG_HOUGH_ANGLES; i++, votes += hough->distances) {
        uint16_t *count = &votes[distance_of(hough, &hough->normals[i], x, y)];
        *count = (uint16_t)(*count - (*count > 0u));
    }
}

/* A walk along a line: one cell a step along the axis to which the line is closer. Q16; a
 * position left of or above the crop wraps to one beyond 2^15 and so is outside as well. */
typedef struct walk {
    uint32_t x, y, dx, dy;
} walk;

static walk start_walk(const rs_normal *normal, uint32_t x, uint32_t y, bool back)
{
    int32_t along_x = -normal->sin, along_y = normal->cos; /* of the line itself */
    bool steep = (along_y < 0 ? -along_y : along_y) > (along_x < 0 ? -along_x : along_x);
    int32_t major = steep ? along_y : along_x, minor = steep ? along_x : along_y;
    uint32_t one = back ? 0u - (1u << 16) : 1u << 16;
    uint32_t slope = (uint32_t)(minor * (1 << 16) / major); /* |minor| <= |major| <= 2^14 */
    walk w = {(x << 16) + (1u << 15), (y << 16) + (1u << 15), 0, 0};

    slope = back ? 0u - slope : slope;
    w.dx = steep ? slope : one;
    w.dy = steep ? one : slope;
    return w;
}

/* The edge byte under the walk; NULL outside of the crop. */
static uint8_t *cell_of(const rs_hough *hough, const walk *w)
{
    uint32_t x = w->x >> 16, y = w->y >> 16;

    if (x >= hough->frame->width || y >= hough->frame->height) {
        return NULL;
    }
    return &hough->edges[rs_frame_index(hough->frame, x, y)];
}

static bool tick(const rs_hough *hough, uint32_t visits, rs_ticker *ticker)
{
    return rs_tick(ticker, visits, hough->total - hough->left, hough->total);
}

/* Follows the line one way, across gaps that are short enough. *end: its last edge cell. */
static int follow(const rs_hough *hough, walk w, uint32_t *end, rs_ticker *ticker)
{
    uint32_t gap = 0;
    const uint8_t *edge;

    while ((edge = cell_of(hough, &w)) != NULL && gap <= RS_HOUGH_GAP) {
        if (tick(hough, 1u, ticker)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        gap++;
        if (*edge != 0u) {
            gap = 0;
            *end = rs_cell_pack(w.x >> 16, w.y >> 16);
        }
        w.x += w.dx;
        w.y += w.dy;
    }
    return ROOMSEG_OK;
}

/* Removes the edges between the start of the walk and `end`, and their votes if the line is
 * good. */
static int erase(rs_hough *hough, walk w, uint32_t end, bool good, rs_ticker *ticker)
{
    for (;;) {
        uint32_t x = w.x >> 16, y = w.y >> 16;
        uint8_t *edge = &hough->edges[rs_frame_index(hough->frame, x, y)];

        if (tick(hough, *edge == VOTED ? ROOMSEG_HOUGH_ANGLES : 1u, ticker)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (good && *edge == VOTED) {
            take_back_votes(hough, x, y);
        }
        *edge = 0;
        if (rs_cell_pack(x, y) == end) {
            return ROOMSEG_OK;
        }
        w.x += w.dx;
        w.y += w.dy;
    }
}

static uint32_t difference(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

/* Takes the segment through a cell out of the edges. *good: it is long enough. */
static int take_segment(rs_hough *hough, uint32_t point, uint32_t angle, rs_line *line,
                        bool *good, rs_ticker *ticker)
{
    const rs_normal *normal = &hough->normals[angle];
    uint32_t ends[2] = {point, point};
    int status = ROOMSEG_OK;
    walk ways[2];

    for (uint32_t i = 0; i < 2u && status == ROOMSEG_OK; i++) {
        ways[i] = start_walk(normal, rs_cell_x(point), rs_cell_y(point), i == 1u);
        status = follow(hough, ways[i], &ends[i], ticker);
    }
    line->x0 = (uint16_t)rs_cell_x(ends[0]);
    line->y0 = (uint16_t)rs_cell_y(ends[0]);
    line->x1 = (uint16_t)rs_cell_x(ends[1]);
    line->y1 = (uint16_t)rs_cell_y(ends[1]);
    *good = difference(line->x0, line->x1) >= RS_HOUGH_LENGTH ||
            difference(line->y0, line->y1) >= RS_HOUGH_LENGTH;
    for (uint32_t i = 0; i < 2u && status == ROOMSEG_OK; i++) {
        status = erase(hough, ways[i], ends[i], *good, ticker);
    }
    return status;
}

int rs_hough_next(rs_hough *hough, rs_line *line, bool *found, rs_ticker *ticker)
{
    int status = ROOMSEG_OK;

    *found = false;
    while (status == ROOMSEG_OK && !*found && hough->left > 0u) {
        uint32_t point = draw_point(hough), angle = 0;
        uint32_t x = rs_cell_x(point), y = rs_cell_y(point);
        uint8_t *edge = &hough->edges[rs_frame_index(hough->frame, x, y)];

        if (tick(hough, ROOMSEG_HOUGH_ANGLES, ticker)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        if (*edge == 0u) {
            continue; /* went with a segment */
        }
        *edge = VOTED;
        if (vote(hough, x, y, &angle) >= RS_HOUGH_VOTES) {
            status = take_segment(hough, point, angle, line, found, ticker);
        }
    }
    return status;
}
