/*
 * forces.c: forces and energy in double, written plainly: what residuals and reports are taken of, and the reference
 * that the kernels are tested against.
 *
 *   spring  E = 1/2 k (l - rest)^2       f_a = k (1 - rest/l) (x_b - x_a)
 *   held    E = 1/2 k d^2, d > 0 below its level
 *   bend    E = 1/2 k |a - 2 b + c|^2    hinge  E = 1/2 k |sum c_i x_i|^2
 * Half runs see each lattice spring twice, so their energy is halved; a stencil's energy is taken at its middle.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"

#define TINY_LENGTH 1e-150
#define MUCH_LEFT 0.02     /* of a node's weight */
#define CREASE 0.0005      /* [m] */
#define SIDES_MOST (3 * MUS__TOUCHING_MAX)
#define TOUCH_SLACK 0.0005 /* [m] a node this much beyond the clearance is still held by the skin */


/* adds the pull of one spring to f at a (and, if both, its opposite at b); returns its energy */
static double add_spring(const double *x, int32_t a, int32_t b, double k, double rest, int32_t both, double *f)
{
    const double *p = x + 3 * (int64_t)a, *q = x + 3 * (int64_t)b;
    const double d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const double l = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double pull = k - k * rest / (l + TINY_LENGTH);
    if (f != NULL)
        for (int32_t i = 0; i < 3; i++) {
            f[3 * (int64_t)a + i] += pull * d[i];
            if (both) f[3 * (int64_t)b + i] -= pull * d[i];
        }
    return 0.5 * k * (l - rest) * (l - rest);
}


/* a bend term's force on its owner; returns the energy of the stencil whose middle the owner is */
static double add_bend(const double *x, const mus__half_bend *bend, int32_t at, double *f)
{
    double energy = 0.0;
    for (int32_t i = 0; i < 3; i++) {
        const double a = x[3 * (int64_t)(bend->a + at) + i], b = x[3 * (int64_t)(bend->b + at) + i];
        const double c = x[3 * (int64_t)(bend->c + at) + i];
        const double e = a - 2.0 * b + c;
        if (f != NULL) f[3 * (int64_t)(bend->o + at) + i] += bend->w * e;
        energy += e * e;
    }
    /* the middle's weight is +2k, the ends' -k: each stencil is counted at its middle alone */
    return bend->w > 0.0 ? 0.25 * bend->w * energy : 0.0;
}


static double add_hinge(const double *x, const mus__hinge *hinge, double *f)
{
    double energy = 0.0;
    for (int32_t i = 0; i < 3; i++) {
        double e = 0.0;
        for (int32_t c = 0; c < 4; c++) e += hinge->coef[c] * x[3 * (int64_t)hinge->node[c] + i];
        if (f != NULL)
            for (int32_t c = 0; c < 4; c++) f[3 * (int64_t)hinge->node[c] + i] -= hinge->k * hinge->coef[c] * e;
        energy += e * e;
    }
    return 0.5 * hinge->k * energy;
}


/* a held node below its level is pulled up, at most by `most`; returns the energy */
static double add_held(const mus__plan *plan, const mus__held *held, const double *x, double *f)
{
    const mus__held_level *level = &plan->level[held->level][held->right];
    const double *p = x + 3 * (int64_t)held->node, *up = level->up;
    const double sunk = level->at - held->below - (up[0] * p[0] + up[1] * p[1] + up[2] * p[2]);
    if (!(sunk > 0.0)) return 0.0;
    const double most = held->share * held->most, far = most / held->k, pull = sunk < far ? held->k * sunk : most;
    if (f != NULL)
        for (int32_t i = 0; i < 3; i++) f[3 * (int64_t)held->node + i] += pull * up[i];
    return sunk < far ? 0.5 * held->k * sunk * sunk : most * (sunk - 0.5 * far);
}


double mus__plan_force(const mus__plan *plan, int32_t n, const double *x, double *f)
{
    double energy = 0.0;
    if (f != NULL) memset(f, 0, 3 * (size_t)n * sizeof *f);
    for (int32_t r = 0; r < plan->nhalf_run; r++) {
        const mus__half_run *run = &plan->half_run[r];
        for (int32_t i = 0; i < run->count; i++)
            energy += 0.5 * add_spring(x, run->a + i, run->b + i, run->k, run->rest, 0, f);
    }
    for (int32_t r = 0; r < plan->nhalf_bend; r++)
        for (int32_t i = 0; i < plan->half_bend[r].count; i++) energy += add_bend(x, &plan->half_bend[r], i, f);
    for (int32_t s = 0; s < plan->nspring; s++) {
        const mus__spring *spring = &plan->spring[s];
        energy += add_spring(x, spring->a, spring->b, spring->k, spring->rest, 1, f);
    }
    for (int32_t h = 0; h < plan->nhinge; h++) energy += add_hinge(x, &plan->hinge[h], f);
    for (int32_t h = 0; h < plan->nheld; h++) energy += add_held(plan, &plan->held[h], x, f);
    return energy;
}


/* a spring without length has no strain */
static double strain_of(const double *x, int32_t a, int32_t b, double rest)
{
    if (rest <= 0.0) return 0.0;
    const double *p = x + 3 * (int64_t)a, *q = x + 3 * (int64_t)b;
    const double d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / rest - 1.0;
}


double mus__plan_strain(const mus__plan *plan, const double *x)
{
    double most = 0.0;
    for (int32_t r = 0; r < plan->nhalf_run; r++) {
        const mus__half_run *run = &plan->half_run[r];
        for (int32_t i = 0; i < run->count; i++) {
            const double strain = strain_of(x, run->a + i, run->b + i, run->rest);
            if (strain > most) most = strain;
        }
    }
    for (int32_t s = 0; s < plan->nspring; s++) {
        if (plan->spring[s].kind == MUS__SPRING_ELASTIC) continue;
        const double strain = strain_of(x, plan->spring[s].a, plan->spring[s].b, plan->spring[s].rest);
        if (strain > most) most = strain;
    }
    return most;
}


static double length3(const double *r)
{
    return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}


/*
 * What skin in contact carries of the force r at a node: pushes p_k >= 0 along the outward normals n_k that leave the
 * least (projected Gauss-Seidel on |r + sum p_k n_k|), then friction against what is left, up to mu sum p_k. The rest
 * stays in r. Surfaces without a friction of their own (below 0) have `friction`.
 */
static void carry(double *r, const double *normals, const double *own, int32_t count, double friction)
{
    double push[SIDES_MOST] = {0.0}, all = 0.0, grip = 0.0;
    for (int32_t sweep = 0; sweep < (count > 1 ? 32 : 1); sweep++)
        for (int32_t k = 0; k < count; k++) {
            const double *n = normals + 3 * k;
            const double more = -(r[0] * n[0] + r[1] * n[1] + r[2] * n[2]);
            const double now = push[k] + more > 0.0 ? push[k] + more : 0.0, change = now - push[k];
            push[k] = now;
            for (int32_t i = 0; i < 3; i++) r[i] += change * n[i];
        }
    for (int32_t k = 0; k < count; k++) {
        if (own[k] < 0.0) all += push[k];
        else if (push[k] > 0.0) grip += own[k] * push[k];
    }
    if (all > 0.0) grip += friction * all;
    const double left = length3(r);
    const double part = left > grip ? (left - grip) / left : 0.0;
    for (int32_t i = 0; i < 3; i++) r[i] *= part;
}


/*
 * What the skin carries of the force r at a node; nonzero when it touches skin. A node on an edge or in a crease of the
 * skin (between two rings of a shoulder) is held by both sides, of which it touches one: where much of the force is
 * left, the skin a little way along it and against it is asked too.
 */
static int32_t carry_by_skin(const mus_drape *drape, const double *x, double weight, double *r)
{
    double normal[3 * SIDES_MOST], friction[SIDES_MOST], all[3];
    const double reach = drape->def.clearance + TOUCH_SLACK;
    const int32_t count = mus__collider_touching(drape->collider, x, reach, normal, friction);
    if (count == 0) return 0;
    memcpy(all, r, sizeof all);
    carry(r, normal, friction, count, drape->friction);
    const double left = length3(r);
    if (left <= MUCH_LEFT * weight) return 1;
    int32_t sides = count;
    for (int32_t side = -1; side <= 1; side += 2) {
        double beside[3];
        for (int32_t d = 0; d < 3; d++) beside[d] = x[d] + side * CREASE * r[d] / left;
        sides += mus__collider_touching(drape->collider, beside, reach, normal + 3 * (int64_t)sides, friction + sides);
    }
    memcpy(r, all, sizeof all);
    carry(r, normal, friction, sides, drape->friction);
    return 1;
}


double mus__drape_residual(const mus_drape *drape, const double *x, double *unheld)
{
    const double *gravity = drape->def.gravity;
    const double g = sqrt(gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    double *f = drape->force, sum = 0.0, free2 = 0.0;
    int64_t count = 0, nfree = 0;
    mus__plan_force(&drape->plan, drape->n, x, f);
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        double *r = f + 3 * (int64_t)i;
        const double weight = drape->mass[i] * (g > 0.0 ? g : 9.81);
        for (int32_t d = 0; d < 3; d++) r[d] += drape->mass[i] * gravity[d];
        int32_t touches = mus__drape_self_force(drape, i, r);
        if (drape->collider != NULL) touches |= carry_by_skin(drape, x + 3 * (int64_t)i, weight, r);
        const double left2 = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) / (weight * weight);
        sum += left2;
        count++;
        free2 += touches ? 0.0 : left2;
        nfree += !touches;
    }
    if (unheld != NULL) *unheld = nfree > 0 ? sqrt(free2 / (double)nfree) : 0.0;
    return count > 0 ? sqrt(sum / (double)count) : 0.0;
}


double mus__drape_gap(const mus_drape *drape, int32_t *seam)
{
    const mus_cloth *cloth = drape->cloth;
    const int32_t waits = drape->plan.wait_from;
    double most = 0.0;
    if (seam != NULL) *seam = MUS_NONE;
    for (int32_t p = 0; p < cloth->npair; p++) {
        if (waits > 0 && mus__cloth_layer(cloth, cloth->pair[2 * p]) >= waits) continue;
        const double *a = drape->x + 3 * (int64_t)cloth->pair[2 * p],
                     *b = drape->x + 3 * (int64_t)cloth->pair[2 * p + 1];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double gap = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (gap <= most && p > 0) continue;
        most = gap;
        if (seam != NULL) *seam = cloth->pair_seam[p];
    }
    return most;
}


mus_status mus_drape_forces(const mus_drape *drape, double *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: out is NULL");
    mus__plan_force(&drape->plan, drape->n, drape->x, out);
    for (int32_t i = 0; i < drape->n; i++)
        for (int32_t d = 0; d < 3; d++) out[3 * (int64_t)i + d] += drape->mass[i] * drape->def.gravity[d];
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->rep[i] != i) memcpy(out + 3 * (int64_t)i, out + 3 * (int64_t)drape->rep[i], 3 * sizeof *out);
    return MUS_OK;
}
