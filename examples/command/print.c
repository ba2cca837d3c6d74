/*
 * print.c: muslin print: writes a pattern as PDF, SVG, DXF or HPGL at true scale, ready to cut.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "json.h"
#include "language.h"
#include "muslin/language.h"
#include "muslin/print.h"
#include "print_dxf.h"
#include "print_notes.h"
#include "print_sizes.h"
#include "scene.h"

#define TITLE 256 /* bytes of a title */

static const struct {
    const char *name;
    int32_t paper;
} papers[] = {{"a4", MUS_PAPER_A4},
              {"letter", MUS_PAPER_LETTER},
              {"a3", MUS_PAPER_A3},
              {"a0", MUS_PAPER_A0},
              {"roll", MUS_PAPER_ROLL}};


static int32_t find_paper(const char *name)
{
    for (size_t i = 0; i < sizeof papers / sizeof papers[0]; i++)
        if (strcmp(papers[i].name, name) == 0) return papers[i].paper;
    return MUS_NONE;
}


/* Writes which part of the sheet each page shows, for programs that join tiles. */
static void describe(const mus_sheet *sheet, json *j)
{
    double box[4];
    json_open(j, NULL, '{');
    json_int(j, "pages", mus_sheet_page_count(sheet));
    json_int(j, "columns", mus_sheet_columns(sheet));
    json_int(j, "rows", mus_sheet_rows(sheet));
    if (mus_sheet_extent(sheet, box) == MUS_OK) {
        json_number(j, "width_m", box[0]);
        json_number(j, "height_m", box[1]);
    }
    json_open(j, "tiles", '[');
    for (int32_t p = 0; p < mus_sheet_page_count(sheet); p++) {
        if (mus_sheet_page(sheet, p, box) != MUS_OK) continue;
        json_open(j, NULL, '{');
        json_int(j, "page", p);
        json_number(j, "x_m", box[0]);
        json_number(j, "y_m", box[1]);
        json_number(j, "width_m", box[2]);
        json_number(j, "height_m", box[3]);
        json_close(j, '}');
    }
    json_close(j, ']');
    json_warnings(j);
    json_close(j, '}');
}


/* Takes the first size of a list as the own one when neither tape, size nor pattern is given. */
static void take_first(source *from, const char *list, char *name, size_t size)
{
    if (from->tape != NULL || from->size != NULL || from->row != NULL || from->pattern != NULL) return;
    snprintf(name, size, "%.*s", (int)strcspn(list, ","), list);
    from->size = name;
}


/* Writes the options of the sheet, and the title of a named design in the language to `title` (TITLE). */
static void define(const scene *s, const source *from, int32_t paper, bool fold, double allowance, int32_t language,
                   char *title, mus_sheet_def *def)
{
    mus_sheet_def_init(def, sizeof *def);
    def->paper = paper;
    def->person = s->tape != NULL ? mus_tape_name(s->tape) : NULL;
    def->language = mus_language_tag(language);
    const char *english = from->design != NULL ? mus_design_title(mus_design_find(from->design)) : NULL;
    if (english != NULL) mus_language_compose(language, "title", english, title, TITLE), def->title = title;
    def->fold = fold;
    if (allowance >= 0.0) def->allowance = 0.001 * allowance;
}


static mus_status write_drawn(const mus_sheet *sheet, const char *pdf, const char *svg)
{
    const mus_status status = pdf != NULL ? mus_sheet_write_pdf(sheet, pdf) : MUS_OK;
    return status == MUS_OK && svg != NULL ? mus_sheet_write_svg(sheet, svg) : status;
}


/* Writes DXF and RUL, which are in English: from the sheet, or from one of its own. */
static int write_dxf(scene *s, const source *from, const mus_sheet *sheet, const mus_sheet_def *def,
                     const print_dxf *dxf)
{
    const bool asked = dxf->dxf != NULL || dxf->rul != NULL;
    if (!asked || mus_language_find(def->language) == MUS_LANGUAGE_ENGLISH)
        return print_dxf_write(s, from, sheet, def, dxf);
    mus_sheet *own;
    mus_sheet_def english = *def;
    english.language = NULL;
    if (from->design != NULL) english.title = mus_design_title(mus_design_find(from->design));
    const mus_status status = mus_sheet_create(s->context, s->pattern, &english, &own);
    if (status != MUS_OK) return scene_fail(s, status);
    const int code = print_dxf_write(s, from, own, &english, dxf);
    mus_sheet_destroy(own);
    return code;
}


/* Are the options of the DXF such that it can be written? Complains when they are not. */
static bool check_dxf(const print_dxf *dxf, bool fold)
{
    if (fold && (dxf->dxf != NULL || dxf->rul != NULL))
        complain(EXIT_INPUT, "print", "--fold: a DXF has whole pieces");
    else if (dxf->rul != NULL && dxf->sizes == NULL)
        complain(EXIT_INPUT, "print", "--rul: needs --sizes LIST, the sizes that the rules are for");
    else if (print_dxf_dialect(dxf->dialect) == MUS_NONE)
        complain(EXIT_INPUT, "print", "--dialect %s: expected astm or aama", dxf->dialect);
    else
        return true;
    return false;
}


int command_print(int argc, char **argv)
{
    source from = {0};
    const char *pdf = NULL, *svg = NULL, *plt = NULL, *instructions = NULL;
    const char *asked = NULL, *paper = "a4", *tongue = NULL;
    bool cutter = false, fold = false, as_json = false;
    double allowance = -1.0;
    print_dxf dxf = {0};
    const option options[] = {
        SOURCE_PATTERN(from),
        SOURCE_TAPE(from),
        {"--pdf", OPTION_OUTPUT, &pdf, 0, 0, "FILE  write a tiled PDF at true scale"},
        {"--svg", OPTION_OUTPUT, &svg, 0, 0, "FILE  write one sheet as SVG with named groups"},
        {"--instructions", OPTION_OUTPUT, &instructions, 0, 0, "FILE  write how it is sewn, step by step, as text"},
        {"--dxf", OPTION_OUTPUT, &dxf.dxf, 0, 0, "FILE  write the pieces as DXF R12 for cutters and CAD"},
        {"--rul", OPTION_OUTPUT, &dxf.rul, 0, 0, "FILE  write the grade rules of --sizes"},
        {"--dialect", OPTION_TEXT, &dxf.dialect, 0, 0, "NAME  of the DXF: astm (default) or aama"},
        {"--sizes", OPTION_TEXT, &dxf.sizes, 0, 0, "LIST  further table sizes, one on the other: W36,W38,W42"},
        {"--sew", OPTION_FLAG, &dxf.sew, 0, 0, "layer 1 of the DXF is the sew line, without allowances"},
        {"--plt", OPTION_OUTPUT, &plt, 0, 0, "FILE  write HPGL/2 for a plotter"},
        {"--cutter", OPTION_FLAG, &cutter, 0, 0, "the plot is for a cutter: piece by piece, the cut line last"},
        {"--paper", OPTION_TEXT, &asked, 0, 0, "NAME  a4 (default), letter, a3, a0, roll"},
        {"--fold", OPTION_FLAG, &fold, 0, 0, "symmetric pieces as halves, to be cut on the fold of the cloth"},
        {"--allowance", OPTION_NUMBER, &allowance, 0, 100, "MM  seam allowance where the pattern has none"},
        LANGUAGE_OPTION(tongue),
        {"--json", OPTION_STDOUT, &as_json, 0, 0, "print pages and their places on the sheet as JSON"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("print", "Write a pattern at true scale, ready to cut.", options, argc, argv)) return EXIT_INPUT;
    if (pdf == NULL && svg == NULL && dxf.dxf == NULL && dxf.rul == NULL && plt == NULL && instructions == NULL)
        return complain(EXIT_INPUT, "print",
                        "no output is given: --pdf FILE, --svg FILE, --dxf FILE, --plt FILE or --instructions FILE");
    const int32_t language = language_read("print", tongue);
    if (language == MUS_NONE || !check_dxf(&dxf, fold)) return EXIT_INPUT;
    char first[32];
    if (asked != NULL) paper = asked;
    if (dxf.sizes != NULL) take_first(&from, dxf.sizes, first, sizeof first);
    if (find_paper(paper) == MUS_NONE)
        return complain(EXIT_INPUT, "print", "--paper %s: expected a4, letter, a3, a0 or roll", paper);

    scene s;
    mus_sheet *sheet = NULL, *nest = NULL;
    char *notes = NULL;
    json j = {0};
    int code = scene_open(&s, "print");
    if (code == EXIT_DONE && (from.tape != NULL || from.size != NULL || from.row != NULL)) code = scene_tape(&s, &from);
    if (code == EXIT_DONE) code = scene_pattern(&s, &from);
    if (code == EXIT_DONE) {
        mus_sheet_def def;
        char title[TITLE];
        define(&s, &from, find_paper(paper), fold, allowance, language, title, &def);
        mus_status status = pdf != NULL && dxf.sizes == NULL ? print_notes(&s, &from, language, &notes) : MUS_OK;
        def.notes = notes;
        if (status == MUS_OK) status = mus_sheet_create(s.context, s.pattern, &def, &sheet);
        if (status == MUS_OK && dxf.sizes != NULL && (pdf != NULL || svg != NULL))
            code = print_sizes_sheet(&s, &from, dxf.sizes, &def, &nest);
        if (status == MUS_OK && code == EXIT_DONE) status = write_drawn(nest != NULL ? nest : sheet, pdf, svg);
        mus_sheet_plt plot;
        mus_sheet_plt_init(&plot, sizeof plot);
        plot.by_piece = cutter;
        if (status == MUS_OK && code == EXIT_DONE && plt != NULL) status = mus_sheet_write_plt(sheet, &plot, plt);
        if (status == MUS_OK && code == EXIT_DONE && instructions != NULL)
            status = mus_pattern_write_instructions_in(s.pattern, def.language, def.title, instructions);
        if (status != MUS_OK) code = scene_fail_output(&s, status);
        if (code == EXIT_DONE) code = write_dxf(&s, &from, sheet, &def, &dxf);
    }
    if (code == EXIT_DONE && as_json) {
        describe(nest != NULL ? nest : sheet, &j);
        if (!json_write(&j, "print", "-")) code = EXIT_FAILED;
    } else if (code == EXIT_DONE && pdf != NULL && !is_stdout(pdf) && !is_stdout(svg)) {
        const int pages = (int)mus_sheet_page_count(nest != NULL ? nest : sheet);
        print_line("%s: %d page%s of %s", pdf, pages, pages == 1 ? "" : "s", paper);
    }
    json_free(&j);
    free(notes);
    mus_sheet_destroy(nest);
    mus_sheet_destroy(sheet);
    scene_close(&s);
    return code;
}
