/*
 * pattern_read.c: mus_pattern_read: find the form of a pattern file by its content, and call its reader.
 */
#include <stdbool.h>
#include <string.h>

#include "exchange/pattern_readers.h"


static mus_status read_pattern(const mus__source *source, mus_pattern **out)
{
    /* a pattern without a name of its own gets that of its file */
    static const char *const endings[] = {"_specification.json", ".json", NULL};
    char name[128];
    mus__source_base(source->path, endings, name, sizeof name);

    mus_status status;
    json_t *json = mus__json_document(source, &status);
    if (json == NULL) return status;
    mus__json_at root = {source, NULL, NULL, 0, json};
    bool own = json_object_get(json, "muslin_pattern") != NULL;
    bool garmentcode = json_object_get(json, "pattern") != NULL;
    const char *format = json_string_value(json_object_get(json, "format"));
    bool freesewing = format != NULL && strcmp(format, "freesewing-dump-1") == 0;
    if (!own && !garmentcode && !freesewing)
        status = mus__json_fail(&root, MUS_ERR_FORMAT,
                                "expected a pattern: an object with \"muslin_pattern\", with \"pattern\" "
                                "(GarmentCode), or with \"format\" \"freesewing-dump-1\"");
    if (status == MUS_OK) status = mus_pattern_create(source->context, name, out);
    if (status == MUS_OK)
        status = own          ? mus__pattern_read_json(&root, *out)
                 : freesewing ? mus__pattern_read_freesewing(&root, *out)
                              : mus__pattern_read_garmentcode(&root, *out);
    json_decref(json);
    return status;
}


static mus_status pattern_load(mus_context *context, const mus__input *input, mus_pattern **out, const char *what)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__input_check(context, input, out, what);
    if (status != MUS_OK) return status;
    mus__source source;
    mus_pattern *pattern = NULL;
    status = mus__source_open(context, input, &source);
    if (status == MUS_OK) status = read_pattern(&source, &pattern);
    mus__source_close(&source);
    if (status == MUS_OK) *out = pattern;
    else mus_pattern_destroy(pattern);
    return status;
}


mus_status mus_pattern_read(mus_context *context, const char *path, mus_pattern **out)
{
    return pattern_load(context, &(mus__input){path, NULL, 0}, out, "mus_pattern_read");
}


mus_status mus_pattern_read_from(mus_context *context, const char *text, size_t size, const char *name,
                                 mus_pattern **out)
{
    return pattern_load(context, &(mus__input){name, text != NULL ? text : "", size}, out, "mus_pattern_read_from");
}
