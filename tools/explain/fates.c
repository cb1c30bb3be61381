#include "fates.h"

#include <stdlib.h>
#include <string.h>

/* What an entry of `touches` says. */
enum { TOUCHES_REGION = 1, TOUCHES_ROOT = 2 };

/* Sums up the roots' cells, and marks what touches another region, and another root. */
static void look_at_regions(const observation *o, fates *f, uint64_t *area, uint8_t *touches) {
    for (uint32_t i = 0; i < o->before.edge_count; i++) {
        const rs_edge *edge = &o->before.edges[i];
        uint16_t a = root_of(o, edge->a);
        uint16_t b = root_of(o, edge->b);
        if (edge->border > 0) {
            touches[edge->a] |= TOUCHES_REGION;
            touches[edge->b] |= TOUCHES_REGION;
        }
        if (edge->border > 0 && a != b) {
            touches[a] |= TOUCHES_ROOT;
            touches[b] |= TOUCHES_ROOT;
        }
    }
    for (uint32_t r = 1; r <= o->before.region_count; r++) {
        uint32_t cells = o->before.regions[r].area;
        area[root_of(o, (uint16_t)r)] += cells;
        f->regions += cells > 0;
        f->islands += cells > 0 && (touches[r] & TOUCHES_REGION) == 0;
    }
}

static void settle(const observation *o, const uint64_t *area, const uint8_t *touches,
                   fates *f) {
    for (uint32_t r = 1; r <= o->before.region_count; r++) {
        uint16_t root = root_of(o, (uint16_t)r);
        int kept = o->after.regions[root].area > 0;
        f->of[r] = kept                                   ? FATE_ROOM
                   : (touches[root] & TOUCHES_ROOT) != 0 ? FATE_UNWALLED
                                                         : FATE_ALONE;
        if (root == r && area[r] > 0) {
            f->roots[f->of[r]]++;
            f->cells[f->of[r]] += area[r];
        }
    }
}

int fates_find(const observation *o, fates *out) {
    size_t count = (size_t)o->before.region_count + 1;
    memset(out, 0, sizeof *out);
    uint64_t *area = calloc(count, sizeof *area);
    uint8_t *touches = calloc(count, 1);
    out->of = calloc(count, 1);
    int rc = area != NULL && touches != NULL && out->of != NULL ? 0 : -1;
    if (rc == 0) {
        look_at_regions(o, out, area, touches);
        settle(o, area, touches, out);
    } else {
        fates_free(out);
    }
    free(area);
    free(touches);
    return rc;
}

void fates_free(fates *f) {
    free(f->of);
    memset(f, 0, sizeof *f);
}
