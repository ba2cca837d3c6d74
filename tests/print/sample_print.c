/*
 * sample_print.c: writes the sample shirt as PDF and SVG and says on standard output, as JSON, what must stand on the
 * paper: the length of each printed edge, the perimeter of each printed panel, and where each page shows the sheet.
 *
 *     sample_print PAPER OUT.pdf OUT.svg [LOCALE]
 *
 * test_print_pdf.py compiles it and measures its PDF. With LOCALE everything after start runs under that locale.
 */
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>

#include "muslin/pattern.h"
#include "muslin/print.h"
#include "sample_patterns.h"

/* number, opened and separated from the one before; in micrometres: no locale has a say in whole numbers */
static void print_micrometres(const char *before, double x)
{
    printf("%s%.0f", before, x * 1e6);
}


static void print_pages(const mus_sheet *sheet)
{
    double page[4];
    const char *comma = "";
    printf(",\n \"pages\": [");
    for (int32_t i = 0; i < mus_sheet_page_count(sheet); i++) {
        if (mus_sheet_page(sheet, i, page) != MUS_OK) continue;
        printf("%s{\"page\": %d", comma, (int)i);
        print_micrometres(", \"x_um\": ", page[0]);
        print_micrometres(", \"y_um\": ", page[1]);
        print_micrometres(", \"width_um\": ", page[2]);
        print_micrometres(", \"height_um\": ", page[3]);
        printf("}");
        comma = ", ";
    }
    printf("]");
}


static void print_lengths(const mus_pattern *pattern)
{
    const char *comma = "";
    printf("{\"edges_um\": [");
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        int32_t count, mirror;
        mus_pattern_cut(pattern, mus_pattern_edge_panel(pattern, i), &count, &mirror);
        if (mirror != MUS_NONE) continue;
        print_micrometres(comma, mus_pattern_edge_length(pattern, i));
        comma = ", ";
    }
    printf("]");
}


int main(int argc, char **argv)
{
    if (argc < 4) return 2;
    if (argc > 4 && setlocale(LC_ALL, argv[4]) == NULL) return 3;

    mus_context *context;
    mus_sheet *sheet = NULL;
    mus_sheet_def def;
    if (mus_context_create(NULL, &context) != MUS_OK) return 1;
    mus_pattern *pattern = sample_shirt(context);
    mus_sheet_def_init(&def, sizeof def);
    def.paper = (int32_t)strtol(argv[1], NULL, 10);
    def.person = "Åsa, size 40";
    mus_status status = pattern == NULL ? MUS_ERR_ARG : mus_sheet_create(context, pattern, &def, &sheet);
    if (status == MUS_OK) status = mus_sheet_write_pdf(sheet, argv[2]);
    if (status == MUS_OK) status = mus_sheet_write_svg(sheet, argv[3]);
    if (status == MUS_OK) {
        print_lengths(pattern);
        print_pages(sheet);
        print_micrometres(",\n \"margin_um\": ", def.margin);
        printf(", \"tiled\": %s}\n", mus_sheet_page(sheet, 0, (double[4]){0}) == MUS_OK ? "false" : "true");
    } else {
        fprintf(stderr, "%s: %s\n", mus_status_name(status), mus_context_error(context));
    }
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    mus_context_destroy(context);
    return status == MUS_OK ? 0 : 1;
}
