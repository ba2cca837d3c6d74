/*
 * dxf_name.c: the name of a piece of a DXF, and how often it is cut.
 *
 * The trade's names are capitals, so a name in capitals alone becomes small. Block names need not be unique, and those
 * of other alphabets arrive as "??????".
 */
#include <stdio.h>
#include <string.h>

#include "trade/dxf_panel.h"


/* copy a name; one in capitals becomes small, since the trade's names have no small letters */
static void name_copy(mus__dxf_slice slice, char *out, size_t capacity)
{
    bool small = false;
    mus__dxf_copy(slice, out, capacity);
    for (const char *c = out; *c != '\0'; c++) small = small || (*c >= 'a' && *c <= 'z');
    for (char *c = out; *c != '\0' && !small; c++)
        if (*c >= 'A' && *c <= 'Z') *c = (char)(*c - 'A' + 'a');
}


static bool name_has_letters(const char *name)
{
    for (; *name != '\0'; name++)
        if ((*name >= 'a' && *name <= 'z') || (*name >= 'A' && *name <= 'Z') || (*name & 0x80) != 0) return true;
    return false;
}


void mus__dxf_panel_name(const mus__dxf_job *job, const mus__dxf_block *block, char *out, size_t capacity)
{
    const mus__dxf_slice piece = mus__dxf_value(job->file, block, "Piece Name");
    name_copy(piece.length > 0 ? piece : block->name, out, capacity);
    for (int32_t i = 0; i < block->n && !name_has_letters(out); i++) {
        const mus__dxf_entity *entity = &job->file->entities[block->first + i];
        if (entity->kind == MUS__DXF_TEXT && entity->layer == 15) name_copy(entity->text, out, capacity);
    }
    if (!name_has_letters(out)) snprintf(out, capacity, "piece_%d", (int)job->npiece + 1);
}


void mus__dxf_name_mirror(char *name, size_t capacity)
{
    static const char *const sides[2] = {"left", "right"};
    char from[128];
    snprintf(from, sizeof from, "%s", name);
    for (int32_t i = 0; i < 2; i++) {
        const char *at = strstr(from, sides[i]);
        if (at == NULL) continue;
        snprintf(name, capacity, "%.*s%s%s", (int)(at - from), from, sides[1 - i], at + strlen(sides[i]));
        return;
    }
    const size_t n = strlen(name) < capacity - 16 ? strlen(name) : 0;
    memcpy(name + n, "_mirrored", sizeof "_mirrored");
}


mus__dxf_slice mus__dxf_piece_value(const mus__dxf_file *file, const mus__dxf_block *block, const char *key)
{
    mus__dxf_slice value = mus__dxf_value(file, block, key), name = mus__dxf_value(file, block, "Piece Name");
    for (int32_t i = 0; i + 1 < file->nblock && value.length < 0 && name.length >= 0; i++)
        if (mus__dxf_same(mus__dxf_value(file, &file->blocks[i], "Piece Name"), name))
            value = mus__dxf_value(file, &file->blocks[i], key);
    return value;
}


void mus__dxf_quantity(const mus__dxf_file *file, const mus__dxf_block *block, int32_t *right, int32_t *left)
{
    const mus__dxf_slice text = mus__dxf_piece_value(file, block, "Quantity");
    int32_t n = 0;
    double r = 1.0, l = 0.0;
    while (n < text.length && text.at[n] != ',') n++;
    if (text.length > 0) mus__dxf_number((mus__dxf_slice){text.at, n}, &r);
    if (n < text.length) mus__dxf_number((mus__dxf_slice){text.at + n + 1, text.length - n - 1}, &l);
    *right = r >= 0.0 && r <= 500.0 ? (int32_t)r : 1;
    *left = l >= 0.0 && l <= 500.0 ? (int32_t)l : 0;
}
