/*
 * drape.c: create, destroy, the state as callers see it, and its bookkeeping.
 *
 * All memory that stepping needs is taken here. The number of steps, evaluations and the clock are kept here too.
 */
#include <math.h>
#include <string.h>

#include "drape/level.h"

#define FLOAT_REACH 1e4 /* [m] */
#define LEAST_THICKNESS 1e-5 /* [m]: floats round a metre off by a hundredth of it */
#define MOST_GRAVITY 1e4 /* [m/s2]: a thousand g and no more */


void mus_drape_def_init(mus_drape_def *def, size_t size)
{
    if (def == NULL || size < sizeof def->size) return;
    mus_drape_def own = {0};
    own.size = size;
    own.gravity[1] = -9.81;
    own.precision = 32;
    own.threads = 1;
    own.collision_distance = 0.001;
    own.clearance = 0.002;
    own.friction = NAN;
    own.drag = 0.5;
    own.seam_pull = 50.0;
    own.sew_seconds = 6.0;
    own.settle_seconds = 10.0;
    own.settle_residual = 0.02;
    own.thickness = 0.002;
    own.self_friction = NAN;
    memset(def, 0, size);
    memcpy(def, &own, size < sizeof own ? size : sizeof own);
}


/* one number of a def: finite and within low..high */
static mus_status check_number(mus_context *context, const char *name, double value, double low, double high)
{
    if (value >= low && value <= high) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "drape: %s is %g, expected %g to %g", name, value, low, high);
}


static mus_status check_def(mus_context *context, const mus_drape_def *def)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < 3 && status == MUS_OK; i++)
        status = check_number(context, "gravity", def->gravity[i], -MOST_GRAVITY, MOST_GRAVITY);
    if (status == MUS_OK && def->precision != 32 && def->precision != 64)
        status = mus__fail(context, MUS_ERR_ARG, "drape: precision is %d, expected 32 or 64", (int)def->precision);
    if (status == MUS_OK && (def->threads < 1 || def->threads > 64))
        status = mus__fail(context, MUS_ERR_ARG, "drape: threads is %d, expected 1 to 64", (int)def->threads);
    if (status == MUS_OK && def->integrator != MUS_METHOD_RK4 && def->integrator != MUS_METHOD_VERLET)
        status = mus__fail(context, MUS_ERR_ARG, "drape: integrator is %d, expected %d or %d", (int)def->integrator,
                           MUS_METHOD_RK4, MUS_METHOD_VERLET);
    if (status == MUS_OK)
        status = check_number(context, "collision_distance", def->collision_distance, 1e-6, 0.05);
    if (status == MUS_OK) status = check_number(context, "clearance", def->clearance, 0.0, 0.05);
    if (status == MUS_OK && !isnan(def->friction) && def->friction != INFINITY)
        status = check_number(context, "friction", def->friction, 0.0, 1e6);
    if (status == MUS_OK) status = check_number(context, "contact_ball", def->contact_ball, 0.0, 0.001);
    if (status == MUS_OK) status = check_number(context, "drag", def->drag, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "seam_pull", def->seam_pull, 1e-3, 1e5);
    if (status == MUS_OK) status = check_number(context, "sew_seconds", def->sew_seconds, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "settle_seconds", def->settle_seconds, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "settle_residual", def->settle_residual, 1e-12, 10.0);
    if (status == MUS_OK) status = check_number(context, "thickness", def->thickness, LEAST_THICKNESS, 0.05);
    if (status == MUS_OK && !isnan(def->self_friction) && def->self_friction != INFINITY)
        status = check_number(context, "self_friction", def->self_friction, 0.0, 1e6);
    return status;
}


/* the arrays of the drape and of its sim */
static mus_status take_memory(mus_drape *drape)
{
    mus_context *context = drape->context;
    const int64_t n = drape->n;
    mus__sim *sim = &drape->sim;
    sim->nodes = drape->n;
    sim->n = (drape->n + MUS_LANES - 1) / MUS_LANES * MUS_LANES;
    sim->plan = &drape->plan;
    drape->x = mus__new(context, 3 * n, sizeof *drape->x);
    drape->v = mus__new(context, 3 * n, sizeof *drape->v);
    drape->force = mus__new(context, 3 * n, sizeof *drape->force);
    drape->work = mus__new(context, 6 * n, sizeof *drape->work);
    drape->mass = mus__new(context, n, sizeof *drape->mass);
    drape->stiffness = mus__new(context, n, sizeof *drape->stiffness);
    drape->rep = mus__new(context, n, sizeof *drape->rep);
    drape->pinned = mus__new(context, n, sizeof *drape->pinned);
    if (drape->x == NULL || drape->v == NULL || drape->force == NULL || drape->work == NULL || drape->mass == NULL ||
        drape->stiffness == NULL || drape->rep == NULL || drape->pinned == NULL)
        return mus__fail_memory(context, "the state of a drape");
    return mus__sim_create(context, sim);
}


/* places that the state can hold: float rounds to a millimetre 10 km from its origin, and farther off it is no cloth */
static mus_status check_reach(const mus_drape *drape, const double *x)
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


/* float: the mean place of the nodes before sewing, to the centimetre */
static mus_status choose_origin(mus_drape *drape)
{
    if (drape->def.precision != 32 || drape->n == 0) return MUS_OK;
    mus__cloth_place(drape->cloth, drape->x);
    for (int32_t d = 0; d < 3; d++) {
        double sum = 0.0;
        for (int32_t i = 0; i < drape->n; i++) sum += drape->x[3 * (int64_t)i + d];
        drape->sim.origin[d] = floor(100.0 * sum / drape->n) / 100.0;
    }
    return check_reach(drape, drape->x);
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
    const struct {
        int32_t absent;
        const char *name;
    } list[] = {
        {drape->collider == NULL, "contact"},
        {drape->collider == NULL || (drape->friction == 0.0 && drape->collider->nplane == 0), "friction"},
        {drape->cloth->npair == 0, "seams"},
        {!has_shear(drape->cloth), "shear"},
        {drape->cloth->nbend + drape->cloth->nhinge == 0, "bending"},
        {!drape->plan.dashpots, "dashpots"},
        {drape->def.drag == 0.0, "drag"},
        {drape->def.threads == 1, "threads"},
        {drape->self == NULL, "layers"},
    };
    size_t at = 0;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        if (!list[i].absent) continue;
        if (at > 0) drape->skipped[at++] = ',';
        const size_t bytes = strlen(list[i].name);
        memcpy(drape->skipped + at, list[i].name, bytes);
        at += bytes;
    }
    drape->skipped[at] = '\0';
}


/* collider and threads: those of the parent, or new ones */
static mus_status take_surroundings(mus_drape *drape, const mus_body *body)
{
    const mus_drape *parent = drape->parent;
    if (parent != NULL) {
        memcpy(drape->sim.origin, parent->sim.origin, sizeof drape->sim.origin);
        drape->pool = parent->pool;
        drape->collider = parent->collider;
        return MUS_OK;
    }
    mus_status status = mus__pool_create(drape->context, drape->def.threads, &drape->pool);
    if (status == MUS_OK) status = choose_origin(drape);
    if (status == MUS_OK && body != NULL)
        status = mus__collider_create(drape->context, body, drape->sim.origin, drape->def.clearance, &drape->collider);
    if (status == MUS_OK && body != NULL) status = mus__drape_stance_create(drape, body);
    if (status == MUS_OK && body != NULL) mus__drape_levels(drape, body);
    return status;
}


mus_status mus__drape_make(mus_context *context, const mus_cloth *cloth, const mus_body *body, mus_drape *parent,
                           const mus_drape_def *def, mus_drape **out)
{
    *out = NULL;
    mus_drape *drape = mus__new(context, 1, sizeof *drape);
    if (drape == NULL) return mus__fail_memory(context, "a drape");
    drape->context = context;
    drape->def = *def;
    drape->n = cloth->nnode;
    drape->parent = parent;
    drape->cloth = mus__cloth_retain(cloth);
    drape->friction = isnan(def->friction) ? cloth->fabric.friction : def->friction;
    drape->sim.ops = def->precision == 64 ? &mus__sim_f64 : &mus__sim_f32;
    mus_status status = mus__plan_build(context, cloth, drape->sim.ops->real, &drape->plan);
    if (status == MUS_OK) status = take_memory(drape);
    if (status == MUS_OK) status = take_surroundings(drape, body);
    if (status == MUS_OK && def->contact_ball > 0.0) status = mus__drape_near(drape);
    if (status == MUS_OK) status = mus__drape_self_create(drape);
    drape->sim.near = NULL;
    if (status != MUS_OK) {
        mus_drape_destroy(drape);
        return status;
    }

    mus__sim *sim = &drape->sim;
    sim->pool = drape->pool;
    sim->collider = drape->collider;
    sim->collision_distance = def->collision_distance;
    mus__drape_name_skipped(drape);

    /* flat in the panels' planes until placed; bare nodes at their place, their pins held */
    for (int32_t i = 0; i < drape->n; i++) {
        double *x = drape->x + 3 * (int64_t)i;
        x[0] = cloth->rest[2 * (int64_t)i], x[1] = cloth->rest[2 * (int64_t)i + 1], x[2] = 0.0;
    }
    if (cloth->place != NULL) mus__cloth_place(cloth, drape->x);
    for (int32_t i = 0; i < cloth->npin; i++) drape->pinned[cloth->pin[i]] = 1;
    drape->cold = 1;
    drape->sewn_so = 0;
    mus_reason_init(&drape->reason, sizeof drape->reason);
    mus_reason_init(&drape->start, sizeof drape->start);
    mus__drape_hold(drape);
    mus__drape_open(drape);
    mus__drape_push(drape);
    *out = drape;
    return MUS_OK;
}


mus_status mus_drape_create(mus_context *context, const mus_cloth *cloth, const mus_body *body,
                            const mus_drape_def *def, mus_drape **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (out == NULL || cloth == NULL) return mus__fail(context, MUS_ERR_ARG, "drape: cloth or out is NULL");
    mus_drape_def own;
    mus_drape_def_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, sizeof own, def, "mus_drape_def");
    if (status == MUS_OK) status = check_def(context, &own);
    if (status == MUS_OK && cloth->npair > 0 && cloth->spacing > 0.0 && own.collision_distance > cloth->spacing)
        status =
            mus__fail(context, MUS_ERR_ARG, "drape: collision_distance is %g m, expected at most the spacing, %g m",
                      own.collision_distance, cloth->spacing);
    return status == MUS_OK ? mus__drape_make(context, cloth, body, NULL, &own, out) : status;
}


void mus_drape_destroy(mus_drape *drape)
{
    if (drape == NULL) return;
    mus_context *context = drape->context;
    mus__drape_coarse_destroy(drape);
    if (drape->parent == NULL) {
        mus__pool_destroy(drape->pool);
        mus__collider_destroy(drape->collider);
    }
    mus__self_contact_destroy(drape->self);
    mus__plan_clear(context, &drape->plan);
    mus_cloth_destroy(drape->cloth);
    mus__sim_destroy(context, &drape->sim);
    void *blocks[] = {drape->x,    drape->v,    drape->force,     drape->mean,
                      drape->work, drape->mass, drape->stiffness, drape->rep,  drape->pinned,
                      drape->skin, drape->plane, drape->stance,    drape->slide};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    mus__free(context, drape);
}


/* ---- state ---- */

void mus__drape_push(mus_drape *drape)
{
    drape->sim.ops->put(&drape->sim, drape->x, drape->v);
    drape->residual = NAN;
    mus__drape_stale(drape);
}


void mus__drape_publish(mus_drape *drape)
{
    drape->sim.ops->get(&drape->sim, drape->x, drape->v);
    if (!drape->welded) return;
    for (int32_t i = 0; i < drape->n; i++) {
        const int32_t r = drape->rep[i];
        if (r == i) continue;
        memcpy(drape->x + 3 * i, drape->x + 3 * r, 3 * sizeof *drape->x);
        memcpy(drape->v + 3 * i, drape->v + 3 * r, 3 * sizeof *drape->v);
    }
}


void mus__drape_tick(mus_drape *drape, int64_t steps, double h, int32_t evaluations)
{
    if (h != drape->dt) {
        drape->time0 = mus_drape_time(drape);
        drape->count = 0;
        drape->dt = h;
    }
    drape->count += steps;
    drape->steps += steps;
    drape->spring_evaluations += steps * evaluations * drape->plan.spring_evaluations;
}


double mus__drape_inertia(mus_drape *drape, int32_t scaled)
{
    mus__drape_stale(drape);
    if (scaled) mus__plan_stiffness_at(&drape->plan, drape->n, drape->x, drape->stiffness, drape->work);
    else mus__plan_stiffness(&drape->plan, drape->n, drape->stiffness);

    /* the lattice's own rate: the largest over nodes that only runs act on; without any, that of the mean node */
    double lattice = 0.0, all = 0.0, stiff = 0.0, heavy = 0.0;
    int32_t g = 0;
    for (int32_t i = 0; i < drape->n; i++) {
        while (g < drape->plan.ngather && drape->plan.gather_node[g] < i) g++;
        const int32_t irregular = g < drape->plan.ngather && drape->plan.gather_node[g] == i;
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        const double rate2 = drape->stiffness[i] / drape->mass[i];
        stiff += drape->stiffness[i];
        heavy += drape->mass[i];
        if (rate2 > all) all = rate2;
        if (!irregular && rate2 > lattice) lattice = rate2;
    }
    if (!(lattice > 0.0) && heavy > 0.0) lattice = stiff / heavy;
    const double reference = scaled ? lattice : all;

    for (int32_t i = 0; i < drape->n; i++) {
        const double mass = drape->mass[i];
        if (mass <= 0.0 || drape->pinned[i]) {
            drape->sim.ops->set_node(&drape->sim, i, 0.0, 0.0);
            continue;
        }
        const double needed = reference > 0.0 ? drape->stiffness[i] / reference : 0.0;
        const double inertia = needed > mass ? needed : mass;
        drape->sim.ops->set_node(&drape->sim, i, 1.0 / inertia, mass / inertia);
    }
    /* h = 2.62 / sqrt(max T/m): proof in the header of mus_drape_step_bound */
    return reference > 0.0 ? 2.62 / sqrt(reference) : 1e9;
}


mus_status mus_drape_set_state(mus_drape *drape, const double *positions, const double *velocities)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (positions == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: positions is NULL");
    for (int64_t i = 0; i < 3 * (int64_t)drape->n; i++)
        if (!mus__finite(positions[i]) || (velocities != NULL && !mus__finite(velocities[i])))
            return mus__fail(drape->context, MUS_ERR_ARG, "drape: the state of node %d is not finite", (int)(i / 3));
    const mus_status status = check_reach(drape, positions);
    if (status != MUS_OK) return status;

    const size_t bytes = 3 * (size_t)drape->n * sizeof *drape->x;
    memcpy(drape->x, positions, bytes);
    if (velocities != NULL) memcpy(drape->v, velocities, bytes);
    else memset(drape->v, 0, bytes);
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->pinned[i]) memset(drape->v + 3 * i, 0, 3 * sizeof *drape->v);
    mus__drape_push(drape);
    mus__drape_publish(drape);
    drape->cold = 1;
    drape->sewn_so = 0;
    return MUS_OK;
}


mus_status mus_drape_set_gravity(mus_drape *drape, const double *gravity)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (gravity == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: gravity is NULL");
    for (int32_t i = 0; i < 3; i++) {
        const mus_status status = check_number(drape->context, "gravity", gravity[i], -MOST_GRAVITY, MOST_GRAVITY);
        if (status != MUS_OK) return status;
    }
    memcpy(drape->def.gravity, gravity, sizeof drape->def.gravity);
    drape->settled = 0;
    mus__drape_stale(drape);
    return MUS_OK;
}


mus_status mus_drape_pin(mus_drape *drape, int32_t node, int32_t fixed)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (node < 0 || node >= drape->n)
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: node %d, expected 0 to %d", (int)node, (int)drape->n - 1);
    drape->pinned[drape->rep[node]] = fixed != 0 ? MUS__PINNED : 0;
    drape->sewn_so = 0;
    if (fixed) {
        memset(drape->v + 3 * (int64_t)drape->rep[node], 0, 3 * sizeof *drape->v);
        mus__drape_push(drape);
        mus__drape_publish(drape);
    }
    mus__drape_stale(drape);
    return MUS_OK;
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


double mus_drape_time(const mus_drape *drape)
{
    return drape != NULL ? drape->time0 + (double)drape->count * drape->dt : 0.0;
}


const char *mus_drape_skipped(const mus_drape *drape)
{
    return drape != NULL ? drape->skipped : "";
}
