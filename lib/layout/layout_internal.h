/*
 * layout_internal.h: outlines of a layout, the parts that are laid, and the layout itself.
 *
 * Flow of the data: panel or item -> outline (layout_outline.c), grown by half the gap and simplified (layout_grow.c)
 * -> parts: what lies where through how many layers (layout_parts.c) -> ways and places by lib/nest (layout_solve.c) ->
 * pieces on the cloth (layout.c).
 */
#ifndef MUS_LAYOUT_LAYOUT_INTERNAL_H
#define MUS_LAYOUT_LAYOUT_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/layout.h"
#include "nest/nest.h"

#define MUS__LAYOUT_MOST 2000 /* pieces; chosen: bounds the memory, 64 MB a run */
#define MUS__LAYOUT_ROUNDING                                                                                           \
    1e-9 /* [m] by which the strip is higher than the cloth: a piece as wide as the cloth fits */
#define MUS__LAYOUT_TOLERANCE 2.5e-4 /* [m] of leaving points out of a grown outline (layout_grow.c) */

typedef struct mus__layout_polygon {
    int32_t n;
    double *xy; /* (n x 2) */
} mus__layout_polygon;

/* a panel or an item in the frame of the cloth: grain along x, right side up */
typedef struct mus__layout_outline {
    int32_t panel;
    char name[128];
    double turn[4];                 /* from its own plane to that frame, */
    double axis;                    /* [m] and then down by this, so that its middle is on y = 0 */
    double area;                    /* [m2] */
    int32_t count;                  /* how many are needed */
    bool mirrored;                  /* half of them turned over */
    bool symmetric;                 /* its own mirror image in y = 0 */
    bool across;                    /* its own mirror image in a line across the grain */
    int32_t turn_count;             /* of an item: angles of its own; 0: those of the cloth */
    double *turns;                  /* (turn_count) [rad] */
    mus__layout_polygon cut;        /* counter-clockwise */
    mus__layout_polygon grown;      /* holds all that is nearer to `cut` than the margin */
    mus__layout_polygon half;       /* of a symmetric one: the part of `cut` with y above 0 */
    mus__layout_polygon grown_half; /* the part of `grown` with y above less the margin */
} mus__layout_outline;

/* how a part may lie */
typedef enum mus__layout_lie {
    MUS__LIE_PLAIN,    /* right side up */
    MUS__LIE_MIRRORED, /* turned over */
    MUS__LIE_EITHER,   /* two layers: one of each */
    MUS__LIE_HALF      /* on the fold */
} mus__layout_lie;

typedef struct mus__layout_part {
    int32_t outline;
    mus__layout_lie lie;
    bool folded; /* on the folded part of the cloth */
    bool spare;
    /* found by the search: from the outline's frame to the cloth */
    double turn[4], shift[2];
} mus__layout_part;

struct mus_layout {
    mus_context *context;
    mus_layout_def def;
    double margin; /* by which outlines are grown [m] */
    int32_t noutline;
    mus__layout_outline *outlines; /* (noutline) */
    int32_t npart;
    mus__layout_part *parts;   /* (npart) */
    mus__layout_polygon *laid; /* (npart) cut lines on the cloth */
    double folded, length;
    int64_t steps;
};

/* polygons (layout_grow.c) */
void mus__layout_polygon_free(mus_context *context, mus__layout_polygon *polygon);
/* make room for n points; what they hold is not set */
mus_status mus__layout_polygon_make(mus_context *context, int32_t n, mus__layout_polygon *polygon);
void mus__layout_outline_free(mus_context *context, mus__layout_outline *outline);
/* make the outlines of the layout's material (layout_outline.c) */
mus_status mus__layout_outlines(mus_layout *layout, const mus_pattern *pattern);
/* grow an outline by the layout's margin, and make its halves (layout_grow.c) */
mus_status mus__layout_outline_grow(const mus_layout *layout, mus__layout_outline *outline);
/* list the parts of the layout: single pieces from opened cloth, or, `doubled`, through both layers (layout_parts.c).
 * singles, unless NULL, gets how many pieces that choice is about */
mus_status mus__layout_parts(mus_layout *layout, bool doubled, int32_t *singles);
/* find the places of all parts: sets turn and shift of each, folded and length. The share of this search in the whole,
 * for progress: from `start`, `share` (layout_solve.c) */
mus_status mus__layout_solve(mus_layout *layout, double start, double share);

#endif
