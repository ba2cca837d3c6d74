/*
 * step.c: mus_drape_step(): stepping by hand, with its bound and the guard on energy.
 *
 * The step bound belongs to a pose. It is taken when a step begins after a change from outside, again every LOOK_STEPS
 * steps, and when a node may have gone as far as its neighbour. A step above the bound is refused at the call. When the
 * pose lowers the bound during a run (strong shear lines threads up), steps are divided until it has risen again, and
 * the report tells in how many parts.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "sim/force_reference.h"
#include "sim/step_bound.h"

#define LEAST_STEP 1e-30 /* [s] far below a step that moves a float */
#define PUSH_SPEED 1.0   /* [m/s] a node that starts inside the body leaves it no faster; chosen: walking speed */
#define PINCH_PULL 100.0 /* [m/s2] acceleration of a pinched node out of a body that never moved; chosen: ten g */
#define GUARD_STEPS 64   /* steps between two checks of the motion */
#define LOOK_WAY 1.0     /* of the spacing: how far a node may go between two looks at the bound */
#define LOOK_STEPS 512   /* steps between two looks at bound and energy, which take about 1 % of the time */
#define MOST_PARTS 64    /* of a divided step at most */
#define ENERGY_GROWTH 0.01 /* of the largest kinetic and elastic energy: the error of energy that a run may have */


double mus__drape_bound(const mus_drape *drape, int32_t *tightest)
{
    double rate2 = 0.0, gamma = 0.0, ratio = 0.0, *dashpots = drape->stepping.dashpot;
    mus__program_stiffness_at(&drape->program, drape->n, drape->x, drape->stepping.stiffness, drape->stepping.tangent);
    if (drape->program.dashpots) mus__program_damping(&drape->program, drape->n, dashpots, &ratio);
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        if (drape->stepping.stiffness[i] > rate2 * drape->mass[i]) {
            rate2 = drape->stepping.stiffness[i] / drape->mass[i];
            if (tightest != NULL) *tightest = i;
        }
        if (drape->program.dashpots && dashpots[i] > gamma * drape->mass[i]) gamma = dashpots[i] / drape->mass[i];
    }
    if (drape->def.integrator == MUS_METHOD_VERLET) return mus__step_bound_verlet(rate2, gamma);
    return mus__step_bound_rk4(rate2, gamma + drape->def.drag, ratio, drape->def.drag);
}


double mus_drape_step_bound(const mus_drape *drape)
{
    return drape != NULL ? mus__drape_bound(drape, NULL) : 0.0;
}


/* energy [J] at drape->x and drape->v: *active gets kinetic and elastic; returns all, with that in gravity */
static double energy_now(const mus_drape *drape, double *active)
{
    const double *g = drape->def.gravity;
    double place = 0.0;
    *active = mus__program_force(&drape->program, drape->n, drape->x, NULL);
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        const double *x = drape->x + 3 * (int64_t)i, *v = drape->v + 3 * (int64_t)i;
        *active += 0.5 * drape->mass[i] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        place -= drape->mass[i] * (g[0] * x[0] + g[1] * x[1] + g[2] * x[2]);
    }
    return *active + place;
}


/* takes the bound of the published pose */
static void look(mus_drape *drape)
{
    drape->stepping.bound = mus__drape_bound(drape, NULL);
    drape->stepping.since_look = 0;
    drape->stepping.way = 0.0;
}


/* energy [J] that the rounding of places gives, with room: 0.5 k ulp^2 in the springs of each node, and the weight
 * times ulp, the last digit of a metre */
static double rounding_energy(const mus_drape *drape)
{
    const double ulp = drape->def.precision == 32 ? 1e-6 : 1e-14, *g = drape->def.gravity;
    const double weight = mus_cloth_mass(drape->cloth) * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    double stiffness = 0.0;
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->stepping.stiffness[i] > stiffness) stiffness = drape->stepping.stiffness[i];
    return 0.5 * drape->n * stiffness * ulp * ulp + weight * ulp;
}


/*
 * Only a body, a plane, an open seam or self-contact does work on a cloth, so without them its energy falls. It may
 * rise above that of the start (the state that the caller left, or the first step) by ENERGY_GROWTH of the largest
 * kinetic and elastic energy since then: more is an error of the steps. With any of them the speed limit alone holds.
 */
static mus_status guard_energy(mus_drape *drape)
{
    mus__stepping *stepping = &drape->stepping;
    double active;
    mus__drape_publish(drape);
    look(drape);
    if (drape->scene.collider != NULL || drape->program.npair > 0 || drape->self != NULL) return MUS_OK;
    const double energy = energy_now(drape, &active);
    stepping->active = fmax(stepping->active, active);
    const double most = stepping->energy + ENERGY_GROWTH * stepping->active + rounding_energy(drape);
    if (energy <= most) return MUS_OK;
    const double start = stepping->energy;
    drape->sim.ops->restore(&drape->sim);
    mus__drape_stale(drape);
    return mus__fail(drape->context, MUS_ERR_DIVERGED,
                     "drape: the energy rose from %.6g J at the start to %.6g J after %g s, expected at most %.6g J: "
                     "a smaller step has a smaller error; the last good state is kept",
                     start, energy, mus_drape_time(drape), most);
}


static mus_status check_step(mus_drape *drape, int32_t steps, double dt)
{
    mus_context *context = drape->context;
    if (steps < 0) return mus__fail(context, MUS_ERR_ARG, "drape: steps is %d, expected 0 or more", (int)steps);
    if (!(dt == 0.0 || dt >= LEAST_STEP) || !mus__finite(dt))
        return mus__fail(context, MUS_ERR_ARG, "drape: step is %g s, expected 0 or at least %g", dt, LEAST_STEP);

    /* true masses and the bound, if anything changed since they were taken */
    if (dt > drape->stepping.bound && drape->stepping.bound > 0.0)
        drape->stepping.bound = mus__drape_bound(drape, NULL);
    if (drape->stepping.bound <= 0.0) {
        mus__drape_inertia(drape, mus__drape_rate(drape, 0));
        look(drape);
        drape->stepping.energy = energy_now(drape, &drape->stepping.active);
        drape->sim.ops->snapshot(&drape->sim);
    }
    if (dt > drape->stepping.bound)
        return mus__fail(context, MUS_ERR_STEP, "drape: step %.9g s is above the stability bound %.9g s", dt,
                         drape->stepping.bound);
    return MUS_OK;
}


int32_t mus__drape_evaluations(const mus_drape *drape)
{
    return drape->def.integrator == MUS_METHOD_VERLET ? 1 : 4;
}


void mus__drape_prepare(mus_drape *drape, double dt)
{
    mus__sim *sim = &drape->sim;
    memcpy(sim->gravity, drape->def.gravity, sizeof sim->gravity);
    sim->drag = drape->def.drag;
    sim->dashpots = drape->program.dashpots;
    memset(sim->distance_cache, 0, (size_t)drape->n * sizeof *sim->distance_cache);
    sim->rule = (mus__contact_rule){.clearance = drape->def.clearance,
                                    .friction = drape->scene.friction,
                                    .push = PUSH_SPEED * dt,
                                    .step = dt,
                                    .cache_radius = drape->def.contact_ball};
    if (drape->scene.body == NULL || !drape->scene.body->posed) sim->rule.pull = PINCH_PULL;
    mus__scene_before_steps(drape);
    if (drape->scene.moved && drape->plane_cache != NULL)
        mus__drape_plane_cache(drape); /* has its memory; forgets earlier queries */
    drape->scene.moved = 0;
    mus__drape_self_forget(drape);
    sim->plane_cache = drape->def.contact_ball > 0.0 && !mus__scene_moves(drape, 0, dt) ? drape->plane_cache : NULL;
}


void mus__drape_advance(mus_drape *drape, int32_t ahead, int32_t steps, double dt)
{
    mus__sim *sim = &drape->sim;
    const double need = dt / drape->stepping.bound;
    const int32_t parts = need > 1.0 ? (int32_t)fmin(ceil(need), MOST_PARTS) : 1;
    const int32_t verlet = drape->def.integrator == MUS_METHOD_VERLET, count = steps * parts;
    const double h = dt / parts;
    sim->rule.push = PUSH_SPEED * h;
    sim->rule.slip = verlet ? h : 0.5 * h;
    sim->rule.step = h;
    mus__drape_self_rule(drape, h);

    /* surfaces are moved before each step */
    const int32_t alone = !verlet || mus__scene_moves(drape, (int64_t)ahead * parts, h) ? 1 : count;
    for (int32_t i = 0; i < count; i += alone) {
        mus__scene_before_step(drape, (int64_t)ahead * parts + i + alone, h);
        if (verlet)
            sim->ops->verlet(sim, h, alone);
        else
            sim->ops->rk4(sim, h);
    }
    drape->counters.steps += count - steps; /* the clock counts the rest */
    const int64_t more = (int64_t)(count - steps) * mus__drape_evaluations(drape);
    drape->counters.spring_evaluations += more * drape->program.spring_evaluations;
    if (parts > drape->stepping.parts) drape->stepping.parts = parts;
}


/* whether any node is free */
static int32_t any_free(const mus_drape *drape)
{
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->mass[i] > 0.0 && !drape->pinned[i]) return 1;
    return 0;
}


mus_status mus_drape_step(mus_drape *drape, int32_t steps, double dt)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_status status = check_step(drape, steps, dt);
    if (status != MUS_OK || steps == 0 || dt == 0.0) return status;

    /* all nodes are fixed: time goes on, nothing else */
    if (!any_free(drape)) {
        mus__drape_tick(drape, steps, dt, 0);
        mus__scene_update(drape, 0, dt, 0.0);
        return MUS_OK;
    }

    mus__sim *sim = &drape->sim;
    mus__drape_prepare(drape, dt);
    status = mus__drape_self_ready(drape, dt);
    drape->stepping.parts = 1;

    /* the clock is set when a state was found good: at a look, and at the end */
    int32_t good = 0;
    for (int32_t done = 0; done < steps && status == MUS_OK;) {
        const int32_t batch = steps - done < GUARD_STEPS ? steps - done : GUARD_STEPS;
        mus__drape_advance(drape, done - good, batch, dt);
        done += batch;
        drape->stepping.since_look += batch;
        status = mus__drape_check_motion(drape);
        if (status == MUS_OK) status = mus__drape_self_fits(drape);
        if (status == MUS_OK && drape->self != NULL && drape->self->ncrossed > 0)
            status = mus__drape_self_ready(drape, dt);
        drape->stepping.way += batch * dt * drape->stepping.speed;
        const int32_t due = drape->stepping.since_look >= LOOK_STEPS;
        if (status == MUS_OK && !due && drape->stepping.way > LOOK_WAY * drape->cloth->spacing &&
            drape->cloth->spacing > 0.0) {
            mus__drape_publish(drape);
            drape->stepping.bound = mus__drape_bound(drape, NULL);
            drape->stepping.way = 0.0;
        }
        if (status == MUS_OK && due) status = guard_energy(drape);
        if (status != MUS_OK || (!due && done < steps)) continue;
        sim->ops->snapshot(sim);
        mus__drape_tick(drape, done - good, dt, mus__drape_evaluations(drape));
        good = done;
    }
    mus__scene_update(drape, 0, dt, 0.0);
    sim->plane_cache = NULL;
    drape->relax.settled = drape->coarse.as_sewn = 0;
    drape->relax.residual = NAN;
    mus__drape_publish(drape);
    return status;
}
