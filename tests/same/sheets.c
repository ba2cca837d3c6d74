/*
 * sheets.c: rows "paper/...": sheets laid out and written as PDF and SVG, whole bytes. A sheet uses no font and its
 * date is fixed, so the bytes depend on cairo alone, which the tables name.
 */
#include "scene.h"

typedef struct page {
    const char *name, *garment, *tape;
    int32_t paper;
    double allowance, margin, overlap; /* [m]; 0: the default */
    const char *title, *person;
} page;

static const page pages[] = {
    {"tshirt-a4", "tshirt", "W40", MUS_PAPER_A4, 0, 0, 0, NULL, NULL},
    {"tshirt-a3-person", "tshirt", "M50", MUS_PAPER_A3, 0, 0, 0, "T-Shirt für Ada", "Ada"},
    {"skirt-letter", "skirt", "W40", MUS_PAPER_LETTER, 0.015, 0, 0, NULL, NULL},
    {"bodice-a0", "bodice", "W40", MUS_PAPER_A0, 0, 0, 0, NULL, "W40"},
    {"jeans-roll", "jeans", "W40", MUS_PAPER_ROLL, 0.012, 0, 0, NULL, NULL},
    {"oxford-a0", "oxford_shirt", "M50", MUS_PAPER_A0, 0, 0.02, 0, NULL, NULL},
    {"kilt-roll", "kilt", "W44", MUS_PAPER_ROLL, 0, 0, 0, NULL, NULL},
    {"coat-a4-overlap", "coat", "W40", MUS_PAPER_A4, 0, 0.008, 0.02, "Coat", NULL},
    {"cape-a3", "cape_hood_knee", "W40", MUS_PAPER_A3, 0.02, 0, 0, NULL, NULL},
    {"child-a4", "child_gathered_short", "C104", MUS_PAPER_A4, 0, 0, 0, NULL, "C104"},
    {"shorts-letter", "straight_shorts", "C128", MUS_PAPER_LETTER, 0, 0, 0.005, NULL, NULL},
    {"blouse-roll", "blouse_peter_pan_short", "W52", MUS_PAPER_ROLL, 0, 0, 0, NULL, NULL},
    {"layers-a0", "tshirt+waistcoat", "W40", MUS_PAPER_A0, 0, 0, 0, NULL, NULL},
    {"spec-000-a0", "garmentcode/specs/d11_000_mean_all_specification.json", NULL, MUS_PAPER_A0, 0, 0, 0, NULL, NULL},
    {"aaron-roll", "freesewing/aaron_cisMaleAdult40.json", NULL, MUS_PAPER_ROLL, 0, 0, 0, NULL, NULL},
};


static void make_page(same_run *run, const void *what, int32_t index)
{
    (void)index;
    const page *p = what;
    double box[4] = {0};
    mus_sheet *sheet = NULL;
    mus_sheet_def def;
    mus_pattern *pattern = same_garment(run, p->garment, p->tape != NULL ? same_size(run, p->tape) : NULL);
    mus_sheet_def_init(&def, sizeof def);
    def.paper = p->paper, def.title = p->title, def.person = p->person;
    if (p->allowance > 0.0) def.allowance = p->allowance;
    if (p->margin > 0.0) def.margin = p->margin;
    if (p->overlap > 0.0) def.overlap = p->overlap;
    if (!same_status(run, mus_sheet_create(run->context, pattern, &def, &sheet))) return;
    same_int(run, mus_sheet_columns(sheet));
    same_int(run, mus_sheet_rows(sheet));
    same_must(run, mus_sheet_extent(sheet, box), "mus_sheet_extent");
    same_reals(run, box, 2);
    for (int32_t i = 0; i < mus_sheet_page_count(sheet); i++)
        if (same_status(run, mus_sheet_page(sheet, i, box))) same_reals(run, box, 4);
    same_must(run, mus_sheet_write_pdf(sheet, "sheet.pdf"), "mus_sheet_write_pdf");
    same_file(run, "sheet.pdf");
    same_must(run, mus_sheet_write_svg(sheet, "sheet.svg"), "mus_sheet_write_svg");
    same_file(run, "sheet.svg");
}


void same_sheets(same_list *list)
{
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        same_row *row = same_add(list, make_page, "paper/%s", pages[i].name);
        row->what = &pages[i];
        row->data = pages[i].tape == NULL;
    }
}
