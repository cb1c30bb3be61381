/* What port/freertos needs of the kernel, with threads of the desk for tasks. */
#ifndef STAND_IN_FREERTOS_H
#define STAND_IN_FREERTOS_H

#include <pthread.h>
#include <stdint.h>

typedef uint32_t StackType_t; /* as on Cortex-M */
typedef unsigned long UBaseType_t;

typedef struct StaticTask_t {
    pthread_t thread;
    void (*run)(void *argument);
    void *argument;
} StaticTask_t;

#endif
