/*
 * muslin/print.h: ready-to-cut paper (libmuslin-print).
 *
 * Lays the pieces of a pattern on a sheet at true scale with cut line, seam line, allowance, notches, grain, labels
 * and a test square, and writes it as PDF (tiled or one long page) or SVG with named groups. Outside dependency: cairo.
 */
#ifndef MUSLIN_PRINT_H
#define MUSLIN_PRINT_H

#include "muslin/base.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MUS_PAPER_A4 0
#define MUS_PAPER_LETTER 1
#define MUS_PAPER_A3 2
#define MUS_PAPER_A0 3
#define MUS_PAPER_ROLL 4 /* 914 mm wide, as long as needed */

/** Options of a sheet. */
typedef struct mus_sheet_def {
    size_t size;
    int32_t paper;     /* MUS_PAPER_*, default A4 */
    double allowance;  /* of edges that do not say their own [m], default 0.01, 0..0.1 */
    double margin;     /* unprinted border of each page [m], default 0.01 */
    double overlap;    /* between tiles [m], default 0.01 */
    const char *title; /* on every label, NULL: the pattern's name; read during the call */
    const char *person; /* whom it is cut for, NULL: nothing */
} mus_sheet_def;

MUS_API void mus_sheet_def_init(mus_sheet_def *def, size_t size);

typedef struct mus_sheet mus_sheet;

/** Lay out a pattern. Errors: MUS_ERR_ARG (value out of range, paper smaller than its margins), MUS_ERR_PATTERN (a
 * fault of the pattern), MUS_ERR_LIMIT (more than 10000 pages), MUS_ERR_MEMORY. The pattern is read, not kept. */
MUS_API mus_status mus_sheet_create(mus_context *context, const mus_pattern *pattern, const mus_sheet_def *def,
                                    mus_sheet **out);
MUS_API void mus_sheet_destroy(mus_sheet *sheet);

/** Pages that the PDF will have (cover included when tiled), tile columns and rows, and the sheet's size (2) [m]. */
MUS_API int32_t mus_sheet_page_count(const mus_sheet *sheet);
MUS_API int32_t mus_sheet_columns(const mus_sheet *sheet);
MUS_API int32_t mus_sheet_rows(const mus_sheet *sheet);
MUS_API mus_status mus_sheet_extent(const mus_sheet *sheet, double *out);

/** Where page `page` shows the sheet: `out` (4) gets the sheet's x, y [m] at the page's lower left corner, and the
 * page's width and height [m]. Errors: MUS_ERR_ARG (page out of range, or the cover). */
MUS_API mus_status mus_sheet_page(const mus_sheet *sheet, int32_t page, double *out);

/** Write the sheet. Whole or not at all (a temporary file beside `path`, then rename). The bytes do not depend on
 * locale, clock or machine's time zone. Errors: MUS_ERR_FILE, MUS_ERR_MEMORY. */
MUS_API mus_status mus_sheet_write_pdf(const mus_sheet *sheet, const char *path);
MUS_API mus_status mus_sheet_write_svg(const mus_sheet *sheet, const char *path);

#ifdef __cplusplus
}
#endif

#endif
