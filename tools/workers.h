/* The same work for many items, on all cores. */
#ifndef ROOMSEG_TOOLS_WORKERS_H
#define ROOMSEG_TOOLS_WORKERS_H

#include <stddef.h>

#define WORKERS_MAX 256

/* For variables of which every worker needs one of its own. */
#ifdef ROOMSEG_THREADS
#define WORKERS_OWN __thread
#else
#define WORKERS_OWN
#endif

/* What is done to an item. user: the caller's, shared by all workers. */
typedef void (*workers_job)(void *user, size_t index);

/* Number of cores; 1 where threads are not available. */
int workers_default(void);

/* Calls job(user, i) for every i < count, in up to `workers` threads at once, and
 * finished(user, i) as soon as the jobs 0..i are done: one call at a time, in the order of i,
 * from any of the threads. Where a thread cannot be started the others do its work; without any
 * the caller's thread does all. Returns when everything is done.
 * workers: 1..WORKERS_MAX. */
void workers_run(size_t count, int workers, workers_job job, workers_job finished, void *user);

#endif
