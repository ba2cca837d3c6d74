/*
 * piece.h: a panel as a piece of paper: turned to its grain, with its sew line and its cut line.
 */
#ifndef MUS__PRINT_PIECE_H
#define MUS__PRINT_PIECE_H

#include "print/drawing.h"

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

#endif
