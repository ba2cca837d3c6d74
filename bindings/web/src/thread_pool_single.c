/* thread_pool_single.c: the pool of lib/base/thread_pool.c where there are no threads: the parts run one by one. */
#include "base/thread_pool.h"

struct mus__pool {
    int32_t parts;
    mus_context *context;
};


mus_status mus__pool_create(mus_context *context, int32_t threads, mus__pool **out)
{
    mus__pool *pool = mus__new(context, 1, sizeof *pool);
    *out = pool;
    if (pool == NULL) return mus__fail_memory(context, "a thread pool");
    pool->parts = threads, pool->context = context;
    return MUS_OK;
}


void mus__pool_destroy(mus__pool *pool)
{
    if (pool != NULL) mus__free(pool->context, pool);
}


void mus__pool_run(mus__pool *pool, mus__pool_fn fn, void *user)
{
    for (int32_t part = 0; part < pool->parts; part++) fn(user, part, pool->parts);
}
