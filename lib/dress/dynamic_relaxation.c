/*
 * dynamic_relaxation.c: relaxation: batches of symplectic Euler steps with scaled inertia, or with inertia tensors
 * (drape/inertia.c). sew.c, settle.c and untangle.c share it.
 *
 * Method: dynamic relaxation with mass scaling. The inertia of a node is raised where the mesh is stiffer than its
 * lattice, so that one step suits all nodes; a shape at rest does not depend on inertia.
 * Source: Underwood, Dynamic relaxation, in: Computational Methods for Transient Analysis, 1983.
 *
 * A batch is: h = mus__relax_step(), mus__relax_ready(), mus__relax_run(), then mus__drape_tick() by the caller.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "sim/force_program_constants.h"

#define ASK_STEPS 4      /* steps between two looks at the clock, which take a hundredth of their time at most */
#define TENSOR_STEPS 128 /* steps between two takings of the inertia tensors; chosen: 5 to 10 % of the time */


mus_status mus__relax_create(mus_drape *drape)
{
    const int64_t n3 = 3 * (int64_t)drape->n;
    if (drape->relax.mean != NULL) return MUS_OK;
    drape->relax.mean = mus__new(drape->context, 7 * n3 + drape->n, sizeof *drape->relax.mean);
    drape->relax.tensor = mus__new(drape->context, 7 * (int64_t)drape->sim.n, drape->sim.ops->real);
    if (drape->relax.mean == NULL || drape->relax.tensor == NULL) {
        mus__relax_clear(drape);
        return mus__fail_memory(drape->context, "a settle");
    }
    drape->relax.before = drape->relax.mean + n3;
    drape->relax.went = drape->relax.before + n3;
    drape->relax.left = drape->relax.went + n3;
    drape->relax.moving = drape->relax.left + n3;
    drape->relax.inertia = drape->relax.moving + n3;
    drape->relax.bending = drape->relax.inertia + 2 * n3;
    return MUS_OK;
}


void mus__relax_clear(mus_drape *drape)
{
    mus__free(drape->context, drape->relax.mean);
    mus__free(drape->context, drape->relax.tensor);
    drape->relax.mean = drape->relax.before = drape->relax.went = drape->relax.left = NULL;
    drape->relax.moving = drape->relax.inertia = drape->relax.bending = NULL;
    drape->relax.tensor = NULL;
}


double mus__relax_step(mus_drape *drape, double safety, double least)
{
    const double own = mus__drape_rate(drape, 1), wanted = least > 0.0 ? 2.0 * safety / least : INFINITY;
    const double rate2 = fmin(own, wanted * wanted);
    mus__drape_inertia(drape, rate2);
    drape->relax.raised = rate2 > 0.0 ? own / rate2 : 1.0;
    /* the bound of symplectic Euler is 2/omega, that of RK4 2.62/omega */
    return safety * (2.0 / 2.62) * (rate2 > 0.0 ? 2.62 / sqrt(rate2) : 1e9);
}


mus_status mus__relax_ready(mus_drape *drape, const mus__relax_rule *rule, double h)
{
    mus__sim *sim = &drape->sim;
    const double travel = rule->speed_limit * h;
    memcpy(sim->gravity, rule->gravity, sizeof sim->gravity);
    sim->drag = rule->drag;
    sim->speed_limit = rule->speed_limit;
    sim->dashpots = 0;
    sim->tensor = rule->tensors ? drape->relax.tensor : NULL;
    sim->rule = (mus__contact_rule){.clearance = drape->def.clearance,
                                    .friction = rule->grip * drape->scene.friction,
                                    .push = rule->push_speed > 0.0 ? rule->push_speed * h : 2.0 * travel,
                                    .deep = rule->deep_rate,
                                    .travel = travel,
                                    .slip = h,
                                    .step = h,
                                    .cache_radius = MUS__CACHE_RADIUS,
                                    .slick = 1.0 - rule->grip};
    return mus__drape_self_ready(drape, h);
}


/* `steps` steps of h [s], each of which is added to mean unless that is NULL; the tensors, if the sim has them, are
 * taken anew on the way. Returns the number taken: fewer where the function of the run stops it */
static int32_t run_steps(mus_drape *drape, mus__progress *run, double h, int32_t steps, double *mean)
{
    mus__sim *sim = &drape->sim;
    for (int32_t i = 0; i < steps; i++) {
        if (run != NULL && i > 0 && i % ASK_STEPS == 0) mus__progress_ask(run, drape);
        if (run != NULL && run->stop) return i;
        if (sim->tensor != NULL && i % TENSOR_STEPS == 0) mus__drape_tensors(drape);
        sim->ops->euler(sim, h);
        if (mean != NULL) sim->ops->add(sim, mean);
    }
    return steps;
}


/* momentum over mass of each node and what drag has taken of it since it was at the origin, v + c x, with the factor
 * `sign` into relax.moving: the difference over some time is the mean acceleration that all forces but drag gave */
static void add_momentum(mus_drape *drape, double sign)
{
    mus__sim *sim = &drape->sim;
    sim->ops->get(sim, drape->x, drape->v);
    for (int64_t k = 0; k < 3 * (int64_t)drape->n; k++)
        drape->relax.moving[k] =
            (sign > 0.0 ? drape->relax.moving[k] : 0.0) + sign * (drape->v[k] + sim->drag * drape->x[k]);
}


/* relax.moving as the force [N] that moved each node in `seconds`: inertia times mean acceleration */
static void mean_force(mus_drape *drape, double seconds)
{
    for (int32_t i = 0; i < drape->n; i++) {
        const double inverse = mus__program_get(&drape->program, drape->sim.inverse, i) * seconds;
        for (int64_t k = 3 * (int64_t)i; k < 3 * (int64_t)i + 3; k++)
            drape->relax.moving[k] = inverse > 0.0 ? drape->relax.moving[k] / inverse : 0.0;
    }
}


mus_status mus__relax_run(mus_drape *drape, mus__progress *run, double h, int32_t *steps, int32_t averaged)
{
    mus__sim *sim = &drape->sim;
    const int64_t n3 = 3 * (int64_t)drape->n;
    const int32_t asked = *steps, before = asked - averaged;
    *steps = run_steps(drape, run, h, before, NULL);
    if (averaged > 0 && *steps == before) {
        double *mean = drape->relax.mean;
        memset(mean, 0, (size_t)n3 * sizeof *mean);
        mus__drape_self_forget(drape);
        add_momentum(drape, -1.0);
        *steps += run_steps(drape, run, h, averaged, mean);
        for (int64_t k = 0; k < n3; k++) mean[k] = mean[k] / averaged + sim->origin[k % 3];
    }
    if (averaged > 0) add_momentum(drape, 1.0), mean_force(drape, averaged * h);
    sim->tensor = NULL;
    const mus_status status = mus__drape_keep_good(drape);
    return status == MUS_OK ? mus__drape_self_fits(drape) : status;
}
