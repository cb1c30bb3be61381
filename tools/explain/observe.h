/* What each stage of a run leaves behind, copied while the library runs.
 *
 * The library is not changed for it: a run calls its progress hook on entering each stage, and
 * at that moment the arena holds what the stage before has left, where the memory plan says.
 * So what is shown is what a firmware's run computes, and a stage that is rewritten inside
 * shows its new results here without a change. */
#ifndef ROOMSEG_EXPLAIN_OBSERVE_H
#define ROOMSEG_EXPLAIN_OBSERVE_H

#include "base.h"
#include "graph.h"
#include "map.h"
#include "segment.h"
#include "tool_error.h"

/* Bordered planes of one byte a cell. */
enum {
    PLANE_FREE,     /* 1 = free, after the threshold */
    PLANE_CLEARED,  /* the same without what is small */
    PLANE_DISTANCE, /* default profile: to the nearest obstacle [RS_DISTANCE_UNIT_MM] */
    PLANE_LIFETIME, /* paper profile: see lifetime.h */
    PLANE_RIDGE,    /* paper profile: see ridge.h */
    PLANE_COUNT
};

/* Labels of the crop, without border and gaps. */
enum {
    LABELS_BACKGROUND, /* paper profile: RS_BACKGROUND on the background's seed */
    LABELS_SEEDS,      /* paper profile: leaf seeds, and the background's */
    LABELS_REGIONS,    /* regions of the watershed; paper profile: with RS_LINE between them */
    LABELS_COUNT
};

typedef struct observation {
    const map *m;   /* the caller's */
    segmentation s; /* the run itself; owned */
    rs_frame frame; /* the crop */
    uint8_t *planes[PLANE_COUNT];     /* NULL: not of this profile; owned */
    uint16_t *labels[LABELS_COUNT];   /* likewise */
    rs_graph before, after;           /* merging; arrays owned */
} observation;

/* Segments a map under observation. config->align must be NULL, and its hook is not used.
 * Fails iff: segment_map fails, no cell is free, or memory runs out. Returns 0, or -1 with
 * *error set and *out zeroed. */
int observe_run(const map *m, const roomseg_config *config, const char *name, observation *out,
                tool_error *error);

/* Frees the copies and zeroes the record. */
void observation_free(observation *o);

/* Value of a plane at a crop cell. */
uint8_t plane_at(const observation *o, int plane, uint32_t x, uint32_t y);

/* Label of a crop cell. */
uint16_t label_at(const observation *o, int labels, uint32_t x, uint32_t y);

/* Label of the room that a crop cell ended in; 0: none. */
uint16_t room_at(const observation *o, uint32_t x, uint32_t y);

/* The region that stands for a merged one in o->after. */
uint16_t root_of(const observation *o, uint16_t region);

#endif
