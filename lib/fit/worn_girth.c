/*
 * worn_girth.c: openings that are too small for the limb at which they start, told before anything is sewn.
 *
 * An opening of one arm, of one leg or of the trunk starts at a contour of that limb. Once it is sewn it may slip along
 * the limb to a thinner place, but not far: the thinnest contour within GIRTH_REACH of the first one counts, of an arm
 * or leg none beyond its wrist or ankle. An opening that would have to be drawn there to more than GIRTH_TIGHT beyond
 * its length, all round, does not come on.
 */
#include <math.h>
#include <stdio.h>

#include "fit/worn_internal.h"
#include "geom/vec.h"

/* [part] mean strain of an opening: no fabric of muslin_fabric(5) is measured beyond it */
#define GIRTH_TIGHT 0.5
#define GIRTH_REACH 0.1 /* [m] along the limb; chosen: a sleeve that is pushed up that far is not worn as it is drawn */
#define GIRTH_DOTS 64   /* points of a contour */
#define GIRTH_ARMS (1 << MUS_WORN_ARM_LEFT | 1 << MUS_WORN_ARM_RIGHT)
#define GIRTH_LEGS (1 << MUS_WORN_LEG_LEFT | 1 << MUS_WORN_LEG_RIGHT)


double mus__worn_contour(const mus_body *body, int32_t limb, int32_t contour, double *centre)
{
    double dot[3 * GIRTH_DOTS], girth = 0.0;
    for (int32_t d = 0; d < 3; d++) centre[d] = 0.0;
    if (mus_body_contour_points(body, limb, contour, GIRTH_DOTS, dot) != MUS_OK) return 0.0;
    for (int32_t i = 0; i < GIRTH_DOTS; i++) {
        const double *a = dot + 3 * (ptrdiff_t)i, *b = dot + 3 * (ptrdiff_t)((i + 1) % GIRTH_DOTS);
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        girth += mus__norm3(d);
        for (int32_t k = 0; k < 3; k++) centre[k] += a[k] / GIRTH_DOTS;
    }
    return girth;
}


static double girth_apart(const double *a, const double *b)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return mus__norm3(d);
}


/* least girth [m] of a limb of the body within GIRTH_REACH of its contour nearest to `place` (3), no farther than `far`
 * [m] from `chest` (3); 0 for a limb without contours there */
static double girth_least(const mus_body *body, int32_t limb, const double *place, const double *chest, double far)
{
    const int32_t n = mus_body_contour_count(body, limb);
    double nearest[3] = {0.0}, centre[3], near = INFINITY, least = INFINITY;
    for (int32_t k = 0; k < n; k++) {
        mus__worn_contour(body, limb, k, centre);
        if (!(girth_apart(centre, place) < near)) continue;
        near = girth_apart(centre, place);
        for (int32_t d = 0; d < 3; d++) nearest[d] = centre[d];
    }
    for (int32_t k = 0; k < n; k++) {
        const double girth = mus__worn_contour(body, limb, k, centre);
        if (girth_apart(centre, nearest) > GIRTH_REACH) continue;
        if (girth_apart(centre, chest) > far) continue;
        least = fmin(least, girth);
    }
    return least < INFINITY ? least : 0.0;
}


void mus__worn_girths(const mus__worn_call *call)
{
    static const char *const names[MUS_WORN_LIMBS] = {"trunk", "left arm", "right arm", "left leg", "right leg"};
    static const int32_t ends[MUS_WORN_LIMBS] = {0, MUS_LANDMARK_WRIST_LEFT, MUS_LANDMARK_WRIST_RIGHT,
                                                 MUS_LANDMARK_ANKLE_LEFT, MUS_LANDMARK_ANKLE_RIGHT};
    for (int32_t l = 0; l < call->loops.nloop; l++) {
        const mus__worn_loop *own = &call->loops.loop[l];
        const bool trunk = (own->expect & GIRTH_ARMS) == GIRTH_ARMS && (own->expect & GIRTH_LEGS) == 0;
        int32_t limb = trunk ? MUS_WORN_NECK : MUS_NONE;
        for (int32_t i = MUS_WORN_ARM_LEFT; i < MUS_WORN_LIMBS; i++)
            if (own->expect == 1 << i) limb = i;
        if (limb == MUS_NONE || call->axes.count[limb] == 0) continue;
        double place[3] = {0.0}, end[3];
        for (int32_t i = 0; i < own->count; i++)
            for (int32_t d = 0; d < 3; d++)
                place[d] += call->placed[3 * (ptrdiff_t)call->loops.node[own->first + i] + d] / own->count;
        const double *chest = call->axes.point[limb][0];
        const bool ends_there = !trunk && mus_body_landmark(call->body, ends[limb], end) == MUS_OK;
        const double girth = girth_least(call->body, call->axes.limb[limb], place, chest,
                                         ends_there ? girth_apart(end, chest) : INFINITY);
        if (!(girth > (1.0 + GIRTH_TIGHT) * own->length)) continue;
        char text[128];
        snprintf(text, sizeof text, "too tight: an opening of %.0f mm, where the %s is %.0f mm round",
                 1000.0 * own->length, names[limb], 1000.0 * girth);
        mus__worn_note(call, MUS_WORN_TIGHT, limb, l, MUS_NONE, girth / own->length - 1.0, text);
    }
}
