/*
 * force_reference.c: forces, energy and strain of a force program in double, written plainly.
 *
 *   spring      E = 1/2 k (l - rest)^2       f_a = k (1 - rest/l) (x_b - x_a)
 *   attachment  E = 1/2 k d^2, d > 0 the depth below its level plane, linear from the largest force on
 *   bend        E = 1/2 k |a - 2 b + c|^2    hinge  E = 1/2 k |sum c_i x_i|^2
 *
 *   slider      E = 1/2 k |e - slip|^2, of which 1/2 k |e|^2 stands in its bend or hinge
 *   cell        as in contraction.h
 *
 * Half runs hold each lattice spring twice, so their energy is halved. The energy of a bending stencil is taken at its
 * middle node.
 */
#include <math.h>
#include <string.h>

#include "sim/bend_clamp.h"
#include "sim/bend_slider.h"
#include "sim/contraction.h"
#include "sim/force_reference.h"

#define TINY_LENGTH 1e-150 /* [m] added to a length that divides, so that coincident nodes give 0 and not NaN */


/* adds the pull of one spring to f at a and, if `both`, the opposite at b; returns its energy */
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


/* adds the force of a half bend on its own node; returns the energy of the stencil if that node is its middle, else 0
 */
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


/* adds the upward pull of an attachment whose node is below its level plane; returns its energy */
static double add_attachment(const mus__program *program, const mus__attachment *attachment, const double *x, double *f)
{
    const mus__level_plane *level = &program->level[attachment->level][attachment->right];
    const double *p = x + 3 * (int64_t)attachment->node, *up = level->up;
    const double sunk = level->at - attachment->below - (up[0] * p[0] + up[1] * p[1] + up[2] * p[2]);
    if (!(sunk > 0.0)) return 0.0;
    const double most = attachment->share * attachment->most, far = most / attachment->k,
                 pull = sunk < far ? attachment->k * sunk : most;
    if (f != NULL)
        for (int32_t i = 0; i < 3; i++) f[3 * (int64_t)attachment->node + i] += pull * up[i];
    return sunk < far ? 0.5 * attachment->k * sunk * sunk : most * (sunk - 0.5 * far);
}


double mus__program_force(const mus__program *program, int32_t n, const double *x, double *f)
{
    double energy = 0.0;
    if (f != NULL) memset(f, 0, 3 * (size_t)n * sizeof *f);
    for (int32_t r = 0; r < program->nhalf_run; r++) {
        const mus__half_run *run = &program->half_run[r];
        for (int32_t i = 0; i < run->count; i++)
            energy += 0.5 * add_spring(x, run->a + i, run->b + i, run->k, run->rest, 0, f);
    }
    for (int32_t r = 0; r < program->nhalf_bend; r++)
        for (int32_t i = 0; i < program->half_bend[r].count; i++) energy += add_bend(x, &program->half_bend[r], i, f);
    for (int32_t s = 0; s < program->nspring; s++) {
        const mus__spring *spring = &program->spring[s];
        energy += add_spring(x, spring->a, spring->b, spring->k, spring->rest, 1, f);
    }
    for (int32_t h = 0; h < program->nhinge; h++) energy += add_hinge(x, &program->hinge[h], f);
    energy += mus__clamps_force(program, x, f) + mus__sliders_force(program, x, f);
    energy += mus__contraction_force(program, x, f);
    for (int32_t h = 0; h < program->nattachment; h++) energy += add_attachment(program, &program->attachment[h], x, f);
    return energy;
}


/* engineering strain of a spring; 0 for a spring of no rest length */
static double strain_of(const double *x, int32_t a, int32_t b, double rest)
{
    if (rest <= 0.0) return 0.0;
    const double *p = x + 3 * (int64_t)a, *q = x + 3 * (int64_t)b;
    const double d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / rest - 1.0;
}


double mus__program_strain(const mus__program *program, const double *x)
{
    double most = 0.0;
    for (int32_t r = 0; r < program->nhalf_run; r++) {
        const mus__half_run *run = &program->half_run[r];
        for (int32_t i = 0; i < run->count; i++) {
            const double strain = strain_of(x, run->a + i, run->b + i, run->rest);
            if (strain > most) most = strain;
        }
    }
    for (int32_t s = 0; s < program->nspring; s++) {
        if (program->spring[s].kind == MUS__SPRING_ELASTIC) continue;
        const double strain = strain_of(x, program->spring[s].a, program->spring[s].b, program->spring[s].rest);
        if (strain > most) most = strain;
    }
    return most;
}
