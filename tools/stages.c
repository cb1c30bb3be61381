#define _POSIX_C_SOURCE 200809L

#include "stages.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The library calls its hook when a stage begins, and at least once in so many visits. */
#define VISITS_PER_CALL 65536u

typedef struct stage_clock {
    int stage; /* in work; -1 before the first */
    double since;
    double ms[ROOMSEG_STAGE_COUNT];
    uint64_t calls[ROOMSEG_STAGE_COUNT]; /* without the one at the stage's beginning */
} stage_clock;

double stages_cpu_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec / 1e6;
}

/* Books the time since the last change of stage. */
static void change_stage(stage_clock *clock, int stage) {
    double now = stages_cpu_ms();
    if (clock->stage >= 0) {
        clock->ms[clock->stage] += now - clock->since;
    }
    clock->stage = stage;
    clock->since = now;
}

static int on_progress(void *user, roomseg_stage stage, unsigned permille) {
    stage_clock *clock = user;
    (void)permille;
    if (clock->stage == (int)stage) {
        clock->calls[stage]++;
    } else {
        change_stage(clock, (int)stage);
    }
    return 0;
}

static int compare_numbers(const void *left, const void *right) {
    const double *a = left;
    const double *b = right;
    return *a < *b ? -1 : *a > *b;
}

static int run_once(const map *m, segmentation *s, stage_clock *clock) {
    roomseg_config config = s->config;
    memset(clock, 0, sizeof *clock);
    clock->stage = -1;
    s->config.progress = on_progress;
    s->config.progress_user = clock;
    int status = segment_again(m, s);
    change_stage(clock, -1);
    s->config = config;
    return status;
}

int stages_measure(const map *m, segmentation *s, int repetitions, stage_costs *out) {
    stage_clock clock;
    size_t count = (size_t)repetitions;
    double *ms = malloc(ROOMSEG_STAGE_COUNT * count * sizeof *ms); /* [stage][repetition] */
    int status = ms != NULL ? ROOMSEG_OK : 1;
    memset(out, 0, sizeof *out);
    for (size_t i = 0; i < count && status == ROOMSEG_OK; i++) {
        status = run_once(m, s, &clock);
        for (size_t stage = 0; stage < ROOMSEG_STAGE_COUNT; stage++) {
            ms[stage * count + i] = clock.ms[stage];
        }
    }
    for (size_t stage = 0; stage < ROOMSEG_STAGE_COUNT && status == ROOMSEG_OK; stage++) {
        double *times = ms + stage * count;
        qsort(times, count, sizeof *times, compare_numbers);
        out->ms[stage] = (times[(count - 1) / 2] + times[count / 2]) / 2.0;
        out->visits[stage] = clock.calls[stage] * VISITS_PER_CALL;
    }
    free(ms);
    return status;
}
