/*
 * inertia.c: inertia tensors of nodes in relaxation. A shape at rest does not depend on inertia, so inertia may be
 * chosen such that one step suits all nodes and all directions.
 *
 * A diagonal bound T of the stiffness K (step_bound.c) has u K u <= u T u for every motion u, so with M = T / rate2 no
 * motion is quicker than sqrt(rate2). The scalar inertia of a node is the largest eigenvalue of its T over rate2. Its
 * tensor is T / rate2 itself: along the sheet a node is as heavy as its springs are stiff, across the sheet as light
 * as bending and tension leave it (a block Jacobi preconditioner, in place of an implicit step; Underwood, Dynamic
 * relaxation, in: Computational Methods for Transient Analysis, 1983, has the diagonal form).
 *
 * Friction on a surface compares impulses across and along it, which stand for forces only where the inertia is a
 * scalar. So nodes that a surface may touch before the tensors are taken anew keep the scalar.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"
#include "sim/step_bound.h"

/* [m] from surfaces, from which on a node has a tensor; chosen: the way of a node between two calls in
 * a settle near rest, with room. A node that comes nearer between two calls is answered with its scalar */
#define TENSOR_CLEAR 2e-3
/* share of the trace of T added in all directions, because the sheet turns until the tensors are taken anew; chosen:
 * 0.003 diverged on cotton, from 0.01 on all cloths were stable, and steps grow with it */
#define TENSOR_TURN 0.03


/* the inverse of a symmetric matrix m, both as xx, yy, zz, xy, yz, zx */
static void invert_symmetric(const double *m, double *out)
{
    const double a = m[1] * m[2] - m[4] * m[4], b = m[5] * m[4] - m[3] * m[2], c = m[3] * m[4] - m[5] * m[1];
    const double over = 1.0 / (m[0] * a + m[3] * b + m[5] * c);
    out[0] = over * a;
    out[1] = over * (m[0] * m[2] - m[5] * m[5]);
    out[2] = over * (m[0] * m[1] - m[3] * m[3]);
    out[3] = over * b;
    out[4] = over * (m[3] * m[5] - m[0] * m[4]);
    out[5] = over * c;
}


/* the tensor of a node, T / rate2, from its bound of springs `t` (6) and the isotropic rest, and its inverse */
static void node_tensor(const double *t, double isotropic, double rate2, double *tensor, double *inverse)
{
    const double all = isotropic + TENSOR_TURN * (t[0] + t[1] + t[2]);
    for (int32_t k = 0; k < 6; k++) tensor[k] = (t[k] + (k < 3 ? all : 0.0)) / rate2;
    invert_symmetric(tensor, inverse);
}


void mus__drape_tensors(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    const double rate2 = drape->relax.rate2;
    double *isotropic = drape->relax.bending;
    sim->ops->get(sim, drape->x, drape->v);
    mus__program_stiffness_at(&drape->program, drape->n, drape->x, drape->stepping.stiffness, drape->stepping.tangent);
    mus__program_stiffness_bending(&drape->program, drape->n, isotropic);
    for (int32_t i = 0; i < drape->n; i++) {
        const double mass = drape->mass[i], needed = drape->stepping.stiffness[i] / rate2;
        const double scalar = needed > mass ? needed : mass;
        double *tensor = drape->relax.inertia + 6 * (int64_t)i, inverse[6] = {0.0};
        memset(tensor, 0, 6 * sizeof *tensor);
        if (mass <= 0.0 || drape->pinned[i]) {
            sim->ops->set_tensor(sim, i, inverse, 0.0);
            continue;
        }
        sim->ops->set_node(sim, i, 1.0 / scalar, mass / scalar);
        if (sim->ops->clear_of(sim, i) > TENSOR_CLEAR)
            node_tensor(drape->stepping.tangent + 6 * (int64_t)i, isotropic[i], rate2, tensor, inverse);
        else
            for (int32_t k = 0; k < 3; k++) tensor[k] = scalar, inverse[k] = 1.0 / scalar;
        sim->ops->set_tensor(sim, i, inverse, mass);
    }
}
