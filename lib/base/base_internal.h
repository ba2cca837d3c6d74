/*
 * base_internal.h: the context's fields, memory through it, failing with a sentence, reading option structs. Every
 * folder of lib/ includes it; no public header does.
 */
#ifndef MUS_BASE_INTERNAL_H
#define MUS_BASE_INTERNAL_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/ieee.h"
#include "muslin/base.h"

/* for what no caller can cause; off in release */
#if defined(MUS_DEBUG)
#include <assert.h>
#define MUS_ASSERT(condition) assert(condition)
#else
#define MUS_ASSERT(condition) ((void)0)
#endif

#if defined(__GNUC__)
#define MUS_PRINTF(at, from) __attribute__((format(printf, at, from)))
#else
#define MUS_PRINTF(at, from)
#endif

#define MUS_ERROR_BYTES 512

struct mus_context {
    mus_context_def def;
    size_t bytes;         /* held by live objects */
    uint64_t allocations; /* since create */
    char error[MUS_ERROR_BYTES];
};

/* ---- memory: every block remembers its size, so it is freed by pointer alone ---- */

/* `count` elements of `size` bytes, zeroed; NULL when there is no memory, the product overflows or count < 0. A count
 * of 0 gives a block that can be freed. */
void *mus__new(mus_context *context, int64_t count, size_t size);
/* the same without zeroes: for large arrays of which each element is written before it is read */
void *mus__room(mus_context *context, int64_t count, size_t size);
void mus__free(mus_context *context, void *block);
/* grow *array (capacity *capacity elements of `size`) to hold `need`; new elements are zeroed. Old array kept on
 * failure */
mus_status mus__reserve(mus_context *context, void *array, int32_t *capacity, int64_t need, size_t size);

/* ---- errors and log ---- */

/* write the context's error text and return `status`; the status alone for NULL */
mus_status mus__fail(mus_context *context, mus_status status, const char *format, ...) MUS_PRINTF(3, 4);
/* MUS_ERR_MEMORY with a sentence */
mus_status mus__fail_memory(mus_context *context, const char *what);
void mus__log(mus_context *context, int32_t level, const char *format, ...) MUS_PRINTF(3, 4);

/* ---- defs ---- */

/* begin a caller's struct of `size` bytes: zero it, copy the defaults `own` (`own_size` bytes, cut to `size`), write
 * `size` to its first field. Nothing for NULL or a size that has no room for itself */
void mus__def_init(void *def, size_t size, const void *own, size_t own_size);

/* copy a caller's def of any released size into `own`, which holds the defaults (`own_size` bytes). Fields are only
 * ever appended, so a shorter def sets the fields that it has. `smallest` is the size of the first release. NULL: the
 * defaults stay. `name` stands in the message. Errors: MUS_ERR_VERSION */
mus_status mus__def_read(mus_context *context, void *own, size_t own_size, size_t smallest, const void *def,
                         const char *name);

/* true when x is neither NaN nor infinite */
bool mus__finite(double x);

/* ---- places ---- */

/* [m] largest coordinate of a point of a pattern, a node, a placement or a pose. Chosen: above the radius of the Earth;
 * a double there is exact to 2e-9 m, and its square is a normal float */
#define MUS__FARTHEST 1e7

/* true when each of the n coordinates is within MUS__FARTHEST; NaN is not */
bool mus__near(int64_t n, const double *x);
/* MUS_OK when the `n` points of `dim` coordinates x are within MUS__FARTHEST of the origin; else MUS_ERR_ARG with "ITEM
 * 3: x is 1e+160 m, expected -1e+07 to 1e+07 m". ITEM is the formatted text; one point has no number */
mus_status mus__check_near(mus_context *context, int32_t n, int32_t dim, const double *x, const char *item, ...)
    MUS_PRINTF(5, 6);

/* FNV-1a, 64 bit, over bytes; start with MUS_HASH_START */
#define MUS_HASH_START UINT64_C(14695981039346656037)
uint64_t mus__hash(uint64_t hash, const void *bytes, size_t count);

#endif
