/*
 * found.h: the parts of placement found (found.c): panels as seen from outside, tubes of panels side by side, the limb
 * that each tube goes round.
 *
 * Seen from its right side every outline runs counter-clockwise. (h, v) is that view, v up the limb: towards the
 * shoulder on an arm, else up as drawn. A tube has an axis, an azimuth from its front (0) towards the right hand of who
 * looks at it from the front, and each of its panels a place u along the girth.
 */
#ifndef MUS_DRAPE_FOUND_H
#define MUS_DRAPE_FOUND_H

#include "base/base_internal.h"
#include "muslin/body.h"
#include "muslin/pattern.h"

#define FOUND_DOTS 9 /* places on an edge, at equal parts of its length */

/* what a tube goes round */
enum { FOUND_TRUNK, FOUND_NECK, FOUND_ARM, FOUND_SITES };

/* what a name or a label says of a panel, added up */
enum { FOUND_FRONT = 1, FOUND_BACK = 2, FOUND_LEFT = 4, FOUND_RIGHT = 8 };

typedef struct found_panel {
    int32_t site, says, tube;
    int32_t nedge;
    const int32_t *edge, *direction; /* the outline, borrowed */
    double sign;                     /* +1: drawn as seen from outside, -1: mirrored */
    double turn[2];                  /* cosine and sine from (sign x, y) to (h, v) */
    int32_t turned;                  /* nonzero: the way up is known */
    int32_t fan;                     /* nonzero: more than half a circle, whose sides face each other */
    double low[2], high[2];          /* box in (h, v) */
    double area;
    double u, v;                     /* its (0, 0) in the tube: along the girth, up the axis */

    /* where it starts: what (line, 0) is at, with the images of h and v and the outer normal; rolled about that line */
    double at[3], along[3], up[3], out[3];
    double line, bend;
} found_panel;

typedef struct found_edge {
    int32_t panel, seam;
    double length;
    double dot[2 * FOUND_DOTS]; /* as drawn; (h, v) once the panel is turned */
    double outward[2];          /* unit, in (h, v) */
} found_edge;

typedef struct found_seam {
    int32_t a, b;    /* edges */
    int32_t beside;  /* +1: a's right side meets b's left, -1: a's left side b's right, 0: one above the other, ... */
    double length;   /* mean of both */
    double high;     /* how far below the tops of its panels it lies, at most 0 */
    double step[2];  /* of (h, v): mean of a's dots less b's */
} found_seam;

typedef struct found_tube {
    int32_t site, piece, panels;
    int32_t ring;      /* nonzero: seams close it */
    int32_t set;       /* nonzero: it has its place */
    int32_t hangs;     /* nonzero: it lies on the shoulders */
    int32_t fork;      /* nonzero: it goes round two legs */
    int32_t fan;       /* nonzero: of one panel, a fan */
    int32_t layer;     /* pieces that came before lie inside */
    double girth;      /* once round */
    double wide;       /* widest: of all boxes side by side */
    double phase;      /* azimuth of u = 0 */
    double shift;      /* what is added to v */
    double axis[3], up[3], front[3], right[3]; /* a point of the axis; frame */
    double radius, body; /* of the tube; of what is in it */
    int32_t halves;    /* nonzero: a front and a back, each nearly flat, no ring */
} found_tube;

typedef struct mus__found {
    mus_context *context;
    const mus_pattern *pattern;
    const mus_body *body;
    int32_t npanel, nedge, nseam, ntube, pieces;
    found_panel *panel;
    found_edge *edge;
    found_seam *seam;
    found_tube *tube;
    int32_t *work;   /* (nseam + npanel) */
    double level[5]; /* heights of the neck, the armpit, the waist, the hip, the crotch */
    double off;      /* half the depth of a torso with room [m] */
    double belly;    /* radius of the hips with room */
} mus__found;

/* ---- found_read.c: what the pattern says ---- */

mus_status mus__found_read(mus__found *found);
/* place i of the partner of a seam's dot i */
int32_t mus__found_partner(const mus__found *found, const found_seam *seam, int32_t i);
/* where a place (h, v) of a panel starts */
void mus__found_place(const found_panel *panel, double h, double v, double *out);

/* ---- found_tube.c: panels side by side ---- */

mus_status mus__found_tubes(mus__found *found);

/* ---- found_site.c: tubes round limbs ---- */

mus_status mus__found_sites(mus__found *found);

/* ---- found_push.c: off the body, and off one another ---- */

mus_status mus__found_push(mus__found *found);

#endif
