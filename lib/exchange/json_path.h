/*
 * json_path.h: a value of a JSON document together with its path, for messages.
 */
#ifndef MUS_EXCHANGE_JSON_PATH_H
#define MUS_EXCHANGE_JSON_PATH_H

#include <jansson.h>

#include "exchange/file_read.h"

typedef struct mus__json_at {
    const mus__source *source;
    const struct mus__json_at *parent;
    const char *key; /* member of the parent; NULL: element `index` of it, or the document itself */
    size_t index;
    const json_t *json; /* the value; NULL when there is no such member */
} mus__json_at;

/* parse the text of a file; free the document with json_decref. NULL and *status after a failure */
json_t *mus__json_document(const mus__source *source, mus_status *status);
mus__json_at mus__json_member(const mus__json_at *parent, const char *key);
mus__json_at mus__json_element(const mus__json_at *parent, size_t index);
/* make "file: at panels[3].name: sentence" the context's error text; returns `status` */
mus_status mus__json_fail(const mus__json_at *at, mus_status status, const char *format, ...) MUS__FILE_PRINTF(3, 4);
/* put file and path before the sentence of a failed call of libmuslin, as mus__source_wrap */
mus_status mus__json_wrap(const mus__json_at *at, mus_status status);
/* MUS_ERR_FORMAT unless the value has this jansson type */
mus_status mus__json_expect(const mus__json_at *at, int type);
mus_status mus__json_array(const mus__json_at *at, size_t low, size_t high, size_t *count);
mus_status mus__json_integer(const mus__json_at *at, int32_t low, int32_t high, int32_t *out);
mus_status mus__json_number(const mus__json_at *at, double *out);
mus_status mus__json_numbers(const mus__json_at *at, size_t count, double *out);
mus_status mus__json_text(const mus__json_at *at, const char **out);

#endif
