/*
 * drape_state.c: the state of a drape between steps: the caller's view of it and the sim's, masses, the clock, the last
 * good state, and the plain getters.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"
#include "sim/force_program_constants.h"
#include "sim/step_bound.h"

#define FLOAT_REACH 1e4 /* [m] from the origin of a float state: a float of 10 km is rounded to a millimetre */
#define SPEED_MAX                                                                                                      \
    1e4 /* [m/s] a node that is faster is taken for a motion that diverged; chosen: no cloth is as fast                \
         */


double mus_drape_time(const mus_drape *drape)
{
    return drape != NULL ? drape->clock.time0 + (double)drape->clock.count * drape->clock.dt : 0.0;
}


double mus__clock_since(const mus_drape *drape, double then, int64_t steps, double h)
{
    return h == drape->clock.dt ? drape->clock.time0 + (double)(drape->clock.count + steps) * h - then
                                : mus_drape_time(drape) + (double)steps * h - then;
}


void mus__drape_tick(mus_drape *drape, int64_t steps, double h, int32_t evaluations)
{
    if (h != drape->clock.dt) {
        drape->clock.time0 = mus_drape_time(drape);
        drape->clock.count = 0;
        drape->clock.dt = h;
    }
    drape->clock.count += steps;
    drape->counters.steps += steps;
    drape->counters.spring_evaluations += steps * evaluations * drape->program.spring_evaluations;
}


void mus__drape_stale(mus_drape *drape)
{
    drape->stepping.bound = 0.0;
}


mus__placed_cloth mus__drape_placed(const mus_drape *drape)
{
    const mus_cloth *cloth = drape->cloth;
    mus__placed_cloth placed = {
        .context = drape->context, .cloth = cloth, .collider = drape->scene.collider, .rep = drape->rep, .x = drape->x};
    memcpy(placed.gravity, drape->def.gravity, sizeof placed.gravity);
    for (int32_t p = 1; p < cloth->npanel; p++)
        if (cloth->panel[p].layer != cloth->panel[0].layer) placed.layered = drape->self != NULL;
    return placed;
}


void mus__drape_push(mus_drape *drape)
{
    drape->sim.ops->put(&drape->sim, drape->x, drape->v);
    drape->relax.residual = NAN;
    mus__drape_stale(drape);
}


void mus__drape_read(const mus_drape *drape, double *x, double *v)
{
    drape->sim.ops->get(&drape->sim, x, v);
    if (!drape->welded) return;
    for (int32_t i = 0; i < drape->n; i++) {
        const int32_t r = drape->rep[i];
        if (r == i) continue;
        memcpy(x + 3 * (ptrdiff_t)i, x + 3 * (ptrdiff_t)r, 3 * sizeof *x);
        memcpy(v + 3 * (ptrdiff_t)i, v + 3 * (ptrdiff_t)r, 3 * sizeof *v);
    }
}


void mus__drape_publish(mus_drape *drape)
{
    mus__drape_read(drape, drape->x, drape->v);
}


mus_status mus__drape_check_reach(const mus_drape *drape, const double *x)
{
    if (drape->def.precision != 32) return MUS_OK;
    for (int64_t i = 0; i < 3 * (int64_t)drape->n; i++) {
        const double from = x[i] - drape->sim.origin[i % 3];
        if (from > FLOAT_REACH || from < -FLOAT_REACH)
            return mus__fail(drape->context, MUS_ERR_ARG,
                             "drape: node %d is %g m from the middle of the cloth as placed, at most %g m with "
                             "precision 32; take 64",
                             (int)(i / 3), from, FLOAT_REACH);
    }
    return MUS_OK;
}


/* whether the cloth has diagonals */
static int32_t has_shear(const mus_cloth *cloth)
{
    for (int32_t r = 0; r < cloth->nrun; r++)
        if (cloth->run[r].kind == MUS__SPRING_SHEAR) return 1;
    for (int32_t s = 0; s < cloth->nspring; s++)
        if (cloth->spring[s].kind == MUS__SPRING_SHEAR) return 1;
    return 0;
}


void mus__drape_name_skipped(mus_drape *drape)
{
    static const char names[][9] = {"contact",  "friction", "seams",   "shear", "bending",
                                    "dashpots", "drag",     "threads", "layers"};
    const mus__collider *collider = drape->scene.collider;
    const bool absent[sizeof names / sizeof names[0]] = {
        collider == NULL,
        collider == NULL || (drape->scene.friction == 0.0 && collider->nplane == 0),
        drape->cloth->npair == 0,
        !has_shear(drape->cloth),
        drape->cloth->nbend + drape->cloth->nhinge == 0,
        !drape->program.dashpots,
        drape->def.drag == 0.0,
        drape->def.threads == 1,
        drape->self == NULL,
    };
    size_t at = 0;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (!absent[i]) continue;
        if (at > 0) drape->skipped[at++] = ',';
        for (const char *c = names[i]; *c != '\0'; c++) drape->skipped[at++] = *c;
    }
    drape->skipped[at] = '\0';
}


mus_status mus__drape_check_motion(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    sim->ops->flush(sim);
    const double speed2 = sim->ops->speed2(sim);
    drape->stepping.speed = sqrt(speed2);
    if (speed2 <= SPEED_MAX * SPEED_MAX) return MUS_OK;
    sim->ops->restore(sim);
    mus__drape_stale(drape);
    return mus__fail(drape->context, MUS_ERR_DIVERGED,
                     "drape: the motion diverged before %g s (speed %g m/s, limit %g); the last good state is kept",
                     mus_drape_time(drape), sqrt(speed2), SPEED_MAX);
}


mus_status mus__drape_keep_good(mus_drape *drape)
{
    const mus_status status = mus__drape_check_motion(drape);
    if (status == MUS_OK) drape->sim.ops->snapshot(&drape->sim);
    return status;
}


mus_status mus__drape_plane_cache(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    const int64_t n = sim->n;
    if (drape->scene.collider == NULL) return MUS_OK;
    if (drape->plane_cache == NULL)
        drape->plane_cache = mus__new(drape->context, MUS__CACHE_PLANES * n, sim->ops->real);
    if (drape->plane_cache == NULL) return mus__fail_memory(drape->context, "what nodes know of the skin");
    for (int64_t i = 7 * n; i < 8 * n; i++) mus__program_put(&drape->program, drape->plane_cache, i, -1.0);
    sim->plane_cache = drape->plane_cache;
    return MUS_OK;
}


double mus__drape_rate(mus_drape *drape, int32_t scaled)
{
    mus__drape_stale(drape);
    if (scaled)
        mus__program_stiffness_at(&drape->program, drape->n, drape->x, drape->stepping.stiffness,
                                  drape->stepping.tangent);
    else
        mus__program_stiffness(&drape->program, drape->n, drape->stepping.stiffness);

    /* the lattice's own rate: the largest over nodes that only runs act on; without any, that of the mean node */
    double lattice = 0.0, all = 0.0, stiff = 0.0, heavy = 0.0;
    int32_t g = 0;
    for (int32_t i = 0; i < drape->n; i++) {
        while (g < drape->program.nirregular && drape->program.irregular_node[g] < i) g++;
        const int32_t irregular = g < drape->program.nirregular && drape->program.irregular_node[g] == i;
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        const double rate2 = drape->stepping.stiffness[i] / drape->mass[i];
        stiff += drape->stepping.stiffness[i];
        heavy += drape->mass[i];
        if (rate2 > all) all = rate2;
        if (!irregular && rate2 > lattice) lattice = rate2;
    }
    if (!(lattice > 0.0) && heavy > 0.0) lattice = stiff / heavy;
    return scaled ? lattice : all;
}


void mus__drape_inertia(mus_drape *drape, double rate2)
{
    drape->relax.rate2 = rate2;
    for (int32_t i = 0; i < drape->n; i++) {
        const double mass = drape->mass[i];
        if (mass <= 0.0 || drape->pinned[i]) {
            drape->sim.ops->set_node(&drape->sim, i, 0.0, 0.0);
            continue;
        }
        const double needed = rate2 > 0.0 ? drape->stepping.stiffness[i] / rate2 : 0.0;
        const double inertia = needed > mass ? needed : mass;
        drape->sim.ops->set_node(&drape->sim, i, 1.0 / inertia, mass / inertia);
    }
}


const double *mus_drape_positions(const mus_drape *drape)
{
    return drape != NULL ? drape->x : NULL;
}


const double *mus_drape_velocities(const mus_drape *drape)
{
    return drape != NULL ? drape->v : NULL;
}


int32_t mus_drape_node_count(const mus_drape *drape)
{
    return drape != NULL ? drape->n : 0;
}


const char *mus_drape_skipped(const mus_drape *drape)
{
    return drape != NULL ? drape->skipped : "";
}
