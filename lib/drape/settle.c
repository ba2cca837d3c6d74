/*
 * settle.c: to rest under gravity.
 *
 * The cloth falls and swings with light drag, then with more and more damping (stages below).
 * Symplectic Euler on inertia that is raised where the mesh is stiffer than its lattice (rest does not depend
 * on inertia). Rest is a residual: the force that springs, gravity, contact and friction leave at each node, over the
 * node's weight, rms over the nodes, taken at the mean place of the last steps (so that the rounding of a float state
 * averages out), and the drift of that mean place from one check to the next. It is never judged by energy. A garment
 * that no longer touches the body and falls is told so at once.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"

#define CHECK_SECONDS 0.1  /* of cloth time between residuals */
#define MEAN_STEPS 96      /* places averaged before a residual: of every step, or ripples would alias */
#define SETTLE_SPEED 4.0   /* [m/s] limit */
#define FALL_SECONDS 1.0   /* of cloth time in which a loose garment drops onto the body */
#define OFF_THE_BODY 0.005 /* [m]: no node this near: nothing carries the garment */
#define REST_DRIFT 0.002   /* [m/s]: no node's mean place drifts faster at rest */


/*
 * What damps at time t of a settle. First light drag, near critical for a garment's swing; then heavier drag for its
 * folds; last, for the ripples of a tight crease, the springs' own dashpots and a smaller part of the step bound.
 */
typedef struct stage {
    double from;     /* [s] */
    double drag;     /* [1/s] */
    double safety;   /* of the bound of symplectic Euler */
    int32_t dashpots;
} stage;

static const stage stages[] = {{0.0, 4.0, 0.75, 0}, {0.8, 10.0, 0.75, 0}, {1.8, 20.0, 0.75, 0}, {3.5, 20.0, 0.5, 1}};


static const stage *stage_at(double t)
{
    const stage *now = stages;
    for (size_t i = 0; i < sizeof stages / sizeof stages[0]; i++)
        if (t >= stages[i].from) now = &stages[i];
    return now;
}


/* `steps` steps, with the mean place of the last MEAN_STEPS into drape->mean */
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


/* largest distance between the mean places of this check and the last, which becomes this one's */
static double take_drift(mus_drape *drape)
{
    double most2 = 0.0;
    for (int32_t i = 0; i < drape->n; i++) {
        const double *now = drape->mean + 3 * (int64_t)i, *then = drape->before + 3 * (int64_t)i;
        const double d[3] = {now[0] - then[0], now[1] - then[1], now[2] - then[2]};
        const double move2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        if (drape->mass[i] > 0.0 && move2 > most2) most2 = move2;
    }
    memcpy(drape->before, drape->mean, 3 * (size_t)drape->n * sizeof *drape->before);
    return sqrt(most2);
}


/* nonzero when nothing is held and no node is near the body any more */
static int32_t has_slid_off(const mus_drape *drape)
{
    double normal[3 * MUS_TOUCH_MOST];
    if (drape->collider == NULL) return 0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->pinned[i]) return 0;
        if (drape->mass[i] <= 0.0) continue;
        if (mus__collider_touching(drape->collider, drape->mean + 3 * (int64_t)i, OFF_THE_BODY, normal) > 0) return 0;
    }
    return 1;
}


mus_status mus_drape_settle(mus_drape *drape, mus_progress_fn progress, void *user)
{
    if (drape == NULL) return MUS_ERR_ARG;

    mus__sim *sim = &drape->sim;
    const double all = drape->def.settle_seconds;
    memcpy(sim->gravity, drape->def.gravity, sizeof sim->gravity);
    sim->speed_limit = SETTLE_SPEED;

    mus__run run;
    mus__run_start(&run, "settle", progress, user);
    mus_status status = MUS_OK;
    int32_t stop = 0, slid = 0;
    double drift = 0.0;
    drape->settled = 0;
    memcpy(drape->before, drape->x, 3 * (size_t)drape->n * sizeof *drape->before);
    for (double t = 0.0; t < all && !drape->settled && !stop && !slid;) {
        const stage *now = stage_at(t);
        const double h = now->safety * (2.0 / 2.62) * mus__drape_inertia(drape, 1), travel = SETTLE_SPEED * h;
        const int32_t batch = (int32_t)fmin(fmax(CHECK_SECONDS / h, 2.0 * MEAN_STEPS), 1e6);
        sim->drag = now->drag;
        sim->dashpots = now->dashpots && drape->plan.dashpots;
        sim->rule = (mus__contact_rule){drape->def.clearance, drape->friction, 2.0 * travel, travel, h};
        advance_mean(drape, batch, h);
        status = mus__drape_guard(drape);
        if (status != MUS_OK) break;
        mus__drape_tick(drape, batch, h, 1);
        t += batch * h;
        drape->settle_time += batch * h;
        drape->residual = mus__drape_residual(drape, drape->mean);
        drift = take_drift(drape) / (batch * h);
        drape->settled = drape->residual <= drape->def.settle_residual && drift <= REST_DRIFT;
        slid = t > FALL_SECONDS && has_slid_off(drape);
        stop = mus__run_report(&run, t / all);
    }
    mus__drape_publish(drape);
    if (status != MUS_OK || stop || drape->settled) return status;
    if (slid) return mus__fail(drape->context, MUS_ERR_UNSETTLED, "slid off the body after %.1f s", drape->settle_time);
    return mus__fail(
        drape->context, MUS_ERR_UNSETTLED,
        "not at rest after %.2f s: residual %.3g of a node's weight (%.3g allowed), drift %.2g mm/s (%.2g)",
        drape->settle_time, drape->residual, drape->def.settle_residual, 1e3 * drift, 1e3 * REST_DRIFT);
}
