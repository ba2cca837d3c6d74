/*
 * print_dxf.c: the DXF and RUL files of muslin print.
 *
 * --sizes lists further table sizes: the design is drafted in each of them, the DXF gets a block for each piece of each
 * size, and the RUL file the rules from the sheet's own size to each.
 */
#include <stdio.h>
#include <string.h>

#include "print_dxf.h"

#define SIZES_MOST 64

typedef struct other_sizes {
    int32_t count;
    char names[SIZES_MOST][32];
    const char *name_list[SIZES_MOST];
    mus_sheet *sheets[SIZES_MOST];
} other_sizes;


int32_t print_dxf_dialect(const char *name)
{
    if (name == NULL || strcmp(name, "astm") == 0) return MUS_DXF_ASTM;
    return strcmp(name, "aama") == 0 ? MUS_DXF_AAMA : MUS_NONE;
}


/* Drafts one size and lays it out on a sheet of its own. */
static int draft_size(scene *s, const source *from, const mus_sheet_def *def, const char *size, mus_sheet **out)
{
    mus_tape *tape = s->tape;
    mus_pattern *pattern = s->pattern;
    s->tape = NULL;
    s->pattern = NULL;
    mus_status status = mus_tape_create(s->context, &s->tape);
    if (status == MUS_OK) status = mus_tape_set_size(s->tape, size);
    int code = status == MUS_OK ? scene_pattern(s, from) : scene_fail(s, status);
    if (code == EXIT_DONE) {
        status = mus_sheet_create(s->context, s->pattern, def, out);
        if (status != MUS_OK) code = scene_fail(s, status);
    }
    mus_pattern_destroy(s->pattern);
    mus_tape_destroy(s->tape);
    s->tape = tape;
    s->pattern = pattern;
    return code;
}


/* Drafts the sizes of the list but for the sheet's own. */
static int draft_sizes(scene *s, const source *from, const mus_sheet_def *def, const char *list, other_sizes *out)
{
    int code = EXIT_DONE;
    if (from->pattern != NULL) return complain(EXIT_INPUT, "print", "--sizes: needs --design or --words");
    while (*list != '\0' && code == EXIT_DONE) {
        const size_t n = strcspn(list, ",");
        if (out->count == SIZES_MOST) return complain(EXIT_INPUT, "print", "--sizes: more than %d sizes", SIZES_MOST);
        char *name = out->names[out->count];
        if (n == 0 || n >= sizeof out->names[0]) return complain(EXIT_INPUT, "print", "--sizes %s: no size", list);
        memcpy(name, list, n);
        name[n] = '\0';
        list += n + (list[n] == ',');
        if (from->size != NULL && strcmp(name, from->size) == 0) continue;
        out->name_list[out->count] = name;
        code = draft_size(s, from, def, name, &out->sheets[out->count]);
        out->count++;
    }
    return code;
}


int print_dxf_write(scene *s, const source *from, const mus_sheet *sheet, const mus_sheet_def *def,
                    const print_dxf *ask)
{
    other_sizes sizes = {0};
    mus_sheet_dxf dxf;
    mus_sheet_dxf_init(&dxf, sizeof dxf);
    dxf.dialect = print_dxf_dialect(ask->dialect);
    dxf.boundary = ask->sew ? MUS_DXF_SEW : MUS_DXF_CUT;
    dxf.size_name = from->size != NULL ? from->size : s->tape != NULL ? mus_tape_name(s->tape) : NULL;
    if (dxf.size_name != NULL && dxf.size_name[0] == '\0') dxf.size_name = NULL;
    dxf.nested = 1;
    int code = ask->sizes != NULL ? draft_sizes(s, from, def, ask->sizes, &sizes) : EXIT_DONE;
    dxf.size_count = sizes.count;
    dxf.sheets = (const mus_sheet *const *)sizes.sheets;
    dxf.size_names = sizes.name_list;
    if (sizes.count == 0) dxf.nested = 0;
    mus_status status = MUS_OK;
    if (code == EXIT_DONE && ask->dxf != NULL) status = mus_sheet_write_dxf(sheet, &dxf, ask->dxf);
    if (code == EXIT_DONE && status == MUS_OK && ask->rul != NULL) status = mus_sheet_write_rul(sheet, &dxf, ask->rul);
    for (int32_t i = 0; i < sizes.count; i++) mus_sheet_destroy(sizes.sheets[i]);
    return status == MUS_OK ? code : scene_fail_output(s, status);
}
