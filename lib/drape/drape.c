/*
 * drape.c: the life of a drape: its def, create, destroy.
 *
 * Where a stranger starts. A drape is a cloth in time; its data is in drape_state.h and the parts that this includes.
 * mus_drape_create() (here) makes the force program and the sim (lib/sim), the scene (scene.c) and self-contact
 * (drape_self.c). mus_drape_place() (drape_positions.c) puts the nodes where the panels start (lib/arrange).
 * mus_drape_step() (step.c) steps by hand; cost_estimate.c tells the cost before. Sewing and settling are runs over
 * these (lib/dress); they use weld.c, coarse_drape.c and residual.c. drape_report.c tells what was done.
 *
 * All memory that stepping needs is taken here.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_nodes.h"
#include "cloth/fabric.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "drape/weld.h"

#define LEAST_THICKNESS 1e-5 /* [m] a hundred times the rounding of a metre in float */
#define MOST_GRAVITY 1e4     /* [m/s2] a thousand g */


void mus_drape_def_init(mus_drape_def *def, size_t size)
{
    mus_drape_def own = {0};
    own.gravity[1] = -MUS__GRAVITY;
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
    own.progress_seconds = 0.1;
    mus__def_init(def, size, &own, sizeof own);
}


/* MUS_ERR_ARG when a number of a def is not within low..high */
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
    if (status == MUS_OK && def->precision != 0 && def->precision != 32 && def->precision != 64)
        status = mus__fail(context, MUS_ERR_ARG, "drape: precision is %d, expected 0, 32 or 64", (int)def->precision);
    if (status == MUS_OK && def->integrator != MUS_METHOD_RK4 && def->integrator != MUS_METHOD_VERLET)
        status = mus__fail(context, MUS_ERR_ARG, "drape: integrator is %d, expected %d or %d", (int)def->integrator,
                           MUS_METHOD_RK4, MUS_METHOD_VERLET);
    if (status == MUS_OK) status = check_number(context, "collision_distance", def->collision_distance, 1e-6, 0.05);
    if (status == MUS_OK) status = check_number(context, "clearance", def->clearance, 0.0, 0.05);
    if (status == MUS_OK && !isnan(def->friction) && def->friction != INFINITY)
        status = check_number(context, "friction", def->friction, 0.0, 1e6);
    if (status == MUS_OK) status = check_number(context, "contact_ball", def->contact_ball, 0.0, 0.001);
    if (status == MUS_OK) status = check_number(context, "drag", def->drag, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "seam_pull", def->seam_pull, 1e-3, 1e5);
    if (status == MUS_OK) status = check_number(context, "sew_seconds", def->sew_seconds, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "settle_seconds", def->settle_seconds, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "progress_seconds", def->progress_seconds, 0.0, 1e4);
    if (status == MUS_OK) status = check_number(context, "settle_residual", def->settle_residual, 1e-12, 10.0);
    if (status == MUS_OK) status = check_number(context, "thickness", def->thickness, LEAST_THICKNESS, 0.05);
    if (status == MUS_OK && !isnan(def->self_friction) && def->self_friction != INFINITY)
        status = check_number(context, "self_friction", def->self_friction, 0.0, 1e6);
    return status;
}


/* takes the arrays of the drape and of its sim */
static mus_status take_memory(mus_drape *drape)
{
    mus_context *context = drape->context;
    const int64_t n = drape->n;
    mus__sim *sim = &drape->sim;
    sim->nodes = drape->n;
    sim->n = (drape->n + MUS__LANES - 1) / MUS__LANES * MUS__LANES;
    sim->program = &drape->program;
    drape->x = mus__new(context, 3 * n, sizeof *drape->x);
    drape->v = mus__new(context, 3 * n, sizeof *drape->v);
    drape->relax.force = mus__new(context, 3 * n, sizeof *drape->relax.force);
    drape->stepping.tangent = mus__new(context, 6 * n, sizeof *drape->stepping.tangent);
    drape->stepping.dashpot = mus__new(context, drape->program.dashpots ? n : 0, sizeof *drape->stepping.dashpot);
    drape->mass = mus__new(context, n, sizeof *drape->mass);
    drape->stepping.stiffness = mus__new(context, n, sizeof *drape->stepping.stiffness);
    drape->rep = mus__new(context, n, sizeof *drape->rep);
    drape->pinned = mus__new(context, n, sizeof *drape->pinned);
    if (drape->x == NULL || drape->v == NULL || drape->relax.force == NULL || drape->stepping.tangent == NULL ||
        drape->stepping.dashpot == NULL || drape->mass == NULL || drape->stepping.stiffness == NULL ||
        drape->rep == NULL || drape->pinned == NULL)
        return mus__fail_memory(context, "the state of a drape");
    return mus__sim_create(context, sim);
}


/* the origin of a float state: the mean place of the nodes before sewing, to the centimetre */
static mus_status choose_origin(mus_drape *drape)
{
    if (drape->def.precision != 32 || drape->n == 0) return MUS_OK;
    mus__arrange_nodes(drape->cloth, drape->x);
    for (int32_t d = 0; d < 3; d++) {
        double sum = 0.0;
        for (int32_t i = 0; i < drape->n; i++) sum += drape->x[3 * (int64_t)i + d];
        drape->sim.origin[d] = floor(100.0 * sum / drape->n) / 100.0;
    }
    return mus__drape_check_reach(drape, drape->x);
}


/* takes collider and threads of the parent, or makes new ones */
static mus_status take_surroundings(mus_drape *drape, const mus_body *body)
{
    const mus_drape *parent = drape->coarse.parent;
    if (parent != NULL) {
        memcpy(drape->sim.origin, parent->sim.origin, sizeof drape->sim.origin);
        drape->pool = parent->pool;
        drape->scene.collider = parent->scene.collider;
        drape->sim.collider = parent->scene.collider;
        drape->sim.contact_pass = parent->sim.contact_pass;
        drape->sim.plane_cache_pass = parent->sim.plane_cache_pass;
        return MUS_OK;
    }
    mus_status status = mus__pool_create(drape->context, drape->def.threads, &drape->pool);
    if (status == MUS_OK) status = choose_origin(drape);
    if (status == MUS_OK && body != NULL) status = drape->kit->add_body(drape, body);
    return status;
}


/* the nodes flat in their panels' planes */
static void lay_flat(mus_drape *drape)
{
    for (int32_t i = 0; i < drape->n; i++) {
        double *x = drape->x + 3 * (int64_t)i;
        x[0] = drape->cloth->rest[2 * (int64_t)i], x[1] = drape->cloth->rest[2 * (int64_t)i + 1], x[2] = 0.0;
    }
}


mus_status mus__drape_make(mus_context *context, const mus_cloth *cloth, const mus_body *body, mus_drape *parent,
                           const mus_drape_def *def, const struct mus__drape_kit *kit, mus_drape **out)
{
    *out = NULL;
    mus_drape *drape = mus__new(context, 1, sizeof *drape);
    if (drape == NULL) return mus__fail_memory(context, "a drape");
    drape->context = context;
    drape->def = *def;
    if (def->precision == 0) drape->def.precision = 32;
    drape->n = cloth->nnode;
    drape->coarse.parent = parent;
    drape->kit = kit;
    drape->cloth = mus__cloth_retain(cloth);
    drape->scene.friction = isnan(def->friction) ? cloth->fabric.friction : def->friction;
    drape->sim.ops = drape->def.precision == 64 ? kit->doubles : kit->single;
    mus_status status = mus__program_build(context, cloth, drape->sim.ops->real, &drape->program);
    if (status == MUS_OK) status = take_memory(drape);
    if (status == MUS_OK) lay_flat(drape);
    if (status == MUS_OK && def->precision == 0 && kit->doubles != NULL && mus__float_too_coarse(drape)) {
        mus_drape_def fine = *def;
        fine.precision = 64;
        mus_drape_destroy(drape);
        return mus__drape_make(context, cloth, body, parent, &fine, kit, out);
    }
    if (status == MUS_OK) status = take_surroundings(drape, body);
    if (status == MUS_OK && def->contact_ball > 0.0) status = mus__drape_plane_cache(drape);
    if (status == MUS_OK && def->self_contact) status = kit->add_self(drape);
    drape->sim.plane_cache = NULL;
    if (status != MUS_OK) {
        mus_drape_destroy(drape);
        return status;
    }

    mus__sim *sim = &drape->sim;
    sim->pool = drape->pool;
    sim->collision_distance = def->collision_distance;
    mus__drape_name_skipped(drape);

    /* flat until placed; nodes of a mass-spring network at their place, their pins fixed */
    lay_flat(drape);
    if (cloth->place != NULL) mus__arrange_nodes(cloth, drape->x);
    for (int32_t i = 0; i < cloth->npin; i++) drape->pinned[cloth->pin[i]] = 1;
    drape->relax.far = 1;
    drape->coarse.as_sewn = 0;
    mus_reason_init(&drape->reason, sizeof drape->reason);
    mus_reason_init(&drape->start, sizeof drape->start);
    mus__scene_levels_update(drape);
    mus__weld_open(drape);
    mus__drape_push(drape);
    *out = drape;
    return MUS_OK;
}


/* a drape made with the parts of a kit */
static mus_status create_with(mus_context *context, const mus_cloth *cloth, const mus_body *body,
                              const mus_drape_def *def, const struct mus__drape_kit *kit, mus_drape **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (out == NULL || cloth == NULL) return mus__fail(context, MUS_ERR_ARG, "drape: cloth or out is NULL");
    mus_drape_def own;
    mus_drape_def_init(&own, sizeof own);
    mus_status status = mus__def_read(context, &own, sizeof own, MUS__DRAPE_DEF_FIRST, def, "mus_drape_def");
    if (status == MUS_OK) status = check_def(context, &own);
    if (status == MUS_OK && cloth->npair > 0 && cloth->spacing > 0.0 && own.collision_distance > cloth->spacing)
        status =
            mus__fail(context, MUS_ERR_ARG, "drape: collision_distance is %g m, expected at most the spacing, %g m",
                      own.collision_distance, cloth->spacing);
    if (status == MUS_OK && own.precision == 64 && kit->doubles == NULL)
        status = mus__fail(context, MUS_ERR_ARG, "drape: precision 64 needs mus_drape_create");
    if (status == MUS_OK && own.self_contact && kit->add_self == NULL)
        status = mus__fail(context, MUS_ERR_ARG, "drape: self_contact needs mus_drape_create");
    return status == MUS_OK ? mus__drape_make(context, cloth, body, NULL, &own, kit, out) : status;
}


mus_status mus_drape_create(mus_context *context, const mus_cloth *cloth, const mus_body *body,
                            const mus_drape_def *def, mus_drape **out)
{
    static const struct mus__drape_kit all = {&mus__sim_f32, &mus__sim_f64, mus__scene_add_body,
                                              mus__drape_self_create};
    return create_with(context, cloth, body, def, &all, out);
}


mus_status mus_drape_create_plain(mus_context *context, const mus_cloth *cloth, const mus_drape_def *def,
                                  mus_drape **out)
{
    static const struct mus__drape_kit plain = {&mus__sim_f32, NULL, NULL, NULL};
    return create_with(context, cloth, NULL, def, &plain, out);
}


void mus_drape_destroy(mus_drape *drape)
{
    if (drape == NULL) return;
    mus_context *context = drape->context;
    if (drape->coarse.destroy != NULL) drape->coarse.destroy(drape);
    if (drape->coarse.parent == NULL) {
        mus__pool_destroy(drape->pool);
        mus__collider_destroy(drape->scene.collider);
    }
    if (drape->self != NULL) drape->self_ops->destroy(drape->self);
    mus__program_clear(context, &drape->program);
    mus_cloth_destroy(drape->cloth);
    mus__sim_destroy(context, &drape->sim);
    void *blocks[] = {drape->x,
                      drape->v,
                      drape->mass,
                      drape->rep,
                      drape->pinned,
                      drape->plane_cache,
                      drape->chord_lift.lift,
                      drape->chord_lift.gap,
                      drape->scene.plane,
                      drape->scene.body,
                      drape->stepping.stiffness,
                      drape->stepping.tangent,
                      drape->stepping.dashpot,
                      drape->relax.mean,
                      drape->relax.tensor,
                      drape->relax.force,
                      drape->relax.component,
                      drape->sewing.start_x};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    mus__free(context, drape);
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
    drape->relax.settled = 0;
    mus__drape_stale(drape);
    return MUS_OK;
}
