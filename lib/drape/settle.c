/*
 * settle.c: to rest under gravity.
 *
 * Symplectic Euler with drag on inertia that is raised where the mesh is stiffer than its lattice (rest does not depend
 * on inertia). Rest is a residual: the force that springs, gravity, contact and friction leave at each node, over the
 * node's weight, rms over the nodes, taken at the mean place of the last steps (so that the rounding of a float state
 * averages out). It is never judged by energy.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"

#define CHECK_SECONDS 0.1  /* of cloth time between residuals */
#define MEAN_STEPS 64      /* places averaged before a residual */
#define SAFETY 0.75        /* of the bound of symplectic Euler */
#define SETTLE_DRAG 4.0    /* [1/s]: near critical for a garment's swing */
#define SETTLE_SPEED 4.0   /* [m/s] limit */
#define REST_SPEED 0.01    /* [m/s]: no node moves faster at rest */


/* `steps` steps, of which the last MEAN_STEPS are averaged into drape->mean */
static void advance_mean(mus_drape *drape, int32_t steps, double h)
{
    mus__sim *sim = &drape->sim;
    const int64_t n3 = 3 * (int64_t)drape->n;
    for (int32_t i = 0; i < steps - MEAN_STEPS; i++) sim->ops->euler(sim, h);
    memset(drape->mean, 0, (size_t)n3 * sizeof *drape->mean);
    for (int32_t i = 0; i < MEAN_STEPS; i++) {
        sim->ops->euler(sim, h);
        sim->ops->get(sim, drape->x, drape->v);
        for (int64_t k = 0; k < n3; k++) drape->mean[k] += drape->x[k];
    }
    for (int64_t k = 0; k < n3; k++) drape->mean[k] /= MEAN_STEPS;
}


mus_status mus_drape_settle(mus_drape *drape, mus_progress_fn progress, void *user)
{
    if (drape == NULL) return MUS_ERR_ARG;

    mus__sim *sim = &drape->sim;
    const double all = drape->def.settle_seconds;
    memcpy(sim->gravity, drape->def.gravity, sizeof sim->gravity);
    sim->drag = SETTLE_DRAG;
    sim->speed_limit = SETTLE_SPEED;
    sim->dashpots = 0;

    mus__run run;
    mus__run_start(&run, "settle", progress, user);
    mus_status status = MUS_OK;
    int32_t stop = 0;
    drape->settled = 0;
    for (double t = 0.0; t < all && !drape->settled && !stop && status == MUS_OK;) {
        const double h = SAFETY * (2.0 / 2.62) * mus__drape_inertia(drape, 1), travel = SETTLE_SPEED * h;
        const int32_t batch = (int32_t)fmin(fmax(CHECK_SECONDS / h, 2.0 * MEAN_STEPS), 1e6);
        sim->rule = (mus__contact_rule){drape->def.clearance, drape->friction, 2.0 * travel, travel};
        advance_mean(drape, batch, h);
        status = mus__drape_guard(drape);
        if (status != MUS_OK) break;
        mus__drape_tick(drape, batch, h, 1);
        t += batch * h;
        drape->settle_time += batch * h;
        drape->residual = mus__drape_residual(drape, drape->mean);
        const double speed = sqrt(sim->ops->speed2(sim));
        drape->settled = drape->residual <= drape->def.settle_residual && speed <= REST_SPEED;
        stop = mus__run_report(&run, t / all);
    }
    mus__drape_publish(drape);
    if (status != MUS_OK || stop || drape->settled) return status;
    return mus__fail(drape->context, MUS_ERR_UNSETTLED,
                     "not at rest after %.2f s: residual %.3g of a node's weight, %.3g allowed, speed %.3g m/s", all,
                     drape->residual, drape->def.settle_residual, sqrt(sim->ops->speed2(sim)));
}
