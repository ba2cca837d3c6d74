/*
 * dxf_read.c: mus_pattern_read_dxf: which blocks of a DXF are the pieces of the wanted size.
 *
 * A nested file has a block for each piece of each size, with a text "Size: 40"; the texts of the style name the sample
 * size. The wanted size is read from its own blocks where there are any, else made from those of the sample by the
 * rules of the RUL file.
 */
#include <string.h>

#include "trade/dxf_panel.h"
#include "trade/dxf_read.h"

#define DXF_PANELS 10000 /* most blocks of a file; chosen: as other forms of a pattern */


void mus_pattern_dxf_init(mus_pattern_dxf *dxf, size_t size)
{
    if (dxf == NULL || size < sizeof dxf->size) return;
    memset(dxf, 0, size);
    dxf->size = size;
}


static bool block_has_size(const mus__dxf_file *file, const mus__dxf_block *block, mus__dxf_slice size)
{
    const mus__dxf_slice own = mus__dxf_value(file, block, "Size");
    return own.length >= 0 && mus__dxf_same(own, size);
}


/* number of pieces of a size; *other gets the size of the first piece that has one */
static int32_t count_size(const mus__dxf_file *file, mus__dxf_slice size, mus__dxf_slice *other)
{
    int32_t count = 0;
    for (int32_t i = 0; i + 1 < file->nblock; i++) {
        if (!mus__dxf_is_piece(file, &file->blocks[i])) continue;
        const mus__dxf_slice own = mus__dxf_value(file, &file->blocks[i], "Size");
        if (own.length >= 0 && other->length < 0) *other = own;
        count += block_has_size(file, &file->blocks[i], size);
    }
    return count;
}


/* MUS_ERR_ARG: the size is in no block and in no rule; the message lists those that are */
static mus_status size_unknown(const mus__dxf_file *file, const mus__rul *rules, const char *size)
{
    mus__unused list = {{0}, 0, 0};
    char name[41];
    for (int32_t i = 0; rules != NULL && i < rules->nsize; i++) {
        mus__dxf_copy(rules->sizes[i], name, sizeof name);
        mus__unused_add(&list, name);
    }
    for (int32_t i = 0; i + 1 < file->nblock && rules == NULL; i++) {
        const mus__dxf_slice own = mus__dxf_value(file, &file->blocks[i], "Size");
        bool known = own.length < 0;
        for (int32_t k = 0; k < i && !known; k++) known = block_has_size(file, &file->blocks[k], own);
        if (known) continue;
        mus__dxf_copy(own, name, sizeof name);
        mus__unused_add(&list, name);
        if (list.count >= 64) break;
    }
    return mus__source_fail(file->source, 0, MUS_ERR_ARG, "no size \"%.40s\"; the file has %s", size,
                            list.count > 0 ? list.names : "no sizes");
}


/* the rules displace the points of one size, and the file has another */
static mus_status size_base(const mus__dxf_file *file, const mus__rul *rules, mus__dxf_slice has)
{
    char own[64], base[64];
    mus__dxf_copy(has, own, sizeof own);
    mus__dxf_copy(rules->sizes[rules->sample], base, sizeof base);
    return mus__source_fail(file->source, 0, MUS_ERR_FORMAT, "size \"%s\", but the rules start from size \"%s\"", own,
                            base);
}


/* the size whose blocks are read, and the rules that make the wanted size of it */
static mus_status size_choose(mus__dxf_job *job, const mus__rul *rules, const char *size, mus__dxf_slice *out)
{
    const mus__dxf_file *file = job->file;
    const mus__dxf_slice none = {"", -1};
    mus__dxf_slice other = none, sample = mus__dxf_value(file, &file->blocks[file->nblock - 1], "Sample Size");
    if (size != NULL) {
        const mus__dxf_slice wanted = {size, (int32_t)strlen(size)};
        *out = wanted;
        if (count_size(file, wanted, &other) > 0) return MUS_OK;
        job->size = rules != NULL ? mus__rul_size(rules, wanted) : MUS_NONE;
        if (job->size == MUS_NONE) return size_unknown(file, rules, size);
        job->rules = rules;
        const mus__dxf_slice base = rules->sizes[rules->sample];
        if (sample.length >= 0 && !mus__dxf_same(sample, base)) return size_base(file, rules, sample);
        sample = base;
        other = none;
    }
    *out = count_size(file, sample, &other) > 0 ? sample : other;
    if (job->rules != NULL && out->length >= 0 && !mus__dxf_same(*out, sample)) return size_base(file, rules, *out);
    return MUS_OK;
}


static mus_status read_blocks(mus__dxf_job *job, mus__dxf_slice size)
{
    const mus__dxf_file *file = job->file;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i + 1 < file->nblock && status == MUS_OK; i++) {
        const mus__dxf_block *block = &file->blocks[i];
        if (!mus__dxf_is_piece(file, block)) continue;
        const mus__dxf_slice own = mus__dxf_value(file, block, "Size");
        if (own.length >= 0 && size.length >= 0 && !mus__dxf_same(own, size)) continue;
        status = mus__dxf_panel(job, block);
    }
    if (status == MUS_OK && job->npiece == 0)
        status = mus__source_fail(file->source, 0, MUS_ERR_FORMAT,
                                  "no piece; expected blocks with an outline (POLYLINE or LINE on layer 1)");
    return status;
}


mus_status mus__dxf_read(const mus__source *source, const mus__source *rules, const char *size, mus_pattern *pattern)
{
    mus__dxf_file file;
    mus__rul rul = {0};
    mus__dxf_job job = {.file = &file, .pattern = pattern};
    mus__dxf_slice chosen;
    char name[128];
    mus_status status = mus__dxf_load(source, &file);
    if (status == MUS_OK && file.nblock > DXF_PANELS)
        status = mus__source_fail(source, 0, MUS_ERR_LIMIT, "%d blocks, the limit is %d", file.nblock - 1, DXF_PANELS);
    if (status == MUS_OK && rules != NULL) status = mus__rul_load(rules, &rul);
    if (status == MUS_OK) status = size_choose(&job, rules != NULL ? &rul : NULL, size, &chosen);
    if (status == MUS_OK) status = read_blocks(&job, chosen);
    if (status == MUS_OK) {
        const mus__dxf_slice style = mus__dxf_value(&file, &file.blocks[file.nblock - 1], "Style Name");
        mus__dxf_copy(style, name, sizeof name);
        if (style.length > 0) status = mus_pattern_set_name(pattern, name);
    }
    mus__dxf_unload(&file);
    mus__rul_unload(source->context, &rul);
    return status;
}
