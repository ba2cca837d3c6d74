/*
 * body_outline.c: reads contours that are given as polygons: sections of a scan, traced forms.
 *
 * An outline is a closed polygon round the contour's centre. It must be star-shaped: seen from the centre, the angles
 * of its corners ascend once round, so that each direction meets one side. Corners are stored with their angles, from
 * -pi on; lib/limb/contour.c computes the radius in a direction from them when a body is made. Contact reads the radius
 * fields only.
 */
#include <math.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"

#define OUTLINE_CORNERS 1024 /* most corners of an outline */
#define OUTLINE_LEAST 1e-4   /* least distance of a corner from the centre [m]; chosen */


static double outline_cross(const double *p, const double *q)
{
    return p[0] * q[1] - p[1] * q[0];
}


/* read the corners of contour i of limb l into `corner` (corners x 3), from the least angle on */
static mus_status outline_read(mus_context *context, int32_t l, int32_t i, const mus_limb *from, mus__contour *to,
                               double *corner)
{
    const int32_t n = from->corners;
    const double *xy = from->outline + 2 * (ptrdiff_t)i * n;
    int32_t first = 0;
    double least = INFINITY;
    for (int32_t k = 0; k < n; k++) {
        const double a = xy[2 * k] - to->ca, b = xy[2 * k + 1] - to->cb, radius = sqrt(a * a + b * b);
        if (!(radius >= OUTLINE_LEAST && radius <= 100.0))
            return mus__fail(context, MUS_ERR_ARG,
                             "limb %d: corner %d of contour %d is %g m off its centre, expected %g to 100", (int)l,
                             (int)k, (int)i, radius, OUTLINE_LEAST);
        if (mus__atan2(b, a) < least) least = mus__atan2(b, a), first = k;
    }

    to->corners = n, to->corner = corner;
    to->a = to->b = 0.0, to->n = 2.0;
    for (int32_t k = 0; k < n; k++) {
        const double *at = xy + 2 * (ptrdiff_t)((first + k) % n);
        corner[3 * k + 1] = at[0] - to->ca, corner[3 * k + 2] = at[1] - to->cb;
        corner[3 * k] = mus__atan2(corner[3 * k + 2], corner[3 * k + 1]);
        to->a = fmax(to->a, fabs(corner[3 * k + 1])), to->b = fmax(to->b, fabs(corner[3 * k + 2]));
    }

    /* star-shaped: each side turns counter-clockwise about the centre, and the angles ascend up to the last corner */
    for (int32_t k = 0; k < n; k++) {
        const double *p = corner + 3 * (ptrdiff_t)k, *q = corner + 3 * (ptrdiff_t)((k + 1) % n);
        if (outline_cross(p + 1, q + 1) > 0.0 && (k + 1 == n || q[0] > p[0])) continue;
        return mus__fail(context, MUS_ERR_BODY,
                         "limb %d (%s): contour %d at s = %g m is not star-shaped about its centre: its outline turns "
                         "back at %.1f degrees",
                         (int)l, from->name != NULL ? from->name : "limb", (int)i, to->s, p[0] * 180.0 / MUS_PI);
    }
    return MUS_OK;
}


mus_status mus__body_outlines(mus_body *body, int32_t first, int32_t limbs, const mus_limb *limb)
{
    int64_t total = 0;
    for (int32_t l = 0; l < limbs; l++) {
        if (limb[l].corners == 0) continue;
        if (limb[l].corners < 3 || limb[l].corners > OUTLINE_CORNERS || limb[l].outline == NULL)
            return mus__fail(body->context, MUS_ERR_ARG,
                             "limb %d: %d corners of an outline, expected 3 to %d and theirs", (int)l,
                             (int)limb[l].corners, OUTLINE_CORNERS);
        total += 3 * (int64_t)limb[l].contours * limb[l].corners;
    }
    if (total == 0) return MUS_OK;
    body->outline = mus__new(body->context, total, sizeof *body->outline);
    if (body->outline == NULL) return mus__fail_memory(body->context, "the outlines of a body");

    double *corner = body->outline;
    for (int32_t l = 0; l < limbs; l++)
        for (int32_t i = 0; i < limb[l].contours && limb[l].corners > 0; i++) {
            mus_status status = outline_read(body->context, l, i, &limb[l], &body->limb[first + l].contour[i], corner);
            if (status != MUS_OK) return status;
            corner += 3 * (ptrdiff_t)limb[l].corners;
        }
    return MUS_OK;
}
