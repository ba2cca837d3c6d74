/*
 * relax.h: relaxation: steps of symplectic Euler with scaled inertia, and what is known of the rest of a drape.
 *
 * Files: relax.c (memory and the loop that sew, settle and untangle share), residual.c (the force left at each node),
 * settle.c (to rest), untangle.c (crossings drawn apart), slid_off.c (whether a component has left its place).
 */
#ifndef MUS_DRAPE_RELAX_H
#define MUS_DRAPE_RELAX_H

#include "drape/progress.h"

/* a component of the garment: panels that hang together by seams. One record a panel; that of the lowest panel counts
 */
typedef struct mus__component {
    int32_t root;     /* lowest panel of the component */
    int32_t panel;    /* panel of its uppermost node at the start */
    double top;       /* height of that node along the torso [m]; -infinity: held up by attachments */
    double foot;      /* height of its lowest node as the pattern places it [m] */
    double high, low; /* heights of its uppermost and lowest node, as of the last look [m] */
} mus__component;

typedef struct mus__relaxation {
    double *mean; /* (n x 3) mean place of the last steps; head of a block of four arrays, NULL before the first use */
    double *before;            /* (n x 3) mean place at the check before */
    double *left;              /* (n x 3) force left at the check before [N] */
    double *anchor;            /* (n x 3) mean place where the cloth began to lie still */
    double *force;             /* (n x 3) force left at each node by the last residual [N] */
    mus__component *component; /* (npanel), NULL before the first settle round a body */
    double residual; /* rms of force left over weight at the end of the last settle; NaN: the cloth was moved since */
    double rest_distance; /* how far the farthest node is still expected to go, as of the last check [m] */
    int32_t settled;      /* nonzero: the last settle came to rest */
    int32_t far;          /* nonzero: not near rest, so that a settle begins on the coarse cut */
} mus__relaxation;

/* memory of mean, before, left and anchor, kept until the drape is destroyed; give it back */
mus_status mus__relax_create(mus_drape *drape);
void mus__relax_clear(mus_drape *drape);

/* rms over free nodes of the force that contact and friction leave at places x (n x 3), over the node's weight; the
 * forces go to relax.force. *unheld (may be NULL) gets the rms over the nodes that touch nothing */
double mus__residual(const mus_drape *drape, const double *x, double *unheld);

/* let the sewn layers fall on this cut until they nearly rest (settle.c) */
mus_status mus__settle_let_down(mus_drape *drape, mus__progress *run);

/* with self-contact: draw crossings apart as far as they go (untangle.c). Errors: as mus_drape_untangle, but crossings
 * that are left are none */
mus_status mus__untangle(mus_drape *drape);
/* put pairs of cloth apart that are closer than a twentieth of the thickness, where nothing crosses by it */
mus_status mus__untangle_part(mus_drape *drape);

/* note where the components hang at x (n x 3): before a settle. Errors: MUS_ERR_MEMORY */
mus_status mus__slid_off_start(mus_drape *drape, const double *x);
/* nonzero, with the reason written, when a component at x has left its place; `loose`: and when no node is near the
 * body */
int32_t mus__slid_off(mus_drape *drape, const double *x, int32_t loose);

#endif
