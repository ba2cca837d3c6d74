/*
 * glide.c: what contact is told of motion: a body that glides, moved as a whole with a constant velocity while the
 * cloth steps, and changes its pose (stance.c), planes that move (plane.c), and nodes so fast that it must sweep them.
 *
 * The body's place is a product, shift0 + velocity (t - t0), never a running sum, so that a long glide keeps its place.
 * Contact works relative to what it touches (contact_kernel.h); nothing else of a drape knows that it moves.
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
    if (drape->collider == NULL || drape->collider->nparts == 0)
        return mus__fail(drape->context, MUS_ERR_STATE, "drape: there is no body to move");
    memcpy(drape->glide_from, drape->collider->shift, sizeof drape->glide_from);
    memcpy(drape->glide, velocity, sizeof drape->glide);
    drape->glide_time = mus_drape_time(drape);
    return MUS_OK;
}


static int32_t body_glides(const mus_drape *drape)
{
    return drape->glide[0] != 0.0 || drape->glide[1] != 0.0 || drape->glide[2] != 0.0;
}


int32_t mus__drape_moves(const mus_drape *drape, int64_t steps, double h)
{
    return body_glides(drape) || mus__drape_plane_moves(drape) || mus__drape_poses(drape, steps, h);
}


double mus__drape_since(const mus_drape *drape, double then, int64_t steps, double h)
{
    return h == drape->dt ? drape->time0 + (double)(drape->count + steps) * h - then
                          : mus_drape_time(drape) + (double)steps * h - then;
}


void mus__drape_stand(mus_drape *drape, int64_t steps, double h, double came)
{
    if (drape->collider == NULL) return;
    const double since = mus__drape_since(drape, drape->glide_time, steps, h);
    double shift[3];
    for (int32_t d = 0; d < 3; d++) shift[d] = drape->glide_from[d] + drape->glide[d] * since;
    mus__collider_move(drape->collider, mus__drape_frames(drape, steps, h), shift, drape->glide, came);
    mus__drape_hold(drape);
    mus__drape_stand_planes(drape, steps, h, came);
    mus__collider_update_speed(drape->collider);
    drape->moving = came > 0.0;
    drape->moved |= drape->moving;
}


void mus__drape_stand_back(mus_drape *drape)
{
    memset(drape->glide_from, 0, sizeof drape->glide_from);
    memset(drape->glide, 0, sizeof drape->glide);
    drape->glide_time = mus_drape_time(drape);
    mus__drape_stance_back(drape);
    for (int32_t k = 0; drape->plane != NULL && k < drape->collider->nplane; k++) {
        mus__drape_plane *plane = &drape->plane[k];
        memcpy(plane->from, plane->added.point, sizeof plane->from);
        memcpy(plane->velocity, plane->added.velocity, sizeof plane->velocity);
        plane->spin = plane->added.spin;
        plane->time = drape->glide_time;
    }
    mus__drape_stand(drape, 0, drape->dt, 0.0);
    drape->moved = 1;
}


mus_status mus__drape_still(const mus_drape *drape, const char *what)
{
    if (body_glides(drape))
        return mus__fail(drape->context, MUS_ERR_STATE,
                         "drape: the body glides at %g, %g, %g m/s; %s needs it at rest (mus_drape_move_body)",
                         drape->glide[0], drape->glide[1], drape->glide[2], what);
    if (mus__drape_poses(drape, 0, drape->dt))
        return mus__fail(drape->context, MUS_ERR_STATE,
                         "drape: the body is on its way to another pose; %s needs it at rest (mus_drape_pose_body)",
                         what);
    if (mus__drape_plane_moves(drape))
        return mus__fail(drape->context, MUS_ERR_STATE,
                         "drape: a plane moves; %s needs all at rest (mus_drape_move_plane)", what);
    return MUS_OK;
}


void mus__drape_meet_first(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    if (sim->collider == NULL) return;
    double glide2 = 0.0;
    for (int32_t d = 0; d < 3; d++) glide2 += drape->glide[d] * drape->glide[d];
    const double speed = sqrt(sim->ops->speed2(sim)) + sqrt(glide2), h = sim->rule.step;
    sim->part_tally[0].fast =
        speed > mus__contact_fast_speed(sim->collider, &sim->rule) || mus__drape_plane_moves(drape) ||
        mus__drape_poses(drape, 0, h);
}


void mus__drape_meet(mus_drape *drape, int64_t steps, double h)
{
    mus__sim *sim = &drape->sim;
    if (sim->collider == NULL) return;
    if (mus__drape_moves(drape, steps - 1, h))
        mus__drape_stand(drape, steps, h, h);
    else if (drape->moving)
        mus__drape_stand(drape, steps, h, 0.0);
    sim->swift = 0;
    for (int32_t part = 0; part < 64; part++) {
        sim->swift |= sim->part_tally[part].fast;
        sim->part_tally[part].fast = 0;
    }
}
