/*
 * arrange_internal.h: the records of mus_arrange_pattern (arrange.c): panels as seen from outside, rings of panels side
 * by side, the limb that each ring goes round.
 *
 * Seen from its right side every outline runs counter-clockwise. (h, v) are coordinates of that view: v points up the
 * limb (on an arm towards the shoulder, else up as drawn). A ring has an axis, and an azimuth measured from its front
 * towards the right hand of a viewer who faces it. Each of its panels has a place u along the girth.
 */
#ifndef MUS_ARRANGE_ARRANGE_INTERNAL_H
#define MUS_ARRANGE_ARRANGE_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/body.h"
#include "muslin/pattern.h"

#define MUS__EDGE_UP 0.5 /* vertical component of the unit normal from which on an edge points up */
#define MUS__ARRANGE_DOTS                                                                                              \
    9 /* points on an edge at equal parts of its length; chosen: odd, so that one is the middle                        \
       */

/* what a ring goes round */
enum { MUS__ARRANGE_TRUNK, MUS__ARRANGE_NECK, MUS__ARRANGE_ARM };

/* sides of the wearer, as the pattern tells them of a panel; bits */
enum {
    MUS__ARRANGE_FRONT = MUS_SIDE_FRONT,
    MUS__ARRANGE_BACK = MUS_SIDE_BACK,
    MUS__ARRANGE_LEFT = MUS_SIDE_LEFT,
    MUS__ARRANGE_RIGHT = MUS_SIDE_RIGHT
};

typedef struct mus__arranged_panel {
    int32_t limb, says, ring; /* says: the sides it is on */
    int32_t nedge;
    const int32_t *edge, *direction; /* the outline, borrowed from the pattern */
    double sign;                     /* +1: drawn as seen from outside, -1: mirrored */
    double turn[2];                  /* cosine and sine of the rotation from (sign x, y) to (h, v) */
    int32_t turned;                  /* nonzero: the direction up is known */
    int32_t fan;                     /* nonzero: more than half a circle, so that its sides face each other */
    double low[2], high[2];          /* box in (h, v) [m] */
    double area;                     /* [m2] */
    double u, v;                     /* place of its (0, 0) in the ring: along the girth, up the axis [m] */

    /* where it starts: the point of (line, 0), the images of h and v, the outer normal; rolled about the line */
    double at[3], along[3], up[3], out[3];
    double line, bend; /* [m]; bend: radius, 0 for a flat panel */
} mus__arranged_panel;

typedef struct mus__arranged_edge {
    int32_t panel, seam;
    double length;                     /* [m] */
    double dot[2 * MUS__ARRANGE_DOTS]; /* as drawn; in (h, v) once the panel is turned [m] */
    double outward[2];                 /* unit normal out of the panel, in (h, v) */
} mus__arranged_edge;

typedef struct mus__arranged_seam {
    int32_t a, b;   /* edges */
    int32_t beside; /* +1: a's right side meets b's left; -1: a's left side meets b's right; 0: neither */
    double length;  /* mean of both edges [m] */
    double high;    /* mean height below the tops of its two panels, at most 0 [m] */
    double step[2]; /* mean of a's dots less b's, in (h, v) [m] */
} mus__arranged_seam;

typedef struct mus__arranged_ring {
    int32_t limb, component, panels;
    int32_t closed;                            /* nonzero: seams close it */
    int32_t set;                               /* nonzero: it has its place */
    int32_t hangs;                             /* nonzero: it lies on the shoulders */
    int32_t fork;                              /* nonzero: it goes round both legs and forks */
    int32_t fan;                               /* nonzero: it is one panel, a fan */
    int32_t layer;                             /* components that were placed before, inside this one */
    double girth;                              /* [m] once round */
    double wide;                               /* [m] widths of all panels side by side */
    double phase;                              /* [rad] azimuth of u = 0 */
    double shift;                              /* [m] added to v */
    double axis[3], up[3], front[3], right[3]; /* a point of the axis; frame */
    double radius, body;                       /* [m] of the ring; of the limb in it */
    int32_t halves;                            /* nonzero: it is placed as a front and a back that are nearly flat */
} mus__arranged_ring;

typedef struct mus__arrangement {
    mus_context *context;
    const mus_pattern *pattern;
    const mus_body *body;
    int32_t npanel, nedge, nseam, nring;
    mus__arranged_panel *panel;
    mus__arranged_edge *edge;
    mus__arranged_seam *seam;
    mus__arranged_ring *ring;
    int32_t *work;   /* (nseam + npanel) scratch of a union-find and of a list of panels */
    double level[5]; /* heights of the neck, the armpit, the waist, the hip, the crotch [m] */
    double off;      /* half the depth of a torso, with room [m] */
    double belly;    /* radius of the hips, with room [m] */
} mus__arrangement;

/* arrange_from_pattern.c: read panels, edges and seams of the pattern. Errors: MUS_ERR_PATTERN */
mus_status mus__arrange_read(mus__arrangement *arrangement);
/* number of the dot on b that a seam joins to dot i on a */
int32_t mus__arrange_partner(const mus__arrangement *arrangement, const mus__arranged_seam *seam, int32_t i);
/* where the point (h, v) of a panel starts, out (3) [m] */
void mus__arrange_point(const mus__arranged_panel *panel, double h, double v, double *out);
/* arrange_ring.c: put panels side by side into rings */
mus_status mus__arrange_rings(mus__arrangement *arrangement);
/* arrange_limb.c: put each ring round its limb. Errors: MUS_ERR_BODY */
mus_status mus__arrange_limbs(mus__arrangement *arrangement);
/* arrange_clear.c: move panels clear of the body along their outer normals */
mus_status mus__arrange_clear(mus__arrangement *arrangement);

#endif
