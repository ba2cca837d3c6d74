/*
 * source.h: a file or a text loaded whole, failures that name file and line, numbers free of the locale.
 */
#ifndef MUS_EXCHANGE_SOURCE_H
#define MUS_EXCHANGE_SOURCE_H

#include <stddef.h>
#include <stdint.h>

#include "file/message.h"
#include "muslin/exchange.h"

#define MUS__DEGREE (3.14159265358979323846 / 180.0) /* [rad] files give angles in degrees */

/* [bytes] a larger file is refused; chosen: no tape, pattern or scan of a person comes near it */
#define MUS__FILE_BYTES_MAX ((size_t)256 << 20)

typedef struct mus__source {
    mus_context *context;
    const char *path; /* borrowed from the caller */
    const char *name; /* the path, or the last 200 bytes of it: for messages */
    char *text;       /* (size + 1), a zero byte at the end */
    size_t size;
} mus__source;

/* what a reader reads: the file `path`, or with a text the `size` bytes of it, which `path` names in messages */
typedef struct mus__input {
    const char *path;
    const char *text; /* NULL: the file */
    size_t size;
} mus__input;

/* MUS_ERR_ARG, in the name of the public call `what`, when path or out is NULL */
mus_status mus__input_check(mus_context *context, const mus__input *input, const void *out, const char *what);
/* load a file or a text; a UTF-8 byte order mark is left out. On failure *out holds nothing */
mus_status mus__source_open(mus_context *context, const mus__input *input, mus__source *out);
void mus__source_close(mus__source *source);
/* "file:line: sentence"; line 0 leaves the line out. Bytes that are not printable UTF-8 come out as '?' */
mus_status mus__source_fail(const mus__source *source, int64_t line, mus_status status, const char *format, ...)
    MUS__FILE_PRINTF(4, 5);
/* put "file:line: " before the sentence that a call of libmuslin left; ERR_ARG becomes ERR_FORMAT, as it is the file
 * that was wrong and not the caller */
mus_status mus__source_wrap(const mus__source *source, int64_t line, mus_status status);

/* name of a path without folders and the given endings (the first that fits), cut to `bytes` - 1 */
void mus__source_base(const char *path, const char *const *endings, char *out, size_t bytes);

/* names of things that a file holds and muslin has no use for, for one log line */
typedef struct mus__unused {
    char names[384];
    int32_t count;
    int32_t listed;
} mus__unused;

void mus__unused_add(mus__unused *unused, const char *name);
void mus__unused_log(const mus__unused *unused, const mus__source *source);

/* ---- numbers and the locale ---- */

/* the "C" locale for this thread between enter and leave: strtod, printf and jansson then know one decimal point */
typedef struct mus__locale {
    void *own;
    void *before;
} mus__locale;

mus_status mus__locale_enter(mus_context *context, mus__locale *locale);
void mus__locale_leave(mus__locale *locale);

/* bytes at the start of `text` that make a plain decimal number (no hex, no inf, no nan), 0 if none */
size_t mus__number_span(const char *text);
/* a text that is one number between blanks: NULL and *out, or what is wrong with it ("has a comma, ...") */
const char *mus__number_read(const char *text, double *out);

/* measure whose name is nearest to a misspelt one, or NULL when none is near */
const char *mus__measure_nearest(const char *name);
/* length of a valid UTF-8 sequence at `text` (1..4), 0 if there is none */
size_t mus__utf8_length(const char *text);

#endif
