/*
 * sim_kernel.h: the steps of a sim, as a template on the floating type.
 *
 * Define MUS__REAL, MUS__NAME(name) (names of that type), MUS__SQRT and MUS__SIM, then include. Loops are plain and
 * counted over planes, so that the compiler vectorises them; the order of the program fixes every sum.
 *
 * RK4 in the form that needs least memory (a_i the acceleration at stage i; v does not depend on the order of nodes):
 *
 *   x2 = x + h/2 v      v2 = v + h/2 a1      x' = x + h v + h^2/6 (a1 + a2 + a3)
 *   x3 = x + h/2 v2     v3 = v + h/2 a2      v' = v + h/6 (a1 + 2 a2 + 2 a3 + a4)
 *   x4 = x + h v3       v4 = v + h a3        a  = f/m + g - drag v
 *
 * Velocity Verlet as kick, move, kick, with the forces of the last kick kept for the first of the next step. Dashpots
 * see the velocity of the half step; drag d acts before and after it, which is stable for any d:
 *
 *   w = v + h/2 (f(x)/m + g - d v)      x' = x + h w      v' = (w + h/2 (f(x', w)/m + g)) / (1 + h/2 d)
 */
#include "sim/bend_slider.h"
#include "sim/force_kernel.h"

/* the passes of self-contact in this precision, as they stand in self_contact.h */
typedef void MUS__NAME(self_fn)(mus__self_contact *self, const mus__self_rule *rule, const MUS__REAL *inverse,
                                MUS__REAL *x, MUS__REAL *v);
typedef void MUS__NAME(self_prepare_fn)(mus__self_contact *self, const MUS__REAL *x);


/* ---- what a step does with the forces of nodes first .. first+count-1, f (3 x MUS__SPAN) in the scratch ---- */

static void MUS__NAME(keep_force)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *f)
{
    for (int64_t d = 0; d < 3; d++)
        memcpy((MUS__REAL *)sim->f + d * sim->n + first, f + d * MUS__SPAN, (size_t)count * sizeof *f);
}


/* number of nodes before the first whose index is a multiple of the lanes: vectors from there straddle no cache line */
static int32_t MUS__NAME(unaligned)(int32_t first, int32_t count)
{
    const int32_t head = (MUS__LANES - first % MUS__LANES) % MUS__LANES;
    return head < count ? head : count;
}


/* a stage of RK4, the drag at v4 taken off at the third; `dash` as a constant: neighbours want velocities of
 * stages; `keep` too: contact wants the places before the step, which take the place of the first acceleration */
static MUS_INLINE void MUS__NAME(rk_plane)(const mus__sim *sim, int32_t stage, int32_t dash, int32_t keep, int64_t at,
                                           int32_t count, MUS__REAL gravity, const MUS__REAL *f)
{
    const MUS__REAL h = (MUS__REAL)sim->phase_h, half = h / 2, sixth = h / 6, square = h * h / 6;
    const MUS__REAL drag = (MUS__REAL)sim->drag;
    const int64_t n3 = 3 * (int64_t)sim->n;
    const MUS__REAL *inverse = (const MUS__REAL *)sim->inverse + at % sim->n;
    const MUS__REAL *weight = (const MUS__REAL *)sim->weight + at % sim->n;
    MUS__REAL *x = (MUS__REAL *)sim->y + at, *v = x + n3;
    MUS__REAL *next = (MUS__REAL *)sim->next + at, *other = (MUS__REAL *)sim->stage + at;
    MUS__REAL *one = (MUS__REAL *)sim->f + at, *two = (MUS__REAL *)sim->second + at;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL push = f[i] * inverse[i] + gravity * weight[i];
        if (stage == 1) {
            const MUS__REAL a = push - drag * v[i];
            one[i] = a;
            next[i] = x[i] + half * v[i];
            if (dash) next[n3 + i] = v[i] + half * a;
        } else if (stage == 2) {
            const MUS__REAL now = v[i] + half * one[i], a = push - drag * now;
            two[i] = a;
            other[i] = x[i] + half * now;
            if (dash) other[n3 + i] = v[i] + half * a;
        } else if (stage == 3) {
            const MUS__REAL now = v[i] + half * two[i], a = push - drag * now, last = v[i] + h * a, was = x[i];
            next[i] = was + h * now;
            if (dash) next[n3 + i] = last;
            x[i] = was + (h * v[i] + square * (one[i] + two[i] + a));
            v[i] += sixth * (one[i] + 2 * (two[i] + a) - drag * last);
            if (keep) one[i] = was;
        } else {
            v[i] += sixth * push;
        }
    }
}


MUS_CLONES
static void MUS__NAME(rk_part)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *f)
{
    for (int64_t d = 0; d < 3; d++) {
        const MUS__REAL g = (MUS__REAL)sim->gravity[d];
        const int64_t at = d * sim->n + first;
        const int32_t dash = sim->dashpots != 0, keep = sim->collider != NULL;
        switch (4 * sim->phase + 2 * dash + (sim->phase == MUS__PHASE_RK3 && keep)) {
        case 4 * MUS__PHASE_RK1: MUS__NAME(rk_plane)(sim, 1, 0, 0, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK2: MUS__NAME(rk_plane)(sim, 2, 0, 0, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK3: MUS__NAME(rk_plane)(sim, 3, 0, 0, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK3 + 1: MUS__NAME(rk_plane)(sim, 3, 0, 1, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK1 + 2: MUS__NAME(rk_plane)(sim, 1, 1, 0, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK2 + 2: MUS__NAME(rk_plane)(sim, 2, 1, 0, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK3 + 2: MUS__NAME(rk_plane)(sim, 3, 1, 0, at, count, g, f + d * MUS__SPAN); break;
        case 4 * MUS__PHASE_RK3 + 3: MUS__NAME(rk_plane)(sim, 3, 1, 1, at, count, g, f + d * MUS__SPAN); break;
        default: MUS__NAME(rk_plane)(sim, 4, 0, 0, at, count, g, f + d * MUS__SPAN); break;
        }
    }
}


static void MUS__NAME(rk_stage)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *f)
{
    const int32_t head = MUS__NAME(unaligned)(first, count);
    MUS__NAME(rk_part)(sim, first, head, f);
    MUS__NAME(rk_part)(sim, first + head, count - head, f + head);
}


/* v' = (v + h (f/m + g)) / (1 + h drag), limited; x' = x + h v'; into `next`. With `tensor` (a constant) the inverse
 * inertia is the matrix B of each node: v' = (v + h B (f + m g)) / (1 + h drag) */
static MUS_INLINE void MUS__NAME(euler_part)(const mus__sim *sim, int32_t tensor, int32_t first, int32_t count,
                                             const MUS__REAL *restrict f)
{
    const int64_t n = sim->n;
    const MUS__REAL h = (MUS__REAL)sim->phase_h, keep = (MUS__REAL)(1.0 / (1.0 + sim->phase_h * sim->drag));
    const MUS__REAL limit = (MUS__REAL)sim->speed_limit;
    const MUS__REAL g0 = (MUS__REAL)sim->gravity[0], g1 = (MUS__REAL)sim->gravity[1], g2 = (MUS__REAL)sim->gravity[2];
    const MUS__REAL *restrict x = (const MUS__REAL *)sim->y + first;
    MUS__REAL *restrict to = (MUS__REAL *)sim->next + first;
    const MUS__REAL *restrict b = tensor ? (const MUS__REAL *)sim->tensor + first : NULL;
    const MUS__REAL *restrict inverse = tensor ? b : (const MUS__REAL *)sim->inverse + first;
    const MUS__REAL *restrict weight = tensor ? b + 6 * n : (const MUS__REAL *)sim->weight + first;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL w = weight[i]; /* the node's mass, or the share of its inertia that has weight */
        MUS__REAL a0, a1, a2;
        if (tensor) {
            const MUS__REAL f0 = f[i] + w * g0, f1 = f[MUS__SPAN + i] + w * g1, f2 = f[2 * MUS__SPAN + i] + w * g2;
            a0 = b[i] * f0 + b[3 * n + i] * f1 + b[5 * n + i] * f2;
            a1 = b[3 * n + i] * f0 + b[n + i] * f1 + b[4 * n + i] * f2;
            a2 = b[5 * n + i] * f0 + b[4 * n + i] * f1 + b[2 * n + i] * f2;
        } else {
            a0 = f[i] * inverse[i] + g0 * w;
            a1 = f[MUS__SPAN + i] * inverse[i] + g1 * w;
            a2 = f[2 * MUS__SPAN + i] * inverse[i] + g2 * w;
        }
        MUS__REAL v0 = keep * (x[3 * n + i] + h * a0), v1 = keep * (x[4 * n + i] + h * a1);
        MUS__REAL v2 = keep * (x[5 * n + i] + h * a2);
        const MUS__REAL speed = MUS__SQRT(v0 * v0 + v1 * v1 + v2 * v2 + MUS__TINY2);
        const MUS__REAL scale = speed > limit ? limit / speed : 1;
        v0 *= scale, v1 *= scale, v2 *= scale;
        to[3 * n + i] = v0, to[4 * n + i] = v1, to[5 * n + i] = v2;
        to[i] = x[i] + h * v0, to[n + i] = x[n + i] + h * v1, to[2 * n + i] = x[2 * n + i] + h * v2;
    }
}


MUS_CLONES
static void MUS__NAME(advance)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *restrict f)
{
    MUS__NAME(euler_part)(sim, 0, first, count, f);
}


/* the same with the tensors of the nodes. It waits for memory at any vector width, so there is one version */
static void MUS__NAME(advance_tensor)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *restrict f)
{
    MUS__NAME(euler_part)(sim, 1, first, count, f);
}


/*
 * The kick that ends a step, as v, and the kick and move that begin the next, as x and w; either may be left out (both
 * as constants). Forces f, `stride` from plane to plane; into `next`.
 */
static MUS_INLINE void MUS__NAME(verlet_plane)(const mus__sim *sim, int32_t end, int32_t begin, int64_t at,
                                               int32_t count, MUS__REAL gravity, const MUS__REAL *f)
{
    const MUS__REAL h = (MUS__REAL)sim->phase_h, half = h / 2, drag = (MUS__REAL)sim->drag;
    const MUS__REAL keep = (MUS__REAL)(1.0 / (1.0 + 0.5 * sim->phase_h * sim->drag));
    const int64_t n3 = 3 * (int64_t)sim->n;
    const MUS__REAL *inverse = (const MUS__REAL *)sim->inverse + at % sim->n;
    const MUS__REAL *weight = (const MUS__REAL *)sim->weight + at % sim->n;
    const MUS__REAL *x = (const MUS__REAL *)sim->y + at;
    MUS__REAL *to = (MUS__REAL *)sim->next + at;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL a = f[i] * inverse[i] + gravity * weight[i];
        MUS__REAL v = x[n3 + i];
        if (end) v = keep * (v + half * a);
        if (begin) v += half * (a - drag * v);
        to[n3 + i] = v;
        to[i] = begin ? x[i] + h * v : x[i];
    }
}


MUS_CLONES
static void MUS__NAME(verlet_stage)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *f, int64_t stride)
{
    for (int64_t d = 0; d < 3; d++) {
        const MUS__REAL g = (MUS__REAL)sim->gravity[d];
        const int64_t at = d * sim->n + first;
        if (sim->phase == MUS__PHASE_START)
            MUS__NAME(verlet_plane)(sim, 0, 1, at, count, g, f + d * stride);
        else if (sim->phase == MUS__PHASE_VERLET)
            MUS__NAME(verlet_plane)(sim, 1, 1, at, count, g, f + d * stride);
        else
            MUS__NAME(verlet_plane)(sim, 1, 0, at, count, g, f + d * stride);
    }
}


/* ---- phases as the pool runs them ---- */

/* uses the forces of a chunk as the phase says */
static void MUS__NAME(phase_chunk)(mus__sim *sim, int32_t first, int32_t count, const MUS__REAL *f)
{
    switch (sim->phase) {
    case MUS__PHASE_FORCE: MUS__NAME(keep_force)(sim, first, count, f); break;
    case MUS__PHASE_EULER: MUS__NAME(advance)(sim, first, count, f); break;
    case MUS__PHASE_TENSOR: MUS__NAME(advance_tensor)(sim, first, count, f); break;
    case MUS__PHASE_VERLET: MUS__NAME(verlet_stage)(sim, first, count, f, MUS__SPAN); break;
    case MUS__PHASE_KICK:
        MUS__NAME(keep_force)(sim, first, count, f);
        MUS__NAME(verlet_stage)(sim, first, count, f, MUS__SPAN);
        break;
    default: MUS__NAME(rk_stage)(sim, first, count, f); break;
    }
}


static void MUS__NAME(phase_part)(void *user, int32_t part, int32_t parts)
{
    mus__sim *sim = user;
    const mus__program *program = sim->program;
    const int32_t first = mus__share(program->nchunk, part, parts), last = mus__share(program->nchunk, part + 1, parts);
    _Alignas(64) MUS__REAL scratch[3 * MUS__SPAN + MUS__LANES];
    for (int32_t c = first; c < last; c++) {
        const mus__chunk *chunk = &program->chunk[c];
        MUS__REAL *f = scratch + chunk->first % MUS__LANES;
        if (sim->phase == MUS__PHASE_START) {
            MUS__NAME(verlet_stage)(sim, chunk->first, chunk->count, (const MUS__REAL *)sim->f + chunk->first, sim->n);
            continue;
        }
        MUS__NAME(chunk_force)(sim, chunk, f);
        MUS__NAME(phase_chunk)(sim, chunk->first, chunk->count, f);
    }
    if (sim->phase_touch == NULL || sim->collider == NULL || first == last) return;
    MUS__REAL *x = sim->phase_touch, *v = x + 3 * (int64_t)sim->n;
    const int32_t start = program->chunk[first].first,
                  end = program->chunk[last - 1].first + program->chunk[last - 1].count;
    if (MUS__SELF_OF(sim) != NULL)
        for (int64_t d = 0; d < 3; d++)
            memcpy((MUS__REAL *)sim->self->before_body + d * sim->n + start, v + d * sim->n + start,
                   (size_t)(end - start) * sizeof *v);
    const mus__contact_nodes nodes = {sim->n, start, end, sim->inverse, sim->x_before, x, v, sim->lift};
    if (sim->plane_cache != NULL && !sim->sweeps)
        sim->plane_cache_pass(sim->collider, &sim->rule, &nodes, sim->plane_cache, &sim->part_tally[part]);
    else
        sim->contact_pass(sim->collider, &sim->rule, &nodes, sim->sweeps, sim->distance_cache, &sim->part_tally[part]);
}


/* runs a phase with the forces at y; the state `touch` meets the colliders then (NULL: none does) */
static void MUS__NAME(run_phase)(mus__sim *sim, int32_t phase, const void *y, void *touch)
{
    sim->phase = phase;
    sim->phase_y = y;
    sim->phase_touch = touch;
    sim->fresh = phase == MUS__PHASE_FORCE || phase == MUS__PHASE_KICK;
    sim->force_evaluations += phase != MUS__PHASE_START;
    mus__pool_run(sim->pool, MUS__NAME(phase_part), sim);
}


/* the same, from y to `next`, which change places */
static void MUS__NAME(run_move)(mus__sim *sim, int32_t phase)
{
    sim->x_before = sim->y;
    MUS__NAME(run_phase)(sim, phase, sim->y, phase == MUS__PHASE_KICK ? NULL : sim->next);
    void *const was = sim->y;
    sim->y = sim->next;
    sim->next = was;
}


static void MUS__NAME(force)(mus__sim *sim)
{
    MUS__NAME(run_phase)(sim, MUS__PHASE_FORCE, sim->y, NULL);
}


/* stitches pairs within reach; stitched pairs get the mean by inertia of their places and velocities */
static void MUS__NAME(stitch)(mus__sim *sim)
{
    mus__program *program = sim->program;
    const int64_t n = sim->n;
    const MUS__REAL reach2 = (MUS__REAL)(sim->collision_distance * sim->collision_distance);
    const MUS__REAL *inverse = sim->inverse;
    for (int32_t p = 0; p < program->npair; p++) {
        mus__seam_pair *pair = &program->pair[p];
        MUS__REAL *a = (MUS__REAL *)sim->y + pair->a, *b = (MUS__REAL *)sim->y + pair->b;
        if (!pair->stitched) {
            const MUS__REAL dx = b[0] - a[0], dy = b[n] - a[n], dz = b[2 * n] - a[2 * n];
            if (!(dx * dx + dy * dy + dz * dz <= reach2)) continue;
            pair->stitched = 1;
        }
        const MUS__REAL total = inverse[pair->a] + inverse[pair->b];
        const MUS__REAL share = total > 0 ? inverse[pair->a] / total : 0;
        for (int32_t d = 0; d < 6; d++) {
            const MUS__REAL mean = a[d * n] + share * (b[d * n] - a[d * n]);
            a[d * n] = b[d * n] = mean;
        }
    }
}


/* self-contact at the end of a step of h */
static inline void MUS__NAME(meet_self)(mus__sim *sim, double h)
{
    if (MUS__SELF_OF(sim) == NULL) return;
    MUS__REAL *y = sim->y;
    ((MUS__NAME(self_fn) *)sim->self_pass)(sim->self, &sim->self_rule, sim->inverse, y, y + 3 * (int64_t)sim->n);
    sim->self_time += h;
}


static void MUS__NAME(find_pairs)(mus__sim *sim)
{
    if (MUS__SELF_OF(sim) != NULL) ((MUS__NAME(self_prepare_fn) *)sim->self_prepare)(sim->self, sim->y);
}


static void MUS__NAME(euler)(mus__sim *sim, double h)
{
    sim->phase_h = h;
    sim->sweeps = sim->collider != NULL && sim->rule.travel > sim->collider->safe;
    MUS__NAME(run_move)(sim, sim->tensor != NULL ? MUS__PHASE_TENSOR : MUS__PHASE_EULER);
    if (sim->program->npair > 0) MUS__NAME(stitch)(sim);

    /* contact gives its impulse after drag has reduced that of the forces, so the time of both is shorter by the factor
     */
    MUS__NAME(meet_self)(sim, h / (1.0 + h * sim->drag));
    if (sim->program->nslider > 0) MUS__NAME(slide_step)(sim);
}


static void MUS__NAME(rk4)(mus__sim *sim, double h)
{
    sim->phase_h = h;
    sim->x_before = sim->f; /* stage 3 leaves it there */
    MUS__NAME(run_phase)(sim, MUS__PHASE_RK1, sim->y, NULL);
    MUS__NAME(run_phase)(sim, MUS__PHASE_RK2, sim->next, NULL);
    MUS__NAME(run_phase)(sim, MUS__PHASE_RK3, sim->stage, NULL);
    MUS__NAME(run_phase)(sim, MUS__PHASE_RK4, sim->next, sim->y);
    MUS__NAME(meet_self)(sim, h);
    if (sim->program->nslider > 0) MUS__NAME(slide_step)(sim);
}


static void MUS__NAME(verlet)(mus__sim *sim, double h, int32_t steps)
{
    if (steps < 1) return;
    sim->phase_h = h;
    if (!sim->fresh) MUS__NAME(force)(sim);
    MUS__NAME(run_move)(sim, MUS__PHASE_START);
    MUS__NAME(meet_self)(sim, h);
    for (int32_t i = 1; i < steps; i++) {
        for (int32_t part = 0; part < 64 && !sim->sweeps; part++) sim->sweeps = sim->part_tally[part].fast;
        if (sim->program->nslider > 0) MUS__NAME(slide_step)(sim);
        MUS__NAME(run_move)(sim, MUS__PHASE_VERLET);
        MUS__NAME(meet_self)(sim, h);
    }
    if (sim->program->nslider > 0) MUS__NAME(slide_step)(sim);
    MUS__NAME(run_move)(sim, MUS__PHASE_KICK);
}


static void MUS__NAME(flush)(mus__sim *sim)
{
    MUS__REAL *y = sim->y;
    for (int64_t i = 0; i < 6 * (int64_t)sim->n; i++) y[i] = y[i] < MUS__TINY && y[i] > -MUS__TINY ? 0 : y[i];
}


/* ---- the world in doubles, (n x 3) ---- */

static void MUS__NAME(put)(mus__sim *sim, const double *x, const double *v)
{
    const int64_t n = sim->n;
    MUS__REAL *y = sim->y;
    for (int64_t i = 0; i < sim->nodes; i++)
        for (int32_t d = 0; d < 3; d++) {
            y[d * n + i] = (MUS__REAL)(x[3 * i + d] - sim->origin[d]);
            y[(3 + d) * n + i] = v != NULL ? (MUS__REAL)v[3 * i + d] : 0;
        }
    MUS__NAME(flush)(sim);
    memset(sim->distance_cache, 0, (size_t)n * sizeof *sim->distance_cache);
    sim->fresh = 0;
    if (MUS__SELF_OF(sim) != NULL) sim->self->invalid = 1;
    MUS__NAME(slide_start)(sim);
    MUS__REAL *good = sim->last_good;
    memcpy(good, y, (size_t)(6 * n) * sizeof *y);
}


static void MUS__NAME(get)(const mus__sim *sim, double *x, double *v)
{
    const int64_t n = sim->n;
    const MUS__REAL *y = sim->y;
    for (int64_t i = 0; i < sim->nodes; i++)
        for (int32_t d = 0; d < 3; d++) {
            x[3 * i + d] = (double)y[d * n + i] + sim->origin[d];
            v[3 * i + d] = (double)y[(3 + d) * n + i];
        }
}


MUS_CLONES
static void MUS__NAME(add)(const mus__sim *sim, double *restrict sum)
{
    const int64_t n = sim->n;
    const MUS__REAL *restrict y = sim->y;
    MUS_IVDEP
    for (int64_t i = 0; i < sim->nodes; i++) {
        sum[3 * i] += (double)y[i];
        sum[3 * i + 1] += (double)y[n + i];
        sum[3 * i + 2] += (double)y[2 * n + i];
    }
}


static void MUS__NAME(get_force)(const mus__sim *sim, double *out)
{
    const int64_t n = sim->n;
    const MUS__REAL *f = sim->f;
    for (int64_t i = 0; i < sim->nodes; i++)
        for (int32_t d = 0; d < 3; d++) out[3 * i + d] = (double)f[d * n + i];
}


static void MUS__NAME(set_node)(mus__sim *sim, int32_t node, double inverse_mass, double weight)
{
    ((MUS__REAL *)sim->inverse)[node] = (MUS__REAL)inverse_mass;
    ((MUS__REAL *)sim->weight)[node] = (MUS__REAL)weight;
}


static void MUS__NAME(set_tensor)(mus__sim *sim, int32_t node, const double *inverse, double mass)
{
    MUS__REAL *b = (MUS__REAL *)sim->tensor + node;
    for (int64_t k = 0; k < 6; k++) b[k * sim->n] = (MUS__REAL)inverse[k];
    b[6 * (int64_t)sim->n] = (MUS__REAL)mass;
}


static double MUS__NAME(clear_of)(const mus__sim *sim, int32_t node)
{
    if (sim->plane_cache == NULL) return sim->collider != NULL ? 0.0 : 1e30;
    const int64_t n = sim->n;
    const MUS__REAL *cache = (const MUS__REAL *)sim->plane_cache + node, *y = (const MUS__REAL *)sim->y + node;
    double way2 = 0.0;
    if (cache[0] != 0 || cache[n] != 0 || cache[2 * n] != 0 || !(cache[7 * n] > 0)) return 0.0;
    for (int64_t d = 0; d < 3; d++) {
        const double way = (double)(y[d * n] - cache[(4 + d) * n]);
        way2 += way * way;
    }
    return 2.0 * sqrt((double)cache[7 * n]) - sqrt(way2);
}


static double MUS__NAME(speed2)(const mus__sim *sim)
{
    const int64_t n = sim->n;
    const MUS__REAL *y = sim->y;
    double most = 0.0, sum = 0.0;
    for (int64_t i = 0; i < sim->nodes; i++) {
        const double v0 = (double)y[3 * n + i], v1 = (double)y[4 * n + i], v2 = (double)y[5 * n + i];
        const double s = v0 * v0 + v1 * v1 + v2 * v2;
        most = s > most ? s : most;
        sum += s + 0.0 * ((double)y[i] + (double)y[n + i] + (double)y[2 * n + i]);
    }
    return mus__finite(sum) ? most : sum - sum;
}


static void MUS__NAME(snapshot)(mus__sim *sim)
{
    memcpy(sim->last_good, sim->y, 6 * (size_t)sim->n * sizeof(MUS__REAL));
}


static void MUS__NAME(restore)(mus__sim *sim)
{
    memcpy(sim->y, sim->last_good, 6 * (size_t)sim->n * sizeof(MUS__REAL));
    memset(sim->distance_cache, 0, (size_t)sim->n * sizeof *sim->distance_cache);
    sim->fresh = 0;
    if (MUS__SELF_OF(sim) != NULL) sim->self->invalid = 1;
    MUS__NAME(slide_start)(sim);
}


const mus__sim_ops MUS__SIM = {
    .real = sizeof(MUS__REAL),
    .force = MUS__NAME(force),
    .euler = MUS__NAME(euler),
    .rk4 = MUS__NAME(rk4),
    .verlet = MUS__NAME(verlet),
    .put = MUS__NAME(put),
    .get = MUS__NAME(get),
    .add = MUS__NAME(add),
    .get_force = MUS__NAME(get_force),
    .set_node = MUS__NAME(set_node),
    .set_tensor = MUS__NAME(set_tensor),
    .clear_of = MUS__NAME(clear_of),
    .flush = MUS__NAME(flush),
    .speed2 = MUS__NAME(speed2),
    .snapshot = MUS__NAME(snapshot),
    .restore = MUS__NAME(restore),
    .find_pairs = MUS__NAME(find_pairs),
};
