/*
 * offset_surface.h: the surface at a distance off the skin on which cloth rests, as radius fields of the parts of a
 * body.
 *
 * Made once a body and distance, kept with the body, and shared by all colliders of it, those of posed copies of the
 * body too: it knows nothing of where the parts are. To make one costs a few milliseconds, half of a drape's creation.
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
    int32_t users; /* colliders and bodies that hold it */
    int32_t nparts;
    double offset;           /* distance off the skin [m] */
    mus__field_f64 *field64; /* (nparts) fields without a place: origin and directions are not set */
    mus__field_f32 *field32; /* (nparts) the same rounded */
    mus__offset_part *part;  /* (nparts) */
    double *table64;         /* centres, radii and maxima of all fields */
    float *table32;
} mus__offset_surface;

/* the surface `offset` [m] off the skin of a body: that kept with it, or a new one. The caller is one of its users */
mus_status mus__offset_surface_take(mus_context *context, const mus_body *body, double offset,
                                    mus__offset_surface **out);
/* one user less; the last one destroys it. NULL is accepted */
void mus__offset_surface_leave(mus__offset_surface *surface);

#endif
