/*
 * worn_internal.h: what the files of the certificate mus_fit_worn() share: boundary loops of the sewn cloth, axes of
 * the limbs, linking numbers, and the openings that the pattern has for the limbs.
 *
 * A boundary loop (Hatcher, Algebraic Topology, 2002, section 3.3) is an open boundary of the cloth once all its seam
 * pairs are one. The body is a star: five axes from the middle of the chest through neck, arms and legs to far outside.
 * The linking number of a loop with an axis is the number of times, with sign, that the axis passes a disc that the
 * loop bounds. Another disc changes the five numbers of a loop by one common integer alone. A garment that is worn
 * right side out has 0 and 1 there, with the right common integers, and each axis 1 at one loop: the opening of that
 * limb.
 */
#ifndef MUS_FIT_WORN_INTERNAL_H
#define MUS_FIT_WORN_INTERNAL_H

#include "drape/drape_state.h"
#include "fit/worn_hood.h"
#include "muslin/fit.h"

/* points of an axis at most: the chest, and the contours of the trunk and of the limb, 128 each (mus_limb) */
#define MUS__WORN_POINTS 257
#define MUS__WORN_WAYS 3    /* ways on which an axis goes far outside from the end of its limb */

typedef struct mus__worn_loop {
    int32_t first, count; /* nodes in mus__worn_loops.node, in order round the loop, right side of the cloth on the left
                             hand */
    int32_t component;    /* of the cloth: its lowest panel */
    int32_t expect;       /* axes that the pattern has for it, a sum of 1 << MUS_WORN_*; 0: none */
    int32_t judged;       /* limbs that any loop of its component is for: a limb that the pattern leaves open is not */
    int32_t sign;         /* -1: its panels have the other side out than most of the garment (a collar that turns) */
    int32_t over;         /* nonzero: the pattern puts it before the face and cloth over the crown: a hood */
    double length;        /* in the flat [m] */
} mus__worn_loop;

typedef struct mus__worn_loops {
    mus_context *context;
    int32_t nloop, nclass;
    int32_t *node;     /* (border edges) start of each border edge, loop by loop */
    int32_t *class_of; /* (nnode) the smallest node of those that seams join */
    mus__worn_loop *loop;
} mus__worn_loops;

typedef struct mus__worn_axes {
    int32_t count[MUS_WORN_LIMBS]; /* points inside the body; 0: the body lacks the limb */
    int32_t limb[MUS_WORN_LIMBS];  /* of the body; of the neck the trunk */
    int32_t own[MUS_WORN_LIMBS];   /* the first of them that is the limb's own, not the trunk's */
    double point[MUS_WORN_LIMBS][MUS__WORN_POINTS][3];
    double far[MUS_WORN_LIMBS][MUS__WORN_WAYS][3]; /* where the axis ends, 20 m outside, on each way */
    int32_t leave[MUS_WORN_LIMBS][MUS__WORN_WAYS]; /* the point from which it goes there */
    double shoulders[3];             /* half way between the joints [m] */
    double up[3], front[3], left[3]; /* unit directions of the trunk; left is square to the others */
} mus__worn_axes;

/* worn_loops.c: the boundary loops of a cloth with all seams sewn. Errors: MUS_ERR_MEMORY; free it always */
mus_status mus__worn_loops_make(mus_context *context, const mus_cloth *cloth, mus__worn_loops *out);
void mus__worn_loops_free(mus__worn_loops *loops);

/* worn_axes.c: the axes of a body where it stands; false for a body without trunk or landmarks */
bool mus__worn_axes_make(const mus_body *body, mus__worn_axes *out);
/* linking numbers of a loop at places x (nnode x 3) with the axes, on each way; 0 for limbs that the body lacks. All
 * have one common integer that no one knows */
void mus__worn_link(const mus__worn_axes *axes, const mus__worn_loops *loops, int32_t loop, const double *x,
                    int32_t out[MUS_WORN_LIMBS][MUS__WORN_WAYS]);
/* distance of a place (3) from an axis, from the limb's own first point to its end [m]; infinite without the limb */
double mus__worn_distance(const mus__worn_axes *axes, int32_t axis, const double *place);

/* worn_hood.c: the head of a body with these axes */
void mus__worn_head(const mus_body *body, const mus__worn_axes *axes, mus__head *out);

/* worn_openings.c: which axes the pattern has for each loop: loop.expect, sign, over. `placed` (nnode x 3): where the
 * panels start. Errors: MUS_ERR_MEMORY */
mus_status mus__worn_expect(const mus_pattern *pattern, const mus_cloth *cloth, const mus__worn_axes *axes,
                            const double *placed, mus__worn_loops *loops);

/* then sets `over` of loops that are before the face as the cloth lies at x (nnode x 3): hoods whose placement does not
 * tell it */
void mus__worn_over(const mus__worn_axes *axes, const double *x, mus__worn_loops *loops);

/* the limbs (a sum of 1 << MUS_WORN_*) whose linking numbers, times `sign`, on one of the ways are what the pattern has
 * for a loop, with the common integer that makes them the most: *common */
int32_t mus__worn_agree(const mus__worn_axes *axes, const mus__worn_loop *loop, int32_t sign,
                        int32_t link[MUS_WORN_LIMBS][MUS__WORN_WAYS], int32_t *common);

/* what the checks of one call read */
typedef struct mus__worn_call {
    const mus_drape *drape;
    const mus_pattern *pattern;
    const mus_body *body;
    const double *x, *placed; /* (nnode x 3) now, and as the pattern places it [m] */
    mus__worn_axes axes;
    mus__worn_loops loops;
    mus_worn *out;
} mus__worn_call;

/* worn_note.c: note why the garment is not worn, at a loop (MUS_NONE: at a node); the first note holds */
void mus__worn_note(const mus__worn_call *call, int32_t kind, int32_t limb, int32_t loop, int32_t node, double value,
                    const char *text);

/* worn_girth.c: a tape round a contour of a limb [m], 0 where there is none; centre (3): the mean of its points */
double mus__worn_contour(const mus_body *body, int32_t limb, int32_t contour, double *centre);
/* openings that are too small for their limb where they start; before anything is sewn */
void mus__worn_girths(const mus__worn_call *call);
/* worn_level.c: heights and shoulders */
void mus__worn_levels(const mus__worn_call *call);
/* worn_through.c: a limb whose axis, as far as it lies in the body, meets a triangle of the cloth: that limb is through
 * the cloth, not a mere fold of the cloth in the skin */
void mus__worn_pierced(const mus__worn_call *call);
/* cloth through the skin: through and its fellows in out. Errors: MUS_ERR_MEMORY */
mus_status mus__worn_through(const mus__worn_call *call);

#endif
