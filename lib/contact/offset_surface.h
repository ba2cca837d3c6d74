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

/* a part as it was made, in the body frame */
typedef struct mus__offset_part {
    double origin[3], axis[3], side[3], front[3];
    double end[2], reach; /* extent of the skin along the axis, and across it [m] */
    double safe;          /* a node that moves no further in a step cannot pass through this part [m] */
} mus__offset_part;

typedef struct mus__offset_surface {
    mus_context *context;
    int32_t users;               /* colliders that use it */
    struct mus__body_kept *kept; /* the body that names it; NULL: none */
    int32_t nparts;
    double offset;           /* distance off the skin [m] */
    mus__field_f64 *field64; /* (nparts) fields without a place: origin and directions are not set */
    mus__field_f32 *field32; /* (nparts) the same rounded */
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

#endif
