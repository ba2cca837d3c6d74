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
#include "drawing/lettering.h"
#include "drawing/phrase.h"
#include "drawing/plain_words.h"
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
    def->overlap = 0.0;
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


/* names of pieces and marks, those of the first size */
static mus_status sheet_names(mus_sheet *sheet, const mus_pattern *pattern)
{
    const int32_t npanel = mus_pattern_panel_count(pattern), nmark = mus_pattern_mark_count(pattern);
    const int64_t most = (int64_t)npanel * sheet->nsize;
    sheet->pieces = mus__print_new(sheet->context, most, sizeof *sheet->pieces);
    sheet->names = mus__print_new(sheet->context, most, sizeof *sheet->names);
    sheet->labels = mus__print_new(sheet->context, most, sizeof *sheet->labels);
    sheet->marks = mus__print_new(sheet->context, nmark, sizeof *sheet->marks);
    if (sheet->pieces == NULL || sheet->names == NULL || sheet->labels == NULL || sheet->marks == NULL)
        return mus__print_memory(sheet->context, "the pieces");
    for (int32_t i = 0; i < nmark; i++) {
        const char *name = "";
        int32_t points = 0;
        mus_pattern_mark(pattern, i, NULL, &name, &points, NULL);
        snprintf(sheet->marks[i], sizeof *sheet->marks, "%s", name);
        sheet->buttonholes = sheet->buttonholes || (points == 2 && strcmp(name, "buttonhole") == 0);
    }
    return MUS_OK;
}


/* the fonts of the sheet: for all texts of a language other than English, else for names that the strokes cannot
 * write */
static mus_status sheet_lettering(mus_sheet *sheet, const mus_pattern *pattern)
{
    bool strokes = sheet->language == MUS_LANGUAGE_ENGLISH && mus__text_has_strokes(sheet->title) &&
                   (sheet->person == NULL || mus__text_has_strokes(sheet->person)) &&
                   (sheet->notes == NULL || mus__text_has_strokes(sheet->notes));
    for (int32_t i = 0; i < sheet->npiece && strokes; i++) strokes = mus__text_has_strokes(sheet->names[i]);
    for (int32_t i = 0; i < sheet->nsize && strokes; i++) strokes = mus__text_has_strokes(sheet->sizes[i]);
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern) && strokes; i++)
        strokes = mus__text_has_strokes(sheet->marks[i]);
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern) && strokes; i++) {
        char words[MUS__PLAIN];
        mus__plain_edge_words(pattern, i, words);
        strokes = mus__text_has_strokes(words);
    }
    const mus_status status = strokes ? MUS_OK
                                      : mus__lettering_make(sheet->context, sheet->language, &sheet->lettering);
    sheet->drawing.language = sheet->language;
    sheet->drawing.lettering = sheet->lettering;
    return status;
}


/* make the sizes of a piece: on the fold all or none, one on the other by the frame of the panel */
static mus_status sheet_nest(mus_sheet *sheet, const mus_pattern *const *patterns, int32_t panel, mus__piece *nest)
{
    mus_status status = MUS_OK;
    bool fold = sheet->def.fold != 0, whole = true;
    for (int32_t round = 0; round < 2 && status == MUS_OK && whole; round++, fold = false) {
        whole = false;
        for (int32_t k = 0; k < sheet->nsize && status == MUS_OK; k++) {
            mus__piece_free(sheet->context, &nest[k]);
            status = mus__piece_make(sheet->context, patterns[k], panel, sheet->def.allowance, &nest[k]);
            if (status == MUS_OK && fold) status = mus__piece_fold(sheet->context, patterns[k], &nest[k]);
            whole = whole || (fold && !nest[k].fold);
        }
        whole = whole && sheet->nsize > 1;
    }
    int32_t least = 0;
    for (int32_t k = 0; k < sheet->nsize && status == MUS_OK; k++) {
        const mus__piece *own = &nest[k], *first = &nest[0], *small = &nest[least];
        const double x = first->fold ? first->axis - own->axis : first->shift[0] - own->shift[0];
        if (k > 0) mus__piece_move(&nest[k], x, first->shift[1] - own->shift[1]);
        nest[k].follower = true;
        if (own->box[2] - own->box[0] + own->box[3] - own->box[1] <
            small->box[2] - small->box[0] + small->box[3] - small->box[1])
            least = k;
    }
    nest[least].follower = false;
    return status;
}


/* make a piece of each panel that is not the mirror image of another, in each size */
static mus_status sheet_pieces(mus_sheet *sheet, const mus_pattern *const *patterns)
{
    const mus_pattern *pattern = patterns[0];
    mus_status status = sheet_names(sheet, pattern);
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern) && status == MUS_OK; i++) {
        int32_t count, mirror;
        status = mus_pattern_cut(pattern, i, &count, &mirror);
        if (status != MUS_OK || mirror != MUS_NONE) continue;
        const int32_t first = sheet->npiece;
        sheet->npiece += sheet->nsize;
        for (int32_t k = first; k < sheet->npiece; k++) {
            snprintf(sheet->names[k], sizeof *sheet->names, "%s", mus_pattern_panel_name(pattern, i));
            snprintf(sheet->labels[k], sizeof *sheet->labels, "%s", mus_pattern_panel_label(pattern, i));
        }
        status = sheet_nest(sheet, patterns, i, sheet->pieces + first);
    }
    if (status == MUS_OK && sheet->npiece == 0)
        status = mus__file_fail(sheet->context, MUS_ERR_PATTERN, "pattern %.100s has no panel to print", sheet->title);
    return status;
}


/* leave out the pages that have no line but those that a neighbour shows in the overlap. The head of an arrow is no
 * line: a grain line that ends on a page by the tip of its arrow asks for no paper there */
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
        for (int32_t i = 0; i < lines->npath && !own; i++)
            own = lines->paths[i].pen != MUS__PEN_INK && mus__path_meets(lines, &lines->paths[i], NULL, box);
        if (own) {
            t++;
            continue;
        }
        sheet->ntile--;
        memmove(sheet->tiles + t, sheet->tiles + t + 1, (size_t)(sheet->ntile - t) * sizeof *sheet->tiles);
    }
}


static mus_status sheet_marks(const mus_sheet *sheet, const mus_pattern *const *patterns, mus__drawing *out)
{
    for (int32_t i = 0; i < sheet->npiece; i++) {
        double grain[4];
        mus__marks_draw(out, patterns[i % sheet->nsize], &sheet->pieces[i], i, grain);
    }
    return out->status;
}


/* the pieces as they lie, with the boxes of their runs */
typedef struct sheet_view {
    const mus_sheet *sheet;
    const mus__drawing *lines;
    double *runs;
} sheet_view;


static bool sheet_taken(const void *user, const double *box, double *at)
{
    const sheet_view *view = user;
    const double *runs = view->runs;
    for (int32_t i = 0; i < view->sheet->npiece; i++) {
        if (mus__piece_meets(&view->sheet->pieces[i], runs, box, at)) return true;
        runs += 4 * mus__piece_runs(&view->sheet->pieces[i], NULL);
    }
    return false;
}


static bool sheet_held(const void *user, const double *box)
{
    const sheet_view *view = user;
    bool held = false;
    for (int32_t i = 0; i < view->sheet->npiece && !held; i++) held = mus__piece_holds(&view->sheet->pieces[i], box);
    for (int32_t i = 0; i < view->lines->npath && held; i++)
        held = !mus__path_meets(view->lines, &view->lines->paths[i], NULL, box);
    return held;
}


/* find the place of the legend among the pieces as they lie, whose lines are drawn */
static mus_status sheet_legend(mus_sheet *sheet, const mus__drawing *lines)
{
    int32_t n = 0;
    for (int32_t i = 0; i < sheet->npiece; i++) n += mus__piece_runs(&sheet->pieces[i], NULL);
    sheet_view view = {sheet, lines, mus__print_new(sheet->context, n, 4 * sizeof *view.runs)};
    if (view.runs == NULL) return mus__print_memory(sheet->context, "the place of the legend");
    n = 0;
    for (int32_t i = 0; i < sheet->npiece; i++) n += mus__piece_runs(&sheet->pieces[i], view.runs + 4 * n);
    const mus__ground ground = {sheet_taken, sheet_held, &view};
    mus__legend_place(sheet, &ground, sheet->packed ? sheet->squares : NULL);
    mus__legend_fill(sheet, &ground);
    mus__print_free(sheet->context, view.runs);
    return MUS_OK;
}


/* the pages of a tiled sheet, once its lines are known, and the place of the legend */
static mus_status sheet_pages(mus_sheet *sheet, const mus_pattern *const *patterns)
{
    if (!sheet->tiled) return MUS_OK;
    mus__drawing lines;
    mus__sheet_draw_init(sheet, &lines);
    mus_status status = sheet_marks(sheet, patterns, &lines);
    if (status == MUS_OK) sheet_prune(sheet, &lines);
    if (status == MUS_OK) status = sheet_legend(sheet, &lines);
    mus__draw_free(&lines);
    return status != MUS_OK || !sheet->cover ? status : mus__cover_check(sheet);
}


/* write the name of a size along its cut line, where the piece is farthest to the right */
static void sheet_size_name(mus_sheet *sheet, int32_t index)
{
    const mus__loops *cut = &sheet->pieces[index].cut;
    int32_t at = 0;
    for (int32_t i = 1; i < cut->start[1]; i++)
        if (cut->xy[2 * i] > cut->xy[2 * at]) at = i;
    mus__draw_path(&sheet->drawing, index, MUS__LAYER_MARKS, MUS__PEN_TEXT);
    mus__draw_text(&sheet->drawing, sheet->sizes[index % sheet->nsize], cut->xy[2 * at] - 0.001,
                   cut->xy[2 * at + 1] - 0.01, &(mus__text_style){0.0025, 0.0, 1.0, 0.5});
}


static mus_status sheet_draw(mus_sheet *sheet, const mus_pattern *const *patterns)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < sheet->npiece && status == MUS_OK; i++) {
        const mus_pattern *pattern = patterns[i % sheet->nsize];
        double grain[4];
        mus__marks_draw(&sheet->drawing, pattern, &sheet->pieces[i], i, grain);
        if (sheet->nsize > 1) sheet_size_name(sheet, i);
        if (!sheet->pieces[i].follower || sheet->nsize == 1) status = mus__label_draw(sheet, pattern, i, grain);
    }
    if (!sheet->cover && status == MUS_OK)
        mus__squares_draw(&sheet->drawing, sheet->squares[0], sheet->squares[1]);
    if (sheet->tiled && !sheet->cover) mus__legend_draw(sheet, &sheet->drawing);
    for (int32_t i = 0; i < sheet->npiece && status == MUS_OK; i++)
        if (!sheet->pieces[i].follower) mus__edge_words_draw(sheet, patterns[i % sheet->nsize], i);
    return status != MUS_OK ? status : sheet->drawing.status;
}


/* MUS_ERR_ARG unless all sizes have the same panels */
static mus_status sheet_sizes_check(mus_context *context, int32_t count, const mus_pattern *const *patterns,
                                    const char *const *names)
{
    const int32_t n = mus_pattern_panel_count(patterns[0]);
    for (int32_t k = 0; k < count; k++) {
        bool same = names[k] != NULL && mus_pattern_panel_count(patterns[k]) == n;
        for (int32_t i = 0; i < n && same; i++)
            same = strcmp(mus_pattern_panel_name(patterns[0], i), mus_pattern_panel_name(patterns[k], i)) == 0;
        if (!same)
            return mus__file_fail(context, MUS_ERR_ARG, "size %d of %d (%.30s): its panels are not those of the first "
                                  "size", k + 1, count, names[k] != NULL ? names[k] : "no name");
    }
    return MUS_OK;
}


/* a copy of the pattern with the panels that are cut and not draped behind its own; *out is NULL when there are none */
static mus_status sheet_join(mus_context *context, const mus_pattern *pattern, mus_pattern **out)
{
    *out = NULL;
    if (mus_pattern_cut_only(pattern) == NULL) return MUS_OK;
    mus_status status = mus_pattern_copy(pattern, out);
    if (status == MUS_OK) status = mus_pattern_join(*out, mus_pattern_cut_only(pattern), 0);
    if (status == MUS_OK) return MUS_OK;
    return mus__file_fail(context, status, "%s", mus_context_error(mus_pattern_context(pattern)));
}


static mus_status sheet_build(mus_sheet *sheet, const mus_pattern *const *patterns, const char *const *names)
{
    mus_context *context = sheet->context;
    const char *title = sheet->def.title != NULL ? sheet->def.title : mus_pattern_name(patterns[0]);
    sheet->title = sheet_text(context, title);
    sheet->sizes = mus__print_new(context, sheet->nsize, sizeof *sheet->sizes);
    if (sheet->def.person != NULL) sheet->person = sheet_text(context, sheet->def.person);
    if (sheet->def.notes != NULL) sheet->notes = sheet_text(context, sheet->def.notes);
    if (sheet->title == NULL || sheet->sizes == NULL || (sheet->def.person != NULL && sheet->person == NULL) ||
        (sheet->def.notes != NULL && sheet->notes == NULL))
        return mus__print_memory(context, "the title of a sheet");
    sheet->def.title = sheet->title;
    sheet->def.person = sheet->person;
    sheet->def.notes = sheet->notes;
    for (int32_t k = 0; k < sheet->nsize && names != NULL; k++)
        snprintf(sheet->sizes[k], sizeof *sheet->sizes, "%s", names[k]);

    mus_status status = mus__paper_check(sheet);
    for (int32_t k = 0; k < sheet->nsize && status == MUS_OK; k++) status = sheet_faults(context, patterns[k]);
    if (status == MUS_OK) status = sheet_pieces(sheet, patterns);
    if (status == MUS_OK) status = sheet_lettering(sheet, patterns[0]);
    if (status == MUS_OK) status = mus__sheet_layout(sheet);
    if (status == MUS_OK) status = sheet_pages(sheet, patterns);
    if (status == MUS_OK) status = sheet_draw(sheet, patterns);
    return status;
}


static mus_status sheet_create(mus_context *context, int32_t count, const mus_pattern *const *patterns,
                               const char *const *names, const mus_sheet_def *def, mus_sheet **out)
{
    mus_sheet_def own;
    mus_sheet_def_init(&own, sizeof own);
    if (def != NULL) {
        if (def->size != sizeof own)
            return mus__file_fail(context, MUS_ERR_VERSION, "mus_sheet_def: size %zu, this library knows %zu; use "
                                  "mus_sheet_def_init", def->size, sizeof own);
        own = *def;
    }
    int32_t language;
    mus_status status = sheet_def_check(context, &own);
    if (status == MUS_OK) status = mus__language_read(context, own.language, "sheet", &language);
    if (status != MUS_OK) return status;

    mus_sheet *sheet = mus__print_new(context, 1, sizeof *sheet);
    if (sheet == NULL) return mus__print_memory(context, "a sheet");
    sheet->context = context;
    sheet->def = own;
    sheet->def.language = NULL; /* the caller's text; its number is kept */
    sheet->language = language;
    sheet->nsize = count;
    mus__draw_init(&sheet->drawing, context);
    status = sheet_build(sheet, patterns, names);
    if (status != MUS_OK) {
        mus_sheet_destroy(sheet);
        return status;
    }
    *out = sheet;
    return MUS_OK;
}


/* lay out the panels of each pattern and those that are cut and not draped; names (count), or NULL of one size */
static mus_status sheet_create_joined(mus_context *context, int32_t count, const mus_pattern *const *patterns,
                                      const char *const *names, const mus_sheet_def *def, mus_sheet **out)
{
    mus_pattern *joined[MUS__SIZES_MOST];
    const mus_pattern *all[MUS__SIZES_MOST] = {NULL};
    mus_status status = MUS_OK;
    int32_t made = 0;
    for (; made < count && status == MUS_OK; made++) {
        status = sheet_join(context, patterns[made], &joined[made]);
        all[made] = joined[made] != NULL ? joined[made] : patterns[made];
    }
    if (status == MUS_OK && names != NULL) status = sheet_sizes_check(context, count, all, names);
    if (status == MUS_OK) status = sheet_create(context, count, all, names, def, out);
    while (made > 0) mus_pattern_destroy(joined[--made]);
    return status;
}


mus_status mus_sheet_create(mus_context *context, const mus_pattern *pattern, const mus_sheet_def *def, mus_sheet **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL || pattern == NULL || out == NULL)
        return mus_context_fail(context, MUS_ERR_ARG, "mus_sheet_create: context, pattern or out is NULL");
    return sheet_create_joined(context, 1, &pattern, NULL, def, out);
}


mus_status mus_sheet_create_sizes(mus_context *context, int32_t count, const mus_pattern *const *patterns,
                                  const char *const *names, const mus_sheet_def *def, mus_sheet **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL || patterns == NULL || names == NULL || out == NULL)
        return mus_context_fail(context, MUS_ERR_ARG,
                                "mus_sheet_create_sizes: context, patterns, names or out is NULL");
    if (count < 1 || count > MUS__SIZES_MOST)
        return mus__file_fail(context, MUS_ERR_ARG, "mus_sheet_create_sizes: %d sizes; expected 1 to %d", (int)count,
                              MUS__SIZES_MOST);
    for (int32_t k = 0; k < count; k++)
        if (patterns[k] == NULL)
            return mus__file_fail(context, MUS_ERR_ARG, "mus_sheet_create_sizes: pattern %d is NULL", (int)k);
    return sheet_create_joined(context, count, patterns, names, def, out);
}


void mus_sheet_destroy(mus_sheet *sheet)
{
    if (sheet == NULL) return;
    mus_context *context = sheet->context;
    for (int32_t i = 0; i < sheet->npiece; i++) mus__piece_free(context, &sheet->pieces[i]);
    mus__draw_free(&sheet->drawing);
    mus__lettering_free(sheet->lettering);
    mus__print_free(context, sheet->pieces);
    mus__print_free(context, sheet->names);
    mus__print_free(context, sheet->labels);
    mus__print_free(context, sheet->marks);
    mus__print_free(context, sheet->sizes);
    mus__print_free(context, sheet->tiles);
    mus__print_free(context, sheet->title);
    mus__print_free(context, sheet->person);
    mus__print_free(context, sheet->notes);
    mus__print_free(context, sheet);
}


int32_t mus_sheet_page_count(const mus_sheet *sheet)
{
    return sheet == NULL ? 0 : sheet->ntile + (sheet->cover ? 1 : 0);
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
    int32_t first = sheet->cover ? 1 : 0;
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
