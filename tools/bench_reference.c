#include "bench_reference.h"

#include <stdlib.h>

#include "dataset.h"
#include "out.h"
#include "score.h"

/* Memory to be freed; NULL when there is none or *failed is set. */
static char *find_labels(const char *folder, const char *set, const char *map, int *failed) {
    char *set_folder = out_join(folder, set);
    if (set_folder == NULL) {
        *failed = 1;
        return NULL;
    }
    char *path = dataset_find_labels(set_folder, map, failed);
    free(set_folder);
    return path == NULL && !*failed ? dataset_find_labels(folder, map, failed) : path;
}

static int score_file(const char *path, uint32_t no_room, const label_image *labels,
                      metrics *out, tool_error *error) {
    label_image reference;
    score s;
    if (label_image_load(path, &reference, error) != 0) {
        return -1;
    }
    if (no_room != 0) {
        label_image_clear(&reference, no_room);
    }
    int rc = -1;
    if (reference.width != labels->width || reference.height != labels->height) {
        tool_error_set(error, "%s: %ux%u cells, but the map has %ux%u", path,
                       (unsigned)reference.width, (unsigned)reference.height,
                       (unsigned)labels->width, (unsigned)labels->height);
    } else if (score_labels(&reference, labels, path, &s, error) == 0) {
        rc = 0;
        *out = s.all;
    }
    label_image_free(&reference);
    if (rc == 0 && out->rooms_true == 0) {
        tool_error_set(error, "%s: holds no room", path);
        rc = -1;
    }
    return rc;
}

int bench_reference_score(const bench_reference *reference, const char *set, const char *map,
                          const label_image *labels, metrics *out, tool_error *error) {
    int failed = 0;
    char *path = find_labels(reference->folder, set, map, &failed);
    int rc = 0;
    if (failed) {
        tool_error_set(error, "%s: out of memory", reference->folder);
        rc = -1;
    } else if (path != NULL) {
        rc = score_file(path, reference->no_room, labels, out, error) == 0 ? 1 : -1;
    }
    free(path);
    return rc;
}
