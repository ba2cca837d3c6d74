/*
 * sink.h: bytes that grow in memory and become a file, whole or not at all, or a block of the caller's.
 *
 * Every writer of libmuslin-exchange and libmuslin-print ends here; both libraries carry these objects, hidden. Memory and
 * failures go through the public functions of the context.
 */
#ifndef MUS_FILE_SINK_H
#define MUS_FILE_SINK_H

#include <stddef.h>

#include "file/message.h"
#include "muslin/base.h"

typedef struct mus__sink {
    mus_context *context;
    char *bytes;
    size_t size;
    size_t capacity;
    mus_status status; /* the first failure; later calls do nothing */
} mus__sink;

void mus__sink_init(mus__sink *sink, mus_context *context);
void mus__sink_free(mus__sink *sink);
void mus__sink_add(mus__sink *sink, const void *bytes, size_t size);
void mus__sink_print(mus__sink *sink, const char *format, ...) MUS__FILE_PRINTF(2, 3);
/* add a number that reads back bit for bit: the shortest of 15, 16 or 17 digits that does */
void mus__sink_number(mus__sink *sink, double number);
/* add a text in JSON's quotes */
void mus__sink_quote(mus__sink *sink, const char *text);

/* where a writer's bytes go: into the file `path` ("-": standard output), or with path NULL to the caller */
typedef struct mus__target {
    const char *path;
    char **bytes; /* gets the block, freed by mus_context_alloc(context, bytes, 0) */
    size_t *size; /* gets its size */
} mus__target;

/* MUS_ERR_ARG, in the name of the public call `what`, when there is no place for the bytes; else *bytes is NULL */
mus_status mus__target_check(mus_context *context, const mus__target *target, const char *what);
/* hand over all bytes of the sink. A file is written beside the wanted one and renamed over it, so that a failure leaves
 * the file as it was. Returns the sink's own failure when it has one */
mus_status mus__sink_give(mus__sink *sink, const mus__target *target);

#endif
