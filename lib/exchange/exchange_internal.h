/*
 * exchange_internal.h: what the readers and writers of this folder share: a file loaded whole with a name for its
 * messages, numbers free of the locale, a path into a JSON document, and a growing text that becomes a file whole or
 * not at all.
 *
 * Everything goes through the public functions of the context (mus_context_fail, mus_context_alloc), since this
 * folder is a library beside libmuslin. Included by lib/exchange only.
 */
#ifndef MUS_EXCHANGE_INTERNAL_H
#define MUS_EXCHANGE_INTERNAL_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "muslin/exchange.h"

#if defined(__GNUC__)
#define MUS_EXCHANGE_PRINTF(at, from) __attribute__((format(printf, at, from)))
#else
#define MUS_EXCHANGE_PRINTF(at, from)
#endif

#define MUS_DEGREE (3.14159265358979323846 / 180.0) /* in radian: files give angles in degrees */

/* ---- a file to read ---- */

/* above this a file is refused: no tape or pattern of a person comes near it */
#define MUS_FILE_BYTES_MAX ((size_t)256 << 20)

typedef struct mus_source {
    mus_context *context;
    const char *path; /* borrowed from the caller */
    const char *name; /* the path, or the last 200 bytes of it: for messages */
    char *text;       /* (size + 1), a zero byte at the end */
    size_t size;
} mus_source;

/* load a file; a UTF-8 byte order mark is left out. On failure *out holds nothing */
mus_status mus__source_open(mus_context *context, const char *path, mus_source *out);
void mus__source_close(mus_source *source);
/* "file:line: sentence"; line 0 leaves the line out. Bytes that are not printable UTF-8 come out as '?' */
mus_status mus__source_fail(const mus_source *source, int64_t line, mus_status status, const char *format, ...)
    MUS_EXCHANGE_PRINTF(4, 5);
/* put "file:line: " before the sentence that a call of libmuslin left; ERR_ARG becomes ERR_FORMAT, as it is the file
 * that was wrong and not the caller */
mus_status mus__source_wrap(const mus_source *source, int64_t line, mus_status status);
mus_status mus__exchange_fail(mus_context *context, mus_status status, const char *format, ...)
    MUS_EXCHANGE_PRINTF(3, 4);

/* name of a path without folders and the given endings (the first that fits), cut to `bytes` - 1 */
void mus__source_base(const char *path, const char *const *endings, char *out, size_t bytes);

/* names of things that a file holds and muslin has no use for, for one log line */
typedef struct mus_unused {
    char names[384];
    int32_t count;
    int32_t listed;
} mus_unused;

void mus__unused_add(mus_unused *unused, const char *name);
void mus__unused_log(const mus_unused *unused, const mus_source *source);

/* ---- numbers and the locale ---- */

/* the "C" locale for this thread between enter and leave: strtod, printf and jansson then know one decimal point */
typedef struct mus_locale {
    void *own;
    void *before;
} mus_locale;

mus_status mus__locale_enter(mus_context *context, mus_locale *locale);
void mus__locale_leave(mus_locale *locale);

/* bytes at the start of `text` that make a plain decimal number (no hex, no inf, no nan), 0 if none */
size_t mus__number_span(const char *text);
/* a text that is one number between blanks: NULL and *out, or what is wrong with it ("has a comma, ...") */
const char *mus__number_read(const char *text, double *out);

/* measure whose name is nearest to a misspelt one, or NULL when none is near */
const char *mus__measure_nearest(const char *name);
/* length of a valid UTF-8 sequence at `text` (1..4), 0 if there is none */
size_t mus__utf8_length(const char *text);

/* ---- forms of a tape: each fills an empty tape ---- */

mus_status mus__tape_read_text(mus_source *source, mus_tape *tape);
mus_status mus__tape_read_yaml(mus_source *source, mus_tape *tape);
mus_status mus__tape_read_vit(mus_source *source, mus_tape *tape);
mus_status mus__tape_read_table(mus_source *source, const char *row, mus_tape *tape);

/* ---- a place in a JSON document ---- */

typedef struct mus_json_at {
    const mus_source *source;
    const struct mus_json_at *parent;
    const char *key; /* member of the parent; NULL: element `index` of it, or the document itself */
    size_t index;
    const json_t *json; /* NULL when there is no such member */
} mus_json_at;

/* the document of a file (json_decref it), or NULL with the status: "file:line: sentence" */
json_t *mus__json_document(const mus_source *source, mus_status *status);
mus_json_at mus__json_member(const mus_json_at *parent, const char *key);
mus_json_at mus__json_element(const mus_json_at *parent, size_t index);
/* "file: at panels[3].name: sentence" */
mus_status mus__json_fail(const mus_json_at *at, mus_status status, const char *format, ...) MUS_EXCHANGE_PRINTF(3, 4);
/* put the place before the sentence that a call of libmuslin left, as mus__source_wrap */
mus_status mus__json_wrap(const mus_json_at *at, mus_status status);
/* the value must be of this jansson type */
mus_status mus__json_expect(const mus_json_at *at, int type);
mus_status mus__json_array(const mus_json_at *at, size_t low, size_t high, size_t *count);
mus_status mus__json_integer(const mus_json_at *at, int32_t low, int32_t high, int32_t *out);
mus_status mus__json_number(const mus_json_at *at, double *out);
mus_status mus__json_numbers(const mus_json_at *at, size_t count, double *out);
mus_status mus__json_text(const mus_json_at *at, const char **out);

/* ---- forms of a pattern: each fills an empty pattern ---- */

/* no garment has more; a panel is found by its name, one after the other, so the limit bounds the time of reading */
#define MUS_FILE_PANELS_MAX 10000

mus_status mus__pattern_read_json(const mus_json_at *root, mus_pattern *pattern);
mus_status mus__pattern_read_garmentcode(const mus_json_at *root, mus_pattern *pattern);
mus_status mus__pattern_read_freesewing(const mus_json_at *root, mus_pattern *pattern);

/* ---- a file to write: built in memory, then saved ---- */

typedef struct mus_sink {
    mus_context *context;
    char *bytes;
    size_t size;
    size_t capacity;
    mus_status status; /* first failure; later calls do nothing */
} mus_sink;

void mus__sink_init(mus_sink *sink, mus_context *context);
void mus__sink_free(mus_sink *sink);
void mus__sink_add(mus_sink *sink, const void *bytes, size_t size);
void mus__sink_print(mus_sink *sink, const char *format, ...) MUS_EXCHANGE_PRINTF(2, 3);
/* a number that reads back bit for bit: the shortest of 15, 16 or 17 digits that does */
void mus__sink_number(mus_sink *sink, double number);
/* a text in JSON's quotes */
void mus__sink_quote(mus_sink *sink, const char *text);
/* write all of it to `path` ("-": standard output): through a file beside it and a rename, so that the file is whole
 * or as it was before */
mus_status mus__sink_save(mus_sink *sink, const char *path);

/* ---- meshes ---- */

/* check views before a byte is written: sizes, counts, finite numbers, indices */
mus_status mus__mesh_check(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes);
/* keys of meshes in motion, which are checked already as meshes */
#define MUS_MESH_KEYS 4096
mus_status mus__mesh_check_motion(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys,
                                  const double *times, const mus_mesh_motion *motion);

#endif
