/*
 * file_read.h: a file or a text in memory; messages with file and line; numbers independent of the locale.
 */
#ifndef MUS_EXCHANGE_FILE_READ_H
#define MUS_EXCHANGE_FILE_READ_H

#include <stddef.h>
#include <stdint.h>

#include "file/message.h"
#include "muslin/exchange.h"

#define MUS__DEGREE (3.14159265358979323846 / 180.0) /* [rad] files give angles in degrees */

/* [bytes] a larger file is refused; chosen: no tape, pattern or scan of a person comes near it */
#define MUS__FILE_BYTES_MAX ((size_t)256 << 20)

/* the "C" locale for this thread, from enter to leave: strtod, printf and jansson use the decimal point "." */
typedef struct mus__locale {
    void *own;
    void *before;
} mus__locale;

mus_status mus__locale_enter(mus_context *context, mus__locale *locale);
void mus__locale_leave(mus__locale *locale);

/* a text in memory; while it is open, its thread is in the "C" locale */
typedef struct mus__source {
    mus_context *context;
    const char *path; /* borrowed from the caller */
    const char *name; /* the path, or its last 200 bytes, for messages */
    char *text;       /* (size + 1), a zero byte at the end */
    size_t size;
    mus__locale locale;
} mus__source;

/* input of a reader: the file `path`, or, with `text`, its `size` bytes, which `path` names in messages */
typedef struct mus__input {
    const char *path;
    const char *text; /* NULL: read the file */
    size_t size;
} mus__input;

/* MUS_ERR_ARG, naming the public call `what`, when path or out is NULL */
mus_status mus__input_check(mus_context *context, const mus__input *input, const void *out, const char *what);
/* enter the "C" locale and load a file or a text; a UTF-8 byte order mark is dropped. After a failure *out owns no
 * memory, and the locale is the former one. It may be closed then too */
mus_status mus__source_open(mus_context *context, const mus__input *input, mus__source *out);
void mus__source_close(mus__source *source);
/* make "file:line: sentence" the context's error text; line 0 leaves out the line. Unprintable bytes become '?' */
mus_status mus__source_fail(const mus__source *source, int64_t line, mus_status status, const char *format, ...)
    MUS__FILE_PRINTF(4, 5);
/* put "file:line: " before the sentence of a failed call of libmuslin; MUS_ERR_ARG becomes MUS_ERR_FORMAT, since the
 * fault is the file's and not the caller's */
mus_status mus__source_wrap(const mus__source *source, int64_t line, mus_status status);

/* grow *array, with room for *room elements of `size` bytes, to hold `need`; after a failure it is unchanged */
mus_status mus__source_reserve(const mus__source *source, void *array, int32_t *room, int64_t need, size_t size);

/* name of a path without folders and without the first of the endings that fits, cut to `bytes` - 1 bytes */
void mus__source_base(const char *path, const char *const *endings, char *out, size_t bytes);

/* put a number behind the name of a panel that the pattern has */
void mus__panel_name_free(const mus_pattern *pattern, char *name, size_t capacity);

/* names of the entries of a file that muslin has no use for, for one log line */
typedef struct mus__unused {
    char names[384];
    int32_t count;
    int32_t listed;
} mus__unused;

void mus__unused_add(mus__unused *unused, const char *name);
void mus__unused_log(const mus__unused *unused, const mus__source *source);
/* MUS_ERR_FORMAT: the file has no measure; the message lists the names that it has */
mus_status mus__unused_fail(const mus__unused *unused, const mus__source *source);

/* ---- numbers ---- */

/* length of the decimal number at the start of `text` [bytes] (no hex, no inf, no nan); 0 if there is none */
size_t mus__number_span(const char *text);
/* read the number at the start of `text` as a person writes it: also with a fraction ("41 1/4", "1/2"), or with a
 * decimal comma where it cannot be one of thousands. Returns NULL with the number's length [bytes], or the fault as a
 * text ("is not a number") */
const char *mus__amount_read(const char *text, double *out, size_t *length);
/* read a text that is one such number between blanks; returns NULL, or the fault */
const char *mus__number_read(const char *text, double *out);

/* name of the measure nearest to a misspelt name, or NULL when none is near */
const char *mus__measure_nearest(const char *name);

#endif
