/*
 * print_dxf.c: the DXF and RUL files of muslin print.
 *
 * --sizes lists further table sizes: the design is drafted in each of them, the DXF gets a block for each piece of each
 * size, and the RUL file the rules from the sheet's own size to each.
 */
#include <stdio.h>
#include <string.h>

#include "print_dxf.h"
#include "print_sizes.h"

int32_t print_dxf_dialect(const char *name)
{
    if (name == NULL || strcmp(name, "astm") == 0) return MUS_DXF_ASTM;
    return strcmp(name, "aama") == 0 ? MUS_DXF_AAMA : MUS_NONE;
}


int print_dxf_write(scene *s, const source *from, const mus_sheet *sheet, const mus_sheet_def *def,
                    const print_dxf *ask)
{
    print_sizes sizes = {0};
    mus_sheet *sheets[SIZES_MOST] = {NULL};
    mus_sheet_dxf dxf;
    mus_sheet_dxf_init(&dxf, sizeof dxf);
    dxf.dialect = print_dxf_dialect(ask->dialect);
    dxf.boundary = ask->sew ? MUS_DXF_SEW : MUS_DXF_CUT;
    dxf.size_name = from->size != NULL ? from->size : s->tape != NULL ? mus_tape_name(s->tape) : NULL;
    if (dxf.size_name != NULL && dxf.size_name[0] == '\0') dxf.size_name = NULL;
    dxf.nested = 1;
    int code = ask->sizes != NULL ? print_sizes_draft(s, from, ask->sizes, false, &sizes) : EXIT_DONE;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < sizes.count && code == EXIT_DONE && status == MUS_OK; i++)
        status = mus_sheet_create(s->context, sizes.patterns[i], def, &sheets[i]);
    dxf.size_count = sizes.count;
    dxf.sheets = (const mus_sheet *const *)sheets;
    dxf.size_names = sizes.name_list;
    if (sizes.count == 0) dxf.nested = 0;
    if (code == EXIT_DONE && status == MUS_OK && ask->dxf != NULL) status = mus_sheet_write_dxf(sheet, &dxf, ask->dxf);
    if (code == EXIT_DONE && status == MUS_OK && ask->rul != NULL) status = mus_sheet_write_rul(sheet, &dxf, ask->rul);
    for (int32_t i = 0; i < sizes.count; i++) mus_sheet_destroy(sheets[i]);
    print_sizes_free(&sizes);
    return status == MUS_OK ? code : scene_fail_output(s, status);
}
