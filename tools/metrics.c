#include "metrics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "expected_mi.h"
#include "partition.h"

/* Relative error that sums over a map may gather; their true size is far above. */
static const double ROUNDING = 1e-12;

/* Place of a figure in the record; its name in JSON is that of the member. */
#define FIELD(member, title) {#member, title, offsetof(metrics, member)}

const metric_field metric_fields[METRIC_COUNT] = {
    [METRIC_UNDER_PAINTING] = FIELD(under_painting, "under-painting"),
    [METRIC_RECALL] = FIELD(recall, "recall"),
    [METRIC_COMPLETENESS] = FIELD(completeness, "completeness"),
    [METRIC_PRECISION] = FIELD(precision, "precision"),
    [METRIC_HOMOGENEITY] = FIELD(homogeneity, "homogeneity"),
    [METRIC_V] = FIELD(v, "V"),
    [METRIC_AMI] = FIELD(ami, "AMI"),
    [METRIC_NMI] = FIELD(nmi, "NMI"),
    [METRIC_ARI] = FIELD(ari, "ARI"),
    [METRIC_FMI] = FIELD(fmi, "FMI"),
    [METRIC_IOU] = FIELD(iou, "IoU"),
    [METRIC_STRICT_V] = FIELD(strict_v, "strict V"),
    [METRIC_ROOM_RECALL] = FIELD(room_recall, "room recall"),
    [METRIC_ROOM_PRECISION] = FIELD(room_precision, "room precision"),
    [METRIC_ROOM_F1] = FIELD(room_f1, "room F1"),
};

double metrics_get(const metrics *m, size_t index) {
    double value;
    memcpy(&value, (const char *)m + metric_fields[index].offset, sizeof value);
    return value;
}

static double entropy(const part *parts, size_t count, uint64_t total) {
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        double share = (double)parts[i].cells / (double)total;
        sum -= share * log(share);
    }
    return count > 1 ? sum : 0.0;
}

/* What the entropy-based figures share. */
typedef struct information {
    double mutual, rows, columns;
    double homogeneity, completeness, v;
} information;

static double mutual_information(const partition *p) {
    double sum = 0.0;
    for (size_t i = 0; i < p->pair_count; i++) {
        double n = (double)p->pairs[i].cells;
        double a = (double)p->rows[p->pairs[i].row].cells;
        double b = (double)p->columns[p->pairs[i].column].cells;
        /* Both quotients are near 1 where the partitions agree: the logarithm of their
         * product would lose digits that the sum of two keeps. */
        sum += n * (log(n / a) + log((double)p->total / b));
    }
    return sum > 0.0 ? sum / (double)p->total : 0.0;
}

static information measure_information(const partition *p) {
    information info = {mutual_information(p),
                        entropy(p->rows, p->row_count, p->total),
                        entropy(p->columns, p->column_count, p->total),
                        1.0, 1.0, 0.0};
    info.mutual = fmin(info.mutual, fmin(info.rows, info.columns)); /* but for rounding */
    if (info.rows > 0.0) {
        info.homogeneity = info.mutual / info.rows;
    }
    if (info.columns > 0.0) {
        info.completeness = info.mutual / info.columns;
    }
    double sum = info.homogeneity + info.completeness;
    if (sum > 0.0) {
        info.v = 2.0 * info.homogeneity * info.completeness / sum;
    }
    return info;
}

static int adjusted_mutual_information(const partition *p, const information *info,
                                       double *out) {
    if (p->row_count == 1 || p->column_count == 1) {
        *out = p->row_count == p->column_count ? 1.0 : 0.0;
        return 0;
    }
    uint64_t *sizes = malloc((p->row_count + p->column_count) * sizeof *sizes);
    if (sizes == NULL) {
        return -1;
    }
    for (size_t i = 0; i < p->row_count; i++) {
        sizes[i] = p->rows[i].cells;
    }
    for (size_t j = 0; j < p->column_count; j++) {
        sizes[p->row_count + j] = p->columns[j].cells;
    }
    double expected = expected_mutual_information(
        sizes, p->row_count, sizes + p->row_count, p->column_count, p->total);
    free(sizes);
    /* Where every cell is a part of its own on both sides, nothing is left to chance and
     * this is 0 / 0 but for rounding. */
    double mean = (info->rows + info->columns) / 2.0;
    double most = mean - expected;
    *out = most > ROUNDING * mean ? (info->mutual - expected) / most : 1.0;
    return 0;
}

/* Number of ordered pairs of different cells in the same part. */
static double pairs_within(uint64_t cells) {
    return (double)cells * ((double)cells - 1.0);
}

static void measure_pairs(const partition *p, metrics *out) {
    double same_both = 0.0;
    double same_room = 0.0;
    double same_label = 0.0;
    for (size_t i = 0; i < p->pair_count; i++) {
        same_both += pairs_within(p->pairs[i].cells);
    }
    for (size_t i = 0; i < p->row_count; i++) {
        same_room += pairs_within(p->rows[i].cells);
    }
    for (size_t j = 0; j < p->column_count; j++) {
        same_label += pairs_within(p->columns[j].cells);
    }
    double tp = same_both;
    double fn = same_room - same_both;
    double fp = same_label - same_both;
    double tn = pairs_within(p->total) - tp - fn - fp;
    out->ari = 1.0;
    if (fn > 0.0 || fp > 0.0) {
        out->ari = 2.0 * (tp * tn - fn * fp) /
                   ((tp + fn) * (fn + tn) + (tp + fp) * (fp + tn));
    }
    out->fmi = tp > 0.0 ? sqrt(tp / same_room) * sqrt(tp / same_label) : 0.0;
}

/* Recall and IoU: what the label with the largest overlap is for each room. */
static void measure_rows(const partition *p, metrics *out) {
    double recall = 0.0;
    double iou = 0.0;
    size_t next;
    for (size_t start = 0; start < p->pair_count; start = next) {
        const shared *best = &p->pairs[start];
        for (next = start; next < p->pair_count && p->pairs[next].row == best->row; next++) {
            if (p->pairs[next].cells > best->cells) {
                best = &p->pairs[next];
            }
        }
        double n = (double)best->cells;
        double a = (double)p->rows[best->row].cells;
        double b = (double)p->columns[best->column].cells;
        recall += n / a;
        iou += n / (a + b - n);
    }
    out->recall = recall / (double)p->row_count;
    out->iou = iou / (double)p->row_count;
}

static int measure_precision(const partition *p, metrics *out) {
    uint64_t *best = calloc(p->column_count, sizeof *best);
    if (best == NULL) {
        return -1;
    }
    for (size_t i = 0; i < p->pair_count; i++) {
        const shared *pair = &p->pairs[i];
        if (pair->cells > best[pair->column]) {
            best[pair->column] = pair->cells;
        }
    }
    double sum = 0.0;
    for (size_t j = 0; j < p->column_count; j++) {
        sum += (double)best[j] / (double)p->columns[j].cells;
    }
    out->precision = sum / (double)p->column_count;
    free(best);
    return 0;
}

/* The paper's ten figures over the cells that are true and labelled. */
static int measure_labelled(const contingency *table, metrics *out) {
    partition p;
    if (partition_build(table, 0, &p) != 0) {
        return -1;
    }
    int rc = 0;
    if (p.total > 0) {
        information info = measure_information(&p);
        out->homogeneity = info.homogeneity;
        out->completeness = info.completeness;
        out->v = info.v;
        double mean = (info.rows + info.columns) / 2.0;
        out->nmi = mean > 0.0 ? info.mutual / mean : 1.0;
        measure_pairs(&p, out);
        measure_rows(&p, out);
        rc = measure_precision(&p, out);
        if (rc == 0) {
            rc = adjusted_mutual_information(&p, &info, &out->ami);
        }
    }
    partition_free(&p);
    return rc;
}

static int measure_strict(const contingency *table, metrics *out) {
    partition p;
    if (partition_build(table, KEEP_UNLABELLED, &p) != 0) {
        return -1;
    }
    if (p.total > 0) {
        uint64_t unlabelled = p.columns[0].value == 0 ? p.columns[0].cells : 0;
        out->under_painting = (double)unlabelled / (double)p.total;
        if (unlabelled < p.total) {
            out->strict_v = measure_information(&p).v;
        }
    }
    partition_free(&p);
    return 0;
}

static uint32_t count_parts(const part *parts, size_t count) {
    return (uint32_t)(count - (count > 0 && parts[0].value == 0 ? 1 : 0));
}

static int measure_rooms(const contingency *table, metrics *out) {
    partition p;
    if (partition_build(table, KEEP_UNLABELLED | KEEP_OUTSIDE, &p) != 0) {
        return -1;
    }
    out->rooms_true = count_parts(p.rows, p.row_count);
    out->rooms_found = count_parts(p.columns, p.column_count);
    for (size_t i = 0; i < p.pair_count; i++) {
        const part *row = &p.rows[p.pairs[i].row];
        const part *column = &p.columns[p.pairs[i].column];
        uint64_t n = p.pairs[i].cells;
        if (row->value != 0 && column->value != 0 &&
            2 * n > row->cells + column->cells - n) {
            out->rooms_matched++;
        }
    }
    partition_free(&p);
    if (out->rooms_matched > 0) {
        double matched = out->rooms_matched;
        out->room_recall = matched / out->rooms_true;
        out->room_precision = matched / out->rooms_found;
        out->room_f1 = 2.0 * matched / ((double)out->rooms_true + out->rooms_found);
    }
    return 0;
}

int metrics_compute(const contingency *table, metrics *out) {
    memset(out, 0, sizeof *out);
    if (measure_labelled(table, out) != 0 || measure_strict(table, out) != 0 ||
        measure_rooms(table, out) != 0) {
        memset(out, 0, sizeof *out);
        return -1;
    }
    return 0;
}
