/* Example: a FreeRTOS task that segments in the background while the robot goes on. */
#ifndef SEGMENT_TASK_H
#define SEGMENT_TASK_H

#include <stdbool.h>

#include "FreeRTOS.h"
#include "roomseg/roomseg.h"
#include "task.h"

/* Stack of the task: 1 KB of the library, the task's own locals, and what the kernel saves. */
#define SEGMENT_TASK_STACK_WORDS (1536u / sizeof(StackType_t))

typedef struct segment_task {
    /* Set before the start; the memory belongs to the task until `done` is called. */
    roomseg_config config; /* its progress hook is the task's own */
    roomseg_grid grid;     /* a copy of the map that SLAM does not write to meanwhile */
    uint16_t *labels;
    void *arena;
    size_t arena_size;
    void (*feed_watchdog)(void);
    void (*done)(struct segment_task *task, int status);

    /* Set by anyone at any time: the run ends soon with ROOMSEG_ERR_CANCELLED. */
    volatile bool cancel;

    /* Read by anyone at any time. */
    volatile int stage;
    volatile unsigned permille;

    roomseg_result result; /* valid in `done` */
    StaticTask_t control;
    StackType_t stack[SEGMENT_TASK_STACK_WORDS];
} segment_task;

/* Starts the task at the priority given, which should be lower than that of everything that
 * must not wait. *task must stay where it is until `done` was called. */
TaskHandle_t segment_task_start(segment_task *task, UBaseType_t priority);

#endif
