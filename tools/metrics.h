/* How well labels agree with the truth. Pure arithmetic on the contingency table.
 *
 * N cells lie in a true room and carry a label; n(i,j) of them lie in room i with label j;
 * a(i) = sum_j n(i,j), b(j) = sum_i n(i,j). U true cells carry no label ("under-painted").
 * All figures but the under-painting, the strict V and the last group leave those cells
 * and the cells outside the truth out, and so all rooms without any labelled cell.
 * Logarithms are natural. With
 *     MI = sum_ij n(i,j)/N log(N n(i,j) / (a(i) b(j)))     mutual information
 *     Ht = -sum_i a(i)/N log(a(i)/N),  Hl = -sum_j b(j)/N log(b(j)/N)      entropies
 * the figures are what the evaluation of Sharif, Mohan, Suvarna, "2D Floor Plan
 * Segmentation Based on Down-sampling" (2023) calls by these names; from completeness to
 * FMI they equal scikit-learn's. A map without labelled true cells scores 0 throughout. */
#ifndef ROOMSEG_TOOLS_METRICS_H
#define ROOMSEG_TOOLS_METRICS_H

#include <stdint.h>

#include "contingency.h"

/* Shares from 0 to 1; AMI and ARI may fall below 0. */
typedef struct metrics {
    double under_painting; /* U / (U + N) */
    double recall;         /* mean over rooms i of max_j n(i,j) / a(i): not cut up */
    double completeness;   /* MI / Hl; 1 when Hl = 0 */
    double precision;      /* mean over labels j of max_i n(i,j) / b(j): not run together */
    double homogeneity;    /* MI / Ht; 1 when Ht = 0 */
    double v;              /* 2 H C / (H + C); 0 when H + C = 0 */
    double ami;            /* (MI - E) / ((Ht + Hl)/2 - E), E = the mean MI over all ways to
                              deal out the cells with the same a(i) and b(j). With one
                              room or one label alone: 1 when both are alone, else 0 */
    double nmi;            /* MI / ((Ht + Hl)/2); 1 when both entropies are 0 */
    double ari;            /* 2 (tp tn - fn fp) / ((tp+fn)(fn+tn) + (tp+fp)(fp+tn)), counted
                              over pairs of cells: tp = same room and same label, fn = same
                              room only, fp = same label only, tn = neither */
    double fmi;            /* tp / sqrt((tp + fp) (tp + fn)); 0 when tp = 0 */
    double iou;            /* mean over rooms i of n(i,m) / (a(i) + b(m) - n(i,m)), where m is
                              the label with the largest n(i,m), the lowest one if several */

    double strict_v; /* V with the under-painted cells kept in, as one more label */

    /* Rooms as objects: a room and a label match when they share more than half of what
     * they cover together (IoU > 0.5), all their cells counted: under-painted ones and
     * those outside the truth too. No room or label can match twice. */
    double room_recall;    /* matches / rooms_true */
    double room_precision; /* matches / rooms_found; 0 when none was found */
    double room_f1;        /* 2 matches / (rooms_true + rooms_found) */
    uint32_t rooms_true;   /* rooms of the truth, labelled or not */
    uint32_t rooms_found;  /* labels in use, inside the truth or not */
    uint32_t rooms_matched;
} metrics;

/* The figures in the order above. */
typedef enum metric {
    METRIC_UNDER_PAINTING,
    METRIC_RECALL,
    METRIC_COMPLETENESS,
    METRIC_PRECISION,
    METRIC_HOMOGENEITY,
    METRIC_V,
    METRIC_AMI,
    METRIC_NMI,
    METRIC_ARI,
    METRIC_FMI,
    METRIC_IOU,
    METRIC_PAPER_COUNT, /* those before are the paper's */
    METRIC_STRICT_V = METRIC_PAPER_COUNT,
    METRIC_ROOM_RECALL,
    METRIC_ROOM_PRECISION,
    METRIC_ROOM_F1,
    METRIC_COUNT
} metric;

/* One figure of the record, for tables and loops over all of them. */
typedef struct metric_field {
    const char *name;  /* in JSON: "under_painting" */
    const char *title; /* in tables: "under-painting" */
    size_t offset;     /* of its double in the record */
} metric_field;

extern const metric_field metric_fields[METRIC_COUNT];

/* index: below METRIC_COUNT. */
double metrics_get(const metrics *m, size_t index);

/* Computes all. Fails iff: memory runs out. Returns 0, or -1 with *out zeroed. */
int metrics_compute(const contingency *table, metrics *out);

#endif
