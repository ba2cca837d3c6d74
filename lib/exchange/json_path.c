/*
 * json_path.c: a value of a JSON document together with its path, for messages.
 *
 * jansson parses the document and gives line and column of a fault in the text. A mus__json_at is a value and the chain
 * of members and elements that leads to it, on the caller's stack. The path is written out only when a check fails.
 * jansson's tree grows linearly with the file.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "exchange/json_path.h"

/* [bytes] longest JSON path in a message; a longer one is cut; chosen: it leaves room for the sentence */
#define PATH_BYTES 200
#define SENTENCE_BYTES 512 /* [bytes] capacity of the context's error text */


mus__json_at mus__json_member(const mus__json_at *parent, const char *key)
{
    mus__json_at at = {parent->source, parent, key, 0, json_object_get(parent->json, key)};
    return at;
}


mus__json_at mus__json_element(const mus__json_at *parent, size_t index)
{
    mus__json_at at = {parent->source, parent, NULL, index, json_array_get(parent->json, index)};
    return at;
}


/* write the path from the document to a value, such as "panels[3].name" */
static void json_path(const mus__json_at *at, char *path, size_t bytes)
{
    if (at->parent == NULL) {
        path[0] = '\0';
        return;
    }
    json_path(at->parent, path, bytes);
    size_t length = strlen(path);
    if (at->key != NULL)
        snprintf(path + length, bytes - length, "%s%s", length > 0 ? "." : "", at->key);
    else
        snprintf(path + length, bytes - length, "[%zu]", at->index);
}


mus_status mus__json_fail(const mus__json_at *at, mus_status status, const char *format, ...)
{
    char path[PATH_BYTES], text[SENTENCE_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    json_path(at, path, sizeof path);
    if (path[0] == '\0') return mus__source_fail(at->source, 0, status, "%s", text);
    return mus__source_fail(at->source, 0, status, "at %s: %s", path, text);
}


mus_status mus__json_wrap(const mus__json_at *at, mus_status status)
{
    char text[SENTENCE_BYTES];
    snprintf(text, sizeof text, "%s", mus_context_error(at->source->context));
    return mus__json_fail(at, status == MUS_ERR_ARG ? MUS_ERR_FORMAT : status, "%s", text);
}


static const char *json_type_name(int type)
{
    switch (type) {
    case JSON_OBJECT: return "an object";
    case JSON_ARRAY: return "an array";
    case JSON_STRING: return "a text";
    case JSON_INTEGER: return "an integer";
    case JSON_REAL: return "a number";
    case JSON_TRUE:
    case JSON_FALSE: return "a truth value";
    case JSON_NULL: return "null";
    default: return "nothing";
    }
}


mus_status mus__json_expect(const mus__json_at *at, int type)
{
    if (at->json != NULL && (int)json_typeof(at->json) == type) return MUS_OK;
    return mus__json_fail(at, MUS_ERR_FORMAT, "expected %s, got %s", json_type_name(type),
                          json_type_name(at->json != NULL ? (int)json_typeof(at->json) : -1));
}


mus_status mus__json_array(const mus__json_at *at, size_t low, size_t high, size_t *count)
{
    mus_status status = mus__json_expect(at, JSON_ARRAY);
    if (status != MUS_OK) return status;
    *count = json_array_size(at->json);
    if (*count >= low && *count <= high) return MUS_OK;
    return mus__json_fail(at, MUS_ERR_FORMAT, "expected an array of %zu to %zu, got %zu", low, high, *count);
}


mus_status mus__json_integer(const mus__json_at *at, int32_t low, int32_t high, int32_t *out)
{
    mus_status status = mus__json_expect(at, JSON_INTEGER);
    if (status != MUS_OK) return status;
    json_int_t value = json_integer_value(at->json);
    if (value < low || value > high)
        return mus__json_fail(at, MUS_ERR_FORMAT, "expected an integer in %d .. %d, got %lld", (int)low, (int)high,
                              (long long)value);
    *out = (int32_t)value;
    return MUS_OK;
}


mus_status mus__json_number(const mus__json_at *at, double *out)
{
    if (!json_is_number(at->json)) return mus__json_expect(at, JSON_REAL);
    *out = json_number_value(at->json);
    return MUS_OK;
}


mus_status mus__json_numbers(const mus__json_at *at, size_t count, double *out)
{
    size_t n;
    mus_status status = mus__json_array(at, count, count, &n);
    for (size_t i = 0; i < count && status == MUS_OK; i++) {
        mus__json_at element = mus__json_element(at, i);
        status = mus__json_number(&element, &out[i]);
    }
    return status;
}


mus_status mus__json_text(const mus__json_at *at, const char **out)
{
    mus_status status = mus__json_expect(at, JSON_STRING);
    if (status == MUS_OK) *out = json_string_value(at->json);
    return status;
}


json_t *mus__json_document(const mus__source *source, mus_status *status)
{
    json_error_t error;
    json_t *json = json_loadb(source->text, source->size, JSON_REJECT_DUPLICATES, &error);
    *status = MUS_OK;
    if (json != NULL) return json;
    if (json_error_code(&error) == json_error_out_of_memory)
        *status = mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for the JSON reader");
    else
        *status = mus__source_fail(source, error.line, MUS_ERR_FORMAT, "expected JSON: %s (column %d, byte %d)",
                                   error.text, error.column, error.position);
    return NULL;
}
