/*
 * dxf.c: the sheet as DXF R12 in the dialects of the garment trade, and its grade rules as RUL.
 *
 * The file has a header with the version alone, one block a piece (and size), and an INSERT for each block. It has no
 * tables and no layout blocks: Gerber AccuMark refuses files with either. Numbers are written from integers, so that no
 * locale can put a comma into them. RUL: lines end with CR LF, as every program of the trade writes them.
 * Source: ANSI/AAMA-292-1993; ASTM D6673-10, Sewn Products Pattern Data Interchange.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cutter/dxf.h"


/* name of the block of a piece: with its size when there are several */
static void dxf_block_name(const mus__dxf *dxf, int32_t piece, int32_t size, char *out, size_t capacity)
{
    int n = snprintf(out, capacity, "%s", dxf->names[piece]);
    if (!dxf->def.nested) return;
    n += snprintf(out + n, capacity - (size_t)n, "_%.20s", mus__dxf_size_name(dxf, size));
    for (char *c = out; *c != '\0'; c++) {
        if (*c >= 'a' && *c <= 'z') *c = (char)(*c - 'a' + 'A');
        if (!((*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9'))) *c = '_';
    }
}


static void dxf_style(const mus__dxf *dxf)
{
    static const double origin[2] = {0.0, 0.0};
    mus__sink *bytes = dxf->bytes;
    mus__dxf_label(bytes, 1, origin, "Style Name", dxf->sheet->title);
    if (dxf->def.date != NULL) mus__dxf_label(bytes, 1, origin, "Creation Date", dxf->def.date);
    mus__dxf_label(bytes, 1, origin, "Author", dxf->sheet->person != NULL ? dxf->sheet->person : "muslin");
    mus__dxf_label(bytes, 1, origin, "Sample Size", dxf->def.size_name);
    if (dxf->nsize > 1) mus__dxf_label(bytes, 1, origin, "Grade Rule Table", dxf->sheet->title);
    mus__dxf_label(bytes, 1, origin, "Units", "METRIC");
    if (dxf->def.dialect == MUS_DXF_ASTM)
        mus__dxf_label(bytes, 1, origin, "ASTM/D13Proposal 1 Version", "D 6673-04");
}


static void dxf_document(const mus__dxf *dxf)
{
    mus__sink *bytes = dxf->bytes;
    const int32_t sizes = dxf->def.nested ? dxf->nsize : 1;
    char name[64];
    mus__sink_print(bytes, "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n");
    for (int32_t size = 0; size < sizes; size++) {
        for (int32_t piece = 0; piece < dxf->sheet->npiece; piece++) {
            dxf_block_name(dxf, piece, size, name, sizeof name);
            mus__sink_print(bytes, "0\nBLOCK\n8\n1\n2\n%s\n70\n0\n10\n0\n20\n0\n", name);
            mus__dxf_piece(dxf, piece, size);
            mus__sink_print(bytes, "0\nENDBLK\n8\n1\n");
        }
    }
    mus__sink_print(bytes, "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
    dxf_style(dxf);
    for (int32_t size = 0; size < sizes; size++) {
        for (int32_t piece = 0; piece < dxf->sheet->npiece; piece++) {
            dxf_block_name(dxf, piece, size, name, sizeof name);
            mus__sink_print(bytes, "0\nINSERT\n8\n1\n2\n%s\n10\n0\n20\n0\n", name);
        }
    }
    mus__sink_print(bytes, "0\nENDSEC\n0\nEOF\n");
}


/* a size's name as one word of a RUL list */
static void rul_size(const mus__dxf *dxf, int32_t i)
{
    mus__sink_add(dxf->bytes, " ", 1);
    for (const char *c = mus__dxf_size_name(dxf, i); *c != '\0'; c++) {
        const bool plain = *c > ' ' && *c < 0x7f && *c != ',';
        mus__sink_add(dxf->bytes, plain ? c : "_", 1);
    }
}


static void rul_document(const mus__dxf *dxf)
{
    mus__sink *bytes = dxf->bytes;
    char title[256];
    snprintf(title, sizeof title, "%.200s", dxf->sheet->title);
    for (char *c = title; *c != '\0'; c++)
        if (*c < ' ' || *c > '~') *c = '_';
    const bool aama = dxf->def.dialect == MUS_DXF_AAMA;
    mus__sink_print(bytes, "%s\r\nAUTHOR: muslin\r\n",
                    aama ? "version ANSI/AAMA-292-B" : "ASTM/D13Proposal 1 Version: D 6673-04");
    if (dxf->def.date != NULL) mus__sink_print(bytes, "CREATION DATE: %.40s\r\n", dxf->def.date);
    mus__sink_print(bytes, "UNITS: METRIC\r\nGRADE RULE TABLE: %s\r\nSAMPLE SIZE:", title);
    rul_size(dxf, 0);
    mus__sink_print(bytes, "\r\nNUMBER OF SIZES: %d\r\nSIZE LIST:", (int)dxf->nsize);
    for (int32_t i = 0; i < dxf->nsize; i++) rul_size(dxf, i);
    mus__sink_print(bytes, "\r\n");
    for (int32_t r = 0; r < dxf->nrule; r++) {
        const int32_t *rule = dxf->rules + (size_t)r * 2 * (size_t)dxf->nsize;
        mus__sink_print(bytes, "RULE: DELTA %d\r\n", (int)r + 1);
        for (int32_t i = 0; i < dxf->nsize; i++) {
            mus__print_number(bytes, 1e-7 * rule[2 * i]);
            mus__sink_add(bytes, ", ", 2);
            mus__print_number(bytes, 1e-7 * rule[2 * i + 1]);
            mus__sink_print(bytes, i % 4 == 3 || i + 1 == dxf->nsize ? "\r\n" : " ");
        }
    }
    mus__sink_print(bytes, "END\r\n");
}


static mus_status dxf_write(const mus_sheet *sheet, const mus_sheet_dxf *def, bool rules, const mus__target *target,
                            const char *what)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(sheet->context, target, what);
    if (status != MUS_OK) return status;
    if (sheet->nsize > 1)
        return mus__file_fail(sheet->context, MUS_ERR_ARG, "a DXF is written from sheets of one size each");
    if (sheet->def.fold)
        return mus__file_fail(sheet->context, MUS_ERR_ARG, "%s: the sheet has half pieces; make one of whole pieces",
                              what);
    mus__sink bytes;
    mus__dxf dxf;
    mus__sink_init(&bytes, sheet->context);
    status = mus__dxf_open(sheet, def, &dxf);
    dxf.bytes = &bytes;
    if (status == MUS_OK && rules) rul_document(&dxf);
    if (status == MUS_OK && !rules) dxf_document(&dxf);
    if (status == MUS_OK) status = bytes.status;
    if (status == MUS_OK) status = mus__sink_give(&bytes, target);
    mus__sink_free(&bytes);
    mus__dxf_free(&dxf);
    return status;
}


mus_status mus_sheet_write_dxf(const mus_sheet *sheet, const mus_sheet_dxf *def, const char *path)
{
    return dxf_write(sheet, def, false, &(mus__target){path, NULL, NULL}, "mus_sheet_write_dxf");
}


mus_status mus_sheet_write_dxf_bytes(const mus_sheet *sheet, const mus_sheet_dxf *def, char **bytes, size_t *size)
{
    return dxf_write(sheet, def, false, &(mus__target){NULL, bytes, size}, "mus_sheet_write_dxf_bytes");
}


mus_status mus_sheet_write_rul(const mus_sheet *sheet, const mus_sheet_dxf *def, const char *path)
{
    return dxf_write(sheet, def, true, &(mus__target){path, NULL, NULL}, "mus_sheet_write_rul");
}


mus_status mus_sheet_write_rul_bytes(const mus_sheet *sheet, const mus_sheet_dxf *def, char **bytes, size_t *size)
{
    return dxf_write(sheet, def, true, &(mus__target){NULL, bytes, size}, "mus_sheet_write_rul_bytes");
}
