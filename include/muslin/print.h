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

/** Zero `def`, write the defaults and its size. */
MUS_API void mus_sheet_def_init(mus_sheet_def *def, size_t size);

/** The pieces of a pattern on paper. */
typedef struct mus_sheet mus_sheet;

/** Lay out a pattern. Errors: MUS_ERR_ARG (value out of range, paper smaller than its margins), MUS_ERR_PATTERN (a
 * fault of the pattern), MUS_ERR_LIMIT (more than 10000 pages), MUS_ERR_MEMORY. The pattern is read, not kept. */
MUS_API mus_status mus_sheet_create(mus_context *context, const mus_pattern *pattern, const mus_sheet_def *def,
                                    mus_sheet **out);

/** Free a sheet. NULL is accepted. */
MUS_API void mus_sheet_destroy(mus_sheet *sheet);

/** Number of pages that the PDF will have, the cover of a tiled sheet included. */
MUS_API int32_t mus_sheet_page_count(const mus_sheet *sheet);

/** Number of columns of tiles; 1 when the sheet is one page. */
MUS_API int32_t mus_sheet_columns(const mus_sheet *sheet);

/** Number of rows of tiles; 1 when the sheet is one page. */
MUS_API int32_t mus_sheet_rows(const mus_sheet *sheet);

/** Width and height of the sheet: `out` (2) [m]. Errors: MUS_ERR_ARG */
MUS_API mus_status mus_sheet_extent(const mus_sheet *sheet, double *out);

/** Where page `page` shows the sheet: `out` (4) gets the sheet's x, y [m] at the page's lower left corner, and the
 * page's width and height [m]. Errors: MUS_ERR_ARG (page out of range, or the cover). */
MUS_API mus_status mus_sheet_page(const mus_sheet *sheet, int32_t page, double *out);

/* ---- pieces and lines as data: what PDF and SVG are written from, for other writers ---- */

/** A panel as it lies on the sheet. */
typedef struct mus_sheet_piece {
    size_t size;
    int32_t panel;    /* of the pattern */
    const char *name; /* of the panel; borrowed until the sheet is destroyed */
    int32_t copies;   /* how often it is cut */
    int32_t mirrored; /* nonzero: half of the copies are cut turned over */
    double turn[4];   /* from the plane of the panel to the sheet: x = turn[0] u + turn[1] v + shift[0], */
    double shift[2];  /* y = turn[2] u + turn[3] v + shift[1] [m]; grain up, right side up */
    double box[4];    /* of the cut line: low x, low y, high x, high y [m] */
} mus_sheet_piece;

/** Zero `piece` and write its size. */
MUS_API void mus_sheet_piece_init(mus_sheet_piece *piece, size_t size);

/** Number of pieces. */
MUS_API int32_t mus_sheet_piece_count(const mus_sheet *sheet);

/** Piece `piece`, in the order of the pattern's panels. Errors: MUS_ERR_ARG (no such piece), MUS_ERR_VERSION */
MUS_API mus_status mus_sheet_piece_get(const mus_sheet *sheet, int32_t piece, mus_sheet_piece *out);

#define MUS_LINE_CUT 0   /* cut line: closed; the outer one first, then holes */
#define MUS_LINE_SEW 1   /* sew line: a line an edge, in the order of the outline */
#define MUS_LINE_NOTCH 2 /* notch: a slit or several, each from the cut line inwards */
#define MUS_LINE_GRAIN 3 /* grain line, and the two heads of its arrow */
#define MUS_LINE_MARK 4  /* mark inside the piece, drill point as a cross, and its name in strokes */
#define MUS_LINE_LABEL 5 /* label of the piece, in strokes */

/** A line of the sheet: steps and points as in PostScript, y up. */
typedef struct mus_sheet_line {
    size_t size;
    int32_t piece;        /* that it belongs to */
    int32_t kind;         /* MUS_LINE_* */
    int32_t edge;         /* of the pattern, for a sew line and a notch; else MUS_NONE */
    int32_t filled;       /* nonzero: an area (arrow heads), else a stroke */
    int32_t op_count;     /* steps */
    int32_t point_count;  /* points of all steps */
    const uint8_t *ops;   /* (op_count) 'm' move and 'l' line take one point, 'c' cubic three, 'z' close none */
    const double *points; /* (point_count x 2) on the sheet [m] */
} mus_sheet_line;

/** Zero `line` and write its size. */
MUS_API void mus_sheet_line_init(mus_sheet_line *line, size_t size);

/** Number of lines of all pieces. */
MUS_API int32_t mus_sheet_line_count(const mus_sheet *sheet);

/**
 * Line `line`: those of a piece follow each other, by their kind.
 *
 * Shapes: ops (op_count), points (point_count x 2); borrowed until the sheet is destroyed
 * Units:  points [m] on the sheet, x right, y up
 * Errors: MUS_ERR_ARG (no such line), MUS_ERR_VERSION
 */
MUS_API mus_status mus_sheet_line_get(const mus_sheet *sheet, int32_t line, mus_sheet_line *out);

/* ---- files ---- */

/** Write the sheet as PDF, whole or not at all; path "-" writes to standard output. The bytes do not depend on locale,
 * clock or time zone. Errors: MUS_ERR_ARG, MUS_ERR_FILE, MUS_ERR_MEMORY */
MUS_API mus_status mus_sheet_write_pdf(const mus_sheet *sheet, const char *path);

/** Write the sheet as PDF into memory: *bytes is the caller's, freed by mus_context_alloc(context, bytes, 0), NULL after
 * a failure. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY */
MUS_API mus_status mus_sheet_write_pdf_bytes(const mus_sheet *sheet, char **bytes, size_t *size);

/** Write the sheet as one SVG drawing with named groups, as mus_sheet_write_pdf() does. */
MUS_API mus_status mus_sheet_write_svg(const mus_sheet *sheet, const char *path);

/** Write the sheet as SVG into memory, as mus_sheet_write_pdf_bytes() does. */
MUS_API mus_status mus_sheet_write_svg_bytes(const mus_sheet *sheet, char **bytes, size_t *size);

#ifdef __cplusplus
}
#endif

#endif
