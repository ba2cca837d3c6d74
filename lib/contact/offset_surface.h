/*
 * offset_surface.h: the surface at a distance off the skin on which cloth rests, as radius fields of the parts of a
 * body.
 *
 * The body names the surface that was made of it last, so that all its colliders share it, those of its posed copies
 * too: a surface knows nothing of where the parts are. It is destroyed with the last collider that uses it. To make one
 * takes about half of the time of a drape's creation (T-shirt at 30 mm).
 */
#ifndef MUS_CONTACT_OFFSET_SURFACE_H
#define MUS_CONTACT_OFFSET_SURFACE_H

#include "contact/contact_template.h"

#define MUS__ENDS 6 /* free ends of a hand: of the limb itself and of five fingers */

/* a part as it was made, in the body frame */
typedef struct mus__offset_part {
    double origin[3], axis[3], side[3], front[3];
    double end[2], reach;          /* extent of the skin along the axis, and across it [m] */
    double safe;                   /* a node that moves no further in a step cannot pass through this part [m] */
    bool foot;                     /* of a body made from a tape */
    bool digits;                   /* its field is widened over fingers or toes (digit_cover.c) */
    double stump;                  /* of a leg above a foot: how far it goes on below its first ring while garments are
                                    * put on [m]; 0: of other parts */
    int32_t ends;                  /* free ends of a hand: its own and those of its fingers; 0: it has none */
    double end_axis[MUS__ENDS][6]; /* from root to tip: s from the first ring, a, b of both [m] */
} mus__offset_part;

typedef struct mus__offset_surface {
    mus_context *context;
    int32_t users;               /* colliders that use it */
    struct mus__body_kept *kept; /* the body that names it; NULL: none */
    int32_t nparts;
    double offset;           /* distance off the skin [m] */
    mus__field_f64 *field64; /* (nparts) fields without a place: origin and directions are not set */
    mus__field_f32 *field32; /* (nparts) the same rounded */
    mus__field_f64 *slim64;  /* (nparts) the same as garments are put on: without fingers and toes, and with stumps */
    mus__field_f32 *slim32;  /* (nparts) */
    mus__offset_part *part;  /* (nparts) */
    double *table64;         /* centres, radii and maxima of all fields */
    float *table32;
} mus__offset_surface;

/* the surface `offset` [m] off the skin of a body: the one that the body names, or a new one. The caller is one of its
 * users */
mus_status mus__offset_surface_take(mus_context *context, const mus_body *body, double offset,
                                    mus__offset_surface **out);
/* one user less; the last one destroys it. NULL is accepted */
void mus__offset_surface_leave(mus__offset_surface *surface);

/* the point (x, y) of the diamond angle 4 j / n, with |x| + |y| = 1, and its distance from the axis */
static inline double mus__diamond_point(int32_t j, int32_t n, double *x, double *y)
{
    const double q = 4.0 * j / n, b = q - floor(q), a = (int32_t)q % 2 == 0 ? 1.0 - b : b;
    *x = q < 1.0 || q >= 3.0 ? a : -a;
    *y = q < 2.0 ? 1.0 - a : a - 1.0;
    return sqrt(a * a + (1.0 - a) * (1.0 - a));
}

/* digit_cover.c: widens *field, a copy of that of a part, over its fingers or toes, if it has any: its radii are put
 * into `radius` (nring x nangle) then. *to: whether it is a foot, and its free ends. Errors: MUS_ERR_MEMORY */
mus_status mus__digit_cover(const mus_body *body, int32_t part, double *radius, mus__field *field,
                            mus__offset_part *to);

#endif
