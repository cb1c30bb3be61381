/* Runs the example task to its end, and once more with a cancel from outside. */
#include "segment_task.h"

#include <stdio.h>

enum { WIDTH = 160, HEIGHT = 96, RESOLUTION_MM = 50 };

static uint8_t cells[HEIGHT][WIDTH];
static uint16_t labels[HEIGHT][WIDTH];
static uint64_t arena[ROOMSEG_ARENA_SIZE_USUAL(WIDTH, HEIGHT, RESOLUTION_MM) / 8];
static segment_task task;
static unsigned feedings;
static int ended_with;
static bool cancel_early;

static void *enter(void *control)
{
    StaticTask_t *self = control;

    self->run(self->argument);
    return NULL;
}

TaskHandle_t xTaskCreateStatic(void (*run)(void *argument), const char *name, uint32_t stack_depth,
                               void *argument, UBaseType_t priority, StackType_t *stack,
                               StaticTask_t *control)
{
    (void)name;
    (void)stack_depth;
    (void)priority;
    (void)stack;
    control->run = run;
    control->argument = argument;
    return pthread_create(&control->thread, NULL, enter, control) == 0 ? control : NULL;
}

void vTaskDelete(TaskHandle_t self)
{
    (void)self; /* NULL: the task itself, which ends by returning */
}

static void feed_watchdog(void)
{
    feedings++;
    task.cancel = cancel_early;
}

static void done(segment_task *self, int status)
{
    (void)self;
    ended_with = status;
}

static int run_task(bool cancel)
{
    cancel_early = cancel;
    feedings = 0;
    ended_with = 1;
    if (segment_task_start(&task, 1) == NULL) {
        return 1;
    }
    pthread_join(task.control.thread, NULL);
    return ended_with;
}

int main(void)
{
    int status;

    for (int y = 0; y < HEIGHT; y++) {
        cells[y][WIDTH / 3] = y < 40 || y >= 56 ? 255 : 0;
    }
    task.config = roomseg_config_default();
    task.config.max_regions = ROOMSEG_USUAL_REGIONS(WIDTH, HEIGHT, RESOLUTION_MM);
    task.config.max_rooms = ROOMSEG_USUAL_ROOMS(WIDTH, HEIGHT, RESOLUTION_MM);
    task.grid = (roomseg_grid){cells[0], WIDTH, HEIGHT, WIDTH, RESOLUTION_MM};
    task.labels = labels[0];
    task.arena = arena;
    task.arena_size = sizeof arena;
    task.feed_watchdog = feed_watchdog;
    task.done = done;

    status = run_task(false);
    printf("%d: %u rooms, watchdog fed: %s\n", status, (unsigned)task.result.room_count,
           feedings > 0u ? "yes" : "no");
    printf("%d after a cancel\n", run_task(true));
    return 0;
}
