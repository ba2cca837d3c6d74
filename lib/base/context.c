/*
 * context.c: the context: allocator and log hooks, text of the last error, count of bytes held.
 *
 * Every block begins with a head of 16 bytes that holds its size. So the allocator hook is told the old size, and
 * mus_context_bytes() is exact, without the callers keeping sizes.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/base_internal.h"

/* [bytes] before each block: its size. 16 keeps the alignment of any type */
#define HEAD 16
/* [bytes] of mus_context_def in release 0.2, the smallest that mus_context_create() takes */
#define CONTEXT_DEF_FIRST (offsetof(mus_context_def, log_user) + sizeof(void *))


static void *libc_alloc(void *user, void *ptr, size_t old_size, size_t new_size)
{
    (void)user;
    (void)old_size;
    if (new_size == 0) {
        free(ptr);
        return NULL;
    }
    return realloc(ptr, new_size);
}


void mus_context_def_init(mus_context_def *def, size_t size)
{
    mus_context_def own = {0};
    mus__def_init(def, size, &own, sizeof own);
}


mus_status mus_context_create(const mus_context_def *def, mus_context **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;

    mus_context_def own;
    mus_context_def_init(&own, sizeof own);
    const mus_status status = mus__def_read(NULL, &own, sizeof own, CONTEXT_DEF_FIRST, def, "mus_context_def");
    if (status != MUS_OK) return status;
    if (own.alloc == NULL) own.alloc = libc_alloc;

    mus_context *context = own.alloc(own.alloc_user, NULL, 0, sizeof *context);
    if (context == NULL) return MUS_ERR_MEMORY;
    memset(context, 0, sizeof *context);
    context->def = own;
    *out = context;
    return MUS_OK;
}


void mus_context_destroy(mus_context *context)
{
    if (context == NULL) return;
    mus_context_def def = context->def;
    def.alloc(def.alloc_user, context, sizeof *context, 0);
}


const char *mus_context_error(const mus_context *context)
{
    return context != NULL ? context->error : "";
}


size_t mus_context_bytes(const mus_context *context)
{
    return context != NULL ? context->bytes : 0;
}


uint64_t mus_context_allocations(const mus_context *context)
{
    return context != NULL ? context->allocations : 0;
}


void *mus__room(mus_context *context, int64_t count, size_t size)
{
    if (count < 0 || size == 0 || (uint64_t)count > (SIZE_MAX / 2 - HEAD) / size) return NULL;

    size_t bytes = (size_t)count * size + HEAD;
    unsigned char *block = context->def.alloc(context->def.alloc_user, NULL, 0, bytes);
    if (block == NULL) return NULL;
    memset(block, 0, HEAD);
    memcpy(block, &bytes, sizeof bytes);
    context->bytes += bytes;
    context->allocations++;
    return block + HEAD;
}


void *mus__new(mus_context *context, int64_t count, size_t size)
{
    void *room = mus__room(context, count, size);
    if (room != NULL) memset(room, 0, (size_t)count * size);
    return room;
}


void mus__free(mus_context *context, void *pointer)
{
    if (pointer == NULL) return;
    unsigned char *block = (unsigned char *)pointer - HEAD;
    size_t bytes;
    memcpy(&bytes, block, sizeof bytes);
    context->bytes -= bytes;
    context->def.alloc(context->def.alloc_user, block, bytes, 0);
}


mus_status mus__reserve(mus_context *context, void *array, int32_t *capacity, int64_t need, size_t size)
{
    void **slot = array;
    if (need <= *capacity) return MUS_OK;
    if (need > INT32_MAX) return mus__fail(context, MUS_ERR_LIMIT, "%lld elements are more than 2^31", (long long)need);

    int64_t grown = (int64_t)*capacity + *capacity / 2 + 8;
    if (grown < need) grown = need;
    if (grown > INT32_MAX) grown = INT32_MAX;
    void *bigger = mus__new(context, grown, size);
    if (bigger == NULL) return mus__fail_memory(context, "a growing array");
    if (*slot != NULL) memcpy(bigger, *slot, (size_t)*capacity * size);
    mus__free(context, *slot);
    *slot = bigger;
    *capacity = (int32_t)grown;
    return MUS_OK;
}


mus_status mus__fail(mus_context *context, mus_status status, const char *format, ...)
{
    /* through a buffer: an argument may be the old error text itself */
    char text[MUS_ERROR_BYTES];
    if (context == NULL) return status;
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    memcpy(context->error, text, sizeof text);
    return status;
}


mus_status mus__fail_memory(mus_context *context, const char *what)
{
    return mus__fail(context, MUS_ERR_MEMORY, "no memory for %s", what);
}


void mus__log(mus_context *context, int32_t level, const char *format, ...)
{
    if (context->def.log == NULL) return;
    char text[MUS_ERROR_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    context->def.log(context->def.log_user, level, text);
}


mus_status mus_context_fail(mus_context *context, mus_status status, const char *text)
{
    if (context == NULL) return status;
    return mus__fail(context, status, "%s", text != NULL ? text : mus_status_text(status));
}


void *mus_context_alloc(mus_context *context, void *ptr, size_t new_size)
{
    if (context == NULL) return NULL;
    if (new_size == 0 || new_size > INT64_MAX) {
        if (new_size == 0) mus__free(context, ptr);
        return NULL;
    }
    void *block = mus__new(context, (int64_t)new_size, 1);
    if (block == NULL || ptr == NULL) return block;

    size_t old;
    memcpy(&old, (unsigned char *)ptr - HEAD, sizeof old);
    old -= HEAD;
    memcpy(block, ptr, old < new_size ? old : new_size);
    mus__free(context, ptr);
    return block;
}


void mus_context_log(mus_context *context, int32_t level, const char *text)
{
    if (context != NULL && text != NULL) mus__log(context, level, "%s", text);
}
