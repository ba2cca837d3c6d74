/*
 * print_internal.h: what the files of this folder share: a drawing (a list of paths), a piece, the sheet and its pages.
 *
 * Way of the data: pattern -> pieces (outline.c, offset.c) -> places on the sheet (pack.c) -> one drawing of the whole
 * sheet (marks.c, label.c, stroke.c) -> pages (tile.c) -> bytes (pdf.c, svg.c) -> file (paper_file.c).
 * Units: metre, x right, y up; the writers turn and scale. Everything goes through the public functions of the context,
 * since this folder is a library beside libmuslin. Included by lib/print only.
 */
#ifndef MUS_PRINT_INTERNAL_H
#define MUS_PRINT_INTERNAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "muslin/print.h"

#if defined(__GNUC__)
#define MUS_PRINT_FORMAT(at, from) __attribute__((format(printf, at, from)))
#else
#define MUS_PRINT_FORMAT(at, from)
#endif

#define MUS_PRINT_PI 3.14159265358979323846

/* ---- helpers (drawing.c) ---- */

mus_status mus__print_fail(mus_context *context, mus_status status, const char *format, ...) MUS_PRINT_FORMAT(3, 4);
mus_status mus__print_memory(mus_context *context, const char *what);
/* millimetres with at most one decimal, without the locale; returns the length */
int32_t mus__print_millimetres(char *out, size_t size, double x);
/* `count` zeroed elements; NULL when there is no memory or the product overflows */
void *mus__print_new(mus_context *context, int64_t count, size_t size);
void mus__print_free(mus_context *context, void *block);
/* grow *array (capacity *capacity elements of `size`) to hold `need`; the old array is kept on failure */
mus_status mus__print_reserve(mus_context *context, void *array, int32_t *capacity, int64_t need, size_t size);

/* ---- a drawing: paths with a pen each ---- */

typedef enum mus__pen {
    MUS__PEN_CUT,    /* cut line: solid 0.5 mm */
    MUS__PEN_SEAM,   /* seam line: dashed 0.25 mm; no other pen has these dashes, so a reader can find seam lines */
    MUS__PEN_NOTCH,  /* slits */
    MUS__PEN_GRAIN,  /* grain line */
    MUS__PEN_MARK,   /* lines inside a piece */
    MUS__PEN_TEXT,   /* letters */
    MUS__PEN_SMALL,  /* small letters */
    MUS__PEN_TITLE,  /* large letters */
    MUS__PEN_SQUARE, /* test squares */
    MUS__PEN_FRAME,  /* edge of a page, page map */
    MUS__PEN_JOIN,   /* where the next page's edge lies */
    MUS__PEN_FAINT,  /* letters beside the pattern */
    MUS__PEN_INK,    /* filled black */
    MUS__PEN_GREY,   /* filled grey */
    MUS__PEN_COUNT
} mus__pen;

typedef struct mus__pen_style {
    double width;   /* [m], 0 for a filled path */
    double dash[2]; /* on, off [m]; 0 for solid */
    double grey;    /* 0 black .. 1 white */
} mus__pen_style;

extern const mus__pen_style mus__pen_styles[MUS__PEN_COUNT];

/* groups of a piece, in the order they are drawn */
typedef enum mus__layer {
    MUS__LAYER_CUT,
    MUS__LAYER_SEAM,
    MUS__LAYER_NOTCHES,
    MUS__LAYER_GRAIN,
    MUS__LAYER_MARKS,
    MUS__LAYER_LABEL,
    MUS__LAYER_COUNT
} mus__layer;

typedef struct mus__path {
    int32_t piece; /* or MUS_NONE */
    mus__layer layer;
    mus__pen pen;
    int32_t op;    /* first in ops */
    int32_t nop;
    int32_t at;    /* first in xy */
    double box[4]; /* low x, y, high x, y of its points */
} mus__path;

typedef struct mus__drawing {
    mus_context *context;
    mus_status status; /* first failure; later calls do nothing */
    int32_t npath, nop, nxy;
    int32_t path_room, op_room, xy_room;
    mus__path *paths;   /* (npath) */
    unsigned char *ops; /* (nop) 'm' and 'l' take one point, 'c' three, 'z' none */
    double *xy;         /* (nxy) two a point */
} mus__drawing;

void mus__draw_init(mus__drawing *drawing, mus_context *context);
void mus__draw_free(mus__drawing *drawing);
void mus__draw_path(mus__drawing *drawing, int32_t piece, mus__layer layer, mus__pen pen);
void mus__draw_move(mus__drawing *drawing, double x, double y);
void mus__draw_line(mus__drawing *drawing, double x, double y);
void mus__draw_curve(mus__drawing *drawing, const double *xy); /* three points */
void mus__draw_close(mus__drawing *drawing);
void mus__draw_rectangle(mus__drawing *drawing, double x, double y, double width, double height);

/* ---- letters (stroke.c) ---- */

typedef struct mus__text_style {
    double height; /* of a capital [m] */
    double cosine; /* direction of the line of text */
    double sine;
    double align; /* 0: x is the left end, 0.5 the middle, 1 the right end */
} mus__text_style;

/* the next character of UTF-8 text, or 0 at its end; a wrong byte counts as one character U+FFFD */
uint32_t mus__text_character(const char **text);
/* width of UTF-8 text at capital height 1 */
double mus__text_width(const char *text);
/* add text to the path in hand, its base line through (x, y) */
void mus__draw_text(mus__drawing *drawing, const char *text, double x, double y, const mus__text_style *style);

/* ---- offset (offset.c) ---- */

/* closed polygons: the outer one first (counter-clockwise), then holes (clockwise) */
typedef struct mus__loops {
    int32_t nloop;
    int32_t n;
    int32_t *start; /* (nloop + 1) */
    double *xy;     /* (n x 2) */
} mus__loops;

void mus__loops_free(mus_context *context, mus__loops *loops);
/* offset a simple counter-clockwise polygon outwards; side i (from point i to the next) by width[i] >= 0. hem (n) may
 * be NULL; a corner between a hem side and another is reflected in the hem. All widths 0: the polygon itself */
mus_status mus__offset(mus_context *context, int32_t n, const double *xy, const double *width,
                       const unsigned char *hem, mus__loops *out);

/* ---- a piece (outline.c) ---- */

/* part of an edge: a line or a cubic, in the direction of the outline */
typedef struct mus__span {
    double p[8]; /* four points; of a line the first and the last count */
    bool line;
    int32_t side; /* which of the piece's sides */
} mus__span;

/* an edge in the outline */
typedef struct mus__side {
    int32_t edge;
    int32_t direction; /* +1, -1; after turning the piece counter-clockwise */
    double width;      /* allowance [m] */
    bool hem;
} mus__side;

typedef struct mus__piece {
    int32_t panel;
    int32_t copies;   /* how often it is cut */
    bool mirrored;    /* half of them turned over */
    double turn[4];   /* pattern plane to sheet, row-major: grain up, outline counter-clockwise */
    double shift[2];  /* added after turn */
    int32_t nside, nspan, nflat;
    mus__side *sides; /* (nside) */
    mus__span *spans; /* (nspan), on the sheet */
    double *flat;     /* (nflat x 2) the outline as chords, on the sheet */
    int32_t *flat_side; /* (nflat) side of the chord from point i */
    mus__loops cut;   /* cut line, on the sheet */
    double box[4];    /* of the cut line */
} mus__piece;

/* outline and cut line of a panel, its box with the low corner at (0, 0). `piece` is zeroed and freed by the caller */
mus_status mus__piece_make(mus_context *context, const mus_pattern *pattern, int32_t panel, double allowance,
                           mus__piece *piece);
void mus__piece_free(mus_context *context, mus__piece *piece);
void mus__piece_move(mus__piece *piece, double x, double y);
/* a point of the panel's plane on the sheet */
void mus__piece_point(const mus__piece *piece, const double *xy, double *out);
/* points between p[0..3] of a cubic: number of chords that stay within `tolerance` of it */
int32_t mus__cubic_chords(const double *p, double tolerance);
void mus__cubic_at(const double *p, double t, double *out);

/* ---- sheet, pages ---- */

typedef struct mus__tile {
    int32_t column; /* from the left */
    int32_t row;    /* from the top */
} mus__tile;

struct mus_sheet {
    mus_context *context;
    mus_sheet_def def; /* its texts point to the copies below */
    char *title;
    char *person;
    int32_t npiece;
    mus__piece *pieces; /* (npiece) in the order of the pattern */
    char (*names)[128]; /* (npiece) of the panels */
    double extent[2];
    bool tiled;         /* has a cover; else the test squares stand on the sheet */
    double squares[2];  /* where they stand when not tiled */
    bool squares_beside; /* side by side, or one above the other */
    double page[2];     /* width and height */
    int32_t columns, rows, ntile;
    mus__tile *tiles;   /* (ntile) in the order of the pages, empty ones left out */
    mus__drawing drawing; /* all pieces */
};

/* low corner for `n` boxes (size, n x 2) on a strip of the given width, the tallest first; the height used comes back.
 * work (n) int32_t, sky (2n + 2) x 3 doubles */
double mus__pack(int32_t n, const double *size, double width, double gap, double *at, int32_t *work, double *sky);

/* width and height of a paper held upright */
void mus__paper_size(int32_t paper, double *out);
/* refuse paper that its margins and overlap use up */
mus_status mus__paper_check(const mus_sheet *sheet);
/* place the pieces: sets extent, tiled, page, columns, rows, tiles */
mus_status mus__sheet_layout(mus_sheet *sheet);
/* page as the sheet sees it: low x, y, high x, y of what is printed (margins left out) */
void mus__tile_window(const mus_sheet *sheet, const mus__tile *tile, double *box);
int32_t mus__tile_find(const mus_sheet *sheet, int32_t column, int32_t row);
/* true when something of a segment lies in a box; when the inside or the cut line of a piece does */
bool mus__segment_meets(const double *a, const double *b, const double *box);
bool mus__piece_meets(const mus__piece *piece, const double *box);

/* ---- what stands on pages beside the pieces (page.c), in the page's own coordinates ---- */

/* 100 mm and 4 inch square, side by side or one above the other, low corner at (x, y) */
void mus__squares_size(bool beside, double *out);
void mus__squares_draw(mus__drawing *out, double x, double y, bool beside);
/* "B3" */
void mus__tile_name(const mus__tile *tile, char *out, size_t size);
/* frame, marks and names of a tile */
void mus__tile_draw(const mus_sheet *sheet, int32_t tile, mus__drawing *out);
/* the first page of a tiled sheet: title, test squares, page map. Refused when the margins leave too little for it */
mus_status mus__cover_check(const mus_sheet *sheet);
void mus__cover_size(const mus_sheet *sheet, double *out);
void mus__cover_draw(const mus_sheet *sheet, mus__drawing *out);

/* ---- what stands on a piece ---- */

/* cut and seam line, notches, grain line (its x, low y, high y to `grain`), marks */
void mus__marks_draw(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index,
                     double *grain);
/* the name of a mark and where it stands */
typedef struct mus__caption {
    const char *text;
    double x, y;
    mus__text_style style;
} mus__caption;

/* false when the mark is not on the piece */
bool mus__mark_caption(const mus_pattern *pattern, const mus__piece *piece, int32_t mark, mus__caption *out);
mus_status mus__label_draw(mus_sheet *sheet, const mus_pattern *pattern, int32_t index, const double *grain);

/* ---- bytes and files (paper_file.c) ---- */

typedef struct mus__bytes {
    mus_context *context;
    mus_status status; /* first failure */
    char *data;
    int32_t size, room;
} mus__bytes;

void mus__bytes_add(mus__bytes *bytes, const void *data, size_t size);
void mus__bytes_print(mus__bytes *bytes, const char *format, ...) MUS_PRINT_FORMAT(2, 3);
/* whole or not at all; "-" is standard output */
mus_status mus__bytes_save(const mus__bytes *bytes, const char *path);

#endif
