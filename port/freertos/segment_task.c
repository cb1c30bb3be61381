#include "segment_task.h"

/* Called at least once in 65,536 visits of a cell, a few milliseconds on a Cortex-M4 at 100 MHz:
 * often enough for a watchdog, rarely enough to cost nothing. */
static int on_progress(void *user, roomseg_stage stage, unsigned permille)
{
    segment_task *task = user;

    task->feed_watchdog();
    task->stage = (int)stage;
    task->permille = permille;
    return task->cancel;
}

static void run(void *argument)
{
    segment_task *task = argument;
    int status;

    task->config.progress = on_progress;
    task->config.progress_user = task;
    status = roomseg_run(&task->config, &task->grid, task->labels, task->grid.width,
                         &task->result, task->arena, task->arena_size);
    task->done(task, status);
    vTaskDelete(NULL);
}

TaskHandle_t segment_task_start(segment_task *task, UBaseType_t priority)
{
    task->cancel = false;
    return xTaskCreateStatic(run, "segment", SEGMENT_TASK_STACK_WORDS, task, priority,
                             task->stack, &task->control);
}
