/*
 * status.c: the list of statuses as names and sentences; the version; small helpers on defs, numbers and hashes.
 */
#include <stdio.h>
#include <string.h>

#include "base/base_internal.h"


const char *mus_status_name(mus_status status)
{
    switch (status) {
#define CASE(number, name, text) \
    case number: return "MUS_" #name;
        MUS_STATUS_LIST(CASE)
#undef CASE
    default: return "MUS_ERR_UNKNOWN";
    }
}


const char *mus_status_text(mus_status status)
{
    switch (status) {
#define CASE(number, name, text) \
    case number: return text;
        MUS_STATUS_LIST(CASE)
#undef CASE
    default: return "no such status";
    }
}


void mus_version(int32_t *version)
{
    if (version == NULL) return;
    version[0] = MUS_VERSION_MAJOR;
    version[1] = MUS_VERSION_MINOR;
    version[2] = MUS_VERSION_PATCH;
}


void mus__def_init(void *def, size_t size, const void *own, size_t own_size)
{
    if (def == NULL || size < sizeof size) return;
    memset(def, 0, size);
    memcpy(def, own, size < own_size ? size : own_size);
    memcpy(def, &size, sizeof size);
}


mus_status mus__def_read(mus_context *context, void *own, size_t own_size, size_t smallest, const void *def,
                         const char *name)
{
    if (def == NULL) return MUS_OK;
    size_t size;
    memcpy(&size, def, sizeof size);
    if (size < smallest || size > own_size)
        return mus__fail(context, MUS_ERR_VERSION, "%s: size %zu, this library knows %zu to %zu; use its init function",
                         name, size, smallest, own_size);
    memcpy(own, def, size);
    memcpy(own, &own_size, sizeof own_size);
    return MUS_OK;
}


bool mus__finite(double x)
{
    return x - x == 0.0;
}


bool mus__near(int64_t n, const double *x)
{
    for (int64_t i = 0; i < n; i++)
        if (!(x[i] >= -MUS__FARTHEST && x[i] <= MUS__FARTHEST)) return false;
    return true;
}


mus_status mus__check_near(mus_context *context, int32_t n, int32_t dim, const double *x, const char *item, ...)
{
    int64_t i = 0;
    while (i < (int64_t)n * dim && mus__near(1, x + i)) i++;
    if (i == (int64_t)n * dim) return MUS_OK;

    char text[MUS_ERROR_BYTES], number[16] = "";
    va_list list;
    va_start(list, item);
    vsnprintf(text, sizeof text, item, list);
    va_end(list);
    if (n > 1) snprintf(number, sizeof number, " %d", (int)(i / dim));
    return mus__fail(context, MUS_ERR_ARG, "%.300s%s: %c is %g m, expected %g to %g m", text, number, "xyz"[i % dim],
                     x[i], -MUS__FARTHEST, MUS__FARTHEST);
}


uint64_t mus__hash(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t i = 0; i < count; i++) hash = (hash ^ byte[i]) * UINT64_C(1099511628211);
    return hash;
}
