/*
 * outline_pack.h: pack outlines on a strip of paper (outline_pack.c).
 */
#ifndef MUS_PRINT_OUTLINE_PACK_H
#define MUS_PRINT_OUTLINE_PACK_H

#include "print/piece.h"

/* an outline grown by half the gap all round, as spans in upright slabs, measured down from its top */
typedef struct mus__shape {
    double slab;    /* width of a slab [m] */
    double width;   /* of the outline [m] */
    double height;  /* of the grown outline [m] */
    bool turns, flips; /* may be turned by half a turn; may be mirrored */
    int32_t first;     /* of the eight ways round, the one that is tried first */
    const struct mus__shape *lying; /* the outline turned by a quarter, which it may lie as too, or NULL */
    int32_t nslab, nspan, room;
    int32_t *start; /* (nslab + 1) first span of each slab */
    double *spans;  /* (nspan x 2) low and high [m] */
} mus__shape;

/* where an outline lies: the upper left corner of its box */
typedef struct mus__place {
    int32_t slab;  /* first slab on the strip */
    bool quarter;  /* turned by a quarter, before it is mirrored */
    bool flip[2];  /* mirrored left to right, top to bottom; both: turned by half a turn */
    double x, y;   /* [m] from the left and from the top of the strip */
} mus__place;

/* the pages that a strip is printed on */
typedef struct mus__pages {
    double step[2];        /* width and height that each adds [m] */
    double border;         /* of the first page, above and left of the strip [m] */
    int32_t columns, rows; /* rows: those that are counted */
    int32_t stamp;
    int32_t *seen; /* (rows x columns) stamp of the place that was counted last; -1: taken; the caller zeroes it */
} mus__pages;

/* a strip while it is filled; the spans of each slab are a list */
typedef struct mus__strip {
    double slab; /* width of a slab [m] */
    int32_t room, nspan;
    int32_t *first; /* (room) first span of each slab, or MUS_NONE */
    int32_t *next;  /* (nspan) next span of the slab */
    double *spans;  /* (nspan x 2) low and high [m] */
    mus__pages *pages; /* shapes are put where they take fewest of these anew; NULL (made so): nearest to the top */
} mus__strip;

/* make the shape of `nloops` outlines that lie on each other in the box (low x, low y, high x, high y [m]), in slabs of
 * `slab` [m]; `gap` [m] is the least distance of two shapes. Freed by the caller, also after a failure */
mus_status mus__shape_make(mus_context *context, int32_t nloops, const mus__loops *const *loops, const double *box,
                           double gap, double slab, mus__shape *shape);
/* the same of the outlines turned by a quarter, of copies */
mus_status mus__shape_make_lying(mus_context *context, int32_t nloops, const mus__loops *const *loops,
                                 const double *box, double gap, double slab, mus__shape *shape);
void mus__shape_free(mus_context *context, mus__shape *shape);
/* width of a shape as it lies narrower [m] */
double mus__shape_narrow(const mus__shape *shape);

/* make a strip for n shapes of one width of slabs that is at most `widest` [m] wide. Freed by the caller, also after a
 * failure */
mus_status mus__strip_make(mus_context *context, int32_t n, const mus__shape *shapes, double widest, mus__strip *strip);
void mus__strip_free(mus_context *context, mus__strip *strip);

/* pack n shapes in the order given on a strip of `width` [m]: places (n) gets where each lies. Returns the height used
 * [m], or -1 when a shape is too wide */
double mus__strip_pack(mus__strip *strip, int32_t n, const mus__shape *shapes, const int32_t *order, double width,
                       double gap, mus__place *places);

#endif
