/*
 * scene.c: the scene of a drape at a time: a body that moves as a whole or to another pose, planes that move, and
 * whether nodes are so fast that contact must sweep them.
 *
 * The public calls set a motion from now on. Before each step the scene is put where it will be at its end
 * (mus__scene_before_step). The place of the body is a product, from + velocity (t - t0), never a running sum, so that
 * a long motion keeps its place.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"

#define SPEED_OF_BODY_MAX 1e3 /* [m/s] largest velocity of the body as a whole */


mus_status mus_drape_move_body(mus_drape *drape, const double *velocity)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (velocity == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: velocity is NULL");
    for (int32_t d = 0; d < 3; d++)
        if (!(fabs(velocity[d]) <= SPEED_OF_BODY_MAX))
            return mus__fail(drape->context, MUS_ERR_ARG, "drape: velocity of the body is %g m/s, expected %g to %g",
                             velocity[d], -SPEED_OF_BODY_MAX, SPEED_OF_BODY_MAX);
    if (drape->scene.collider == NULL || drape->scene.collider->nparts == 0)
        return mus__fail(drape->context, MUS_ERR_STATE, "drape: there is no body to move");
    memcpy(drape->scene.from, drape->scene.collider->shift, sizeof drape->scene.from);
    memcpy(drape->scene.velocity, velocity, sizeof drape->scene.velocity);
    drape->scene.time = mus_drape_time(drape);
    return MUS_OK;
}


/* whether the body moves as a whole */
static int32_t body_translates(const mus_drape *drape)
{
    return drape->scene.velocity[0] != 0.0 || drape->scene.velocity[1] != 0.0 || drape->scene.velocity[2] != 0.0;
}


int32_t mus__scene_moves(const mus_drape *drape, int64_t steps, double h)
{
    return body_translates(drape) || mus__scene_plane_moves(drape) || mus__scene_body_poses(drape, steps, h);
}


void mus__scene_update(mus_drape *drape, int64_t steps, double h, double came)
{
    if (drape->scene.collider == NULL) return;
    const double since = mus__clock_since(drape, drape->scene.time, steps, h);
    double shift[3];
    for (int32_t d = 0; d < 3; d++) shift[d] = drape->scene.from[d] + drape->scene.velocity[d] * since;
    mus__collider_move(drape->scene.collider, mus__scene_body_frames(drape, steps, h), shift, drape->scene.velocity,
                       came);
    mus__scene_levels_update(drape);
    mus__scene_planes_update(drape, steps, h, came);
    mus__collider_update_speed(drape->scene.collider);
    drape->scene.moving = came > 0.0;
    drape->scene.moved |= drape->scene.moving;
}


void mus__scene_reset(mus_drape *drape)
{
    memset(drape->scene.from, 0, sizeof drape->scene.from);
    memset(drape->scene.velocity, 0, sizeof drape->scene.velocity);
    drape->scene.time = mus_drape_time(drape);
    mus__scene_body_reset(drape);
    for (int32_t k = 0; drape->scene.plane != NULL && k < drape->scene.collider->nplane; k++) {
        mus__scene_plane *plane = &drape->scene.plane[k];
        memcpy(plane->from, plane->added.point, sizeof plane->from);
        memcpy(plane->velocity, plane->added.velocity, sizeof plane->velocity);
        plane->spin = plane->added.spin;
        plane->time = drape->scene.time;
    }
    mus__scene_update(drape, 0, drape->clock.dt, 0.0);
    drape->scene.moved = 1;
}


mus_status mus__scene_require_rest(const mus_drape *drape, const char *what)
{
    if (body_translates(drape))
        return mus__fail(drape->context, MUS_ERR_STATE,
                         "drape: the body glides at %g, %g, %g m/s; %s needs it at rest (mus_drape_move_body)",
                         drape->scene.velocity[0], drape->scene.velocity[1], drape->scene.velocity[2], what);
    if (mus__scene_body_poses(drape, 0, drape->clock.dt))
        return mus__fail(drape->context, MUS_ERR_STATE,
                         "drape: the body is on its way to another pose; %s needs it at rest (mus_drape_pose_body)",
                         what);
    if (mus__scene_plane_moves(drape))
        return mus__fail(drape->context, MUS_ERR_STATE,
                         "drape: a plane moves; %s needs all at rest (mus_drape_move_plane)", what);
    return MUS_OK;
}


void mus__scene_before_steps(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    if (sim->collider == NULL) return;
    double glide2 = 0.0;
    for (int32_t d = 0; d < 3; d++) glide2 += drape->scene.velocity[d] * drape->scene.velocity[d];
    const double speed = sqrt(sim->ops->speed2(sim)) + sqrt(glide2), h = sim->rule.step;
    sim->part_tally[0].fast = speed > mus__contact_fast_speed(sim->collider, &sim->rule) ||
                              mus__scene_plane_moves(drape) || mus__scene_body_poses(drape, 0, h);
}


void mus__scene_before_step(mus_drape *drape, int64_t steps, double h)
{
    mus__sim *sim = &drape->sim;
    if (sim->collider == NULL) return;
    if (mus__scene_moves(drape, steps - 1, h))
        mus__scene_update(drape, steps, h, h);
    else if (drape->scene.moving)
        mus__scene_update(drape, steps, h, 0.0);
    sim->sweeps = 0;
    for (int32_t part = 0; part < 64; part++) {
        sim->sweeps |= sim->part_tally[part].fast;
        sim->part_tally[part].fast = 0;
    }
}
