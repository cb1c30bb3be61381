/* Two runs at once in two arenas, again and again: the same results as one after the other. What
 * a race would do to shared memory is for -fsanitize=thread to see (.ci/run). */
#define _POSIX_C_SOURCE 200809L

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "roomseg/roomseg.h"

enum { WIDTH = 150, HEIGHT = 110, CELLS = WIDTH * HEIGHT, CONFIGS = 4, ROUNDS = 6 };

static uint8_t map[CELLS];

/* Four rooms and some noise. */
static void draw_map(void)
{
    uint32_t random = 7;
    for (uint32_t i = 0; i < CELLS; i++) {
        uint32_t x = i % WIDTH;
        uint32_t y = i / WIDTH;
        bool wall = (x == 70 && y % 55 > 12) || (y == 55 && x % 75 > 12);
        random = random * 1664525u + 1013904223u;
        map[i] = wall || random >> 24 == 0 ? 255 : 0;
    }
}

static roomseg_config config_at(int index)
{
    roomseg_config config = index % 2 == 0 ? roomseg_config_default() : roomseg_config_paper();
    config.align = index >= 2 ? ROOMSEG_ALIGN_ON : NULL;
    return config;
}

typedef struct worker {
    int first; /* config to begin with */
    uint16_t labels[CONFIGS][CELLS];
    bool failed;
} worker;

static bool run_once(int index, uint16_t *labels)
{
    const roomseg_config config = config_at(index);
    const roomseg_grid grid = {map, WIDTH, HEIGHT, WIDTH, 50};
    roomseg_result result;
    size_t need = 0;
    bool done = roomseg_arena_size_for_grid(&config, &grid, &need) == ROOMSEG_OK;
    void *arena = malloc(need);
    done = done && arena != NULL &&
           roomseg_run(&config, &grid, labels, WIDTH, &result, arena, need) == ROOMSEG_OK &&
           result.room_count > 1;
    free(arena);
    return done;
}

static void *work(void *argument)
{
    worker *w = argument;
    for (int round = 0; round < ROUNDS * CONFIGS; round++) {
        int index = (w->first + round) % CONFIGS;
        w->failed = !run_once(index, w->labels[index]) || w->failed;
    }
    return NULL;
}

static worker alone;
static worker workers[2];

int main(void)
{
    pthread_t threads[2];
    draw_map();
    work(&alone);
    bool good = !alone.failed;
    for (int i = 0; i < 2; i++) {
        workers[i].first = i;
        if (pthread_create(&threads[i], NULL, work, &workers[i]) != 0) {
            fputs("no thread\n", stderr);
            return 1;
        }
    }
    for (int i = 0; i < 2; i++) {
        pthread_join(threads[i], NULL);
        good = good && !workers[i].failed &&
               memcmp(workers[i].labels, alone.labels, sizeof alone.labels) == 0;
    }
    puts(good ? "two runs at once: the same rooms" : "FAILED: other rooms than alone");
    return good ? 0 : 1;
}
