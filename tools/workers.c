#define _POSIX_C_SOURCE 200809L

#include "workers.h"

#include <stdlib.h>

#ifdef ROOMSEG_THREADS
#include <pthread.h>
#include <unistd.h>
#endif

/* Everything behind `user` is read and written under the lock. */
typedef struct queue {
    size_t count;
    workers_job job, finished;
    void *user;
    size_t next;         /* first item that nobody has taken */
    size_t reported;     /* items whose end was reported */
    unsigned char *done; /* per item; NULL: one worker, nothing to put in order */
#ifdef ROOMSEG_THREADS
    pthread_mutex_t lock;
#endif
} queue;

static void lock(queue *q) {
#ifdef ROOMSEG_THREADS
    pthread_mutex_lock(&q->lock);
#else
    (void)q;
#endif
}

static void unlock(queue *q) {
#ifdef ROOMSEG_THREADS
    pthread_mutex_unlock(&q->lock);
#else
    (void)q;
#endif
}

static void report(queue *q, size_t index) {
    if (q->done == NULL) {
        q->finished(q->user, index);
        return;
    }
    q->done[index] = 1;
    while (q->reported < q->count && q->done[q->reported]) {
        q->finished(q->user, q->reported++);
    }
}

static void work(queue *q) {
    lock(q);
    while (q->next < q->count) {
        size_t index = q->next++;
        unlock(q);
        q->job(q->user, index);
        lock(q);
        report(q, index);
    }
    unlock(q);
}

#ifdef ROOMSEG_THREADS

static void *work_thread(void *argument) {
    work(argument);
    return NULL;
}

int workers_default(void) {
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > WORKERS_MAX ? WORKERS_MAX : (int)cores;
}

/* The caller's thread is one of the workers. */
static void work_together(queue *q, int workers) {
    pthread_t threads[WORKERS_MAX];
    int started = 0;
    while (started + 1 < workers &&
           pthread_create(&threads[started], NULL, work_thread, q) == 0) {
        started++;
    }
    work(q);
    for (int i = 0; i < started; i++) {
        pthread_join(threads[i], NULL);
    }
}

void workers_run(size_t count, int workers, workers_job job, workers_job finished, void *user) {
    queue q = {count, job, finished, user, 0, 0, NULL, PTHREAD_MUTEX_INITIALIZER};
    if ((size_t)workers > count) {
        workers = (int)count;
    }
    if (workers > 1) {
        q.done = calloc(count, 1);
    }
    work_together(&q, q.done != NULL ? workers : 1);
    free(q.done);
    pthread_mutex_destroy(&q.lock);
}

#else

int workers_default(void) {
    return 1;
}

void workers_run(size_t count, int workers, workers_job job, workers_job finished, void *user) {
    queue q = {count, job, finished, user, 0, 0, NULL};
    (void)workers;
    work(&q);
}

#endif
