/*
 * sheet.c: make a sheet from a pattern and its options, with all pieces placed and drawn; and the questions about it.
 *
 * A pattern whose panels cannot be cut (open or crossing outline, a panel too small) is refused. A pattern whose seams
 * join sides of different lengths is printed.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "muslin/topology.h"
#include "print/page.h"

#define ALLOWANCE_MOST 0.1 /* [m] largest default allowance; chosen: a larger one is an error of units */
#define BORDER_MOST 0.1    /* [m] largest margin and overlap; chosen: half the width of A4 */


void mus_sheet_def_init(mus_sheet_def *def, size_t size)
{
    if (def == NULL || size < sizeof def->size) return;
    memset(def, 0, size);
    if (size < sizeof *def) return;
    def->size = size;
    def->paper = MUS_PAPER_A4;
    def->allowance = 0.01;
    def->margin = 0.01;
    def->overlap = 0.01;
}


/* MUS_ERR_ARG unless x [m] is in 0 .. high; NaN is refused */
static mus_status sheet_range(mus_context *context, const char *name, double x, double high)
{
    if (x >= 0.0 && x <= high) return MUS_OK;
    char most[32], given[32] = "not a number";
    mus__print_millimetres(most, sizeof most, high);
    if (x - x == 0.0 && fabs(x) < 1e6) snprintf(given, sizeof given, "%ld um", lround(x * 1e6));
    else if (x == x) snprintf(given, sizeof given, "above 1000 km");
    return mus__file_fail(context, MUS_ERR_ARG, "sheet: %s is %s; expected 0 to %s mm", name, given, most);
}


static mus_status sheet_def_check(mus_context *context, const mus_sheet_def *def)
{
    if (def->paper < MUS_PAPER_A4 || def->paper > MUS_PAPER_ROLL)
        return mus__file_fail(context, MUS_ERR_ARG, "sheet: paper %d is unknown; expected 0 (A4) to %d (roll)",
                              def->paper, MUS_PAPER_ROLL);
    mus_status status = sheet_range(context, "allowance", def->allowance, ALLOWANCE_MOST);
    if (status == MUS_OK) status = sheet_range(context, "margin", def->margin, BORDER_MOST);
    if (status == MUS_OK) status = sheet_range(context, "overlap", def->overlap, BORDER_MOST);
    return status;
}


static char *sheet_text(mus_context *context, const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = mus__print_new(context, (int64_t)size, 1);
    if (copy != NULL) memcpy(copy, text, size);
    return copy;
}


/* MUS_ERR_PATTERN for a pattern with a fault that keeps a panel from being cut */
static mus_status sheet_faults(mus_context *context, const mus_pattern *pattern)
{
    mus_faults *faults;
    int32_t count = 0;
    mus_status status = mus_pattern_check(pattern, &count, &faults);
    if (status != MUS_OK) mus__file_fail(context, status, "%s", mus_context_error(mus_pattern_context(pattern)));
    for (int32_t i = 0; i < count && status == MUS_OK; i++) {
        int32_t kind;
        status = mus_faults_item(faults, i, &kind, NULL, NULL, NULL);
        if (kind == MUS_FAULT_OPEN_OUTLINE || kind == MUS_FAULT_CROSSING || kind == MUS_FAULT_SMALL_PANEL)
            status = mus__file_fail(context, MUS_ERR_PATTERN, "pattern %.100s cannot be printed: %.300s",
                                    mus_pattern_name(pattern), mus_faults_text(faults, i));
    }
    mus_faults_destroy(faults);
    return status;
}


/* make a piece of each panel that is not the mirror image of another */
static mus_status sheet_pieces(mus_sheet *sheet, const mus_pattern *pattern)
{
    int32_t npanel = mus_pattern_panel_count(pattern), count, mirror;
    sheet->pieces = mus__print_new(sheet->context, npanel, sizeof *sheet->pieces);
    sheet->names = mus__print_new(sheet->context, npanel, sizeof *sheet->names);
    sheet->labels = mus__print_new(sheet->context, npanel, sizeof *sheet->labels);
    sheet->marks = mus__print_new(sheet->context, mus_pattern_mark_count(pattern), sizeof *sheet->marks);
    if (sheet->pieces == NULL || sheet->names == NULL || sheet->labels == NULL || sheet->marks == NULL)
        return mus__print_memory(sheet->context, "the pieces");
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        const char *name = "";
        mus_pattern_mark(pattern, i, NULL, &name, NULL, NULL);
        snprintf(sheet->marks[i], sizeof *sheet->marks, "%s", name);
    }

    mus_status status = MUS_OK;
    for (int32_t i = 0; i < npanel && status == MUS_OK; i++) {
        status = mus_pattern_cut(pattern, i, &count, &mirror);
        if (status != MUS_OK || mirror != MUS_NONE) continue;
        snprintf(sheet->names[sheet->npiece], sizeof *sheet->names, "%s", mus_pattern_panel_name(pattern, i));
        snprintf(sheet->labels[sheet->npiece], sizeof *sheet->labels, "%s", mus_pattern_panel_label(pattern, i));
        status = mus__piece_make(sheet->context, pattern, i, sheet->def.allowance, &sheet->pieces[sheet->npiece++]);
    }
    for (int32_t i = 0; i < sheet->npiece && status == MUS_OK && sheet->def.fold; i++)
        status = mus__piece_fold(sheet->context, pattern, &sheet->pieces[i]);
    if (status == MUS_OK && sheet->npiece == 0)
        status = mus__file_fail(sheet->context, MUS_ERR_PATTERN, "pattern %.100s has no panel to print", sheet->title);
    return status;
}


/* does a path pass through the box? Cubics are read as eight chords */
static bool sheet_path_meets(const mus__drawing *drawing, const mus__path *path, const double *box)
{
    const double *xy = drawing->xy + path->at;
    double at[2] = {0.0, 0.0}, first[2] = {0.0, 0.0}, p[2];
    for (int32_t i = 0; i < path->nop; i++) {
        const unsigned char op = drawing->ops[path->op + i];
        double cubic[8] = {at[0], at[1], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
        if (op == 'c') memcpy(cubic + 2, xy, 6 * sizeof *xy);
        for (int32_t k = 1; k <= (op == 'c' ? 8 : op == 'm' ? 0 : 1); k++) {
            if (op == 'c') mus__cubic_at(cubic, 0.125 * k, p);
            else memcpy(p, op == 'z' ? first : xy, sizeof p);
            if (mus__segment_meets(at, p, box)) return true;
            memcpy(at, p, sizeof at);
        }
        if (op == 'm') memcpy(at, xy, sizeof at), memcpy(first, xy, sizeof first);
        xy += 2 * (op == 'c' ? 3 : op == 'z' ? 0 : 1);
    }
    return false;
}


/* leave out the pages that have no line but those that a neighbour shows in the overlap */
static void sheet_prune(mus_sheet *sheet, const mus__drawing *lines)
{
    const double overlap = sheet->def.overlap;
    for (int32_t t = 0; t < sheet->ntile;) {
        const mus__tile *tile = &sheet->tiles[t];
        double box[4];
        mus__tile_window(sheet, tile, box);
        if (mus__tile_find(sheet, tile->column - 1, tile->row) != MUS_NONE) box[0] += overlap;
        if (mus__tile_find(sheet, tile->column + 1, tile->row) != MUS_NONE) box[2] -= overlap;
        if (mus__tile_find(sheet, tile->column, tile->row + 1) != MUS_NONE) box[1] += overlap;
        if (mus__tile_find(sheet, tile->column, tile->row - 1) != MUS_NONE) box[3] -= overlap;
        bool own = false;
        for (int32_t i = 0; i < lines->npath && !own; i++) own = sheet_path_meets(lines, &lines->paths[i], box);
        if (own) {
            t++;
            continue;
        }
        sheet->ntile--;
        memmove(sheet->tiles + t, sheet->tiles + t + 1, (size_t)(sheet->ntile - t) * sizeof *sheet->tiles);
    }
}


/* the pages of a tiled sheet, once its lines are known */
static mus_status sheet_pages(mus_sheet *sheet, const mus_pattern *pattern)
{
    if (!sheet->tiled) return MUS_OK;
    mus__drawing lines;
    mus__draw_init(&lines, sheet->context);
    for (int32_t i = 0; i < sheet->npiece; i++) {
        double grain[3];
        mus__marks_draw(&lines, pattern, &sheet->pieces[i], i, grain);
    }
    const mus_status status = lines.status;
    if (status == MUS_OK) sheet_prune(sheet, &lines);
    mus__draw_free(&lines);
    return status;
}


static mus_status sheet_draw(mus_sheet *sheet, const mus_pattern *pattern)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < sheet->npiece && status == MUS_OK; i++) {
        double grain[3];
        mus__marks_draw(&sheet->drawing, pattern, &sheet->pieces[i], i, grain);
        status = mus__label_draw(sheet, pattern, i, grain);
    }
    if (!sheet->tiled && status == MUS_OK)
        mus__squares_draw(&sheet->drawing, sheet->squares[0], sheet->squares[1], sheet->squares_beside);
    return status != MUS_OK ? status : sheet->drawing.status;
}


static mus_status sheet_build(mus_sheet *sheet, const mus_pattern *pattern)
{
    mus_context *context = sheet->context;
    const char *title = sheet->def.title != NULL ? sheet->def.title : mus_pattern_name(pattern);
    sheet->title = sheet_text(context, title);
    if (sheet->def.person != NULL) sheet->person = sheet_text(context, sheet->def.person);
    if (sheet->title == NULL || (sheet->def.person != NULL && sheet->person == NULL))
        return mus__print_memory(context, "the title of a sheet");
    sheet->def.title = sheet->title;
    sheet->def.person = sheet->person;

    mus_status status = mus__paper_check(sheet);
    if (status == MUS_OK) status = sheet_faults(context, pattern);
    if (status == MUS_OK) status = sheet_pieces(sheet, pattern);
    if (status == MUS_OK) status = mus__sheet_layout(sheet);
    if (status == MUS_OK && sheet->tiled) status = mus__cover_check(sheet);
    if (status == MUS_OK) status = sheet_pages(sheet, pattern);
    if (status == MUS_OK) status = sheet_draw(sheet, pattern);
    return status;
}


mus_status mus_sheet_create(mus_context *context, const mus_pattern *pattern, const mus_sheet_def *def, mus_sheet **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL || pattern == NULL || out == NULL)
        return mus_context_fail(context, MUS_ERR_ARG, "mus_sheet_create: context, pattern or out is NULL");

    mus_sheet_def own;
    mus_sheet_def_init(&own, sizeof own);
    if (def != NULL) {
        if (def->size != sizeof own)
            return mus__file_fail(context, MUS_ERR_VERSION, "mus_sheet_def: size %zu, this library knows %zu; use "
                                  "mus_sheet_def_init", def->size, sizeof own);
        own = *def;
    }
    mus_status status = sheet_def_check(context, &own);
    if (status != MUS_OK) return status;

    mus_sheet *sheet = mus__print_new(context, 1, sizeof *sheet);
    if (sheet == NULL) return mus__print_memory(context, "a sheet");
    sheet->context = context;
    sheet->def = own;
    mus__draw_init(&sheet->drawing, context);
    status = sheet_build(sheet, pattern);
    if (status != MUS_OK) {
        mus_sheet_destroy(sheet);
        return status;
    }
    *out = sheet;
    return MUS_OK;
}


void mus_sheet_destroy(mus_sheet *sheet)
{
    if (sheet == NULL) return;
    mus_context *context = sheet->context;
    for (int32_t i = 0; i < sheet->npiece; i++) mus__piece_free(context, &sheet->pieces[i]);
    mus__draw_free(&sheet->drawing);
    mus__print_free(context, sheet->pieces);
    mus__print_free(context, sheet->names);
    mus__print_free(context, sheet->labels);
    mus__print_free(context, sheet->marks);
    mus__print_free(context, sheet->tiles);
    mus__print_free(context, sheet->title);
    mus__print_free(context, sheet->person);
    mus__print_free(context, sheet);
}


int32_t mus_sheet_page_count(const mus_sheet *sheet)
{
    return sheet == NULL ? 0 : sheet->ntile + (sheet->tiled ? 1 : 0);
}


int32_t mus_sheet_columns(const mus_sheet *sheet)
{
    return sheet == NULL ? 0 : sheet->columns;
}


int32_t mus_sheet_rows(const mus_sheet *sheet)
{
    return sheet == NULL ? 0 : sheet->rows;
}


mus_status mus_sheet_extent(const mus_sheet *sheet, double *out)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus_context_fail(sheet->context, MUS_ERR_ARG, "mus_sheet_extent: out is NULL");
    memcpy(out, sheet->extent, sizeof sheet->extent);
    return MUS_OK;
}


mus_status mus_sheet_page(const mus_sheet *sheet, int32_t page, double *out)
{
    if (sheet == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus_context_fail(sheet->context, MUS_ERR_ARG, "mus_sheet_page: out is NULL");
    int32_t first = sheet->tiled ? 1 : 0;
    if (page < first || page >= first + sheet->ntile)
        return mus__file_fail(sheet->context, MUS_ERR_ARG, "page %d shows no part of the sheet; pages %d to %d do",
                              page, first, first + sheet->ntile - 1);

    double box[4];
    mus__tile_window(sheet, &sheet->tiles[page - first], box);
    out[0] = box[0] - sheet->def.margin;
    out[1] = box[1] - sheet->def.margin;
    out[2] = sheet->page[0];
    out[3] = sheet->page[1];
    return MUS_OK;
}
