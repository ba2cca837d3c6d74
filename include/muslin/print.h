/*
 * muslin/print.h: ready-to-cut paper (libmuslin-print).
 *
 * A sheet holds the pieces of a pattern at true scale, with cut line, sew line, allowance, notches, grain line, labels
 * and test squares. It is written as PDF (tiles or one long page), as SVG with named groups, DXF with its RUL, or HPGL.
 * Outside dependencies: cairo, Pango.
 */
#ifndef MUSLIN_PRINT_H
#define MUSLIN_PRINT_H

#include "muslin/base.h"
#include "muslin/language.h"
#include "muslin/layout.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MUS_PAPER_A4 0     /* 210 x 297 mm (ISO 216) */
#define MUS_PAPER_LETTER 1 /* 8.5 x 11 inches */
#define MUS_PAPER_A3 2     /* 297 x 420 mm (ISO 216) */
#define MUS_PAPER_A0 3     /* 841 x 1189 mm (ISO 216) */
#define MUS_PAPER_ROLL 4 /* 914 mm wide, as long as needed */

/** Options of a sheet. */
typedef struct mus_sheet_def {
    size_t size;
    int32_t paper;     /* MUS_PAPER_*, default A4 */
    double allowance;  /* of edges without an allowance of their own [m], default 0.01, 0..0.1 */
    double margin;     /* unprinted border of each page [m], default 0.01, 0..0.1 */
    double overlap;    /* of what neighbouring tiles print [m], default 0 (frame on frame), 0..0.1 */
    const char *title; /* on every label, NULL: the name of the pattern; read during the call */
    const char *person; /* wearer's name, on every label; NULL: none */
    int32_t fold;      /* nonzero: a symmetric panel is printed as its half, with the line that is laid on the fold of
                        * the cloth; pieces may be turned by quarters and halves mirrored to save paper; default 0.
                        * Such a sheet is not written as DXF */
    const char *language; /* of what is written on it: a tag such as "de" or "pt_BR" (muslin/language.h); NULL: English;
                           * read during the call. The title is not translated */
    const char *notes; /* lines of text for the first page of a tiled sheet, as of measures, cloth and notions; an empty
                        * line parts them; read during the call and not translated; NULL: none */
} mus_sheet_def;

/** Zero `def`, write the defaults and its size. */
MUS_API void mus_sheet_def_init(mus_sheet_def *def, size_t size);

/** The pieces of a pattern on paper. */
typedef struct mus_sheet mus_sheet;

/** Lay out a pattern on paper, and after its panels those that are cut and not draped (mus_pattern_cut_only()). The
 * pattern is read during the call and not kept; def NULL takes the defaults. Errors:
 * MUS_ERR_ARG (value out of range, unknown language, margins leave too little of the paper), MUS_ERR_PATTERN (a
 * fault of the pattern), MUS_ERR_LIMIT (more than 10000 pages), MUS_ERR_VERSION, MUS_ERR_MEMORY */
MUS_API mus_status mus_sheet_create(mus_context *context, const mus_pattern *pattern, const mus_sheet_def *def,
                                    mus_sheet **out);

/** Lay out the same pattern in `count` sizes (1 to 64) on one sheet: the sizes of a piece lie on each other by the
 * frame of its panel, halves by their fold lines. `names` (count) are those of the sizes ("W40"). Each size has dashes
 * of its own for its cut line, with its name beside it, and is a layer of the PDF; all layers are visible. Such a
 * sheet is not written as DXF. Errors: as mus_sheet_create(), and MUS_ERR_ARG (count out of range; a size whose panels
 * are not those of the first) */
MUS_API mus_status mus_sheet_create_sizes(mus_context *context, int32_t count, const mus_pattern *const *patterns,
                                          const char *const *names, const mus_sheet_def *def, mus_sheet **out);

/** Free a sheet. NULL is accepted. */
MUS_API void mus_sheet_destroy(mus_sheet *sheet);

/** Number of pages of the PDF, with the cover of a tiled sheet: one of ten pages and more has one, and one whose pages
 * have no room for title and squares. */
MUS_API int32_t mus_sheet_page_count(const mus_sheet *sheet);

/** Number of columns of tiles; 1 when the sheet is one page. */
MUS_API int32_t mus_sheet_columns(const mus_sheet *sheet);

/** Number of rows of tiles; 1 when the sheet is one page. */
MUS_API int32_t mus_sheet_rows(const mus_sheet *sheet);

/** Width and height of the sheet: `out` (2) [m]. Errors: MUS_ERR_ARG */
MUS_API mus_status mus_sheet_extent(const mus_sheet *sheet, double *out);

/** Part of the sheet that page `page` shows: `out` (4) gets the sheet's x and y at the lower left corner of the page,
 * then the width and height of the page [m]. Errors: MUS_ERR_ARG (page out of range, or the cover) */
MUS_API mus_status mus_sheet_page(const mus_sheet *sheet, int32_t page, double *out);

/* ---- pieces and lines as data, for writers of other forms; PDF and SVG are written from the same data ---- */

/** A panel as it lies on the sheet. */
typedef struct mus_sheet_piece {
    size_t size;
    int32_t panel;    /* index in the pattern; those of mus_pattern_cut_only() follow its own panels */
    const char *name; /* of the panel; borrowed until the sheet is destroyed */
    int32_t copies;   /* number of copies to cut of the main cloth; without any, of the first material that has some */
    int32_t mirrored; /* nonzero: half of the copies are cut turned over */
    int32_t fold;     /* nonzero: the half of a symmetric panel. 1: it lies right of the fold line, which is at box[0];
                       * -1: left, at box[2]; turned by a quarter, 2: above, at box[1]; -2: below, at box[3] */
    double turn[4];   /* from the plane of the panel to the sheet: x = turn[0] u + turn[1] v + shift[0], */
    double shift[2];  /* y = turn[2] u + turn[3] v + shift[1] [m]; right side up, grain upright, level
                       * on a sheet of halves where that saves paper */
    double box[4];    /* of the cut line: low x, low y, high x, high y [m] */
    int32_t size_index; /* of the size that the piece is of; 0 on a sheet of one size */
    int32_t materials[8]; /* number of copies to cut of each MUS_MATERIAL_*; 0 beyond the last */
} mus_sheet_piece;

/** Zero `piece` and write its size. */
MUS_API void mus_sheet_piece_init(mus_sheet_piece *piece, size_t size);

/** Number of pieces. */
MUS_API int32_t mus_sheet_piece_count(const mus_sheet *sheet);

/** Get piece `piece`, in the order of the pattern's panels; the sizes of a panel stand together. Errors: MUS_ERR_ARG
 * (no such piece), MUS_ERR_VERSION */
MUS_API mus_status mus_sheet_piece_get(const mus_sheet *sheet, int32_t piece, mus_sheet_piece *out);

#define MUS_LINE_CUT 0   /* cut line: closed; the outer one first, then holes */
#define MUS_LINE_SEW 1   /* sew line: one line for each edge, in the order of the outline */
#define MUS_LINE_NOTCH 2 /* notch: one slit or more, each from the cut line inwards */
#define MUS_LINE_GRAIN 3 /* grain line, and its two arrow heads */
#define MUS_LINE_MARK 4  /* mark inside the piece (a drill point is a cross), its name; words of edges, in strokes */
#define MUS_LINE_LABEL 5 /* label of the piece, in strokes */

/** A line of the sheet: steps and their points, as a PostScript path; y up. */
typedef struct mus_sheet_line {
    size_t size;
    int32_t piece;        /* index of the piece that the line belongs to; MUS_NONE: test squares and instructions */
    int32_t kind;         /* MUS_LINE_* */
    int32_t edge;         /* edge of the pattern, for a sew line and a notch; else MUS_NONE. Those of
                           * mus_pattern_cut_only() follow its own edges */
    int32_t filled;       /* nonzero: a filled area (arrow heads); 0: a stroke */
    int32_t op_count;     /* number of steps */
    int32_t point_count;  /* number of points of all steps */
    const uint8_t *ops;   /* (op_count) 'm' move and 'l' line take one point, 'c' cubic three, 'z' close none */
    const double *points; /* (point_count x 2) on the sheet [m] */
} mus_sheet_line;

/** Zero `line` and write its size. */
MUS_API void mus_sheet_line_init(mus_sheet_line *line, size_t size);

/** Number of lines of all pieces. */
MUS_API int32_t mus_sheet_line_count(const mus_sheet *sheet);

/**
 * Get line `line`. The lines of a piece stand together, in the order of their kinds.
 *
 * Shapes: ops (op_count), points (point_count x 2); borrowed until the sheet is destroyed
 * Units:  points [m] on the sheet, x right, y up
 * Errors: MUS_ERR_ARG (no such line), MUS_ERR_VERSION
 */
MUS_API mus_status mus_sheet_line_get(const mus_sheet *sheet, int32_t line, mus_sheet_line *out);

/* ---- files ---- */

/** Write the sheet as PDF. A failure leaves no half file; path "-" writes to standard output. The bytes do not depend
 * on locale, clock or time zone; in English not on fonts either. Text of another language, and names beyond Latin, are
 * set in fonts of the machine, which go into the file. Errors: MUS_ERR_ARG, MUS_ERR_FILE, MUS_ERR_MEMORY */
MUS_API mus_status mus_sheet_write_pdf(const mus_sheet *sheet, const char *path);

/** Write the sheet as PDF into memory. *bytes belongs to the caller, who frees it with
 * mus_context_alloc(context, bytes, 0); it is NULL after a failure. Errors: MUS_ERR_ARG, MUS_ERR_MEMORY */
MUS_API mus_status mus_sheet_write_pdf_bytes(const mus_sheet *sheet, char **bytes, size_t *size);

/** Write the sheet as one SVG drawing with named groups. path and errors: as mus_sheet_write_pdf() */
MUS_API mus_status mus_sheet_write_svg(const mus_sheet *sheet, const char *path);

/** Write the sheet as SVG into memory. *bytes and errors: as mus_sheet_write_pdf_bytes() */
MUS_API mus_status mus_sheet_write_svg_bytes(const mus_sheet *sheet, char **bytes, size_t *size);

/* ---- instructions ---- */

/**
 * Write how a pattern is sewn, as plain text: pieces, the metres of each cloth by its width, notions (buttons, zips,
 * elastic), what is prepared, the steps.
 *
 * The order follows from the seams alone: darts and pleats, patches, seams, free edges, buttons. A seam that ends
 * within another is sewn before it, and no ring (a sleeve, a leg) is closed while something can be sewn flat. A seam
 * stands in one step, with its length, its notches and the length of what is eased or stretched to it. What is the same
 * left and right is told once. The steps do not depend on the order of panels, edges and seams in the pattern; the
 * lists of pieces and notions do, the metres of cloth by some centimetres, and the order of panels that are cut and not
 * draped. The metres are those of layouts on folded cloth, rounded up to 5 cm. `title` is the first line; NULL: the
 * name of the pattern.
 * Units:  cm and mm in the text, which is UTF-8 with a newline after each line
 * Errors: MUS_ERR_ARG (pattern or path NULL), MUS_ERR_FILE, MUS_ERR_MEMORY. A failure leaves no half file; path "-"
 *         writes to standard output
 * Cost:   lines of stitching times seams and edges; a layout for each material and width, 10 ms or more each
 */
MUS_API mus_status mus_pattern_write_instructions(const mus_pattern *pattern, const char *title, const char *path);

/** Write the instructions into memory. *bytes: as mus_sheet_write_pdf_bytes(); errors: as
 * mus_pattern_write_instructions() */
MUS_API mus_status mus_pattern_write_instructions_bytes(const mus_pattern *pattern, const char *title, char **bytes,
                                                        size_t *size);

/** Write the instructions in a language: a tag such as "de" or "pt_BR" (muslin/language.h), NULL for English. The order
 * of steps, lines and lists is that of English. The title is not translated. Errors: as
 * mus_pattern_write_instructions(), and MUS_ERR_ARG for an unknown language */
MUS_API mus_status mus_pattern_write_instructions_in(const mus_pattern *pattern, const char *language,
                                                     const char *title, const char *path);

/** Write the instructions in a language into memory. *bytes: as mus_sheet_write_pdf_bytes(); errors: as
 * mus_pattern_write_instructions_in() */
MUS_API mus_status mus_pattern_write_instructions_in_bytes(const mus_pattern *pattern, const char *language,
                                                           const char *title, char **bytes, size_t *size);

/* ---- a layout on cloth (muslin/layout.h) ---- */

/**
 * Draw a layout as SVG at true scale: the cloth with its fold and selvedges, the pieces with their names, grain arrows,
 * a scale in decimetres. The cloth runs to the right; the fold, or the lower selvedge, is at the bottom.
 *
 * Units:  millimetres in the file; each piece is a group with the name of its panel
 * Errors: MUS_ERR_ARG (layout or path NULL), MUS_ERR_FILE, MUS_ERR_MEMORY. A failure leaves no half file; path "-"
 *         writes to standard output
 */
MUS_API mus_status mus_layout_write_svg(const mus_layout *layout, const char *path);

/** Draw a layout as SVG into memory. *bytes: as mus_sheet_write_pdf_bytes(); errors: as mus_layout_write_svg() */
MUS_API mus_status mus_layout_write_svg_bytes(const mus_layout *layout, char **bytes, size_t *size);

/* ---- DXF and RUL, for cutters and CAD of the trade ---- */

#define MUS_DXF_AAMA 0 /* ANSI/AAMA-292: a notch is a line on layer 4 */
#define MUS_DXF_ASTM 1 /* ASTM D6673: a notch is a point with depth and angle; 84, 85 and 87 repeat 1, 8 and 14 */

#define MUS_DXF_CUT 0 /* layer 1 is the cut line, layer 14 the sew line */
#define MUS_DXF_SEW 1 /* layer 1 is the sew line: the receiver adds the allowances */

/** Options of a DXF file and of the RUL file beside it. */
typedef struct mus_sheet_dxf {
    size_t size;
    int32_t dialect;        /* MUS_DXF_AAMA or MUS_DXF_ASTM (default) */
    int32_t boundary;       /* MUS_DXF_CUT (default) or MUS_DXF_SEW; a RUL file numbers the ends of edges either way */
    const char *size_name;  /* size of the sheet ("W40"); NULL: "1" */
    const char *date;       /* creation date "dd-mm-yyyy"; NULL: none is written, so that the bytes stay the same */
    int32_t nested;         /* nonzero: a block for each piece of each size; 0 (default): the sheet's own size alone */
    int32_t size_count;     /* sizes besides the sheet's own, 0 (default) to 64 */
    const mus_sheet *const *sheets; /* (size_count) the same pattern in these sizes, on sheets of their own */
    const char *const *size_names;  /* (size_count) */
} mus_sheet_dxf;

/** Write the defaults: ASTM, the cut line on layer 1, one size. */
MUS_API void mus_sheet_dxf_init(mus_sheet_dxf *def, size_t size);

/**
 * Write the pieces as DXF R12, one block a piece (and size, when nested); def NULL takes the defaults.
 *
 * Layers: 1 boundary and texts, 2 turn points, 3 curve points, 4 notches, 7 grain, 8 lines inside, 11 cut-outs, 13
 * drill points, 14 sew line (one polyline an edge), 15 annotation. Names are capitals, digits and "_", at most 20.
 * Curves are chords within 0.01 mm. With sizes, the ends of edges carry the numbers of their grade rules ("# 3").
 * Units:  millimetres in the file
 * Errors: MUS_ERR_ARG (an unknown dialect or boundary; a size whose pieces or edges are not those of the sheet),
 *         MUS_ERR_VERSION, MUS_ERR_FILE, MUS_ERR_MEMORY. path "-" writes to standard output
 * Source: ANSI/AAMA-292-1993; ASTM D6673-10
 */
MUS_API mus_status mus_sheet_write_dxf(const mus_sheet *sheet, const mus_sheet_dxf *def, const char *path);

/** Write the DXF into memory. *bytes: as mus_sheet_write_pdf_bytes(); errors: as mus_sheet_write_dxf() */
MUS_API mus_status mus_sheet_write_dxf_bytes(const mus_sheet *sheet, const mus_sheet_dxf *def, char **bytes,
                                             size_t *size);

/** Write the grade rules of the sizes of `def` as a RUL file: for each rule the displacement of its points from the
 * sheet's own size to each size [mm]. Errors: as mus_sheet_write_dxf() */
MUS_API mus_status mus_sheet_write_rul(const mus_sheet *sheet, const mus_sheet_dxf *def, const char *path);

/** Write the RUL file into memory. *bytes: as mus_sheet_write_pdf_bytes(); errors: as mus_sheet_write_dxf() */
MUS_API mus_status mus_sheet_write_rul_bytes(const mus_sheet *sheet, const mus_sheet_dxf *def, char **bytes,
                                             size_t *size);

/* ---- HPGL, for plotters and cutters ---- */

/** Options of a plot. */
typedef struct mus_sheet_plt {
    size_t size;
    int32_t hpgl2;    /* nonzero (default): HPGL/2, with the length and width of the plot (PS); 0: HPGL */
    int32_t by_piece; /* nonzero: for a cutter: of each piece marks and notches, then its cut line; no letters, no sew
                       * line. 0 (default): for a plotter: all lines, pen after pen */
    int32_t one_pen;  /* nonzero: pen 1 draws all; 0 (default): pen 1 cut line and notches, 2 sew line (dashed), 3 grain
                       * and marks, 4 letters */
} mus_sheet_plt;

/** Write the defaults: HPGL/2 for a plotter with four pens. */
MUS_API void mus_sheet_plt_init(mus_sheet_plt *def, size_t size);

/**
 * Write the sheet as HPGL; def NULL takes the defaults. The paper runs along x: x of the plot is y of the sheet.
 *
 * Units:  a plotter unit is 0.025 mm; curves are chords within 0.01 mm
 * Errors: MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_FILE, MUS_ERR_MEMORY. path "-" writes to standard output
 * Source: Hewlett-Packard, HP-GL/2 and HP RTL Reference Guide
 */
MUS_API mus_status mus_sheet_write_plt(const mus_sheet *sheet, const mus_sheet_plt *def, const char *path);

/** Write the plot into memory. *bytes: as mus_sheet_write_pdf_bytes(); errors: as mus_sheet_write_plt() */
MUS_API mus_status mus_sheet_write_plt_bytes(const mus_sheet *sheet, const mus_sheet_plt *def, char **bytes,
                                             size_t *size);

#ifdef __cplusplus
}
#endif

#endif
