/*
 * fabric_json.c: read and write a fabric as JSON: each value under a key that names the unit, as a number and its
 * source.
 *
 * Keys and ranges are those of libmuslin (mus_fabric_value_key, mus_fabric_set), so a file cannot hold a value that a
 * cloth refuses. jansson does not keep the lines of values, so a message finds its line by searching the text for the
 * key. Form: muslin_fabric(5).
 */
#include <stdbool.h>
#include <string.h>

#include "exchange/file_read.h"
#include "exchange/json_path.h"
#include "file/sink.h"

#define FABRIC_NAME_BYTES 100    /* [bytes] longest name; chosen, as muslin_fabric(5) says */
#define FABRIC_SOURCE_BYTES 1000 /* [bytes] longest source of a value; chosen, as muslin_fabric(5) says */
#define FABRIC_VALUES_MAX 32     /* most values of a fabric: capacity of arrays on the stack; a fabric has twelve */
#define FABRIC_VALUES_ASKED 10   /* the first values must be in a file; a later one that is left out is 0 */


/* end of the JSON string that starts at `text` (a quote), or of the whole text when the string does not end */
static const char *fabric_string_end(const char *text)
{
    for (text++; *text != '\0' && *text != '"'; text++)
        if (*text == '\\' && text[1] != '\0') text++;
    return text;
}


/*
 * Line of the member `key` of the document or, when `parent` is not NULL, of the member `parent`. Without such a key
 * the line of the parent, without both the last line. The text has to be valid JSON.
 */
static int64_t fabric_line(const mus__source *source, const char *parent, const char *key)
{
    int64_t line = 1, found = 0;
    int32_t depth = 0;
    bool inside = false;
    for (const char *at = source->text; *at != '\0'; at++) {
        if (*at == '\n') line++;
        if (*at == '{' || *at == '[') depth++;
        if (*at == '}' || *at == ']') depth--;
        if (depth <= 1 && (*at == ',' || *at == '}')) inside = false;
        if (*at != '"') continue;

        const char *end = fabric_string_end(at), *after = end + (*end != '\0');
        const size_t length = (size_t)(end - at - 1);
        after += strspn(after, " \t\r\n");
        if (*after == ':' && depth == 1 && parent != NULL && strlen(parent) == length &&
            memcmp(at + 1, parent, length) == 0)
            inside = true, found = line;
        if (*after == ':' && (parent == NULL ? depth == 1 : inside && depth == 2) && strlen(key) == length &&
            memcmp(at + 1, key, length) == 0)
            return line;
        for (; at < end; at++)
            if (*at == '\n') line++;
        if (*at == '\0') break;
    }

    /* a line feed at the end of the text does not begin another line */
    if (found == 0 && source->size > 0 && source->text[source->size - 1] == '\n') line--;
    return found > 0 ? found : line;
}


/* MUS_ERR_FORMAT unless every member has one of the `count` known keys */
static mus_status fabric_keys(const mus__source *source, const char *parent, json_t *json, int32_t count,
                              const char *const *known)
{
    for (void *at = json_object_iter(json); at != NULL; at = json_object_iter_next(json, at)) {
        const char *key = json_object_iter_key(at);
        bool good = false;
        for (int32_t k = 0; k < count; k++) good = good || strcmp(key, known[k]) == 0;
        if (!good)
            return mus__source_fail(source, fabric_line(source, parent, key), MUS_ERR_FORMAT,
                                    "%s%sthe key \"%.100s\" is unknown", parent != NULL ? parent : "",
                                    parent != NULL ? ": " : "", key);
    }
    return MUS_OK;
}


/* MUS_ERR_FORMAT unless the member is a text of 1 to `most` bytes */
static mus_status fabric_text(const mus__source *source, const char *parent, const char *key, const json_t *json,
                              size_t most)
{
    const char *where = parent != NULL ? parent : "the fabric";
    const int64_t line = fabric_line(source, parent, key);
    if (!json_is_string(json))
        return mus__source_fail(source, line, MUS_ERR_FORMAT, "%s has no text \"%s\"", where, key);
    const size_t length = json_string_length(json);
    if (length >= 1 && length <= most) return MUS_OK;
    return mus__source_fail(source, line, MUS_ERR_FORMAT, "%s: \"%s\" has %zu bytes, expected 1 to %zu", where, key,
                            length, most);
}


static mus_status fabric_read_value(const mus__source *source, json_t *json, int32_t value, mus_fabric *fabric)
{
    static const char *const known[] = {"value", "source"};
    const char *key = mus_fabric_value_key(value);
    json_t *member = json_object_get(json, key), *number = json_object_get(member, "value");
    const int64_t line = fabric_line(source, NULL, key);
    if (member == NULL && value >= FABRIC_VALUES_ASKED) return mus_fabric_set(source->context, fabric, value, 0.0);
    if (member == NULL) return mus__source_fail(source, line, MUS_ERR_FORMAT, "the fabric has no \"%s\"", key);
    if (!json_is_object(member))
        return mus__source_fail(source, line, MUS_ERR_FORMAT, "%s: expected {\"value\": number, \"source\": text}",
                                key);
    mus_status status = fabric_keys(source, key, member, 2, known);
    if (status != MUS_OK) return status;
    if (!json_is_number(number))
        return mus__source_fail(source, fabric_line(source, key, "value"), MUS_ERR_FORMAT, "%s has no number \"value\"",
                                key);
    status = fabric_text(source, key, "source", json_object_get(member, "source"), FABRIC_SOURCE_BYTES);
    if (status != MUS_OK) return status;
    status = mus_fabric_set(source->context, fabric, value, json_number_value(number));
    return status == MUS_OK ? MUS_OK : mus__source_wrap(source, fabric_line(source, key, "value"), status);
}


/* keys of the document: format, name and values; returns their number */
static int32_t fabric_known(const char **known)
{
    int32_t count = 0;
    known[count++] = "muslin_fabric";
    known[count++] = "name";
    for (int32_t v = 0; v < mus_fabric_value_count() && v < FABRIC_VALUES_MAX; v++)
        known[count++] = mus_fabric_value_key(v);
    return count;
}


static mus_status fabric_read(const mus__source *source, mus_fabric *fabric)
{
    mus_status status;
    const char *known[FABRIC_VALUES_MAX + 2];
    json_t *json = mus__json_document(source, &status);
    if (json == NULL) return status;

    const json_t *form = json_object_get(json, "muslin_fabric");
    if (!json_is_integer(form) || json_integer_value(form) != 1)
        status = mus__source_fail(source, form != NULL ? fabric_line(source, NULL, "muslin_fabric") : 1, MUS_ERR_FORMAT,
                                  "expected a fabric: an object with \"muslin_fabric\": 1");
    if (status == MUS_OK) status = fabric_keys(source, NULL, json, fabric_known(known), known);
    if (status == MUS_OK) status = fabric_text(source, NULL, "name", json_object_get(json, "name"), FABRIC_NAME_BYTES);
    for (int32_t v = 0; status == MUS_OK && v < mus_fabric_value_count(); v++)
        status = fabric_read_value(source, json, v, fabric);
    json_decref(json);
    return status;
}


static mus_status fabric_load(mus_context *context, const mus__input *input, mus_fabric *out, const char *what)
{
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__input_check(context, input, out, what);
    if (status != MUS_OK) return status;
    double ignored;
    status = mus_fabric_get(out, 0, &ignored);
    if (status != MUS_OK) return mus__file_fail(context, status, "%s: the size of out; use mus_fabric_init", what);

    mus_fabric fabric = *out;
    mus__source source;
    status = mus__source_open(context, input, &source);
    if (status == MUS_OK) status = fabric_read(&source, &fabric);
    mus__source_close(&source);
    if (status == MUS_OK) *out = fabric;
    return status;
}


mus_status mus_fabric_load(mus_context *context, const char *path, mus_fabric *out)
{
    return fabric_load(context, &(mus__input){path, NULL, 0}, out, "mus_fabric_load");
}


mus_status mus_fabric_load_from(mus_context *context, const char *text, size_t size, const char *name, mus_fabric *out)
{
    return fabric_load(context, &(mus__input){name, text != NULL ? text : "", size}, out, "mus_fabric_load_from");
}


/* ---- writing ---- */

/* get the sources of a named fabric; false when there is no such fabric */
static bool fabric_named(const char *name, const char **sources)
{
    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        if (strcmp(name, mus_fabric_name(i)) != 0) continue;
        for (int32_t v = 0; v < mus_fabric_value_count(); v++) sources[v] = mus_fabric_value_source(i, v);
        return true;
    }
    return false;
}


static mus_status fabric_check_text(mus_context *context, const char *what, const char *text, size_t most)
{
    const size_t length = text != NULL ? strlen(text) : 0;
    if (length < 1 || length > most)
        return mus__file_fail(context, MUS_ERR_ARG, "mus_fabric_save: %s has %zu bytes, expected 1 to %zu", what,
                              length, most);
    if (mus__utf8_span(text) < length)
        return mus__file_fail(context, MUS_ERR_ARG, "mus_fabric_save: %s is not UTF-8", what);
    return MUS_OK;
}


static mus_status fabric_write(mus_context *context, const mus_fabric *fabric, const char *name,
                               const char *const *sources, const mus__target *target)
{
    mus__sink sink;
    mus__sink_init(&sink, context);
    mus__sink_print(&sink, "{\"muslin_fabric\": 1,\n \"name\": ");
    mus__sink_quote(&sink, name);
    for (int32_t v = 0; v < mus_fabric_value_count(); v++) {
        double number = 0.0;
        mus_fabric_get(fabric, v, &number);
        if (v >= FABRIC_VALUES_ASKED && !(number > 0.0)) continue;
        mus__sink_print(&sink, ",\n \"%s\": {\"value\": ", mus_fabric_value_key(v));
        mus__sink_number(&sink, number);
        mus__sink_print(&sink, ", \"source\": ");
        mus__sink_quote(&sink, sources[v]);
        mus__sink_print(&sink, "}");
    }
    mus__sink_print(&sink, "}\n");
    const mus_status status = mus__sink_give(&sink, target);
    mus__sink_free(&sink);
    return status;
}


static mus_status fabric_save(mus_context *context, const mus_fabric *fabric, const char *name,
                              const char *const *sources, const mus__target *target, const char *what)
{
    const char *own[FABRIC_VALUES_MAX];
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK && fabric == NULL) status = mus__file_fail(context, MUS_ERR_ARG, "%s: fabric is NULL", what);
    if (status == MUS_OK) status = mus_fabric_check(context, fabric);
    if (status == MUS_OK) status = fabric_check_text(context, "the name", name, FABRIC_NAME_BYTES);
    if (status == MUS_OK && sources == NULL && !fabric_named(name, own))
        status =
            mus__file_fail(context, MUS_ERR_ARG, "mus_fabric_save: no sources, and no fabric is named %s", name);
    for (int32_t v = 0; status == MUS_OK && sources != NULL && v < mus_fabric_value_count(); v++) {
        own[v] = sources[v];
        status = fabric_check_text(context, mus_fabric_value_key(v), own[v], FABRIC_SOURCE_BYTES);
    }
    if (status != MUS_OK) return status;

    mus__locale locale;
    status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;
    status = fabric_write(context, fabric, name, own, target);
    mus__locale_leave(&locale);
    return status;
}


mus_status mus_fabric_save(mus_context *context, const mus_fabric *fabric, const char *name, const char *const *sources,
                           const char *path)
{
    const mus__target target = {path, NULL, NULL};
    return fabric_save(context, fabric, name, sources, &target, "mus_fabric_save");
}


mus_status mus_fabric_save_bytes(mus_context *context, const mus_fabric *fabric, const char *name,
                                 const char *const *sources, char **bytes, size_t *size)
{
    const mus__target target = {NULL, bytes, size};
    return fabric_save(context, fabric, name, sources, &target, "mus_fabric_save_bytes");
}
