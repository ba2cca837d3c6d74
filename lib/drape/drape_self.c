/*
 * drape_self.c: self-contact (cloth against cloth) as a drape uses it: made when the def asks for it, told of welds,
 * asked for its forces.
 *
 * Contact acts by impulses after each step, so the force program knows nothing of it. The impulses that it gave a node
 * over some steps, divided by their time, are the mean force that a residual includes: at rest it carries what springs,
 * weight and skin leave.
 */
#include <math.h>
#include <string.h>

#include "selfcontact/crossing_count.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "geom/vec.h"
#include "sim/force_program_constants.h"

#define SELF_PUSH_SPEED 0.5 /* [m/s] overlapping pairs part no faster; chosen: below the speed of falling cloth */
#define SELF_THICKEST 0.5   /* of the spacing: the largest thickness */
#define SELF_DEEP 0.7e-3    /* [m] depth in the body from which on thickness yields; see also self_no_room() */
#define SELF_FROZEN 1e-6    /* [m] a node with a smaller displacement bound cannot move */
#define SELF_LINGERS 1e-3   /* [m] between two checks: a deep node that moves farther mostly comes out by itself */


/* takes the triangles of the open or welded cloth */
static void self_weld(mus_drape *drape)
{
    mus__self_contact_weld(drape->self, drape->welded ? drape->rep : NULL, drape->pinned, MUS__WAITS);
}


/* the rule of steps of `h`; finds the pairs anew where displacement bounds do not hold so long */
static void self_rule(mus_drape *drape, double h)
{
    mus__sim *sim = &drape->sim;
    sim->self_rule = (mus__self_rule){
        .step = h, .slip = sim->rule.slip, .push = SELF_PUSH_SPEED * h, .body = drape->scene.collider != NULL};
    if (sim->self == NULL || sim->self->invalid || !mus__self_contact_expires(sim->self, h)) return;
    sim->self->invalid = 1;
    sim->ops->find_pairs(sim);
}


/* lets self-contact act from now on: finds the pairs, and takes capacity for them */
static mus_status self_ready(mus_drape *drape, double h)
{
    mus__self_contact *self = drape->self;
    if (drape->sim.self == NULL) self->invalid = 1;
    drape->sim.self = self;
    self_rule(drape, h);
    if (self->invalid || self->ncrossed > 0) {
        mus__drape_publish(drape);
        mus__self_contact_mark_crossings(self, drape->x, NULL, NULL);
    }

    /* capacity for the pairs that there are, and as many again */
    mus_status status = MUS_OK;
    do {
        drape->sim.ops->find_pairs(&drape->sim);
        status = mus__self_contact_grow(self);
    } while (status == MUS_OK && self->invalid);
    return status;
}


static const struct mus__self_ops self_ops = {mus__self_contact_destroy, self_weld, self_ready, self_rule};


mus_status mus__drape_self_create(mus_drape *drape)
{
    const mus_cloth *cloth = drape->cloth;
    const mus_drape_def *def = &drape->def;
    if (!def->self_contact || cloth->ntriangle == 0) return MUS_OK;
    if (cloth->spacing > 0.0 && def->thickness > SELF_THICKEST * cloth->spacing)
        return mus__fail(drape->context, MUS_ERR_ARG,
                         "drape: thickness is %g m, expected at most half the spacing, %g m", def->thickness,
                         SELF_THICKEST * cloth->spacing);
    const double friction = isnan(def->self_friction) ? cloth->fabric.friction : fmin(def->self_friction, 1e15);
    const mus__self_mesh flat = {drape->n,    cloth->ntriangle,  cloth->npair, cloth->triangle,
                                 cloth->rest, cloth->node_panel, cloth->pair};
    const mus_status status = mus__self_contact_create(drape->context, drape->sim.ops->real, drape->sim.n, &flat,
                                                       def->thickness, friction, &drape->self);
    if (status != MUS_OK) return status;
    const bool single = drape->sim.ops->real == sizeof(float);
    drape->self_ops = &self_ops;
    drape->sim.self_pass = single ? (mus__self_fn)mus__self_contact_pass_f32 : (mus__self_fn)mus__self_contact_pass_f64;
    drape->sim.self_prepare =
        single ? (mus__self_fn)mus__self_contact_prepare_f32 : (mus__self_fn)mus__self_contact_prepare_f64;
    return MUS_OK;
}


mus_status mus__drape_self_fits(const mus_drape *drape)
{
    if (drape->sim.self == NULL || !drape->self->full) return MUS_OK;
    return mus__fail(drape->context, MUS_ERR_LIMIT,
                     "drape: more than %d pairs of cloth and cloth are near each other; they are held where they are, "
                     "and the next call has room for twice as many",
                     (int)drape->self->pair_capacity);
}


void mus__drape_self_forget(mus_drape *drape)
{
    if (drape->self == NULL) return;
    memset(drape->self->force, 0, 3 * (size_t)drape->sim.n * drape->sim.ops->real);
    drape->sim.self_time = 0.0;
}


int32_t mus__drape_self_force(const mus_drape *drape, int32_t i, double *force)
{
    const mus__sim *sim = &drape->sim;
    int32_t touches = 0;
    if (drape->self == NULL || !(sim->self_time > 0.0)) return 0;
    for (int64_t d = 0; d < 3; d++) {
        const double own = mus__program_get(&drape->program, drape->self->force, d * sim->n + i) / sim->self_time;
        force[d] += own;
        touches |= own != 0.0;
    }
    return touches;
}


/* whether cloth that touches node i, at x (3), has no room beside it: the node is pressed into the body, or surfaces
 * face each other there that are nearer than another layer is thick */
static bool self_no_room(const mus_drape *drape, int32_t i, const double *x)
{
    const mus__collider *collider = drape->scene.collider;
    const double reach = drape->def.clearance + 2.0 * (double)drape->self->thick_max[i];
    return mus__collider_depth(collider, x, 0.0, NULL) > SELF_DEEP || mus__collider_pinches(collider, x, reach);
}


int32_t mus__drape_self_give_way(mus_drape *drape)
{
    mus__self_contact *self = drape->self;
    if (self == NULL || drape->scene.collider == NULL) return 0;
    for (int32_t i = 0; i < drape->n; i++) {
        const double *x = drape->relax.mean + 3 * (int64_t)i, *was = drape->relax.before + 3 * (int64_t)i;
        const double way[3] = {x[0] - was[0], x[1] - was[1], x[2] - was[2]};
        double force[3] = {0.0};
        self->stale[i] = drape->mass[i] > 0.0 && mus__norm3(way) < SELF_LINGERS &&
                         mus__drape_self_force(drape, i, force) && self_no_room(drape, i, x);
    }
    return mus__self_contact_yield(self, self->stale);
}


int32_t mus__drape_self_frozen(const mus_drape *drape)
{
    int32_t frozen = 0;
    if (drape->self == NULL) return 0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->rep[i] != i || drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        frozen +=
            mus__program_get(&drape->program, drape->self->bound, 3 * drape->sim.n + i) < SELF_FROZEN * SELF_FROZEN;
    }
    return frozen;
}


void mus__drape_self_report(const mus_drape *drape, mus_drape_report *report)
{
    if (drape->self == NULL) return;
    for (const mus_drape *cut = drape; cut != NULL; cut = cut->coarse.drape)
        if (cut->self != NULL) report->self_queries += cut->self->responses + cut->self->measured;
    report->self_contacts = drape->self->close;
}


mus_status mus_drape_crossings(const mus_drape *drape, int32_t most, int32_t *pairs, int64_t *count)
{
    if (count != NULL) *count = 0;
    if (drape == NULL) return MUS_ERR_ARG;
    if (count == NULL || most < 0 || (most > 0 && pairs == NULL))
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: crossings: %s",
                         count == NULL ? "count is NULL"
                         : most < 0    ? "most is below 0"
                                       : "pairs is NULL");
    const mus__placed_cloth placed = mus__drape_placed(drape);
    return mus__placed_crossings(&placed, most, pairs, count);
}
