/*
 * paper.c: ready-to-cut paper and nothing else: from a tape to pages, without body, cloth or drape.
 *
 *     build/examples/paper [FOLDER]
 *
 * Jeans are drafted for men's 50 and laid out on A4 pages and on a roll; FOLDER gets a PDF of the pages and an SVG
 * of the sheet. A program like this links none of the library's simulation.
 */
#include <stdio.h>
#include <stdlib.h>

#include "muslin/design.h"
#include "muslin/print.h"

static mus_context *context;


/* end with one sentence when a call failed */
static void must(mus_status status)
{
    if (status == MUS_OK) return;
    fprintf(stderr, "paper: %s: %s\n", mus_status_name(status), mus_context_error(context));
    exit(1);
}


int main(int argc, char **argv)
{
    char pdf[4096], svg[4096];
    mus_tape *tape;
    mus_pattern *pattern;
    mus_sheet *sheet;
    mus_sheet_def def;
    double extent[2], page[4];

    snprintf(pdf, sizeof pdf, "%s/jeans.pdf", argc > 1 ? argv[1] : ".");
    snprintf(svg, sizeof svg, "%s/jeans.svg", argc > 1 ? argv[1] : ".");
    must(mus_context_create(NULL, &context));
    must(mus_tape_create(context, &tape));
    must(mus_tape_set_size(tape, "M50"));
    must(mus_design_draft(context, mus_design_find("jeans"), tape, NULL, &pattern));
    printf("%s: %d panels, %d seams\n", mus_pattern_name(pattern), (int)mus_pattern_panel_count(pattern),
           (int)mus_pattern_seam_count(pattern));

    /* pages to glue together, with 15 mm of seam allowance */
    mus_sheet_def_init(&def, sizeof def);
    def.paper = MUS_PAPER_A4;
    def.allowance = 0.015;
    def.title = "Jeans";
    def.person = "Men's 50";
    must(mus_sheet_create(context, pattern, &def, &sheet));
    must(mus_sheet_extent(sheet, extent));
    printf("A4: a sheet of %.0f x %.0f cm on %d pages, %d columns and %d rows\n", 100 * extent[0], 100 * extent[1],
           (int)mus_sheet_page_count(sheet), (int)mus_sheet_columns(sheet), (int)mus_sheet_rows(sheet));
    must(mus_sheet_page(sheet, 1, page));
    printf("each shows %.0f x %.0f mm of it\n", 1e3 * page[2], 1e3 * page[3]);
    must(mus_sheet_write_pdf(sheet, pdf));
    mus_sheet_destroy(sheet);

    /* one long page for a plotter */
    def.paper = MUS_PAPER_ROLL;
    must(mus_sheet_create(context, pattern, &def, &sheet));
    must(mus_sheet_extent(sheet, extent));
    printf("roll: %d page, %.0f x %.0f cm\n", (int)mus_sheet_page_count(sheet), 100 * extent[0], 100 * extent[1]);
    must(mus_sheet_write_svg(sheet, svg));
    mus_sheet_destroy(sheet);

    /* a sheet that cannot be made says why */
    def.allowance = 2.0;
    const mus_status status = mus_sheet_create(context, pattern, &def, &sheet);
    printf("allowance of 2 m: %s\n", mus_status_name(status));

    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    mus_context_destroy(context);
    return 0;
}
