/*
 * sink.h: a buffer that a writer fills, and that then becomes a file or an allocation of the caller's.
 *
 * Every writer of libmuslin-exchange and libmuslin-print ends with a sink; each library carries a hidden copy of this
 * code. Memory and failures go through the public functions of the context.
 */
#ifndef MUS_FILE_SINK_H
#define MUS_FILE_SINK_H

#include <stddef.h>
#include <stdint.h>

#include "file/message.h"
#include "muslin/base.h"

typedef struct mus__sink {
    mus_context *context;
    char *bytes;
    size_t size;
    size_t capacity;
    mus_status status; /* first failure; after it all calls that add bytes do nothing */
} mus__sink;

/* make an empty sink */
void mus__sink_init(mus__sink *sink, mus_context *context);
/* free the buffer of a sink */
void mus__sink_free(mus__sink *sink);
/* add `size` bytes */
void mus__sink_add(mus__sink *sink, const void *bytes, size_t size);
/* add 4 bytes, the lowest first */
void mus__sink_u32(mus__sink *sink, uint32_t value);
/* add a number as a float of 4 bytes */
void mus__sink_f32(mus__sink *sink, double value);
/* add formatted text, as printf */
void mus__sink_print(mus__sink *sink, const char *format, ...) MUS__FILE_PRINTF(2, 3);
/* add a number with 15, 16 or 17 digits: the fewest that read back to the same double */
void mus__sink_number(mus__sink *sink, double number);
/* add a text as a quoted JSON string */
void mus__sink_quote(mus__sink *sink, const char *text);

/* destination of a writer's bytes: the file `path` ("-": standard output), or, with path NULL, the caller */
typedef struct mus__target {
    const char *path;
    char **bytes; /* gets the allocation; the caller frees it with mus_context_alloc(context, bytes, 0) */
    size_t *size; /* gets the number of bytes */
} mus__target;

/* check a target and set *bytes to NULL; MUS_ERR_ARG, naming the public call `what`, when a pointer is missing */
mus_status mus__target_check(mus_context *context, const mus__target *target, const char *what);
/* give all bytes of the sink to the target. A failure leaves an existing file unchanged. Returns the sink's first
 * failure when it has one */
mus_status mus__sink_give(mus__sink *sink, const mus__target *target);

#endif
