/*
 * dxf_rules.c: the options of a DXF file, its texts, names of pieces as the trade allows them, and grade rules.
 *
 * A grade rule is the displacement of a point from the sample size to each size. The points are the ends of the edges,
 * in the frame of their panel with the grain up. Points with equal rules share a number.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cutter/dxf.h"

#define SIZES_MOST 64 /* sizes besides the sample; chosen: twice the longest size list of a shop */
#define RULE_UNIT 1e-7 /* [m] step of a rule: the last digit of the file */
#define DXF_LETTERS "2.5" /* [mm] height of letters; chosen: as Valentina writes them */


void mus_sheet_dxf_init(mus_sheet_dxf *def, size_t size)
{
    if (def == NULL || size < sizeof def->size) return;
    memset(def, 0, size);
    if (size < sizeof *def) return;
    def->size = size;
    def->dialect = MUS_DXF_ASTM;
}


void mus__dxf_text(mus__sink *bytes, int32_t code, const char *text)
{
    mus__sink_print(bytes, "%d\n", (int)code);
    while (*text != '\0') {
        const uint32_t c = mus__text_character(&text);
        if (c >= 0x20 && c < 0x7f) mus__sink_print(bytes, "%c", (int)c);
        else if (c >= 0xa0 && c < 0x10000 && c != 0xfffd) mus__sink_print(bytes, "\\U+%04X", (unsigned)c);
        else mus__sink_print(bytes, "?");
    }
    mus__sink_add(bytes, "\n", 1);
}


void mus__dxf_label(mus__sink *bytes, int32_t layer, const double *at, const char *key, const char *value)
{
    char text[256];
    snprintf(text, sizeof text, "%s%s%.160s", key != NULL ? key : "", key != NULL ? ": " : "", value);
    mus__sink_print(bytes, "0\nTEXT\n8\n%d\n10\n", (int)layer);
    mus__print_number(bytes, at[0]);
    mus__sink_print(bytes, "\n20\n");
    mus__print_number(bytes, at[1]);
    mus__sink_print(bytes, "\n40\n" DXF_LETTERS "\n");
    mus__dxf_text(bytes, 1, text);
}


void mus__dxf_free(mus__dxf *dxf)
{
    mus__print_free(dxf->sheet->context, dxf->rule_of);
    mus__print_free(dxf->sheet->context, dxf->rules);
    mus__print_free(dxf->sheet->context, dxf->names);
}


const mus_sheet *mus__dxf_sheet(const mus__dxf *dxf, int32_t i)
{
    return i == 0 ? dxf->sheet : dxf->def.sheets[i - 1];
}


const char *mus__dxf_size_name(const mus__dxf *dxf, int32_t i)
{
    return i == 0 ? dxf->def.size_name : dxf->def.size_names[i - 1];
}


static mus_status dxf_options(mus__dxf *dxf, const mus_sheet_dxf *def)
{
    mus_context *context = dxf->sheet->context;
    mus_sheet_dxf_init(&dxf->def, sizeof dxf->def);
    if (def != NULL) {
        if (def->size != sizeof *def)
            return mus__file_fail(context, MUS_ERR_VERSION, "mus_sheet_dxf: size %zu, this library knows %zu; use "
                                  "mus_sheet_dxf_init", def->size, sizeof *def);
        dxf->def = *def;
    }
    def = &dxf->def;
    if (def->dialect != MUS_DXF_AAMA && def->dialect != MUS_DXF_ASTM)
        return mus__file_fail(context, MUS_ERR_ARG, "dxf: dialect %d; expected 0 (AAMA) or 1 (ASTM)", def->dialect);
    if (def->boundary != MUS_DXF_CUT && def->boundary != MUS_DXF_SEW)
        return mus__file_fail(context, MUS_ERR_ARG, "dxf: boundary %d; expected 0 (cut) or 1 (sew)", def->boundary);
    if (def->size_count < 0 || def->size_count > SIZES_MOST)
        return mus__file_fail(context, MUS_ERR_ARG, "dxf: %d sizes; expected 0 to %d", def->size_count, SIZES_MOST);
    if (dxf->def.size_name == NULL) dxf->def.size_name = "1";
    dxf->nsize = def->size_count + 1;
    for (int32_t i = 0; i < def->size_count; i++)
        if (def->sheets == NULL || def->size_names == NULL || def->sheets[i] == NULL || def->size_names[i] == NULL)
            return mus__file_fail(context, MUS_ERR_ARG, "dxf: size %d has no sheet or no name", i + 1);
    return MUS_OK;
}


/* each size has the pieces of the sample, with as many edges; counts the points */
static mus_status dxf_sizes(mus__dxf *dxf)
{
    const mus_sheet *own = dxf->sheet;
    for (int32_t p = 0; p < own->npiece; p++) dxf->npoint += own->pieces[p].nside;
    for (int32_t i = 1; i < dxf->nsize; i++) {
        const mus_sheet *other = mus__dxf_sheet(dxf, i);
        const char *size = mus__dxf_size_name(dxf, i);
        if (other->npiece != own->npiece)
            return mus__file_fail(own->context, MUS_ERR_ARG, "dxf: size %.40s has %d pieces, the sample has %d", size,
                                  other->npiece, own->npiece);
        for (int32_t p = 0; p < own->npiece; p++)
            if (strcmp(other->names[p], own->names[p]) != 0 || other->pieces[p].nside != own->pieces[p].nside)
                return mus__file_fail(own->context, MUS_ERR_ARG,
                                      "dxf: size %.40s: piece %.60s has %d edges; the sample has %.60s with %d. Rules "
                                      "move the points of the sample and make no dart", size, other->names[p],
                                      other->pieces[p].nside, own->names[p], own->pieces[p].nside);
    }
    return MUS_OK;
}


/* name `name` in capitals; a character that is no letter, digit or "_" becomes "_" */
static void dxf_name_clean(const char *name, char *out)
{
    int32_t n = 0;
    for (; *name != '\0' && n < MUS__DXF_NAME - 1; name++) {
        char c = *name;
        if (((unsigned char)c & 0xc0) == 0x80) continue; /* the rest of a character of UTF-8 */
        if (c >= 'a' && c <= 'z') c = (char)(c - 'a' + 'A');
        out[n++] = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
    }
    if (n == 0) out[n++] = '_';
    out[n] = '\0';
}


/* names of all pieces; one that an earlier piece has gets the piece's number at its end */
static mus_status dxf_names(mus__dxf *dxf)
{
    const int32_t n = dxf->sheet->npiece;
    dxf->names = mus__print_new(dxf->sheet->context, n, sizeof *dxf->names);
    if (dxf->names == NULL) return mus__print_memory(dxf->sheet->context, "names of pieces");
    for (int32_t i = 0; i < n; i++) {
        char *name = dxf->names[i];
        bool taken = false;
        dxf_name_clean(dxf->sheet->names[i], name);
        for (int32_t k = 0; k < i && !taken; k++) taken = strcmp(name, dxf->names[k]) == 0;
        if (!taken) continue;
        char number[16];
        const int length = snprintf(number, sizeof number, "_%d", (int)i + 1);
        const size_t keep = MUS__DXF_NAME - 1 - (size_t)length;
        if (strlen(name) > keep) name[keep] = '\0';
        memcpy(name + strlen(name), number, (size_t)length + 1);
    }
    return MUS_OK;
}


/* place of the start of a side in the frame of its panel, with the grain up [m] */
static void dxf_side_start(const mus__piece *piece, int32_t side, double *out)
{
    int32_t k = 0;
    while (k < piece->nspan && piece->spans[k].side != side) k++;
    for (int32_t i = 0; i < 2; i++) out[i] = k < piece->nspan ? piece->spans[k].p[i] - piece->shift[i] : 0.0;
}


static mus_status dxf_rules(mus__dxf *dxf)
{
    const mus_sheet *own = dxf->sheet;
    const int32_t width = 2 * dxf->nsize;
    if (dxf->nsize == 1) return MUS_OK;
    dxf->rule_of = mus__print_new(own->context, dxf->npoint, sizeof *dxf->rule_of);
    dxf->rules = mus__print_new(own->context, (int64_t)dxf->npoint * width, sizeof *dxf->rules);
    if (dxf->rule_of == NULL || dxf->rules == NULL) return mus__print_memory(own->context, "grade rules");

    int32_t point = 0;
    for (int32_t p = 0; p < own->npiece; p++) {
        for (int32_t side = 0; side < own->pieces[p].nside; side++, point++) {
            int32_t *rule = dxf->rules + (size_t)dxf->nrule * (size_t)width, found = 0;
            double from[2], to[2];
            dxf_side_start(&own->pieces[p], side, from);
            for (int32_t i = 0; i < dxf->nsize; i++) {
                dxf_side_start(&mus__dxf_sheet(dxf, i)->pieces[p], side, to);
                for (int32_t k = 0; k < 2; k++) rule[2 * i + k] = (int32_t)lround((to[k] - from[k]) / RULE_UNIT);
            }
            const size_t bytes = (size_t)width * sizeof *rule;
            while (found < dxf->nrule && memcmp(dxf->rules + (size_t)found * (size_t)width, rule, bytes) != 0) found++;
            dxf->rule_of[point] = found;
            dxf->nrule += found == dxf->nrule;
        }
    }
    return MUS_OK;
}


mus_status mus__dxf_open(const mus_sheet *sheet, const mus_sheet_dxf *def, mus__dxf *dxf)
{
    memset(dxf, 0, sizeof *dxf);
    dxf->sheet = sheet;
    mus_status status = dxf_options(dxf, def);
    if (status == MUS_OK) status = dxf_sizes(dxf);
    if (status == MUS_OK) status = dxf_names(dxf);
    if (status == MUS_OK) status = dxf_rules(dxf);
    return status;
}
