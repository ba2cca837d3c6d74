/*
 * sheet.h: a sheet: all pieces, their places on paper, the pages.
 *
 * Flow of the data: pattern -> pieces (piece_outline.c, piece_fold.c) -> places on the sheet (outline_pack.c,
 * sheet_layout.c) -> one drawing of the whole sheet (piece_marks.c, piece_notches.c, piece_label.c,
 * stroke_font.c) -> pages (page.c) -> bytes (pdf.c, svg.c, dxf.c, plt.c) -> file (lib/file).
 */
#ifndef MUS_PRINT_SHEET_H
#define MUS_PRINT_SHEET_H

#include "print/piece.h"

#define MUS__SIZES_MOST 64 /* sizes of a sheet; chosen: twice the longest size list of a shop */
#define MUS__SIZE_NAME 32  /* [bytes] of the name of a size with its zero byte */
#define MUS__RUN 16        /* sides of a cut line in a run, and runs in a group; chosen: changes the time alone */

typedef struct mus__tile {
    int32_t column; /* from the left */
    int32_t row;    /* from the top */
} mus__tile;

struct mus_sheet {
    mus_context *context;
    mus_sheet_def def; /* options; its texts point to the copies below */
    int32_t language;
    struct mus__lettering *lettering; /* fonts for what is not drawn in strokes, or NULL */
    char *title;
    char *person;
    char *notes;        /* lines of the cover that the caller gave, or NULL */
    int32_t nsize;      /* sizes of the pattern that lie on each other */
    char (*sizes)[MUS__SIZE_NAME]; /* (nsize) their names */
    int32_t npiece;     /* pieces of all sizes */
    mus__piece *pieces; /* (npiece) in the order of the pattern, the sizes of a piece (a nest) together */
    char (*names)[128]; /* (npiece) names of the panels */
    char (*labels)[128]; /* (npiece) labels of the panels */
    char (*marks)[128]; /* (marks of the pattern) names of the marks */
    bool buttonholes;   /* a mark is the line of a buttonhole, with the button of the other layer on it */
    double extent[2];
    bool tiled;         /* several pages that are joined */
    bool cover;         /* the first page has title, squares and instructions; else they stand on the sheet */
    bool full;          /* the legend has notes and the list of pieces too */
    bool packed;        /* the test squares were packed as a piece */
    double squares[2];  /* low corner of the test squares [m], without a cover */
    double legend[4];   /* low x, low y, high x, high y of title and instructions [m], tiled without a cover */
    double page[2];     /* width and height of a page [m] */
    int32_t columns, rows, ntile;
    mus__tile *tiles; /* (ntile) in the order of the pages, without the empty ones; that of the legend is the first */
    mus__drawing drawing; /* lines of all pieces */
};

/* place the pieces on pages: sets extent, tiled, page, columns, rows, tiles */
mus_status mus__sheet_layout(mus_sheet *sheet);
/* window of a tile: low x, low y, high x, high y of the part of the sheet that it prints, without margins [m] */
void mus__tile_window(const mus_sheet *sheet, const mus__tile *tile, double *box);
/* write the name of a piece in words; of a mirrored one without its side, except in English */
void mus__sheet_piece_words(const mus_sheet *sheet, int32_t index, char *out, size_t size);
/* write the names of the sizes, as "Sizes W36, W38" */
void mus__sheet_sizes(const mus_sheet *sheet, char *out, size_t size);
/* begin a drawing of the sheet: with its language and letters */
void mus__sheet_draw_init(const mus_sheet *sheet, mus__drawing *drawing);
/* true when a box of the sheet lies on the name of the page with this window, or on the marks of its neighbours */
bool mus__tile_marked(const double *window, const double *box);
/* true when one page shows the whole box, `plain`: clear of its name and of the marks of its neighbours */
bool mus__page_holds(const mus_sheet *sheet, const double *box, bool plain);
/* true when every corner of the box, and its middle, is on a page: one in the middle of a piece may be left out */
bool mus__pages_show(const mus_sheet *sheet, const double *box);
int32_t mus__tile_find(const mus_sheet *sheet, int32_t column, int32_t row);
/* true when a part of the segment (mus__piece_meets: of the inside or the cut line of the piece) lies in the box; at
 * (2), unless NULL, gets a point where it does */
bool mus__segment_meets(const double *a, const double *b, const double *box);
/* a frame on the sheet: its origin [m], and the unit vector of its first coordinate */
typedef struct mus__frame {
    double x, y, u[2];
} mus__frame;

/* true when a part of the segment of the sheet lies in the box, which is given in the frame */
bool mus__frame_meets(const mus__frame *frame, const double *a, const double *b, const double *box);
/* true when a line of the path passes through the box, given in the frame, or on the sheet with NULL; cubics are read
 * as eight chords */
bool mus__path_meets(const mus__drawing *drawing, const mus__path *path, const mus__frame *frame, const double *box);
bool mus__piece_meets(const mus__piece *piece, const double *runs, const double *box, double *at);
/* true when the point lies inside the sew line of the piece; when the whole box does */
bool mus__piece_inside(const mus__piece *piece, double x, double y);
bool mus__piece_holds(const mus__piece *piece, const double *box);
/* write the boxes of each MUS__RUN sides of the cut line, those of a group after the box of the group, to `runs`
 * (n x 4), which spare mus__piece_meets most sides; both take NULL. Returns n */
int32_t mus__piece_runs(const mus__piece *piece, double *runs);

/* draw the label of a piece: name, copies, person and scale, at a place where it fits (piece_label.c) */
mus_status mus__label_draw(mus_sheet *sheet, const mus_pattern *pattern, int32_t index, const double *grain);
/* write (MUS__PLAIN) what a side is called: by its label, or by its name where the label is that of sides with another
 * allowance (piece_label.c) */
void mus__side_words(const mus_pattern *pattern, const mus__piece *piece, int32_t side, char *out);
/* write the words of the edges of a piece, clear of all that is drawn (edge_words.c) */
void mus__edge_words_draw(mus_sheet *sheet, const mus_pattern *pattern, int32_t index);

#endif
