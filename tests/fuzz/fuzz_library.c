/* Any grid, config, arena and hook: what the header promises of a run holds.
 * The address sanitizer watches grid, labels and arena, which end where the header says. */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "config_fields.h"
#include "reference.h"
#include "run.h"
#include "scenario.h"
#include "unity.h"

#define LABEL_FILL 0xABABu
#define ARENA_FILL 0xEE

typedef struct hook_state {
    uint32_t calls, cancel_at;
    roomseg_stage stage;
    unsigned permille;
} hook_state;

/* Stages come in their order, and the share done never falls within one. */
static int hook(void *user, roomseg_stage stage, unsigned permille)
{
    hook_state *state = user;
    TEST_ASSERT_TRUE(permille <= 1000u && stage < ROOMSEG_STAGE_COUNT);
    TEST_ASSERT_TRUE(state->calls == 0 || stage >= state->stage);
    TEST_ASSERT_TRUE(state->calls == 0 || stage > state->stage || permille >= state->permille);
    state->stage = stage;
    state->permille = permille;
    state->calls++;
    return state->calls == state->cancel_at;
}

/* The memory of a scenario. */
typedef struct memory {
    uint16_t *labels;
    size_t label_count;
    uint8_t *block; /* the arena lies `shift` bytes behind its start and reaches to its end */
    size_t shift, arena_size;
} memory;

static memory memory_make(const scenario *s, size_t arena_size)
{
    memory m;
    m.label_count = (size_t)(s->grid.height - 1) * s->label_stride + s->grid.width;
    m.labels = malloc(m.label_count * sizeof *m.labels);
    m.shift = 8u * s->arena_shift;
    m.arena_size = arena_size;
    m.block = malloc(arena_size + m.shift + (arena_size + m.shift == 0));
    TEST_ASSERT_TRUE(m.labels != NULL && m.block != NULL);
    memset(m.block, ARENA_FILL, arena_size + m.shift);
    return m;
}

static void memory_free(memory *m)
{
    free(m->labels);
    free(m->block);
}

static int call(const scenario *s, const roomseg_config *config, memory *m, size_t arena_size,
                roomseg_result *result)
{
    for (size_t i = 0; i < m->label_count; i++) {
        m->labels[i] = LABEL_FILL;
    }
    memset(result, 0x5A, sizeof *result);
    return roomseg_run(config, &s->grid, m->labels, s->label_stride, result, m->block + m->shift,
                       arena_size);
}

/* The first bytes are as memory_make() filled them. */
static void check_untouched(const uint8_t *block, size_t size)
{
    TEST_ASSERT_TRUE(size == 0 || block[0] == ARENA_FILL);
    TEST_ASSERT_TRUE(size == 0 || memcmp(block, block + 1, size - 1) == 0);
}

/* Each cell's label is `value`, and gaps between rows are as they were. */
static void check_labels_are(const scenario *s, const memory *m, uint16_t value)
{
    for (size_t i = 0; i < m->label_count; i++) {
        uint16_t expected = i % s->label_stride < s->grid.width ? value : LABEL_FILL;
        TEST_ASSERT_EQUAL_UINT(expected, m->labels[i]);
    }
    check_untouched(m->block, m->shift);
}

/* What the header says of result after a failure. */
static void check_failure(const scenario *s, const memory *m, int status,
                          const roomseg_result *result)
{
    roomseg_result expected;
    memset(&expected, 0, sizeof expected);
    if (status == ROOMSEG_ERR_REGIONS) {
        /* Too many of them, or of pairs of them. */
        uint64_t count = result->region_count, most = s->config.max_regions;
        TEST_ASSERT_TRUE(count > most || count * (count - 1u) / 2u > 3u * most);
        expected.region_count = result->region_count;
    } else if (status == ROOMSEG_ERR_ARENA_SIZE) {
        TEST_ASSERT_EQUAL_UINT(m->arena_size, result->arena_used);
        expected.arena_used = result->arena_used;
    }
    TEST_ASSERT_EQUAL_INT(0, memcmp(&expected, result, sizeof expected));
    bool cleared = status == ROOMSEG_ERR_REGIONS || status == ROOMSEG_ERR_ROOMS ||
                   status == ROOMSEG_ERR_CANCELLED;
    check_labels_are(s, m, cleared ? 0 : LABEL_FILL);
}

/* A successful run as the checks of tests/support want it; labels without gaps. */
static run run_of(const scenario *s, const memory *m, const roomseg_result *result)
{
    run r;
    memset(&r, 0, sizeof r);
    r.config = s->config;
    r.grid = s->grid;
    r.arena_size = m->arena_size;
    r.result = *result;
    r.labels = malloc((size_t)s->grid.width * s->grid.height * sizeof *r.labels);
    TEST_ASSERT_NOT_NULL(r.labels);
    for (uint32_t y = 0; y < s->grid.height; y++) {
        memcpy(r.labels + (size_t)y * s->grid.width, m->labels + (size_t)y * s->label_stride,
               s->grid.width * sizeof *r.labels);
    }
    return r;
}

/* The paper profile leaves cells beside walls and lines between rooms without label. */
static void check_paper(const run *r)
{
    size_t cells = (size_t)r->grid.width * r->grid.height;
    for (size_t i = 0; i < cells; i++) {
        TEST_ASSERT_TRUE(r->labels[i] <= r->result.room_count);
        size_t at = i / r->grid.width * r->grid.stride + i % r->grid.width;
        TEST_ASSERT_TRUE(r->labels[i] == 0 || r->grid.cells[at] < r->config.occupied_min);
    }
    check_rooms(r, NULL);
    check_doorways(r, NULL);
}

static void check_default(const run *r)
{
    uint8_t *kinds = reference_kinds(&r->config, &r->grid);
    check_records(r, kinds);
    if (r->config.unwalled_percent == 0) {
        check_dropped(r, kinds);
    }
    free(kinds);
}

static void check_success(const scenario *s, const memory *m, const roomseg_result *result)
{
    for (size_t i = 0; i < m->label_count; i++) {
        TEST_ASSERT_TRUE(i % s->label_stride < s->grid.width || m->labels[i] == LABEL_FILL);
    }
    check_untouched(m->block, m->shift);
    run r = run_of(s, m, result);
    if (s->config.profile == ROOMSEG_PROFILE_PAPER) {
        check_paper(&r);
    } else {
        check_default(&r);
    }
    free(r.labels);
}

static uint64_t mix(uint64_t sum, const void *bytes, size_t size)
{
    const uint8_t *at = bytes;
    for (size_t i = 0; i < size; i++) {
        sum = (sum ^ at[i]) * 1099511628211u; /* FNV-1a */
    }
    return sum;
}

/* What a record holds before the padding at its end. */
#define ROOM_BYTES (offsetof(roomseg_room, inscribed_radius_mm) + sizeof(uint16_t))

/* A number that depends on all that a run gave. */
static uint64_t sum_of(const memory *m, int status, const roomseg_result *result)
{
    roomseg_result bare = *result;
    bare.rooms = NULL;
    bare.doorways = NULL;
    bare.links = NULL;
    uint64_t sum = mix(14695981039346656037u, &status, sizeof status);
    sum = mix(sum, &bare, sizeof bare);
    sum = mix(sum, m->labels, m->label_count * sizeof *m->labels);
    for (uint32_t i = 0; i < result->room_count; i++) {
        sum = mix(sum, &result->rooms[i], ROOM_BYTES);
    }
    if (result->doorway_count > 0) {
        sum = mix(sum, result->doorways, result->doorway_count * sizeof *result->doorways);
        sum = mix(sum, result->links, 2 * result->doorway_count * sizeof *result->links);
    }
    return sum;
}

/* An arena too small or misaligned is refused and nothing is written. */
static void check_refusals(const scenario *s, memory *m)
{
    roomseg_result result;
    int status = call(s, &s->config, m, m->arena_size - 1, &result);
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ARENA_SIZE, status);
    check_failure(s, m, status, &result);
    m->shift++;
    status = call(s, &s->config, m, m->arena_size - 1, &result);
    m->shift--;
    TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_ARENA_ALIGN, status);
    check_failure(s, m, status, &result);
    check_untouched(m->block, m->shift + m->arena_size);
}

/* A run that is cancelled leaves nothing behind. */
static void check_cancelled(const scenario *s, memory *m)
{
    roomseg_config config = s->config;
    hook_state state = {0, s->cancel_at, ROOMSEG_STAGE_THRESHOLD, 0};
    roomseg_result result;
    config.progress = hook;
    config.progress_user = &state;
    int status = call(s, &config, m, m->arena_size, &result);
    if (s->cancel_at > 0 && state.calls >= s->cancel_at) {
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CANCELLED, status);
        TEST_ASSERT_EQUAL_UINT(s->cancel_at, state.calls);
    }
    if (status != ROOMSEG_OK) {
        check_failure(s, m, status, &result);
    }
}

static void check_runs(const scenario *s, size_t need)
{
    memory m = memory_make(s, need);
    roomseg_result result;
    if (need > 0) {
        check_refusals(s, &m);
    }
    int status = call(s, &s->config, &m, need, &result);
    uint64_t sum = sum_of(&m, status, &result);
    if (status == ROOMSEG_OK) {
        check_success(s, &m, &result);
    } else {
        TEST_ASSERT_TRUE(status == ROOMSEG_ERR_REGIONS || status == ROOMSEG_ERR_ROOMS);
        check_failure(s, &m, status, &result);
    }
    check_cancelled(s, &m);
    status = call(s, &s->config, &m, need, &result);
    TEST_ASSERT_EQUAL_UINT64(sum, sum_of(&m, status, &result));
    memory_free(&m);
}

static bool in_range(const roomseg_config *config)
{
    for (size_t i = 0; i < config_field_count; i++) {
        const config_field *field = &config_fields[i];
        const uint8_t *at = (const uint8_t *)config + field->offset;
        uint32_t value = *at;
        if (field->size > 1) {
            memcpy(&value, at, sizeof value);
        }
        /* The table's ends of these three are those with the other fields at their defaults. */
        bool relative = field->offset == offsetof(roomseg_config, free_max) ||
                        field->offset == offsetof(roomseg_config, occupied_min);
        uint32_t high = field->offset == offsetof(roomseg_config, max_rooms) ? ROOMSEG_MAX_ROOMS
                                                                            : field->high;
        if (!relative && (value < field->low || value > high)) {
            return false;
        }
    }
    return config->free_max < config->occupied_min && config->max_rooms <= config->max_regions;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    scenario s = scenario_make(bytes, size);
    size_t need = 1;
    int status = roomseg_arena_size_for_grid(&s.config, &s.grid, &need);
    if (!in_range(&s.config)) {
        memory m = memory_make(&s, 64);
        roomseg_result result;
        TEST_ASSERT_TRUE(s.wild);
        TEST_ASSERT_EQUAL_INT(ROOMSEG_ERR_CONFIG, status);
        TEST_ASSERT_EQUAL_UINT(0, need);
        TEST_ASSERT_EQUAL_INT(status, call(&s, &s.config, &m, 64, &result));
        check_failure(&s, &m, status, &result);
        memory_free(&m);
    } else {
        TEST_ASSERT_EQUAL_INT(ROOMSEG_OK, status);
        if (need <= SCENARIO_MAX_ARENA) {
            check_runs(&s, need);
        }
    }
    scenario_free(&s);
    return 0;
}
