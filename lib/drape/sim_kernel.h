/*
 * sim_kernel.h: the passes of a sim, as a template on the floating type.
 *
 * Define MUS_REAL, MUS_FN(name) (names of that type), MUS_SQRT, MUS_RK4 and MUS_CONTACT, then include. Loops are plain
 * and counted over planes, so that the compiler vectorises them; the plan's order fixes every sum.
 */

/* sqrt(l2 + TINY) keeps coincident nodes finite: the force is then 0 times a finite number */
#define TINY ((MUS_REAL)1e-20)


/* f += k (1 - rest/l) (b - a) on `count` pairs; planes are `n` apart */
static MUS_INLINE void MUS_FN(run_pull)(int64_t n, int32_t count, MUS_REAL k, MUS_REAL rest, const MUS_REAL *restrict a,
                                        const MUS_REAL *restrict b, MUS_REAL *restrict f)
{
    const MUS_REAL krest = k * rest;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL dx = b[i] - a[i], dy = b[n + i] - a[n + i], dz = b[2 * n + i] - a[2 * n + i];
        const MUS_REAL s = k - krest / MUS_SQRT(dx * dx + dy * dy + dz * dz + TINY);
        f[i] += s * dx, f[n + i] += s * dy, f[2 * n + i] += s * dz;
    }
}


/* f += w (a - 2 b + c) on one plane */
static MUS_INLINE void MUS_FN(bend_pull)(int32_t count, MUS_REAL w, const MUS_REAL *restrict a,
                                         const MUS_REAL *restrict b, const MUS_REAL *restrict c, MUS_REAL *restrict f)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) f[i] += w * (a[i] - 2 * b[i] + c[i]);
}


/* the three bend terms of a node between its neighbours, in one: f -= k (a - 4 b + 6 x - 4 c + d) */
static MUS_INLINE void MUS_FN(bend_whole)(int32_t count, MUS_REAL k, const MUS_REAL *restrict a,
                                          const MUS_REAL *restrict b, const MUS_REAL *restrict x,
                                          const MUS_REAL *restrict c, const MUS_REAL *restrict d, MUS_REAL *restrict f)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) f[i] -= k * ((a[i] + d[i]) - 4 * (b[i] + c[i]) + 6 * x[i]);
}


/* dashpot along the spring: c ((v_b - v_a).n) n */
static MUS_INLINE void MUS_FN(run_dash)(int64_t n, int32_t count, MUS_REAL c, const MUS_REAL *restrict a,
                                        const MUS_REAL *restrict b, MUS_REAL *restrict f)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL dx = b[i] - a[i], dy = b[n + i] - a[n + i], dz = b[2 * n + i] - a[2 * n + i];
        const MUS_REAL vx = b[3 * n + i] - a[3 * n + i], vy = b[4 * n + i] - a[4 * n + i];
        const MUS_REAL vz = b[5 * n + i] - a[5 * n + i];
        const MUS_REAL s = c * (dx * vx + dy * vy + dz * vz) / (dx * dx + dy * dy + dz * dz + TINY);
        f[i] += s * dx, f[n + i] += s * dy, f[2 * n + i] += s * dz;
    }
}


/* phase: lattice rows of one share */
MUS_CLONES
static void MUS_FN(rows)(mus__sim *sim, int32_t first, int32_t last)
{
    const mus__plan *plan = sim->plan;
    const int64_t n = sim->n;
    const MUS_REAL *y = sim->phase_y;
    MUS_REAL *f = sim->f;
    for (int32_t r = first; r < last; r++) {
        const mus__plan_row *row = &plan->row[r];
        const size_t bytes = (size_t)row->count * sizeof(MUS_REAL);
        for (int32_t d = 0; d < 3; d++) memset(f + d * n + row->first, 0, bytes);
        for (int32_t h = row->run; h < row->run + row->nrun; h++) {
            const mus__half_run *run = &plan->half_run[h];
            MUS_FN(run_pull)(n, run->count, (MUS_REAL)run->k, (MUS_REAL)run->rest, y + run->a, y + run->b, f + run->a);
        }
        for (int32_t h = row->bend; h < row->bend + row->nbend; h++) {
            const mus__half_bend *bend = &plan->half_bend[h];
            const MUS_REAL w = (MUS_REAL)bend->w;
            for (int32_t d = 0; d < 3; d++) {
                const MUS_REAL *x = y + d * n;
                if (bend->whole)
                    MUS_FN(bend_whole)(bend->count, w, x + bend->a, x + bend->b, x + bend->o, x + bend->c, x + bend->d,
                                       f + d * n + bend->o);
                else
                    MUS_FN(bend_pull)(bend->count, w, x + bend->a, x + bend->b, x + bend->c, f + d * n + bend->o);
            }
        }
    }
    if (!sim->dashpots || first == last) return;
    for (int32_t h = plan->row[first].run; first < last && h < plan->row[last - 1].run + plan->row[last - 1].nrun;
         h++) {
        const mus__half_run *run = &plan->half_run[h];
        MUS_FN(run_dash)(n, run->count, (MUS_REAL)run->dashpot, y + run->a, y + run->b, f + run->a);
    }
}


/* pull of spring s on its node a, into out (3) */
static inline void MUS_FN(spring_pull)(const mus__sim *sim, int32_t s, MUS_REAL *out)
{
    const mus__spring *spring = &sim->plan->spring[s];
    const int64_t n = sim->n;
    const MUS_REAL *a = (const MUS_REAL *)sim->phase_y + spring->a, *b = (const MUS_REAL *)sim->phase_y + spring->b;
    const MUS_REAL dx = b[0] - a[0], dy = b[n] - a[n], dz = b[2 * n] - a[2 * n];
    const MUS_REAL l2 = dx * dx + dy * dy + dz * dz + TINY, k = (MUS_REAL)spring->k;
    MUS_REAL pull = k - k * (MUS_REAL)spring->rest / MUS_SQRT(l2);
    if (sim->dashpots) {
        const MUS_REAL along =
            dx * (b[3 * n] - a[3 * n]) + dy * (b[4 * n] - a[4 * n]) + dz * (b[5 * n] - a[5 * n]);
        pull += (MUS_REAL)sim->plan->spring_dashpot[s] * along / l2;
    }
    out[0] = pull * dx, out[1] = pull * dy, out[2] = pull * dz;
}


/* pull of a seam pair on its node a: k d, at most the tension times the length it stands for */
static inline void MUS_FN(pair_pull)(const mus__sim *sim, const mus__pair *pair, MUS_REAL *out)
{
    const int64_t n = sim->n;
    const MUS_REAL *a = (const MUS_REAL *)sim->phase_y + pair->a, *b = (const MUS_REAL *)sim->phase_y + pair->b;
    const MUS_REAL dx = b[0] - a[0], dy = b[n] - a[n], dz = b[2 * n] - a[2 * n];
    const MUS_REAL cap = (MUS_REAL)(sim->plan->seam_pull * pair->length), k = pair->locked ? 0 : (MUS_REAL)pair->k;
    const MUS_REAL most = cap / MUS_SQRT(dx * dx + dy * dy + dz * dz + TINY);
    const MUS_REAL pull = k < most ? k : most;
    out[0] = pull * dx, out[1] = pull * dy, out[2] = pull * dz;
}


/* phase: elements of one share, into g */
static void MUS_FN(elements)(mus__sim *sim, int32_t first, int32_t last)
{
    const mus__plan *plan = sim->plan;
    const int64_t n = sim->n;
    const MUS_REAL *y = sim->phase_y;
    MUS_REAL *g = sim->g;
    for (int32_t e = first; e < last; e++) {
        MUS_REAL *out = g + 3 * (int64_t)e;
        if (e < plan->nspring) {
            MUS_FN(spring_pull)(sim, e, out);
        } else if (e < plan->nspring + plan->nhinge) {
            const mus__hinge *hinge = &plan->hinge[e - plan->nspring];
            const MUS_REAL k = (MUS_REAL)hinge->k;
            for (int32_t d = 0; d < 3; d++) {
                const MUS_REAL *x = y + d * n;
                MUS_REAL sum = 0;
                for (int32_t c = 0; c < 4; c++) sum += (MUS_REAL)hinge->coef[c] * x[hinge->node[c]];
                out[d] = k * sum;
            }
        } else {
            MUS_FN(pair_pull)(sim, &plan->pair[e - plan->nspring - plan->nhinge], out);
        }
    }
}


/* phase: nodes of one share gather their elements */
static void MUS_FN(gather)(mus__sim *sim, int32_t first, int32_t last)
{
    const mus__plan *plan = sim->plan;
    const int64_t n = sim->n;
    const MUS_REAL *g = sim->g;
    MUS_REAL *f = sim->f;
    for (int32_t i = first; i < last; i++) {
        const int32_t node = plan->gather_node[i];
        MUS_REAL s0 = 0, s1 = 0, s2 = 0;
        for (int32_t k = plan->gather_start[i]; k < plan->gather_start[i + 1]; k++) {
            const MUS_REAL *e = g + 3 * (int64_t)plan->gather_element[k];
            const MUS_REAL c = (MUS_REAL)plan->gather_coef[k];
            s0 += c * e[0], s1 += c * e[1], s2 += c * e[2];
        }
        if (plan->gather_lattice[i]) {
            f[node] += s0, f[n + node] += s1, f[2 * n + node] += s2;
        } else {
            f[node] = s0, f[n + node] = s1, f[2 * n + node] = s2;
        }
    }
}


/* v = (v + h (f/m + g)) / (1 + h drag), limited; x += h v; on one share of the nodes */
MUS_CLONES
static void MUS_FN(advance)(mus__sim *sim, int32_t first, int32_t last)
{
    const int64_t n = sim->n;
    const MUS_REAL h = (MUS_REAL)sim->phase_h, keep = (MUS_REAL)(1.0 / (1.0 + sim->phase_h * sim->drag));
    const MUS_REAL limit = (MUS_REAL)sim->speed_limit;
    const MUS_REAL g0 = (MUS_REAL)sim->gravity[0], g1 = (MUS_REAL)sim->gravity[1], g2 = (MUS_REAL)sim->gravity[2];
    MUS_REAL *restrict x = sim->y;
    MUS_REAL *restrict v = x + 3 * n;
    const MUS_REAL *restrict f = sim->f;
    const MUS_REAL *restrict inverse = sim->inverse, *restrict weight = sim->weight;
    for (int32_t i = first; i < last; i++) {
        MUS_REAL v0 = keep * (v[i] + h * (f[i] * inverse[i] + g0 * weight[i]));
        MUS_REAL v1 = keep * (v[n + i] + h * (f[n + i] * inverse[i] + g1 * weight[i]));
        MUS_REAL v2 = keep * (v[2 * n + i] + h * (f[2 * n + i] * inverse[i] + g2 * weight[i]));
        const MUS_REAL speed = MUS_SQRT(v0 * v0 + v1 * v1 + v2 * v2 + TINY);
        const MUS_REAL scale = speed > limit ? limit / speed : 1;
        v0 *= scale, v1 *= scale, v2 *= scale;
        v[i] = v0, v[n + i] = v1, v[2 * n + i] = v2;
        x[i] += h * v0, x[n + i] += h * v1, x[2 * n + i] += h * v2;
    }
}


/* ---- phases as the pool runs them ---- */

static void MUS_FN(phase_springs)(void *user, int32_t part, int32_t parts)
{
    mus__sim *sim = user;
    const mus__plan *plan = sim->plan;
    const int32_t elements = plan->nspring + plan->nhinge + plan->npair;
    MUS_FN(rows)(sim, mus__share(plan->nrow, part, parts), mus__share(plan->nrow, part + 1, parts));
    MUS_FN(elements)(sim, mus__share(elements, part, parts), mus__share(elements, part + 1, parts));
}


static void MUS_FN(phase_gather)(void *user, int32_t part, int32_t parts)
{
    mus__sim *sim = user;
    MUS_FN(gather)(sim, mus__share(sim->plan->ngather, part, parts), mus__share(sim->plan->ngather, part + 1, parts));
}


static void MUS_FN(phase_contact)(void *user, int32_t part, int32_t parts)
{
    mus__sim *sim = user;
    MUS_REAL *x = sim->y;
    sim->part_queries[part] += MUS_CONTACT(sim->collider, &sim->rule, sim->n, mus__share(sim->n, part, parts),
                                           mus__share(sim->n, part + 1, parts), sim->weight, sim->rest, x,
                                           x + 3 * (int64_t)sim->n);
}


static void MUS_FN(phase_advance)(void *user, int32_t part, int32_t parts)
{
    mus__sim *sim = user;
    MUS_FN(advance)(sim, mus__share(sim->n, part, parts), mus__share(sim->n, part + 1, parts));
    if (sim->collider != NULL) MUS_FN(phase_contact)(user, part, parts);
}


static void MUS_FN(evaluate)(mus__sim *sim, const MUS_REAL *y)
{
    sim->phase_y = y;
    mus__pool_run(sim->pool, MUS_FN(phase_springs), sim);
    mus__pool_run(sim->pool, MUS_FN(phase_gather), sim);
    sim->force_evaluations++;
}


static void MUS_FN(force)(mus__sim *sim)
{
    MUS_FN(evaluate)(sim, sim->y);
}


/* stitched pairs move as one: the mean by inertia of place and velocity; a pair within reach is stitched */
static void MUS_FN(stitch)(mus__sim *sim)
{
    mus__plan *plan = sim->plan;
    const int64_t n = sim->n;
    const MUS_REAL reach2 = (MUS_REAL)(sim->collision_distance * sim->collision_distance);
    const MUS_REAL *inverse = sim->inverse;
    for (int32_t p = 0; p < plan->npair; p++) {
        mus__pair *pair = &plan->pair[p];
        MUS_REAL *a = (MUS_REAL *)sim->y + pair->a, *b = (MUS_REAL *)sim->y + pair->b;
        if (!pair->locked) {
            const MUS_REAL dx = b[0] - a[0], dy = b[n] - a[n], dz = b[2 * n] - a[2 * n];
            if (!(dx * dx + dy * dy + dz * dz <= reach2)) continue;
            pair->locked = 1;
        }
        const MUS_REAL total = inverse[pair->a] + inverse[pair->b];
        const MUS_REAL share = total > 0 ? inverse[pair->a] / total : 0;
        for (int32_t d = 0; d < 6; d++) {
            const MUS_REAL mean = a[d * n] + share * (b[d * n] - a[d * n]);
            a[d * n] = b[d * n] = mean;
        }
    }
}


static void MUS_FN(euler)(mus__sim *sim, double h)
{
    MUS_FN(evaluate)(sim, sim->y);
    sim->phase_h = h;
    mus__pool_run(sim->pool, MUS_FN(phase_advance), sim);
    if (sim->plan->npair > 0) MUS_FN(stitch)(sim);
}


/* dy = (v, f/m + g - drag v) */
static void MUS_FN(rhs)(void *user, const MUS_REAL *y, MUS_REAL *dy)
{
    mus__sim *sim = user;
    const int64_t n = sim->n;
    MUS_FN(evaluate)(sim, y);
    const MUS_REAL drag = (MUS_REAL)sim->drag;
    const MUS_REAL *f = sim->f, *inverse = sim->inverse, *weight = sim->weight;
    memcpy(dy, y + 3 * n, (size_t)(3 * n) * sizeof *dy);
    for (int32_t d = 0; d < 3; d++) {
        const MUS_REAL g = (MUS_REAL)sim->gravity[d];
        const MUS_REAL *v = y + (3 + d) * n;
        MUS_REAL *a = dy + (3 + d) * n;
        for (int64_t i = 0; i < n; i++) a[i] = f[d * n + i] * inverse[i] + g * weight[i] - drag * v[i];
    }
}


static void MUS_FN(rk4)(mus__sim *sim, double h)
{
    MUS_RK4(6 * (int64_t)sim->n, sim->y, (MUS_REAL)h, MUS_FN(rhs), sim, sim->work);
    if (sim->collider != NULL) mus__pool_run(sim->pool, MUS_FN(phase_contact), sim);
}


/* ---- the world in doubles, (n x 3) ---- */

static void MUS_FN(put)(mus__sim *sim, const double *x, const double *v)
{
    const int64_t n = sim->n;
    MUS_REAL *y = sim->y;
    for (int64_t i = 0; i < n; i++)
        for (int32_t d = 0; d < 3; d++) {
            y[d * n + i] = (MUS_REAL)(x[3 * i + d] - sim->origin[d]);
            y[(3 + d) * n + i] = v != NULL ? (MUS_REAL)v[3 * i + d] : 0;
        }
    memset(sim->rest, 0, (size_t)n);
    MUS_REAL *good = sim->good;
    memcpy(good, y, (size_t)(6 * n) * sizeof *y);
}


static void MUS_FN(get)(const mus__sim *sim, double *x, double *v)
{
    const int64_t n = sim->n;
    const MUS_REAL *y = sim->y;
    for (int64_t i = 0; i < n; i++)
        for (int32_t d = 0; d < 3; d++) {
            x[3 * i + d] = (double)y[d * n + i] + sim->origin[d];
            v[3 * i + d] = (double)y[(3 + d) * n + i];
        }
}


static void MUS_FN(get_force)(const mus__sim *sim, double *out)
{
    const int64_t n = sim->n;
    const MUS_REAL *f = sim->f;
    for (int64_t i = 0; i < n; i++)
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
    for (int64_t i = 0; i < n; i++) {
        const double v0 = (double)y[3 * n + i], v1 = (double)y[4 * n + i], v2 = (double)y[5 * n + i];
        const double s = v0 * v0 + v1 * v1 + v2 * v2;
        most = s > most ? s : most;
        sum += s + 0.0 * ((double)y[i] + (double)y[n + i] + (double)y[2 * n + i]);
    }
    return mus__finite(sum) ? most : sum - sum;
}


static void MUS_FN(snapshot)(mus__sim *sim)
{
    memcpy(sim->good, sim->y, 6 * (size_t)sim->n * sizeof(MUS_REAL));
}


static void MUS_FN(restore)(mus__sim *sim)
{
    memcpy(sim->y, sim->good, 6 * (size_t)sim->n * sizeof(MUS_REAL));
    memset(sim->rest, 0, (size_t)sim->n);
}


const mus__sim_ops MUS_SIM = {
    .real = sizeof(MUS_REAL),
    .force = MUS_FN(force),
    .euler = MUS_FN(euler),
    .rk4 = MUS_FN(rk4),
    .put = MUS_FN(put),
    .get = MUS_FN(get),
    .get_force = MUS_FN(get_force),
    .set_node = MUS_FN(set_node),
    .speed2 = MUS_FN(speed2),
    .snapshot = MUS_FN(snapshot),
    .restore = MUS_FN(restore),
};
