/*
 * thread_pool.h: a few threads that run the same function over parts of the same work, and meet.
 *
 * Used by the drape: several phases a step, tens of microseconds each. Threads sleep on a condition variable between
 * phases, so a loaded machine does not collapse them. Part i of n is the same whatever thread runs it, so results do
 * not depend on the number of threads.
 */
#ifndef MUS_BASE_THREAD_POOL_H
#define MUS_BASE_THREAD_POOL_H

#include "base/base_internal.h"

typedef struct mus__pool mus__pool;
typedef void (*mus__pool_fn)(void *user, int32_t part, int32_t parts);

/* a pool of `threads` (the caller's own counts as one); threads 1 makes no thread and costs nothing */
mus_status mus__pool_create(mus_context *context, int32_t threads, mus__pool **out);
void mus__pool_destroy(mus__pool *pool);
/* run fn(user, part, threads) for part 0 .. threads-1 and wait for all */
void mus__pool_run(mus__pool *pool, mus__pool_fn fn, void *user);

/* first and one past the last of `part` of `parts` equal shares of n items */
static inline int32_t mus__share(int32_t n, int32_t part, int32_t parts)
{
    return (int32_t)((int64_t)n * part / parts);
}

#endif
