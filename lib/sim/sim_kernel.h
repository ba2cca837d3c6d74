/*
 * sim_kernel.h: the steps of a sim, as a template on the floating type.
 *
 * Define MUS_REAL, MUS_FN(name) (names of that type), MUS_SQRT, MUS_CONTACT, MUS_CLOTH and MUS_SIM, then include. Loops
 * are plain and counted over planes, so that the compiler vectorises them; the program's order fixes every sum.
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
#include "sim/force_kernel.h"


/* ---- what a step does with the forces of nodes first .. first+count-1, f (3 x SPAN) in the scratch ---- */

static void MUS_FN(keep_force)(mus__sim *sim, int32_t first, int32_t count, const MUS_REAL *f)
{
    for (int64_t d = 0; d < 3; d++)
        memcpy((MUS_REAL *)sim->f + d * sim->n + first, f + d * SPAN, (size_t)count * sizeof *f);
}


/* how many of the nodes come before the first that stands on whole lanes: vectors from there straddle no cache line */
static int32_t MUS_FN(unaligned)(int32_t first, int32_t count)
{
    const int32_t head = (LANES - first % LANES) % LANES;
    return head < count ? head : count;
}


/* a stage of RK4, the drag at v4 taken off at the third; `dash` as a constant: neighbours want velocities of
 * stages; `keep` too: contact wants the places before the step, which take the place of the first acceleration */
static MUS_INLINE void MUS_FN(rk_plane)(const mus__sim *sim, int32_t stage, int32_t dash, int32_t keep, int64_t at,
                                        int32_t count, MUS_REAL gravity, const MUS_REAL *f)
{
    const MUS_REAL h = (MUS_REAL)sim->phase_h, half = h / 2, sixth = h / 6, square = h * h / 6;
    const MUS_REAL drag = (MUS_REAL)sim->drag;
    const int64_t n3 = 3 * (int64_t)sim->n;
    const MUS_REAL *inverse = (const MUS_REAL *)sim->inverse + at % sim->n;
    const MUS_REAL *weight = (const MUS_REAL *)sim->weight + at % sim->n;
    MUS_REAL *x = (MUS_REAL *)sim->y + at, *v = x + n3;
    MUS_REAL *next = (MUS_REAL *)sim->next + at, *other = (MUS_REAL *)sim->stage + at;
    MUS_REAL *one = (MUS_REAL *)sim->f + at, *two = (MUS_REAL *)sim->second + at;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL push = f[i] * inverse[i] + gravity * weight[i];
        if (stage == 1) {
            const MUS_REAL a = push - drag * v[i];
            one[i] = a;
            next[i] = x[i] + half * v[i];
            if (dash) next[n3 + i] = v[i] + half * a;
        } else if (stage == 2) {
            const MUS_REAL now = v[i] + half * one[i], a = push - drag * now;
            two[i] = a;
            other[i] = x[i] + half * now;
            if (dash) other[n3 + i] = v[i] + half * a;
        } else if (stage == 3) {
            const MUS_REAL now = v[i] + half * two[i], a = push - drag * now, last = v[i] + h * a, was = x[i];
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
static void MUS_FN(rk_part)(mus__sim *sim, int32_t first, int32_t count, const MUS_REAL *f)
{
    for (int64_t d = 0; d < 3; d++) {
        const MUS_REAL g = (MUS_REAL)sim->gravity[d];
        const int64_t at = d * sim->n + first;
        const int32_t dash = sim->dashpots != 0, keep = sim->collider != NULL;
        switch (4 * sim->phase + 2 * dash + (sim->phase == MUS__PHASE_RK3 && keep)) {
        case 4 * MUS__PHASE_RK1: MUS_FN(rk_plane)(sim, 1, 0, 0, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK2: MUS_FN(rk_plane)(sim, 2, 0, 0, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK3: MUS_FN(rk_plane)(sim, 3, 0, 0, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK3 + 1: MUS_FN(rk_plane)(sim, 3, 0, 1, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK1 + 2: MUS_FN(rk_plane)(sim, 1, 1, 0, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK2 + 2: MUS_FN(rk_plane)(sim, 2, 1, 0, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK3 + 2: MUS_FN(rk_plane)(sim, 3, 1, 0, at, count, g, f + d * SPAN); break;
        case 4 * MUS__PHASE_RK3 + 3: MUS_FN(rk_plane)(sim, 3, 1, 1, at, count, g, f + d * SPAN); break;
        default: MUS_FN(rk_plane)(sim, 4, 0, 0, at, count, g, f + d * SPAN); break;
        }
    }
}


static void MUS_FN(rk_stage)(mus__sim *sim, int32_t first, int32_t count, const MUS_REAL *f)
{
    const int32_t head = MUS_FN(unaligned)(first, count);
    MUS_FN(rk_part)(sim, first, head, f);
    MUS_FN(rk_part)(sim, first + head, count - head, f + head);
}


/* v' = (v + h (f/m + g)) / (1 + h drag), limited; x' = x + h v'; into `next` */
MUS_CLONES
static void MUS_FN(advance)(mus__sim *sim, int32_t first, int32_t count, const MUS_REAL *restrict f)
{
    const int64_t n = sim->n;
    const MUS_REAL h = (MUS_REAL)sim->phase_h, keep = (MUS_REAL)(1.0 / (1.0 + sim->phase_h * sim->drag));
    const MUS_REAL limit = (MUS_REAL)sim->speed_limit;
    const MUS_REAL g0 = (MUS_REAL)sim->gravity[0], g1 = (MUS_REAL)sim->gravity[1], g2 = (MUS_REAL)sim->gravity[2];
    const MUS_REAL *restrict x = (const MUS_REAL *)sim->y + first;
    MUS_REAL *restrict to = (MUS_REAL *)sim->next + first;
    const MUS_REAL *restrict inverse = (const MUS_REAL *)sim->inverse + first;
    const MUS_REAL *restrict weight = (const MUS_REAL *)sim->weight + first;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        MUS_REAL v0 = keep * (x[3 * n + i] + h * (f[i] * inverse[i] + g0 * weight[i]));
        MUS_REAL v1 = keep * (x[4 * n + i] + h * (f[SPAN + i] * inverse[i] + g1 * weight[i]));
        MUS_REAL v2 = keep * (x[5 * n + i] + h * (f[2 * SPAN + i] * inverse[i] + g2 * weight[i]));
        const MUS_REAL speed = MUS_SQRT(v0 * v0 + v1 * v1 + v2 * v2 + TINY);
        const MUS_REAL scale = speed > limit ? limit / speed : 1;
        v0 *= scale, v1 *= scale, v2 *= scale;
        to[3 * n + i] = v0, to[4 * n + i] = v1, to[5 * n + i] = v2;
        to[i] = x[i] + h * v0, to[n + i] = x[n + i] + h * v1, to[2 * n + i] = x[2 * n + i] + h * v2;
    }
}


/*
 * The kick that ends a step, as v, and the kick and move that begin the next, as x and w; either may be left out (both
 * as constants). Forces f, `stride` from plane to plane; into `next`.
 */
static MUS_INLINE void MUS_FN(verlet_plane)(const mus__sim *sim, int32_t end, int32_t begin, int64_t at, int32_t count,
                                            MUS_REAL gravity, const MUS_REAL *f)
{
    const MUS_REAL h = (MUS_REAL)sim->phase_h, half = h / 2, drag = (MUS_REAL)sim->drag;
    const MUS_REAL keep = (MUS_REAL)(1.0 / (1.0 + 0.5 * sim->phase_h * sim->drag));
    const int64_t n3 = 3 * (int64_t)sim->n;
    const MUS_REAL *inverse = (const MUS_REAL *)sim->inverse + at % sim->n;
    const MUS_REAL *weight = (const MUS_REAL *)sim->weight + at % sim->n;
    const MUS_REAL *x = (const MUS_REAL *)sim->y + at;
    MUS_REAL *to = (MUS_REAL *)sim->next + at;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL a = f[i] * inverse[i] + gravity * weight[i];
        MUS_REAL v = x[n3 + i];
        if (end) v = keep * (v + half * a);
        if (begin) v += half * (a - drag * v);
        to[n3 + i] = v;
        to[i] = begin ? x[i] + h * v : x[i];
    }
}


MUS_CLONES
static void MUS_FN(verlet_stage)(mus__sim *sim, int32_t first, int32_t count, const MUS_REAL *f, int64_t stride)
{
    for (int64_t d = 0; d < 3; d++) {
        const MUS_REAL g = (MUS_REAL)sim->gravity[d];
        const int64_t at = d * sim->n + first;
        if (sim->phase == MUS__PHASE_START)
            MUS_FN(verlet_plane)(sim, 0, 1, at, count, g, f + d * stride);
        else if (sim->phase == MUS__PHASE_VERLET)
            MUS_FN(verlet_plane)(sim, 1, 1, at, count, g, f + d * stride);
        else
            MUS_FN(verlet_plane)(sim, 1, 0, at, count, g, f + d * stride);
    }
}


/* ---- phases as the pool runs them ---- */

/* what a phase does with a chunk's forces */
static void MUS_FN(phase_chunk)(mus__sim *sim, int32_t first, int32_t count, const MUS_REAL *f)
{
    switch (sim->phase) {
    case MUS__PHASE_FORCE: MUS_FN(keep_force)(sim, first, count, f); break;
    case MUS__PHASE_EULER: MUS_FN(advance)(sim, first, count, f); break;
    case MUS__PHASE_VERLET: MUS_FN(verlet_stage)(sim, first, count, f, SPAN); break;
    case MUS__PHASE_KICK:
        MUS_FN(keep_force)(sim, first, count, f);
        MUS_FN(verlet_stage)(sim, first, count, f, SPAN);
        break;
    default: MUS_FN(rk_stage)(sim, first, count, f); break;
    }
}


static void MUS_FN(phase_part)(void *user, int32_t part, int32_t parts)
{
    mus__sim *sim = user;
    const mus__program *program = sim->program;
    const int32_t first = mus__share(program->nchunk, part, parts), last = mus__share(program->nchunk, part + 1, parts);
    _Alignas(64) MUS_REAL scratch[3 * SPAN + LANES];
    for (int32_t c = first; c < last; c++) {
        const mus__chunk *chunk = &program->chunk[c];
        MUS_REAL *f = scratch + chunk->first % LANES;
        if (sim->phase == MUS__PHASE_START) {
            MUS_FN(verlet_stage)(sim, chunk->first, chunk->count, (const MUS_REAL *)sim->f + chunk->first, sim->n);
            continue;
        }
        MUS_FN(chunk_force)(sim, chunk, f);
        MUS_FN(phase_chunk)(sim, chunk->first, chunk->count, f);
    }
    if (sim->phase_touch == NULL || sim->collider == NULL || first == last) return;
    MUS_REAL *x = sim->phase_touch, *v = x + 3 * (int64_t)sim->n;
    const int32_t start = program->chunk[first].first,
                  end = program->chunk[last - 1].first + program->chunk[last - 1].count;
    if (MUS__SELF_OF(sim) != NULL)
        for (int64_t d = 0; d < 3; d++)
            memcpy((MUS_REAL *)sim->self->before_body + d * sim->n + start, v + d * sim->n + start,
                   (size_t)(end - start) * sizeof *v);
    if (sim->plane_cache != NULL && !sim->sweeps)
        MUS_NEAR(sim->collider, &sim->rule, sim->n, start, end, sim->inverse, sim->plane_cache, x, v,
                 &sim->part_tally[part]);
    else
        MUS_CONTACT(sim->collider, &sim->rule, sim->n, start, end, sim->inverse, sim->x_before, sim->sweeps,
                    sim->distance_cache, x, v, &sim->part_tally[part]);
}


/* forces at y, and what the phase makes of them; `touch` meets the body then */
static void MUS_FN(run_phase)(mus__sim *sim, int32_t phase, const void *y, void *touch)
{
    sim->phase = phase;
    sim->phase_y = y;
    sim->phase_touch = touch;
    sim->fresh = phase == MUS__PHASE_FORCE || phase == MUS__PHASE_KICK;
    sim->force_evaluations += phase != MUS__PHASE_START;
    mus__pool_run(sim->pool, MUS_FN(phase_part), sim);
}


/* the same from y to `next`, which change places */
static void MUS_FN(run_move)(mus__sim *sim, int32_t phase)
{
    sim->x_before = sim->y;
    MUS_FN(run_phase)(sim, phase, sim->y, phase == MUS__PHASE_KICK ? NULL : sim->next);
    void *const was = sim->y;
    sim->y = sim->next;
    sim->next = was;
}


static void MUS_FN(force)(mus__sim *sim)
{
    MUS_FN(run_phase)(sim, MUS__PHASE_FORCE, sim->y, NULL);
}


/* stitched pairs move as one: the mean by inertia of place and velocity; a pair within reach is stitched */
static void MUS_FN(stitch)(mus__sim *sim)
{
    mus__program *program = sim->program;
    const int64_t n = sim->n;
    const MUS_REAL reach2 = (MUS_REAL)(sim->collision_distance * sim->collision_distance);
    const MUS_REAL *inverse = sim->inverse;
    for (int32_t p = 0; p < program->npair; p++) {
        mus__seam_pair *pair = &program->pair[p];
        MUS_REAL *a = (MUS_REAL *)sim->y + pair->a, *b = (MUS_REAL *)sim->y + pair->b;
        if (!pair->stitched) {
            const MUS_REAL dx = b[0] - a[0], dy = b[n] - a[n], dz = b[2 * n] - a[2 * n];
            if (!(dx * dx + dy * dy + dz * dz <= reach2)) continue;
            pair->stitched = 1;
        }
        const MUS_REAL total = inverse[pair->a] + inverse[pair->b];
        const MUS_REAL share = total > 0 ? inverse[pair->a] / total : 0;
        for (int32_t d = 0; d < 6; d++) {
            const MUS_REAL mean = a[d * n] + share * (b[d * n] - a[d * n]);
            a[d * n] = b[d * n] = mean;
        }
    }
}


/* cloth against cloth, at the end of a step of h */
static inline void MUS_FN(meet_self)(mus__sim *sim, double h)
{
    if (MUS__SELF_OF(sim) == NULL) return;
    MUS_REAL *y = sim->y;
    MUS_CLOTH(sim->self, &sim->self_rule, sim->inverse, y, y + 3 * (int64_t)sim->n);
    sim->self_time += h;
}


static void MUS_FN(find_pairs)(mus__sim *sim)
{
    if (MUS__SELF_OF(sim) != NULL) MUS_CLOTH_LOOK(sim->self, sim->y);
}


static void MUS_FN(euler)(mus__sim *sim, double h)
{
    sim->phase_h = h;
    sim->sweeps = sim->collider != NULL && sim->rule.travel > sim->collider->safe;
    MUS_FN(run_move)(sim, MUS__PHASE_EULER);
    if (sim->program->npair > 0) MUS_FN(stitch)(sim);

    /* what rests gets its impulse after drag has taken its share of the step's forces: they are greater by that */
    MUS_FN(meet_self)(sim, h / (1.0 + h * sim->drag));
}


static void MUS_FN(rk4)(mus__sim *sim, double h)
{
    sim->phase_h = h;
    sim->x_before = sim->f; /* stage 3 leaves it there */
    MUS_FN(run_phase)(sim, MUS__PHASE_RK1, sim->y, NULL);
    MUS_FN(run_phase)(sim, MUS__PHASE_RK2, sim->next, NULL);
    MUS_FN(run_phase)(sim, MUS__PHASE_RK3, sim->stage, NULL);
    MUS_FN(run_phase)(sim, MUS__PHASE_RK4, sim->next, sim->y);
    MUS_FN(meet_self)(sim, h);
}


static void MUS_FN(verlet)(mus__sim *sim, double h, int32_t steps)
{
    if (steps < 1) return;
    sim->phase_h = h;
    if (!sim->fresh) MUS_FN(force)(sim);
    MUS_FN(run_move)(sim, MUS__PHASE_START);
    MUS_FN(meet_self)(sim, h);
    for (int32_t i = 1; i < steps; i++) {
        for (int32_t part = 0; part < 64 && !sim->sweeps; part++) sim->sweeps = sim->part_tally[part].fast;
        MUS_FN(run_move)(sim, MUS__PHASE_VERLET);
        MUS_FN(meet_self)(sim, h);
    }
    MUS_FN(run_move)(sim, MUS__PHASE_KICK);
}


static void MUS_FN(flush)(mus__sim *sim)
{
    MUS_REAL *y = sim->y;
    for (int64_t i = 0; i < 6 * (int64_t)sim->n; i++) y[i] = y[i] < MUS_TINY && y[i] > -MUS_TINY ? 0 : y[i];
}


/* ---- the world in doubles, (n x 3) ---- */

static void MUS_FN(put)(mus__sim *sim, const double *x, const double *v)
{
    const int64_t n = sim->n;
    MUS_REAL *y = sim->y;
    for (int64_t i = 0; i < sim->nodes; i++)
        for (int32_t d = 0; d < 3; d++) {
            y[d * n + i] = (MUS_REAL)(x[3 * i + d] - sim->origin[d]);
            y[(3 + d) * n + i] = v != NULL ? (MUS_REAL)v[3 * i + d] : 0;
        }
    MUS_FN(flush)(sim);
    memset(sim->distance_cache, 0, (size_t)n * sizeof *sim->distance_cache);
    sim->fresh = 0;
    if (MUS__SELF_OF(sim) != NULL) sim->self->invalid = 1;
    MUS_REAL *good = sim->last_good;
    memcpy(good, y, (size_t)(6 * n) * sizeof *y);
}


static void MUS_FN(get)(const mus__sim *sim, double *x, double *v)
{
    const int64_t n = sim->n;
    const MUS_REAL *y = sim->y;
    for (int64_t i = 0; i < sim->nodes; i++)
        for (int32_t d = 0; d < 3; d++) {
            x[3 * i + d] = (double)y[d * n + i] + sim->origin[d];
            v[3 * i + d] = (double)y[(3 + d) * n + i];
        }
}


MUS_CLONES
static void MUS_FN(add)(const mus__sim *sim, double *restrict sum)
{
    const int64_t n = sim->n;
    const MUS_REAL *restrict y = sim->y;
    MUS_IVDEP
    for (int64_t i = 0; i < sim->nodes; i++) {
        sum[3 * i] += (double)y[i];
        sum[3 * i + 1] += (double)y[n + i];
        sum[3 * i + 2] += (double)y[2 * n + i];
    }
}


static void MUS_FN(get_force)(const mus__sim *sim, double *out)
{
    const int64_t n = sim->n;
    const MUS_REAL *f = sim->f;
    for (int64_t i = 0; i < sim->nodes; i++)
        for (int32_t d = 0; d < 3; d++) out[3 * i + d] = (double)f[d * n + i];
}


static void MUS_FN(set_node)(mus__sim *sim, int32_t node, double inverse_mass, double weight)
{
    ((MUS_REAL *)sim->inverse)[node] = (MUS_REAL)inverse_mass;
    ((MUS_REAL *)sim->weight)[node] = (MUS_REAL)weight;
}


static double MUS_FN(speed2)(const mus__sim *sim)
{
    const int64_t n = sim->n;
    const MUS_REAL *y = sim->y;
    double most = 0.0, sum = 0.0;
    for (int64_t i = 0; i < sim->nodes; i++) {
        const double v0 = (double)y[3 * n + i], v1 = (double)y[4 * n + i], v2 = (double)y[5 * n + i];
        const double s = v0 * v0 + v1 * v1 + v2 * v2;
        most = s > most ? s : most;
        sum += s + 0.0 * ((double)y[i] + (double)y[n + i] + (double)y[2 * n + i]);
    }
    return mus__finite(sum) ? most : sum - sum;
}


static void MUS_FN(snapshot)(mus__sim *sim)
{
    memcpy(sim->last_good, sim->y, 6 * (size_t)sim->n * sizeof(MUS_REAL));
}


static void MUS_FN(restore)(mus__sim *sim)
{
    memcpy(sim->y, sim->last_good, 6 * (size_t)sim->n * sizeof(MUS_REAL));
    memset(sim->distance_cache, 0, (size_t)sim->n * sizeof *sim->distance_cache);
    sim->fresh = 0;
    if (MUS__SELF_OF(sim) != NULL) sim->self->invalid = 1;
}


const mus__sim_ops MUS_SIM = {
    .real = sizeof(MUS_REAL),
    .force = MUS_FN(force),
    .euler = MUS_FN(euler),
    .rk4 = MUS_FN(rk4),
    .verlet = MUS_FN(verlet),
    .put = MUS_FN(put),
    .get = MUS_FN(get),
    .add = MUS_FN(add),
    .get_force = MUS_FN(get_force),
    .set_node = MUS_FN(set_node),
    .flush = MUS_FN(flush),
    .speed2 = MUS_FN(speed2),
    .snapshot = MUS_FN(snapshot),
    .restore = MUS_FN(restore),
    .find_pairs = MUS_FN(find_pairs),
};
