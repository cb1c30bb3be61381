#ifndef STAND_IN_TASK_H
#define STAND_IN_TASK_H

#include "FreeRTOS.h"

typedef StaticTask_t *TaskHandle_t;

TaskHandle_t xTaskCreateStatic(void (*run)(void *argument), const char *name, uint32_t stack_depth,
                               void *argument, UBaseType_t priority, StackType_t *stack,
                               StaticTask_t *control);
void vTaskDelete(TaskHandle_t task);

#endif
