/*
 * piece.h: a panel as a piece of paper, turned so that its grain runs up, with its sew line and its cut line.
 */
#ifndef MUS__PRINT_PIECE_H
#define MUS__PRINT_PIECE_H

#include "drawing/stroke_font.h"

/* closed polygons: the outer one first (counter-clockwise), then holes (clockwise) */
typedef struct mus__loops {
    int32_t nloop, n;
    int32_t *start; /* (nloop + 1) */
    double *xy;     /* (n x 2) */
} mus__loops;

/* ---- a piece (piece_outline.c) ---- */

/* part of an edge of the pattern: a line or a cubic, in the direction of the outline */
typedef struct mus__span {
    double p[8]; /* four points [m]; a line uses the first and the last */
    bool line;
    int32_t side; /* index of the side that it is part of */
} mus__span;

/* a side of the piece: an edge of the pattern in the outline */
typedef struct mus__side {
    int32_t edge;
    int32_t direction; /* +1 along the edge, -1 against it; the outline runs counter-clockwise */
    double width;      /* allowance [m] */
} mus__side;

typedef struct mus__piece {
    int32_t panel;
    int32_t copies[MUS_MATERIAL_COUNT]; /* number of copies to cut of each material */
    bool mirrored;    /* half of the copies are cut turned over */
    bool fold;        /* the half of a symmetric piece, to be laid on the fold of the cloth */
    int32_t grain;    /* coordinate that the grain runs along: 1 upright, 0 level */
    int32_t across;   /* coordinate that the fold line of a half is at: 0 an upright line, 1 a level one */
    double axis;      /* that coordinate of the fold line [m] */
    double inward;    /* +1: the half lies right of its fold line, or above it; -1: left, or below */
    bool follower;    /* another size of the nest carries grain line, label and words */
    double turn[4];   /* matrix from the panel's plane to the sheet, row-major: grain upright */
    double shift[2];  /* [m] added after turn */
    int32_t nside, nspan, nflat;
    mus__side *sides; /* (nside) */
    mus__span *spans; /* (nspan), on the sheet */
    double *flat;     /* (nflat x 2) the outline as chords, on the sheet */
    int32_t *flat_side; /* (nflat) side of the chord from point i */
    mus__loops cut;   /* cut line, on the sheet */
    int32_t ndart;
    double *darts;    /* (ndart x 4 x 2) on the sheet: first end of the mouth, point, second end, end of the fold */
    double box[4];    /* low x, low y, high x, high y of the cut line [m] */
} mus__piece;

/* make a piece of a panel: outline and cut line, the low corner of its box at (0, 0). allowance [m] is that of edges
 * without their own; the caller zeroes `piece` before and frees it afterwards */
mus_status mus__piece_make(mus_context *context, const mus_pattern *pattern, int32_t panel, double allowance,
                           mus__piece *piece);
/* number of copies to cut of the main cloth; of a piece without any, of the first material that it is cut of */
int32_t mus__piece_copies(const mus__piece *piece);
/* write how a piece is cut: "Cut 2 mirrored", "Cut 1 on fold", "Cut 2 + 1 interfacing", "Cut 1 rib" */
void mus__piece_cut_text(const mus__piece *piece, int32_t language, char *out, size_t size);
void mus__piece_free(mus_context *context, mus__piece *piece);
void mus__piece_box(mus__piece *piece);
void mus__piece_move(mus__piece *piece, double x, double y);
/* mirror a piece left to right (x) and top to bottom (y) in lines through (0, 0); both are half a turn */
void mus__piece_flip(mus__piece *piece, bool x, bool y);
/* turn a piece by a quarter, counter-clockwise about (0, 0) */
void mus__piece_quarter(mus__piece *piece);
/* turn a box (low x, low y, high x, high y) by a quarter, counter-clockwise about (0, 0) */
void mus__box_quarter(const double *box, double *out);
/* map a point of the panel's plane to the sheet */
void mus__piece_point(const mus__piece *piece, const double *xy, double *out);
/* distance [m] of a point from the fold line of a half, negative on the side that is not printed */
double mus__piece_inward(const mus__piece *piece, const double *p);
/* true when the outline goes on straight from chord i to the next, with a turn of 15 degrees at most */
bool mus__piece_straight(const mus__piece *piece, int32_t i);
void mus__cubic_at(const double *p, double t, double *out);
/* number of equal chords that keep within `tolerance` [m] of a cubic (four points) */
int32_t mus__cubic_chords(const double *p, double tolerance);

/* turn a piece that is symmetric about the upright line through its middle into its right half, with the low corner of
 * its box at (0, 0) (piece_fold.c) */
mus_status mus__piece_fold(mus_context *context, const mus_pattern *pattern, mus__piece *piece);

/* ---- lines on a piece (piece_marks.c) ---- */

/* [m] distance of the bracket from the fold line of a half; chosen: its words fit between */
#define MUS__FOLD_BRACKET 0.012

/* draw cut line, sew line, notches, marks, and the grain line unless it follows; grain (4) gets the ends of the grain
 * line: x and y of the low one, then of the high one [m] */
void mus__marks_draw(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index,
                     double *grain);
/* draw the notches of a piece, each a path with its edge (piece_notches.c) */
void mus__notches_draw(mus__drawing *out, const mus_pattern *pattern, const mus__piece *piece, int32_t index);
/* [m] height of capitals in the name of a mark or an edge; chosen: the smallest that is read at arm's length */
#define MUS__CAPTION_HEIGHT 0.0025
/* [m] distance of words from lines that they would touch or cross; chosen: they are read */
#define MUS__WORDS_CLEAR 0.001
/* write what must be free round words of that height in their frame: low x, low y, high x, high y; they are twice
 * `half` wide, with the middle of their base line at its origin (sheet_tile.c) */
void mus__words_wall(double half, double *wall);
#define MUS__CAPTION 128 /* [bytes] of the name of a mark with its zero byte; longer ones are cut; chosen */

/* the name of a mark, with the left end of its base line and its direction */
typedef struct mus__caption {
    char text[MUS__CAPTION];
    double x, y;
    mus__text_style style;
} mus__caption;

/* compute the caption of a mark, clear of the lines of the piece where there is a place beside the mark; false when the
 * mark is not on the piece, or is a point on a line, whose caption names both: "buttonhole, button" */
bool mus__mark_caption(const mus_pattern *pattern, const mus__piece *piece, const struct mus__lettering *lettering,
                       int32_t language, int32_t mark, mus__caption *out);

#endif
