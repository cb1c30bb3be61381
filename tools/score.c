#include "score.h"

#include <string.h>

#include "contingency.h"
#include "truth.h"

int score_labels(const label_image *truth, const label_image *labels, const char *name,
                 score *out, tool_error *error) {
    contingency table;
    memset(out, 0, sizeof *out);
    if (truth->width != labels->width || truth->height != labels->height) {
        tool_error_set(error, "%s: %ux%u cells, but the truth has %ux%u", name,
                       (unsigned)labels->width, (unsigned)labels->height,
                       (unsigned)truth->width, (unsigned)truth->height);
        return -1;
    }
    int rc = contingency_count(truth, labels, &table);
    if (rc == 0) {
        rc = metrics_compute(&table, &out->all);
    }
    if (rc == 0) {
        contingency_drop_specks(&table, TRUTH_SPECK_CELLS);
        rc = metrics_compute(&table, &out->without_specks);
    }
    contingency_free(&table);
    if (rc != 0) {
        tool_error_set(error, "%s: out of memory", name);
        memset(out, 0, sizeof *out);
    }
    return rc;
}
