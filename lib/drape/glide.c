/*
 * glide.c: what contact is told of motion: a body that glides, moved as a whole with a constant velocity while the
 * cloth steps, and nodes so fast that it must sweep them.
 *
 * The body's place is a product, shift0 + velocity (t - t0), never a running sum, so that a long glide keeps its place.
 * Contact works relative to the body (contact_kernel.h); nothing else of a drape knows that it moves.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"

#define MOST_GLIDE 1e3 /* [m/s] */


mus_status mus_drape_move_body(mus_drape *drape, const double *velocity)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (velocity == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: velocity is NULL");
    for (int32_t d = 0; d < 3; d++)
        if (!(fabs(velocity[d]) <= MOST_GLIDE))
            return mus__fail(drape->context, MUS_ERR_ARG, "drape: velocity of the body is %g m/s, expected %g to %g",
                             velocity[d], -MOST_GLIDE, MOST_GLIDE);
    if (drape->collider == NULL) return mus__fail(drape->context, MUS_ERR_STATE, "drape: there is no body to move");
    memcpy(drape->glide_from, drape->collider->shift, sizeof drape->glide_from);
    memcpy(drape->glide, velocity, sizeof drape->glide);
    drape->glide_time = mus_drape_time(drape);
    mus__drape_glide(drape, 0, drape->dt);
    return MUS_OK;
}


int32_t mus__drape_glides(const mus_drape *drape)
{
    return drape->glide[0] != 0.0 || drape->glide[1] != 0.0 || drape->glide[2] != 0.0;
}


void mus__drape_glide(mus_drape *drape, int64_t steps, double h)
{
    if (drape->collider == NULL) return;
    const double since = h == drape->dt ? drape->time0 + (double)(drape->count + steps) * h - drape->glide_time
                                        : mus_drape_time(drape) + (double)steps * h - drape->glide_time;
    double shift[3];
    for (int32_t d = 0; d < 3; d++) shift[d] = drape->glide_from[d] + drape->glide[d] * since;
    mus__collider_move(drape->collider, shift, drape->glide);
}


void mus__drape_glide_back(mus_drape *drape)
{
    memset(drape->glide_from, 0, sizeof drape->glide_from);
    memset(drape->glide, 0, sizeof drape->glide);
    drape->glide_time = mus_drape_time(drape);
    mus__drape_glide(drape, 0, drape->dt);
}


mus_status mus__drape_still(const mus_drape *drape, const char *what)
{
    if (!mus__drape_glides(drape)) return MUS_OK;
    return mus__fail(drape->context, MUS_ERR_STATE,
                     "drape: the body glides at %g, %g, %g m/s; %s needs it at rest (mus_drape_move_body)",
                     drape->glide[0], drape->glide[1], drape->glide[2], what);
}


void mus__drape_meet_first(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    if (sim->collider == NULL) return;
    double glide2 = 0.0;
    for (int32_t d = 0; d < 3; d++) glide2 += drape->glide[d] * drape->glide[d];
    const double speed = sqrt(sim->ops->speed2(sim)) + sqrt(glide2);
    sim->part_tally[0].swift = speed > mus__contact_swift(sim->collider, &sim->rule);
}


void mus__drape_meet(mus_drape *drape, int64_t steps, double h)
{
    mus__sim *sim = &drape->sim;
    if (sim->collider == NULL) return;
    if (mus__drape_glides(drape)) mus__drape_glide(drape, steps, h);
    sim->swift = 0;
    for (int32_t part = 0; part < 64; part++) {
        sim->swift |= sim->part_tally[part].swift;
        sim->part_tally[part].swift = 0;
    }
}
