#include "components.h"

/* One reading of the map. */
typedef struct sweep {
    const rs_frame *frame;
    uint8_t *surface;
    uint8_t value; /* of the cells whose components are sought */
    rs_component_limits limits;
    uint32_t *stack;       /* NULL: nothing is cleared */
    rs_ticker *ticker;
    uint32_t count, total; /* components that have ended, and their area */
} sweep;

/* Slots for the components that reach the row in work or the one above it. */
typedef struct slots {
    rs_component *components;
    uint16_t *active; /* slots in use */
    uint16_t *vacant; /* a stack of free ones */
    uint32_t active_count, vacant_count;
} slots;

rs_component_limits rs_components_limits(const roomseg_config *config, uint32_t resolution_mm)
{
    rs_component_limits limits;

    limits.speck_cells = rs_cells_of_area(config->speck_mm2, resolution_mm);
    limits.clutter_cells = config->clutter_mm / resolution_mm;
    limits.diagonal = true; /* the free space is 4-connected: a diagonal wall is tight */
    return limits;
}

static uint16_t find_root(rs_component *components, uint16_t slot)
{
    while (components[slot].parent != slot) {
        components[slot].parent = components[components[slot].parent].parent;
        slot = components[slot].parent;
    }
    return slot;
}

static uint16_t take_slot(slots *s)
{
    uint16_t slot = s->vacant[--s->vacant_count];

    s->active[s->active_count++] = slot;
    return slot;
}

static uint32_t add_area(uint32_t a, uint32_t b)
{
    return rs_min_u32(a + b, RS_COMPONENT_OPEN); /* both <= 2^30: no overflow */
}

static uint16_t unite(rs_component *components, uint16_t a, uint16_t b)
{
    rs_component *into = &components[a];
    const rs_component *from = &components[b];

    if (a == b) {
        return a;
    }
    into->area = add_area(into->area, from->area);
    into->min_x = into->min_x < from->min_x ? into->min_x : from->min_x;
    into->max_x = into->max_x > from->max_x ? into->max_x : from->max_x;
    into->min_y = into->min_y < from->min_y ? into->min_y : from->min_y;
    into->max_y = into->max_y > from->max_y ? into->max_y : from->max_y;
    components[b].parent = a;
    return a;
}

static uint32_t find_runs(const uint8_t *row, uint32_t width, uint8_t value, rs_run *runs)
{
    uint8_t other = value == 0u;
    uint32_t count = 0;
    uint32_t x = rs_skip(row, 0, width, other);

    while (x < width) {
        runs[count].first = (uint16_t)x;
        x = rs_skip(row, x + 1u, width, value);
        runs[count].last = (uint16_t)(x - 1u);
        count++;
        x = rs_skip(row, rs_min_u32(x + 1u, width), width, other);
    }
    return count;
}

/* Cells of a run, RS_COMPONENT_OPEN of one that touches the border. */
static uint32_t run_area(const rs_frame *frame, const rs_run *run, uint32_t y)
{
    bool at_border = y - 1u >= frame->height || run->first == 0u || run->last > frame->width;

    return at_border ? RS_COMPONENT_OPEN : (uint32_t)run->last - run->first + 1u;
}

/* The run as a component of its own. */
static void start_component(const rs_frame *frame, const rs_run *run, uint32_t y,
                            uint16_t slot, rs_component *c)
{
    c->area = run_area(frame, run, y);
    c->min_x = run->first;
    c->max_x = run->last;
    c->min_y = (uint16_t)y;
    c->max_y = (uint16_t)y;
    c->anchor_x = run->first;
    c->anchor_y = (uint16_t)y;
    c->parent = slot;
    c->unused = 0;
}

/* The run as a part of a component that reaches row y - 1. */
static void extend_component(const rs_frame *frame, const rs_run *run, uint32_t y,
                             rs_component *c)
{
    c->area = add_area(c->area, run_area(frame, run, y));
    c->min_x = c->min_x < run->first ? c->min_x : run->first;
    c->max_x = c->max_x > run->last ? c->max_x : run->last;
    c->max_y = (uint16_t)y;
}

/* Gives every run of row y a component: that of the first run above that shares a column with
 * it or, with reach 1, touches it at a corner, joined with those of all others that do; one of
 * its own where there is none. */
static void join_row(const rs_frame *frame, uint32_t reach, const rs_run *above,
                     uint32_t above_count, rs_run *runs, uint32_t count, uint32_t y, slots *s)
{
    uint32_t i = 0;
    bool united = false;

    for (uint32_t j = 0; j < count; j++) {
        uint16_t component;

        while (i < above_count && above[i].last + reach < runs[j].first) {
            i++;
        }
        if (i == above_count || above[i].first > runs[j].last + reach) {
            component = take_slot(s);
            start_component(frame, &runs[j], y, component, &s->components[component]);
        } else {
            component = find_root(s->components, above[i].component);
            extend_component(frame, &runs[j], y, &s->components[component]);
            /* A run above that reaches farther may touch the next run, too. */
            while (above[i].last + reach <= runs[j].last && ++i < above_count &&
                   above[i].first <= runs[j].last + reach) {
                component = unite(s->components, component,
                                  find_root(s->components, above[i].component));
                united = true;
            }
        }
        runs[j].component = component;
    }
    for (uint32_t j = 0; united && j < count; j++) {
        runs[j].component = find_root(s->components, runs[j].component);
    }
}

/* Noise is told by its area alone. Clutter is compact: neither side of its bounding box
 * more than twice the other, and a third of the box filled; a piece of a wall is not. */
static bool is_small(const rs_component *c, rs_component_limits limits)
{
    uint32_t wide = (uint32_t)c->max_x - c->min_x + 1u;
    uint32_t high = (uint32_t)c->max_y - c->min_y + 1u;

    if (c->area == RS_COMPONENT_OPEN) {
        return false;
    }
    return c->area < limits.speck_cells ||
           (rs_max_u32(wide, high) <= limits.clutter_cells && wide <= 2u * high &&
            high <= 2u * wide && 3u * c->area >= wide * high);
}

/* Turns all cells of a small component, from its anchor outwards. A cell enters the stack
 * once, so the stack needs no more than the component's area. */
static int clear_component(const sweep *w, const rs_component *c)
{
    uint32_t depth = 0, stride = w->frame->stride, neighbours = w->limits.diagonal ? 8u : 4u;
    uint8_t value = w->value, other = value == 0u;
    const uint32_t step[8] = {1u,      0u - 1u,      stride,      0u - stride, /* modulo 2^32 */
                              stride + 1u, stride - 1u, 1u - stride, 0u - stride - 1u};

    w->stack[depth++] = c->anchor_y * stride + c->anchor_x;
    w->surface[w->stack[0]] = other;
    while (depth > 0u) {
        uint32_t cell = w->stack[--depth];

        if (rs_tick(w->ticker, 1, c->max_y, w->frame->height + 2u)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        for (uint32_t k = 0; k < neighbours; k++) {
            uint32_t next = cell + step[k];
            if (w->surface[next] == value) {
                w->surface[next] = other;
                w->stack[depth++] = next;
            }
        }
    }
    return ROOMSEG_OK;
}

/* Ends the components that do not reach row y: clears the small ones, frees their slots
 * and those of components that were joined to others. */
static int end_components(sweep *w, uint32_t y, slots *s)
{
    uint32_t kept = 0;
    int status = ROOMSEG_OK;

    for (uint32_t i = 0; i < s->active_count; i++) {
        uint16_t slot = s->active[i];
        const rs_component *c = &s->components[slot];

        if (c->parent == slot && c->max_y == y) {
            s->active[kept++] = slot;
            continue;
        }
        if (c->parent == slot) {
            w->count++;
            w->total += c->area;
            if (status == ROOMSEG_OK && w->stack != NULL && is_small(c, w->limits)) {
                status = clear_component(w, c);
            }
        }
        s->vacant[s->vacant_count++] = slot;
    }
    s->active_count = kept;
    return status;
}

static int run_sweep(sweep *w, const rs_component_scratch *scratch)
{
    const rs_frame *frame = w->frame;
    uint32_t capacity = 2u * (uint32_t)ROOMSEG_PLAN_RUNS(frame->width);
    rs_run *above = scratch->runs;
    rs_run *runs = scratch->runs + capacity / 2u;
    uint32_t above_count = 0;
    slots s = {scratch->components, scratch->active, scratch->vacant, 0, 0};

    while (s.vacant_count < capacity) {
        s.vacant[s.vacant_count] = (uint16_t)s.vacant_count;
        s.vacant_count++;
    }
    for (uint32_t y = 0; y < frame->height + 2u; y++) {
        const uint8_t *row = w->surface + (size_t)y * frame->stride;
        uint32_t count;
        rs_run *swap;

        if (rs_tick(w->ticker, frame->width, y, frame->height + 2u)) {
            return ROOMSEG_ERR_CANCELLED;
        }
        count = find_runs(row, frame->stride, w->value, runs);
        join_row(frame, w->limits.diagonal ? 1u : 0u, above, above_count, runs, count, y, &s);
        if (end_components(w, y, &s) != ROOMSEG_OK) {
            return ROOMSEG_ERR_CANCELLED;
        }
        swap = above;
        above = runs;
        runs = swap;
        above_count = count;
    }
    return ROOMSEG_OK;
}

int rs_components_clear_small(const rs_frame *frame, rs_component_limits limits,
                              uint8_t *surface, const rs_component_scratch *scratch,
                              rs_ticker *ticker)
{
    sweep w = {frame, surface, 0, limits, scratch->stack, ticker, 0, 0};

    return run_sweep(&w, scratch);
}

int rs_components_drop_islands(const rs_frame *frame, uint32_t cells, uint8_t *surface,
                               const rs_component_scratch *scratch, rs_ticker *ticker)
{
    sweep w = {frame, surface, 1, {cells, 0, false}, scratch->stack, ticker, 0, 0};

    return run_sweep(&w, scratch);
}

int rs_components_keep_large_free(const rs_frame *frame, uint8_t *surface,
                                  const rs_component_scratch *scratch, rs_ticker *ticker)
{
    sweep w = {frame, surface, 1, {0, 0, true}, NULL, ticker, 0, 0};
    int status = run_sweep(&w, scratch);

    if (status != ROOMSEG_OK || w.count < 2u) {
        return status;
    }
    w.limits.speck_cells = (w.total + w.count - 1u) / w.count;
    w.stack = scratch->stack;
    return run_sweep(&w, scratch);
}
