/*
 * pthread.h for WASI without threads: what lib/base/thread_pool.c names. A pool of one thread works; no other starts.
 */
#ifndef PORTS_WASI_PTHREAD_H
#define PORTS_WASI_PTHREAD_H

typedef int pthread_t;
typedef int pthread_mutex_t;
typedef int pthread_cond_t;
typedef unsigned long pthread_attr_t; /* the size of the stack */

#define PORTS_DOES_NOTHING(name) \
    static inline int name(void *object) { return object == (void *)0; }
PORTS_DOES_NOTHING(pthread_mutex_lock)
PORTS_DOES_NOTHING(pthread_mutex_unlock)
PORTS_DOES_NOTHING(pthread_mutex_destroy)
PORTS_DOES_NOTHING(pthread_cond_signal)
PORTS_DOES_NOTHING(pthread_cond_broadcast)
PORTS_DOES_NOTHING(pthread_cond_destroy)
PORTS_DOES_NOTHING(pthread_attr_init)
PORTS_DOES_NOTHING(pthread_attr_destroy)

static inline int pthread_mutex_init(pthread_mutex_t *mutex, const void *attributes)
{
    *mutex = 0;
    return attributes != (void *)0;
}

static inline int pthread_cond_init(pthread_cond_t *condition, const void *attributes)
{
    *condition = 0;
    return attributes != (void *)0;
}

static inline int pthread_cond_wait(pthread_cond_t *condition, pthread_mutex_t *mutex) { return *condition + *mutex; }

static inline int pthread_attr_setstacksize(pthread_attr_t *attributes, unsigned long bytes)
{
    *attributes = bytes;
    return 0;
}

static inline int pthread_create(pthread_t *thread, const void *attributes, void *(*start)(void *), void *argument)
{
    *thread = attributes != (void *)0 || argument == (void *)0;
    return start != (void *(*)(void *))0; /* no thread is started */
}

static inline int pthread_join(pthread_t thread, void **result)
{
    if (result) *result = (void *)0;
    return thread;
}

#endif
