/* roomseg - cuts a robot's 2D occupancy grid into rooms.
 *
 * Fixed memory (one caller-supplied arena), integers only, no libc beyond
 * memcpy/memset/memmove, no mutable globals: two runs in two arenas may run at
 * once. The same inputs give the same bits on every CPU and compiler.
 *
 *     roomseg_config cfg = roomseg_config_default();
 *     size_t need;
 *     int rc = roomseg_arena_size_for_grid(&cfg, &grid, &need);
 *     ...
 *     rc = roomseg_run(&cfg, &grid, labels, label_stride, &result, arena, need);
 *
 * Terms. A grid is an occupancy grid: one byte a cell, 0 = certainly free,
 * 255 = certainly occupied, about 127 = unknown. Cell (x, y) is column x, row y;
 * row 0 is the first row in memory (the top of an image). The cell's centre has
 * the coordinates (x, y), so a centroid of 3.5 lies between two cells.
 * The CROP is the bounding box of the free cells; memory is needed for it alone,
 * never for the whole grid. A REGION is one basin of the watershed, a ROOM what
 * remains after regions were merged. */
#ifndef ROOMSEG_ROOMSEG_H
#define ROOMSEG_ROOMSEG_H

#include <stddef.h>
#include <stdint.h>

#if SIZE_MAX < 0xFFFFFFFFu
#error "roomseg is for CPUs of 32 bits and more"
#endif

#include "roomseg/plan.h" /* ROOMSEG_ARENA_SIZE(), the compile-time size */
#include "roomseg/plan_paper.h"

#ifdef __cplusplus
extern "C" {
#endif

#define ROOMSEG_VERSION_MAJOR 0
#define ROOMSEG_VERSION_MINOR 1
#define ROOMSEG_VERSION_PATCH 0

/* Largest grid side (columns with a border on both sides fit in 16 bits), and largest number
 * of cells in the crop. */
#define ROOMSEG_MAX_SIDE 65533u
#define ROOMSEG_MAX_CROP_CELLS (1ul << 28)

/* Resolutions that the physical parameters are meant for [mm per cell]. */
#define ROOMSEG_MIN_RESOLUTION_MM 20u
#define ROOMSEG_MAX_RESOLUTION_MM 200u

/* Limits of configuration fields and capacities. */
#define ROOMSEG_MAX_SPECK_MM2 4000000u
#define ROOMSEG_MAX_CLUTTER_MM 2000u
#define ROOMSEG_MAX_SMALLEST_ROOM_MM2 4000000000u
#define ROOMSEG_MIN_SHARED_WALL_MM 200u
#define ROOMSEG_MAX_SHARED_WALL_MM 10000000u
#define ROOMSEG_MAX_DOOR_MM 10000u
#define ROOMSEG_MAX_HALL_MM 10000u
#define ROOMSEG_MAX_DILATION_MM 1000u
#define ROOMSEG_MAX_BORDER_MM 1000000u
#define ROOMSEG_MAX_REGIONS 65531u
#define ROOMSEG_MAX_ROOMS 16384u

/* The arena's address must be a multiple of this. */
#define ROOMSEG_ARENA_ALIGN 8u

/* What roomseg functions return. Each cause has a code of its own. */
typedef enum roomseg_status {
    ROOMSEG_OK = 0,
    ROOMSEG_ERR_NULL = -1,        /* a required pointer is NULL */
    ROOMSEG_ERR_GRID_SIZE = -2,   /* width or height is 0 or above ROOMSEG_MAX_SIDE, or
                                     the crop has more than ROOMSEG_MAX_CROP_CELLS */
    ROOMSEG_ERR_STRIDE = -3,      /* a stride is smaller than the width */
    ROOMSEG_ERR_RESOLUTION = -4,  /* resolution_mm outside the limits above */
    ROOMSEG_ERR_CONFIG = -5,      /* a config field is outside its documented range */
    ROOMSEG_ERR_ARENA_ALIGN = -6, /* the arena is not aligned to ROOMSEG_ARENA_ALIGN */
    ROOMSEG_ERR_ARENA_SIZE = -7,  /* the arena is too small for this grid and config */
    ROOMSEG_ERR_REGIONS = -8,     /* more regions than config.max_regions */
    ROOMSEG_ERR_ROOMS = -9,       /* more rooms than config.max_rooms */
    ROOMSEG_ERR_CANCELLED = -10   /* the progress hook asked to stop */
} roomseg_status;

/* A short English sentence for a status, static storage; never NULL, "unknown
 * status" for a number that is none. */
const char *roomseg_status_text(int status);

/* Stages of a run in the order in which they are carried out. */
typedef enum roomseg_stage {
    ROOMSEG_STAGE_THRESHOLD = 0, /* grid -> free/occupied cells of the crop */
    ROOMSEG_STAGE_ALIGN,         /* direction of the walls, grid turned; with config.align */
    ROOMSEG_STAGE_COMPONENTS,    /* specks dropped, clutter made transparent */
    ROOMSEG_STAGE_SURFACE,       /* how deep inside the free space each cell lies */
    ROOMSEG_STAGE_SEEDS,         /* the paper profile's: parts that never divide */
    ROOMSEG_STAGE_RIDGE,         /* the paper profile's: narrows between obstacles */
    ROOMSEG_STAGE_WATERSHED,     /* one region per peak of the surface, or per seed */
    ROOMSEG_STAGE_GRAPH,         /* region adjacency graph */
    ROOMSEG_STAGE_MERGE,         /* regions -> rooms */
    ROOMSEG_STAGE_ROOMS,         /* labels and records written */
    ROOMSEG_STAGE_TURN_BACK,     /* labels and records of the caller's grid, if it was turned */
    ROOMSEG_STAGE_COUNT
} roomseg_stage;

/* Name of a stage in lower case, static storage; "?" outside the enumeration. */
const char *roomseg_stage_name(int stage);

/* Called at least once in every 65,536 visits of a cell, from inside
 * roomseg_run, on the caller's stack: feed the watchdog here.
 * permille: share of this stage that is done, 0..1000, never falling within a stage.
 * Return 0 to go on; any other value ends the run with ROOMSEG_ERR_CANCELLED. */
typedef int (*roomseg_progress_fn)(void *user, roomseg_stage stage, unsigned permille);

/* The occupancy grid. Not modified; may lie in read-only memory. */
typedef struct roomseg_grid {
    const uint8_t *cells;   /* cell (x, y) = cells[y * stride + x] */
    uint32_t width;         /* 1..ROOMSEG_MAX_SIDE */
    uint32_t height;        /* 1..ROOMSEG_MAX_SIDE */
    uint32_t stride;        /* bytes from one row to the next, >= width */
    uint32_t resolution_mm; /* edge of a cell, 20..200 mm */
} roomseg_grid;

/* A profile is one way through the pipeline. The config points to it, so that the linker
 * drops the stages of a profile that a program never names.
 * ROOMSEG_PROFILE_DEFAULT: distance map, merging by the width of openings.
 * ROOMSEG_PROFILE_PAPER: the system of Sharif, Mohan, Suvarna, "2D Floor Plan Segmentation
 * Based on Down-sampling", 2023, as published: seeds from the free space blurred more and
 * more, watershed with lines on a ridge map, merging by the length of borders. Cells beside
 * walls and the border line between two rooms carry no label. */
typedef struct roomseg_profile roomseg_profile;
extern const roomseg_profile roomseg_profile_default;
extern const roomseg_profile roomseg_profile_paper;
#define ROOMSEG_PROFILE_DEFAULT (&roomseg_profile_default)
#define ROOMSEG_PROFILE_PAPER (&roomseg_profile_paper)

/* Alignment: the grid is turned until its walls lie along the axes, segmented, and the labels
 * are turned back. Named only where it is wanted, so that the linker drops it elsewhere. */
typedef struct roomseg_aligner roomseg_aligner;
extern const roomseg_aligner roomseg_aligner_on;
#define ROOMSEG_ALIGN_ON (&roomseg_aligner_on)

/* Take a ready set from roomseg_config_default() or roomseg_config_paper() and change single
 * fields. Defaults are the same in both unless "paper" says otherwise. A profile checks the
 * range of every field, of those too that only the other one reads. */
typedef struct roomseg_config {
    const roomseg_profile *profile; /* one of the ROOMSEG_PROFILE_ constants, not NULL */

    /* NULL: the grid is taken as it lies; default. ROOMSEG_ALIGN_ON: walls are brought into
     * line with the axes first. Takes more memory (ROOMSEG_ARENA_SIZE_ALIGNED) and time, and
     * halves the largest crop: (width + height + 2)^2 / 2 <= ROOMSEG_MAX_CROP_CELLS. Labels
     * and records are those of the caller's grid all the same. */
    const roomseg_aligner *align;

    /* A cell is free when its value is at most free_max, else it is an obstacle (unknown
     * cells too). From occupied_min on an obstacle is certain: such a cell never carries a
     * label. 0 <= free_max < occupied_min <= 255; default 51 and 204, that is 0.2 and 0.8
     * of full occupancy. */
    uint8_t free_max;
    uint8_t occupied_min;

    /* Obstacles smaller than this are noise and do not shape the rooms. Area of an
     * 8-connected component [mm2], 0 (keep all)..ROOMSEG_MAX_SPECK_MM2; default 96,000 =
     * 60 cells of 4 cm. Their cells below occupied_min carry the label of the room around.
     * Paper: 4-connected; 4,000,000 for homes. */
    uint32_t speck_mm2;

    /* The same for compact free-standing obstacles, such as a table, a bin, a pillar: the
     * bounding box at most this long on both sides, neither side more than twice the other,
     * and at least a third of it filled. [mm], 0 (none)..ROOMSEG_MAX_CLUTTER_MM; default
     * 1500, paper 0. */
    uint32_t clutter_mm;

    /* Regions below this area never stand as a room of their own [mm2],
     * 0..ROOMSEG_MAX_SMALLEST_ROOM_MM2; default 1,000,000 = 1 m2. Regions that touch no other
     * are dropped (label 0) below the larger of this and isolated_permille of the free area. */
    uint32_t smallest_room_mm2;
    uint32_t isolated_permille; /* 0..1000; default 10 */

    /* Read by the default profile only, up to unwalled_percent.
     * Regions below this area are a niche of their neighbour, not a room, when the opening
     * between them is at least nine tenths as wide as they are themselves. [mm2],
     * 0 (none)..ROOMSEG_MAX_SMALLEST_ROOM_MM2; default 3,000,000. */
    uint32_t niche_mm2;

    /* Two regions are one room when the opening between them is wide in proportion
     * to their own widths: opening >= percent/100 * sqrt(width_a * width_b), where a
     * width is the diameter of the largest inscribed circle. 1..100; default 83.
     * Without a wall between them 72 percent are enough, when the opening takes 78 percent of
     * the narrower width: two pieces of a corridor (where nobody lives, see lived_in_permille). */
    uint32_t room_opening_percent;

    /* The same between two regions that are both passages, that is, have
     * passage_min_neighbours or more neighbours of at least smallest_room_mm2.
     * 1..100; default 41. passage_min_neighbours: 2..8; default 3. */
    uint32_t passage_opening_percent;
    uint32_t passage_min_neighbours;

    /* Walls between two regions, that is, obstacles of at most 350 mm with the one region
     * on this side and the other on that, tell more than the width of their opening.
     * From this length of shared wall on they are two rooms, whatever the opening [mm],
     * ROOMSEG_MIN_SHARED_WALL_MM..ROOMSEG_MAX_SHARED_WALL_MM; default 1000. */
    uint32_t shared_wall_mm;

    /* In a building that is lived in, what makes an opening narrow may be furniture, so that
     * walls have to decide. A map shows one when more than this share of the floor is taken by
     * certain obstacles that speck_mm2 and clutter_mm ignore (single cells are noise and do not
     * count) [1/1000], 0..1000 (never); default 3. Then two regions
     * - that are still as narrow as a hall together, hall_mm [mm], 0 (never)..
     *   ROOMSEG_MAX_HALL_MM, default 1600, are one room, unless they share 600 mm of wall or
     *   more, which is a door's frame. That width is the one of the rectangle with the same second
     *   moments, so that neither furniture nor a bay counts for much, nor the direction;
     * - without a shared wall are one room from the opening open_plan_percent on: 1..100, the
     *   same measure as room_opening_percent; default 50;
     * - whose common border is longer than a door is wide, door_mm [mm], 0..
     *   ROOMSEG_MAX_DOOR_MM, default 950, are one room, too, when they share at most half as
     *   much wall and the opening is passage_opening_percent or more;
     * - with a shorter border and at least 300 mm of shared wall stay two rooms.
     * The middle two do not join a hall that is twice as long as wide or longer to what is none,
     * nor what has too few walls of its own (unwalled_percent) to anything. */
    uint32_t lived_in_permille;
    uint32_t open_plan_percent;
    uint32_t door_mm;
    uint32_t hall_mm;

    /* What was only seen through a window or an open door is no room: its border consists
     * of walls (cells of occupied_min or more) by less than this percentage of the share
     * that walls have in the border of the whole map. Such rooms below a tenth of the whole
     * area are dropped (label 0) when they lead nowhere else; below a fifth of it, when it is
     * less than half of that percentage, wherever they lead. Where walls make up less than 35 % of the whole border, the map does
     * not mark its walls, and nothing is dropped. 0 (keep all)..100; default 50. */
    uint32_t unwalled_percent;

    /* Read by the paper profile only, up to longest_border_mm.
     * Obstacles are grown by this much before the seeds are found [mm, rounded to whole
     * cells], 0..ROOMSEG_MAX_DILATION_MM; default 120 = 3 cells of 4 cm. */
    uint32_t dilation_mm;

    /* A cell is a seed while the blur leaves it at most this share of obstacles [1/1000],
     * 0..499; default 50. */
    uint32_t seed_obstacle_permille;

    /* Two regions are one when their shared border is longer than this [mm],
     * 0..ROOMSEG_MAX_BORDER_MM; default 3000. */
    uint32_t longest_border_mm;

    /* Capacities; the arena grows with them (see ROOMSEG_ARENA_SIZE). More regions
     * or rooms than these end the run with ROOMSEG_ERR_REGIONS / _ROOMS; so do more than
     * 3 * max_regions pairs of regions that touch or share a wall.
     * max_regions: 1..ROOMSEG_MAX_REGIONS, default 1024.
     * max_rooms: 1..max_regions and ROOMSEG_MAX_ROOMS, default 255. */
    uint32_t max_regions;
    uint32_t max_rooms;

    roomseg_progress_fn progress; /* may be NULL; default NULL */
    void *progress_user;          /* handed to progress as it is */
} roomseg_config;


/* One room. Positions in cells of the caller's grid. */
typedef struct roomseg_room {
    uint16_t label;               /* 1..room_count; rooms[i].label == i + 1 */
    uint16_t link_count;          /* number of adjacent rooms */
    uint32_t link_first;          /* links[link_first .. link_first + link_count - 1]
                                     are the indices of this room's doorways */
    uint32_t area_cells;          /* cells that carry the label, >= 1 */
    uint32_t area_cm2;            /* the same in cm2, rounded down; saturates */
    uint32_t centroid_x_q8;       /* mean x of the cells in 1/256 cell, rounded down */
    uint32_t centroid_y_q8;       /* mean y; may lie outside an L-shaped room */
    uint16_t min_x, min_y;        /* bounding box, both ends inside */
    uint16_t max_x, max_y;
    uint16_t interior_x;          /* a cell of this room, far from walls: its inscribed */
    uint16_t interior_y;          /* circle is the largest (up to integer rounding) */
    uint16_t inscribed_radius_mm; /* distance from there to the nearest obstacle; saturates */
} roomseg_room;

/* Where two rooms touch. One record for each pair of adjacent rooms. */
typedef struct roomseg_doorway {
    uint16_t room_a, room_b; /* labels, room_a < room_b */
    uint16_t x, y;           /* middle of the opening: a cell where both rooms meet; where the
                                pair has several openings, of the widest */
    uint32_t width_mm;       /* clear width there, from wall to wall */
    uint32_t border_cells;   /* pairs of 4-adjacent cells that the two rooms share; paper
                                profile: cells of the border line between them */
} roomseg_doorway;

/* What a run found. The arrays lie in the arena and stay valid until the arena is
 * used again. Largest room first; equal areas in reading order of their first cell. */
typedef struct roomseg_result {
    const roomseg_room *rooms;
    const roomseg_doorway *doorways; /* sorted by (room_a, room_b) */
    const uint16_t *links;           /* doorway indices, grouped by room, see link_first */
    uint32_t room_count;
    uint32_t doorway_count;
    uint32_t region_count;           /* regions before merging, for tuning max_regions */
    uint16_t crop_x, crop_y;         /* the crop's first cell in the grid ... */
    uint16_t crop_width, crop_height; /* ... and size; all 0 when no cell is free */
    int32_t wall_angle;              /* with config.align: direction of most walls, from the x
                                        axis towards the y axis, -4500..4499 hundredths of a
                                        degree; below 100 either way the grid was not turned */
    size_t arena_used;               /* bytes of the arena that this run needed */
} roomseg_result;

/* The default profile's parameters. */
roomseg_config roomseg_config_default(void);

/* The paper profile's: those published for the benchmark, without alignment. */
roomseg_config roomseg_config_paper(void);

/* The same as published for homes: with alignment, and obstacles below 4 m2 shape nothing, so
 * that furniture does not part a room (and a free-standing piece of wall does not either). */
roomseg_config roomseg_config_paper_home(void);

/* Arena bytes for any grid whose free cells fit in a box of width x height cells;
 * equals ROOMSEG_ARENA_SIZE() or ROOMSEG_ARENA_SIZE_PAPER() of the same numbers.
 * Fails iff: config or bytes is NULL (ERR_NULL); width or height is 0 or above
 * ROOMSEG_MAX_SIDE or their product above ROOMSEG_MAX_CROP_CELLS (ERR_GRID_SIZE);
 * resolution_mm is out of range (ERR_RESOLUTION); a field is out of range (ERR_CONFIG).
 * On failure *bytes is 0. */
int roomseg_arena_size(const roomseg_config *config, uint32_t width, uint32_t height,
                       uint32_t resolution_mm, size_t *bytes);

/* Arena bytes for exactly this grid: finds the crop by reading each cell once.
 * Fails iff: as roomseg_arena_size, or grid or grid->cells is NULL, or
 * grid->stride < grid->width (ERR_STRIDE). A grid without a free cell needs 0 bytes. */
int roomseg_arena_size_for_grid(const roomseg_config *config, const roomseg_grid *grid,
                                size_t *bytes);

/* Segments a grid.
 * labels: width x height cells, label of (x, y) = labels[y * label_stride + x];
 *   0 = no room (obstacle, unknown, dropped free space), 1..room_count otherwise. label_stride in
 *   elements, >= width. Cells between width and label_stride are not touched.
 * arena: arena_size bytes, aligned to ROOMSEG_ARENA_ALIGN; contents need no
 *   preparation and mean nothing afterwards but for what *result points to. May be NULL
 *   when arena_size is 0 (a grid without a free cell).
 * grid->cells, labels and arena must not overlap.
 * Fails iff: a pointer is NULL (ERR_NULL); the grid is invalid (ERR_GRID_SIZE, ERR_STRIDE,
 * ERR_RESOLUTION); a field is out of range (ERR_CONFIG); the arena is misaligned or too
 * small (ERR_ARENA_ALIGN, ERR_ARENA_SIZE); a capacity is exceeded (ERR_REGIONS, ERR_ROOMS);
 * the hook cancels (ERR_CANCELLED).
 * On failure *result is zeroed except that arena_used holds the need after
 * ERR_ARENA_SIZE and region_count the count so far after ERR_REGIONS. After ERR_REGIONS,
 * ERR_ROOMS and ERR_CANCELLED every label is 0; after the other errors labels is
 * untouched. The arena can be used again at once. */
int roomseg_run(const roomseg_config *config, const roomseg_grid *grid, uint16_t *labels,
                uint32_t label_stride, roomseg_result *result, void *arena,
                size_t arena_size);

#ifdef __cplusplus
}
#endif
#endif
