/*
 * thread_pool.c: threads that meet at a generation counter under one mutex and two condition variables.
 *
 * The caller publishes the work, wakes the others, does part 0 itself, and waits until all have finished.
 */
#include <pthread.h>

#include "base/thread_pool.h"

/* [bytes] of a thread's stack. A pass of contact in double has 188 kB of local arrays, unoptimised code under
 * sanitizers some more; what a C library gives by itself is 128 KiB (musl) to 8 MiB (glibc) */
#define STACK_BYTES ((size_t)1 << 20)

struct mus__pool {
    mus_context *context;
    int32_t threads;
    int32_t started; /* threads that exist besides the caller's */
    int32_t next;    /* number of the next thread to take its part index */
    int32_t running; /* threads still at work in this generation */
    uint64_t generation;
    int32_t stop;
    mus__pool_fn fn;
    void *user;
    pthread_mutex_t mutex;
    pthread_cond_t wake, done;
    pthread_t thread[64];
};


static void *pool_main(void *argument)
{
    mus__pool *pool = argument;
    pthread_mutex_lock(&pool->mutex);
    const int32_t part = ++pool->next;
    uint64_t seen = 0;
    for (;;) {
        while (pool->generation == seen && !pool->stop) pthread_cond_wait(&pool->wake, &pool->mutex);
        if (pool->stop) break;
        seen = pool->generation;
        pthread_mutex_unlock(&pool->mutex);
        pool->fn(pool->user, part, pool->threads);
        pthread_mutex_lock(&pool->mutex);
        if (--pool->running == 0) pthread_cond_signal(&pool->done);
    }
    pthread_mutex_unlock(&pool->mutex);
    return NULL;
}


mus_status mus__pool_create(mus_context *context, int32_t threads, mus__pool **out)
{
    *out = NULL;
    if (threads < 1 || threads > 64)
        return mus__fail(context, MUS_ERR_ARG, "threads %d, expected 1 to 64", (int)threads);
    mus__pool *pool = mus__new(context, 1, sizeof *pool);
    if (pool == NULL) return mus__fail_memory(context, "a thread pool");
    pool->context = context;
    pool->threads = threads;
    pthread_mutex_init(&pool->mutex, NULL);
    pthread_cond_init(&pool->wake, NULL);
    pthread_cond_init(&pool->done, NULL);
    pthread_attr_t attr;
    int trouble = pthread_attr_init(&attr);
    if (trouble == 0) trouble = pthread_attr_setstacksize(&attr, STACK_BYTES);
    while (trouble == 0 && pool->started + 1 < threads) {
        trouble = pthread_create(&pool->thread[pool->started + 1], &attr, pool_main, pool);
        pool->started += trouble == 0;
    }
    pthread_attr_destroy(&attr);
    if (trouble != 0) {
        mus__pool_destroy(pool);
        return mus__fail(context, MUS_ERR_LIMIT, "%d threads cannot be started", (int)threads);
    }
    *out = pool;
    return MUS_OK;
}


void mus__pool_destroy(mus__pool *pool)
{
    if (pool == NULL) return;
    pthread_mutex_lock(&pool->mutex);
    pool->stop = 1;
    pthread_cond_broadcast(&pool->wake);
    pthread_mutex_unlock(&pool->mutex);
    for (int32_t i = 1; i <= pool->started; i++) pthread_join(pool->thread[i], NULL);
    pthread_cond_destroy(&pool->wake);
    pthread_cond_destroy(&pool->done);
    pthread_mutex_destroy(&pool->mutex);
    mus__free(pool->context, pool);
}


void mus__pool_run(mus__pool *pool, mus__pool_fn fn, void *user)
{
    if (pool->threads == 1) {
        fn(user, 0, 1);
        return;
    }
    pthread_mutex_lock(&pool->mutex);
    pool->fn = fn;
    pool->user = user;
    pool->running = pool->threads - 1;
    pool->generation++;
    pthread_cond_broadcast(&pool->wake);
    pthread_mutex_unlock(&pool->mutex);

    fn(user, 0, pool->threads);

    pthread_mutex_lock(&pool->mutex);
    while (pool->running > 0) pthread_cond_wait(&pool->done, &pool->mutex);
    pthread_mutex_unlock(&pool->mutex);
}
