/*
 * sheet_lines.c: the pieces and lines of a sheet as public data, for other writers (a cutter's file, a screen).
 *
 * The lines are those of the drawing that PDF and SVG are written from, so a caller reads the lines that are printed.
 */
#include <string.h>

#include "print/sheet.h"


/* MUS_LINE_* equal the groups of a drawing */
_Static_assert((int)MUS__LAYER_CUT == MUS_LINE_CUT && (int)MUS__LAYER_SEAM == MUS_LINE_SEW, "lines");
_Static_assert((int)MUS__LAYER_NOTCHES == MUS_LINE_NOTCH && (int)MUS__LAYER_GRAIN == MUS_LINE_GRAIN, "lines");
_Static_assert((int)MUS__LAYER_MARKS == MUS_LINE_MARK && (int)MUS__LAYER_LABEL == MUS_LINE_LABEL, "lines");


void mus_sheet_piece_init(mus_sheet_piece *piece, size_t size)
{
    if (piece == NULL || size < sizeof piece->size) return;
    memset(piece, 0, size);
    piece->size = size;
}


void mus_sheet_line_init(mus_sheet_line *line, size_t size)
{
    if (line == NULL || size < sizeof line->size) return;
    memset(line, 0, size);
    line->size = size;
}


int32_t mus_sheet_piece_count(const mus_sheet *sheet)
{
    return sheet != NULL ? sheet->npiece : 0;
}


/* check the size of a caller's struct and the index i of a piece or line */
static mus_status lines_check(const mus_sheet *sheet, const char *what, size_t size, size_t expected, int32_t i,
                              int32_t count)
{
    if (size != expected)
        return mus__file_fail(sheet->context, MUS_ERR_VERSION, "%s: size %zu, this library knows %zu; use its init",
                              what, size, expected);
    if (i >= 0 && i < count) return MUS_OK;
    return mus__file_fail(sheet->context, MUS_ERR_ARG, "%s: number %d, expected 0 to %d", what, (int)i, (int)count - 1);
}


mus_status mus_sheet_piece_get(const mus_sheet *sheet, int32_t piece, mus_sheet_piece *out)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__file_fail(sheet->context, MUS_ERR_ARG, "mus_sheet_piece_get: out is NULL");
    mus_status status =
        lines_check(sheet, "mus_sheet_piece_get", out->size, sizeof *out, piece, sheet->npiece);
    if (status != MUS_OK) return status;
    const mus__piece *own = &sheet->pieces[piece];
    out->panel = own->panel;
    out->name = sheet->names[piece];
    out->copies = mus__piece_copies(own);
    memcpy(out->materials, own->copies, sizeof own->copies);
    out->mirrored = own->mirrored;
    out->fold = !own->fold ? 0 : (own->inward > 0.0 ? 1 : -1) * (1 + own->across);
    out->size_index = piece % sheet->nsize;
    memcpy(out->turn, own->turn, sizeof out->turn);
    memcpy(out->shift, own->shift, sizeof out->shift);
    memcpy(out->box, own->box, sizeof out->box);
    return MUS_OK;
}


int32_t mus_sheet_line_count(const mus_sheet *sheet)
{
    return sheet != NULL ? sheet->drawing.npath : 0;
}


mus_status mus_sheet_line_get(const mus_sheet *sheet, int32_t line, mus_sheet_line *out)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__file_fail(sheet->context, MUS_ERR_ARG, "mus_sheet_line_get: out is NULL");
    const mus__drawing *drawing = &sheet->drawing;
    mus_status status = lines_check(sheet, "mus_sheet_line_get", out->size, sizeof *out, line, drawing->npath);
    if (status != MUS_OK) return status;
    const mus__path *path = &drawing->paths[line];
    const int32_t end = line + 1 < drawing->npath ? drawing->paths[line + 1].at : drawing->nxy;
    out->piece = path->piece;
    out->kind = (int32_t)path->layer;
    out->edge = path->edge;
    out->filled = mus__pen_styles[path->pen].width == 0.0;
    out->op_count = path->nop;
    out->point_count = (end - path->at) / 2;
    out->ops = drawing->ops + path->op;
    out->points = drawing->xy + path->at;
    return MUS_OK;
}
