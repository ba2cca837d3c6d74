/*
 * step_bound.c: the stiffness at each node, and the largest stable step.
 *
 *   T_i = sum over items e at node i of  k_e S_e |w_ei| N_e,  S_e = sum_j |w_ej|,  omega_max^2 <= max_i lambda(T_i)/m_i
 *
 * from |sum w x|^2 <= sum |w| sum |w| |x|^2. A spring gives 2k to both ends, a second difference 4k, 8k, 4k. N is the
 * identity (a bound for every pose), or, at one pose, n n^T + max(0, 1 - rest/l) (1 - n n^T): the tangent stiffness,
 * without the part that a compressed spring takes away.
 */
#include <math.h>
#include <string.h>

#include "sim/contraction.h"
#include "sim/step_bound.h"


/* number of springs of the cloth; tacks come after them */
static int32_t own_springs(const mus__program *program)
{
    int32_t n = program->nspring;
    while (n > 0 && program->spring[n - 1].kind == MUS__SPRING_TACK) n--;
    return n;
}


/* adds to t (nnode) the stiffness of bends, hinges, pairs, tacks and attachments: isotropic in every pose */
static void add_isotropic(const mus__program *program, double *t)
{
    for (int32_t r = 0; r < program->nhalf_bend; r++) {
        const mus__half_bend *bend = &program->half_bend[r];
        const double part = 4.0 * fabs(bend->w);
        for (int32_t i = 0; i < bend->count; i++) t[bend->o + i] += part;
    }
    for (int32_t h = 0; h < program->nhinge; h++) {
        const mus__hinge *hinge = &program->hinge[h];
        double size = 0.0;
        for (int32_t k = 0; k < 4; k++) size += fabs(hinge->coef[k]);
        for (int32_t k = 0; k < 4; k++) t[hinge->node[k]] += fabs(hinge->k) * size * fabs(hinge->coef[k]);
    }
    for (int32_t p = 0; p < program->npair; p++) {
        t[program->pair[p].a] += 2.0 * program->pair[p].k;
        t[program->pair[p].b] += 2.0 * program->pair[p].k;
    }
    for (int32_t h = 0; h < program->nattachment; h++) t[program->attachment[h].node] += program->attachment[h].k;
    for (int32_t s = own_springs(program); s < program->nspring; s++) {
        t[program->spring[s].a] += 2.0 * program->spring[s].k;
        t[program->spring[s].b] += 2.0 * program->spring[s].k;
    }
}


void mus__program_stiffness_bending(const mus__program *program, int32_t nnode, double *t)
{
    memset(t, 0, (size_t)nnode * sizeof *t);
    add_isotropic(program, t);
}


void mus__program_stiffness(const mus__program *program, int32_t nnode, double *t)
{
    memset(t, 0, (size_t)nnode * sizeof *t);
    add_isotropic(program, t);
    mus__contraction_stiffness(program, t);
    for (int32_t r = 0; r < program->nhalf_run; r++)
        for (int32_t i = 0; i < program->half_run[r].count; i++)
            t[program->half_run[r].a + i] += 2.0 * program->half_run[r].k;
    for (int32_t s = 0, n = own_springs(program); s < n; s++) {
        t[program->spring[s].a] += 2.0 * program->spring[s].k;
        t[program->spring[s].b] += 2.0 * program->spring[s].k;
    }
}


/* adds 2k N of a spring on node a to the six numbers xx, yy, zz, xy, yz, zx of its T; tangent (nnode x 6) */
static void add_tangent(const double *x, int32_t a, int32_t b, double k, double rest, double *work)
{
    const double *p = x + 3 * (int64_t)a, *q = x + 3 * (int64_t)b;
    double n[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const double l = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + 1e-150;
    const double across = l > rest ? 1.0 - rest / l : 0.0, along = 1.0 - across;
    double *t = work + 6 * (int64_t)a;
    for (int32_t i = 0; i < 3; i++) n[i] /= l;
    for (int32_t i = 0; i < 3; i++) {
        t[i] += 2.0 * k * (across + along * n[i] * n[i]);
        t[3 + i] += 2.0 * k * along * n[i] * n[(i + 1) % 3];
    }
}


/* squares a symmetric 3 x 3 matrix of six numbers in place */
static void square_matrix(double *t)
{
    const double xx = t[0], yy = t[1], zz = t[2], xy = t[3], yz = t[4], zx = t[5];
    t[0] = xx * xx + xy * xy + zx * zx;
    t[1] = yy * yy + xy * xy + yz * yz;
    t[2] = zz * zz + zx * zx + yz * yz;
    t[3] = xx * xy + xy * yy + zx * yz;
    t[4] = xy * zx + yy * yz + yz * zz;
    t[5] = xx * zx + xy * yz + zx * zz;
}


/*
 * The largest eigenvalue, from above: (trace T^16)^(1/16) is too large by at most 3^(1/16), 7.2 %. Newton's method on
 * the characteristic polynomial p, whose roots are real, comes down from there to the largest root and never below it.
 */
static double largest_eigenvalue(const double *matrix)
{
    double t[6], s[6];
    const double scale = matrix[0] + matrix[1] + matrix[2];
    if (!(scale > 0.0)) return 0.0;
    for (int32_t i = 0; i < 6; i++) s[i] = t[i] = matrix[i] / scale;
    for (int32_t i = 0; i < 4; i++) square_matrix(t);
    double root = sqrt(sqrt(sqrt(sqrt(t[0] + t[1] + t[2]))));

    /* p = r^3 - r^2 + minors r - determinant, the trace being 1 */
    const double minors = s[0] * s[1] + s[1] * s[2] + s[2] * s[0] - s[3] * s[3] - s[4] * s[4] - s[5] * s[5];
    const double determinant =
        s[0] * (s[1] * s[2] - s[4] * s[4]) - s[3] * (s[3] * s[2] - s[4] * s[5]) + s[5] * (s[3] * s[4] - s[1] * s[5]);
    for (int32_t i = 0; i < 6; i++) {
        const double p = ((root - 1.0) * root + minors) * root - determinant;
        const double slope = (3.0 * root - 2.0) * root + minors;
        if (!(p > 0.0) || !(slope > 0.0)) break;
        root -= p / slope;
    }
    return scale * root;
}


void mus__program_stiffness_at(const mus__program *program, int32_t nnode, const double *x, double *t, double *work)
{
    memset(t, 0, (size_t)nnode * sizeof *t);
    memset(work, 0, 6 * (size_t)nnode * sizeof *work);
    for (int32_t r = 0; r < program->nhalf_run; r++) {
        const mus__half_run *run = &program->half_run[r];
        for (int32_t i = 0; i < run->count; i++) add_tangent(x, run->a + i, run->b + i, run->k, run->rest, work);
    }
    for (int32_t s = 0, n = own_springs(program); s < n; s++) {
        const mus__spring *spring = &program->spring[s];
        add_tangent(x, spring->a, spring->b, spring->k, spring->rest, work);
        add_tangent(x, spring->b, spring->a, spring->k, spring->rest, work);
    }
    mus__contraction_stiffness_at(program, x, work);
    add_isotropic(program, t);
    for (int32_t i = 0; i < nnode; i++) t[i] += largest_eigenvalue(work + 6 * (int64_t)i);
}


void mus__program_damping(const mus__program *program, int32_t nnode, double *t, double *ratio)
{
    memset(t, 0, (size_t)nnode * sizeof *t);
    *ratio = 0.0;
    for (int32_t r = 0; r < program->nhalf_run; r++) {
        const mus__half_run *run = &program->half_run[r];
        for (int32_t i = 0; i < run->count; i++) t[run->a + i] += 2.0 * run->dashpot;
        if (run->dashpot > *ratio * run->k) *ratio = run->dashpot / run->k;
    }
    for (int32_t s = 0; s < program->nspring; s++) {
        const double dashpot = program->spring_dashpot[s];
        t[program->spring[s].a] += 2.0 * dashpot;
        t[program->spring[s].b] += 2.0 * dashpot;
        if (dashpot > *ratio * program->spring[s].k) *ratio = dashpot / program->spring[s].k;
    }

    /* a mode that shears a cell purely finds its line springs softer by the coupling's share */
    *ratio /= 1.0 - program->couple_share;
}


/*
 * An eigenvalue s of M s^2 + C s + K solves, with its own vector u, s^2 + gamma s + omega^2 = 0 where omega^2 =
 * u*Ku/u*Mu and gamma = u*Cu/u*Mu; so omega^2 <= rate2, gamma <= gamma_max, and gamma - drag <= ratio omega^2 (each
 * dashpot is at most ratio times its spring).
 *
 *   complex: |s| = omega, and the half disc of radius 2.62 lies in the stability region of RK4
 *   real:    -s <= (gamma + sqrt(gamma^2 - 4 omega^2)) / 2, which grows with gamma and falls with omega: largest at
 *            gamma_max and the least omega^2 = (gamma_max - drag) / ratio; the region reaches -2.785
 */
double mus__step_bound_rk4(double rate2, double gamma, double ratio, double drag)
{
    const double least = gamma > drag && ratio > 0.0 ? (gamma - drag) / ratio : 0.0;
    const double root2 = gamma * gamma - 4.0 * least;
    double real = root2 > 0.0 ? 0.5 * (gamma + sqrt(root2)) : 0.0;
    if (drag > real) real = drag;

    double h = rate2 > 0.0 ? 2.62 / sqrt(rate2) : 1e9;
    if (real > 0.0 && 2.785 / real < h) h = 2.785 / real;
    return h;
}


/*
 * Velocity Verlet with the dashpots' velocity half a step old, M (w' - w)/h + C w + K x = 0, w the velocity between the
 * steps, keeps the energy  w (M - h/2 C) w/2 + x K x'/2  from growing; it is an energy as long as
 * M - h/2 C - h^2/4 K >= 0:  h^2 rate2 + 2 h gamma <= 4. Drag acts before and after a force, and is stable for itself.
 *
 * That is the limit of a frozen pose. In motion K changes with the pose, and a mode whose period is three steps
 * (omega h = sqrt(3)) takes energy from the change (resonance of order 3: Schlick, Mandziuk, Skeel and Srinivas,
 * Nonlinear resonance artifacts in molecular dynamics simulations, J. Comput. Phys. 140, 1998). The bound lies below
 * it: h^2 rate2 + 2 h gamma <= 3.
 */
double mus__step_bound_verlet(double rate2, double gamma)
{
    const double sum = gamma + sqrt(gamma * gamma + 3.0 * rate2);
    return sum > 3e-9 ? 3.0 / sum : 1e9;
}
