/*
 * pattern_read.c: mus_pattern_read: find the form of a pattern file by its content, and call its reader.
 *
 * The room: the files of the garment trade. The readers of muslin's JSON, GarmentCode and FreeSewing are in
 * lib/exchange; here are DXF and its grade rules: dxf_file.c (text to entities), dxf_read.c (which pieces), dxf_ring.c
 * (outline), dxf_panel.c (panel), dxf_name.c, rul_read.c; SVG: svg_path.c (path data), svg_panel.c, svg_read.c,
 * svg_write.c; seam_find.h (seams of a pattern without); and garmentcode_write.c. The room is a part of
 * libmuslin-exchange.
 */
#include <string.h>

#include "exchange/pattern_readers.h"
#include "trade/dxf_file.h"
#include "trade/dxf_read.h"
#include "trade/svg_read.h"
#include "valentina/val_draw.h"


static mus_status read_pattern(const mus__source *source, mus_pattern **out)
{
    /* a pattern without a name of its own gets that of its file */
    static const char *const endings[] = {"_specification.json", ".json", NULL};
    char name[128];
    mus__source_base(source->path, endings, name, sizeof name);

    mus_status status;
    if (mus__dxf_begins(source->text)) {
        static const char *const dxf_endings[] = {".dxf", ".DXF", NULL};
        mus__source_base(source->path, dxf_endings, name, sizeof name);
        status = mus_pattern_create(source->context, name, out);
        return status == MUS_OK ? mus__dxf_read(source, NULL, NULL, *out) : status;
    }
    if (mus__svg_begins(source->text)) {
        static const char *const svg_endings[] = {".svg", ".SVG", NULL};
        mus__source_base(source->path, svg_endings, name, sizeof name);
        status = mus_pattern_create(source->context, name, out);
        return status == MUS_OK ? mus__svg_read(source, *out) : status;
    }
    if (mus__val_begins(source->text)) {
        static const char *const val_endings[] = {".val", ".sm2d", NULL};
        mus__source_base(source->path, val_endings, name, sizeof name);
        status = mus_pattern_create(source->context, name, out);
        return status == MUS_OK ? mus__val_read(source, NULL, NULL, *out) : status;
    }
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
                                "(GarmentCode), or with \"format\" \"freesewing-dump-1\"; or a DXF or SVG");
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


/* read the DXF, then its rules, in the size that is wanted */
static mus_status dxf_load(mus_context *context, const mus_pattern_dxf *from, mus_pattern **out)
{
    static const char *const endings[] = {".dxf", ".DXF", NULL};
    const mus__input files[2] = {{from->path, from->text, from->text_size},
                                 {from->rules_path, from->rules, from->rules_size}};
    mus__source source, rules;
    char name[128];
    mus_status status = mus__source_open(context, &files[0], &source);
    if (status == MUS_OK && files[1].path != NULL) {
        status = mus__source_open(context, &files[1], &rules);
        if (status != MUS_OK) mus__source_close(&source);
    }
    if (status != MUS_OK) return status;
    mus__source_base(from->path, endings, name, sizeof name);
    status = mus_pattern_create(context, name, out);
    if (status == MUS_OK)
        status = mus__dxf_read(&source, files[1].path != NULL ? &rules : NULL, from->size_name, *out);
    if (files[1].path != NULL) mus__source_close(&rules);
    mus__source_close(&source);
    return status;
}


/* read the drawing with its measurements */
static mus_status val_load(mus_context *context, const mus_pattern_val *from, mus_pattern **out)
{
    static const char *const endings[] = {".val", ".sm2d", NULL};
    const mus__input files[2] = {{from->path, from->text, from->text_size},
                                 {from->measures_path, from->measures, from->measures_size}};
    mus__source source, measures;
    char name[128];
    mus_status status = mus__source_open(context, &files[0], &source);
    if (status == MUS_OK && files[1].path != NULL) {
        status = mus__source_open(context, &files[1], &measures);
        if (status != MUS_OK) mus__source_close(&source);
    }
    if (status != MUS_OK) return status;
    mus__source_base(from->path, endings, name, sizeof name);
    status = mus_pattern_create(context, name, out);
    if (status == MUS_OK)
        status = mus__val_read(&source, files[1].path != NULL ? &measures : NULL, from->size_name, *out);
    if (files[1].path != NULL) mus__source_close(&measures);
    mus__source_close(&source);
    return status;
}


void mus_pattern_val_init(mus_pattern_val *val, size_t size)
{
    if (val == NULL || size < sizeof val->size) return;
    memset(val, 0, size);
    val->size = size;
}


mus_status mus_pattern_read_val(mus_context *context, const mus_pattern_val *from, mus_pattern **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (from == NULL || out == NULL)
        return mus__file_fail(context, MUS_ERR_ARG, "mus_pattern_read_val: a required pointer is NULL");
    if (from->size != sizeof *from)
        return mus__file_fail(context, MUS_ERR_VERSION, "mus_pattern_val: size %zu, this library knows %zu; use "
                              "mus_pattern_val_init", from->size, sizeof *from);
    if (from->path == NULL || (from->measures != NULL && from->measures_path == NULL))
        return mus__file_fail(context, MUS_ERR_ARG, "mus_pattern_read_val: a path is NULL; messages show it");
    mus_pattern *pattern = NULL;
    const mus_status status = val_load(context, from, &pattern);
    if (status == MUS_OK) *out = pattern;
    else mus_pattern_destroy(pattern);
    return status;
}


mus_status mus_pattern_read_dxf(mus_context *context, const mus_pattern_dxf *from, mus_pattern **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (from == NULL || out == NULL)
        return mus__file_fail(context, MUS_ERR_ARG, "mus_pattern_read_dxf: a required pointer is NULL");
    if (from->size != sizeof *from)
        return mus__file_fail(context, MUS_ERR_VERSION, "mus_pattern_dxf: size %zu, this library knows %zu; use "
                              "mus_pattern_dxf_init", from->size, sizeof *from);
    if (from->path == NULL || (from->rules != NULL && from->rules_path == NULL))
        return mus__file_fail(context, MUS_ERR_ARG, "mus_pattern_read_dxf: a path is NULL; messages show it");
    mus_pattern *pattern = NULL;
    const mus_status status = dxf_load(context, from, &pattern);
    if (status == MUS_OK) *out = pattern;
    else mus_pattern_destroy(pattern);
    return status;
}
