/*
 * residual.c: the force that springs, gravity, contact and friction leave at each node, over the node's weight.
 *
 * What the skin carries is worked out from the place of a node: pushes along the normals there, and friction of
 * Coulomb. Steps met a plane that may lie a degree off, and a node wedged between surfaces may bear thousands of its
 * weight, of which a degree leaves many. Newton's law tells what all contacts together have left of it in the last
 * steps: inertia times mean acceleration, and what drag took. So a node that touches has the lesser of the two left.
 */
#include <math.h>
#include <string.h>

#include "cloth/fabric.h"
#include "contact/contact_template.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "geom/vec.h"
#include "sim/force_reference.h"

#define LEFT_MUCH 0.02 /* of a node's weight: with more force left, the surfaces beside the node are included */
#define CREASE                                                                                                         \
    0.0005 /* [m] how far to each side they are looked for; chosen: below the radius of any crease of a skin */
#define SIDES_MAX (3 * MUS__TOUCHING_MAX)
#define LIFT_SLACK 0.1     /* of a lift, likewise: distances are of first order, 6 % too large at a shoulder */
#define TOUCH_SLACK 0.0005 /* [m] a node this far beyond the clearance still counts as carried by the skin */


/* length of a vector (3) */
static double length3(const double *r)
{
    return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}


/*
 * Takes from the force r (3) [N] at a node what the surfaces that it touches carry; the rest stays in r. First pushes
 * p_k >= 0 along the outward normals n_k (count x 3), by projected Gauss-Seidel on |r + sum p_k n_k|; then friction
 * against the force that is left, at most mu sum p_k. A surface whose own friction is below 0 has `friction`.
 */
static void carry(double *r, const double *normals, const double *own, int32_t count, double friction)
{
    double push[SIDES_MAX] = {0.0}, all = 0.0, grip = 0.0;
    for (int32_t sweep = 0; sweep < (count > 1 ? 32 : 1); sweep++)
        for (int32_t k = 0; k < count; k++) {
            const double *n = normals + 3 * k;
            const double more = -(r[0] * n[0] + r[1] * n[1] + r[2] * n[2]);
            const double now = push[k] + more > 0.0 ? push[k] + more : 0.0, change = now - push[k];
            push[k] = now;
            for (int32_t i = 0; i < 3; i++) r[i] += change * n[i];
        }
    for (int32_t k = 0; k < count; k++) {
        if (own[k] < 0.0)
            all += push[k];
        else if (push[k] > 0.0)
            grip += own[k] * push[k];
    }
    if (all > 0.0) grip += friction * all;
    const double part = mus__friction_keep_f64(length3(r), grip);
    for (int32_t i = 0; i < 3; i++) r[i] *= part;
}


/*
 * Takes from the force r (3) at a node at x what the skin carries; returns nonzero when the node touches skin. A node
 * on an edge or in a crease of the skin (between two rings of a shoulder) is carried by both sides and touches one. So
 * where much force is left, the surfaces a little way along the force and against it are included.
 */
static int32_t carry_by_skin(const mus_drape *drape, const double *x, double lift, double weight, double *r)
{
    double normal[3 * SIDES_MAX], friction[SIDES_MAX], all[3];
    const double reach = drape->def.clearance + lift + TOUCH_SLACK + LIFT_SLACK * lift;
    const int32_t count = mus__collider_touching(drape->scene.collider, x, reach, normal, friction);
    if (count == 0) return 0;
    memcpy(all, r, sizeof all);
    carry(r, normal, friction, count, drape->scene.friction);
    const double left = length3(r);
    if (left <= LEFT_MUCH * weight) return 1;
    int32_t sides = count;
    for (int32_t side = -1; side <= 1; side += 2) {
        double beside[3];
        for (int32_t d = 0; d < 3; d++) beside[d] = x[d] + side * CREASE * r[d] / left;
        sides +=
            mus__collider_touching(drape->scene.collider, beside, reach, normal + 3 * (int64_t)sides, friction + sides);
    }
    memcpy(r, all, sizeof all);
    carry(r, normal, friction, sides, drape->scene.friction);
    return 1;
}


double mus__drape_lift(const mus_drape *drape, int32_t i)
{
    return drape->chord_lift.lift != NULL ? (double)drape->chord_lift.lift[drape->rep[i]] : 0.0;
}


void mus__drape_lift_clear(mus_drape *drape)
{
    mus__free(drape->context, drape->chord_lift.lift);
    mus__free(drape->context, drape->chord_lift.gap);
    drape->chord_lift = (mus__chord_lift_data){NULL, NULL, NULL, NULL, NULL};
    drape->sim.lift = NULL;
    if (drape->coarse.drape != NULL) mus__drape_lift_clear(drape->coarse.drape);
}


double mus__residual(const mus_drape *drape, const double *x)
{
    const double *gravity = drape->def.gravity, g = length3(gravity);
    const double *moving = drape->relax.moving, allowed = drape->def.settle_residual;
    double *f = drape->relax.force, sum = 0.0;
    int64_t count = 0;
    mus__program_force(&drape->program, drape->n, x, f);
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        double *r = f + 3 * (int64_t)i;
        const double weight = drape->mass[i] * (g > 0.0 ? g : MUS__GRAVITY);
        for (int32_t d = 0; d < 3; d++) r[d] += drape->mass[i] * gravity[d];
        int32_t touches = mus__drape_self_force(drape, i, r);
        if (drape->scene.collider != NULL)
            touches |= carry_by_skin(drape, x + 3 * (int64_t)i, mus__drape_lift(drape, i), weight, r);
        double left2 = mus__dot3(r, r) / (weight * weight);
        if (touches && left2 > allowed * allowed && x == drape->relax.mean)
            left2 = fmin(left2, mus__dot3(moving + 3 * (int64_t)i, moving + 3 * (int64_t)i) / (weight * weight));
        sum += left2;
        count++;
    }
    return count > 0 ? sqrt(sum / (double)count) : 0.0;
}
