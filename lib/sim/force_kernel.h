/*
 * force_kernel.h: the forces of one chunk of a program, as a template on the floating type (MUS__REAL, MUS__NAME,
 * MUS__SQRT, and MUS__OVER_ROOT(a, x) for a / sqrt(x + 1e-20), where a is a number of the program's tables).
 *
 * The loop over the lanes of a packet has a constant count and no branch: it becomes straight vector code, with sums in
 * registers, and each force is stored once. Lanes without a node write behind the chunk's nodes, where the next packet,
 * or nothing, follows. There is one loop for each set of items that a cloth may have, chosen once a chunk.
 */

/* [m2] added to a squared length, so that coincident nodes give finite numbers */
#define MUS__TINY2 ((MUS__REAL)1e-20)
#define MUS__SPAN (MUS__CHUNK_NODES + MUS__LANES) /* from plane to plane of a chunk's forces */


/* forces of one packet; y at its first node, planes n apart; f in the scratch. near, far and dash are constants */
static MUS_INLINE void MUS__NAME(packet_pull)(int64_t n, const MUS__REAL *restrict y,
                                              const mus__packet_shape *restrict shape, const MUS__REAL *restrict table,
                                              int32_t near, int32_t far, int32_t dash, MUS__REAL *restrict f)
{
    const MUS__REAL *restrict krest = table + near * MUS__LANES, *restrict w = krest + near * MUS__LANES;
    const MUS__REAL *restrict damp = w + far * MUS__LANES;
    for (int32_t i = 0; i < MUS__LANES; i++) {
        const MUS__REAL x0 = y[i], x1 = y[n + i], x2 = y[2 * n + i];
        MUS__REAL f0 = 0, f1 = 0, f2 = 0;
        MUS_UNROLL
        for (int32_t k = 0; k < near; k++) {
            const MUS__REAL *p = y + shape->near[k];
            const MUS__REAL d0 = p[i] - x0, d1 = p[n + i] - x1, d2 = p[2 * n + i] - x2;
            const MUS__REAL l2 = d0 * d0 + d1 * d1 + d2 * d2;
            MUS__REAL s = table[k * MUS__LANES + i] - MUS__OVER_ROOT(krest[k * MUS__LANES + i], l2);
            if (dash) {
                const MUS__REAL v0 = p[3 * n + i] - y[3 * n + i], v1 = p[4 * n + i] - y[4 * n + i];
                const MUS__REAL v2 = p[5 * n + i] - y[5 * n + i];
                s += damp[k * MUS__LANES + i] * (d0 * v0 + d1 * v1 + d2 * v2) / (l2 + MUS__TINY2);
            }
            f0 += s * d0, f1 += s * d1, f2 += s * d2;
        }
        MUS_UNROLL
        for (int32_t k = 0; k < far; k++) {
            const MUS__REAL *p = y + shape->far[k];
            const MUS__REAL s = w[k * MUS__LANES + i];
            f0 += s * (p[i] - x0), f1 += s * (p[n + i] - x1), f2 += s * (p[2 * n + i] - x2);
        }
        f[i] = f0, f[MUS__SPAN + i] = f1, f[2 * MUS__SPAN + i] = f2;
    }
}


/* the packets of a chunk, with one kind of loop */
#define MUS__PACKETS(name, near, far, dash)                                                                            \
    MUS_CLONES                                                                                                         \
    static void MUS__NAME(name)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)                            \
    {                                                                                                                  \
        const mus__program *program = sim->program;                                                                    \
        const int64_t size = mus__program_table_size(program);                                                         \
        for (int32_t b = chunk->packet; b < chunk->packet + chunk->npacket; b++) {                                     \
            const mus__packet *block = &program->packet[b];                                                            \
            MUS__NAME(packet_pull)                                                                                     \
            (sim->n, (const MUS__REAL *)sim->phase_y + block->first, &program->shape[block->shape],                    \
             (const MUS__REAL *)program->table + size * block->table, near, far, dash,                                 \
             f + (block->first - chunk->first));                                                                       \
        }                                                                                                              \
    }

MUS__PACKETS(packets_near4, 4, 0, 0)
MUS__PACKETS(packets_near4_far4, 4, 4, 0)
MUS__PACKETS(packets_near8, 8, 0, 0)
MUS__PACKETS(packets_near8_far4, 8, 4, 0)
MUS__PACKETS(packets_near8_far8, 8, 8, 0)
MUS__PACKETS(packets_paper, MUS__NEAR_SLOTS_MAX, 8, 0)
MUS__PACKETS(packets_near4_dash, 4, 0, 1)
MUS__PACKETS(packets_near4_far4_dash, 4, 4, 1)
MUS__PACKETS(packets_near8_dash, 8, 0, 1)
MUS__PACKETS(packets_near8_far4_dash, 8, 4, 1)
MUS__PACKETS(packets_near8_far8_dash, 8, 8, 1)
MUS__PACKETS(packets_paper_dash, MUS__NEAR_SLOTS_MAX, 8, 1)


/* the packets of a chunk, with the loop for the program's items */
static void MUS__NAME(packets)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    switch (10 * sim->program->near + sim->program->far + (sim->dashpots ? 1000 : 0)) {
    case 40: MUS__NAME(packets_near4)(sim, chunk, f); break;
    case 44: MUS__NAME(packets_near4_far4)(sim, chunk, f); break;
    case 80: MUS__NAME(packets_near8)(sim, chunk, f); break;
    case 84: MUS__NAME(packets_near8_far4)(sim, chunk, f); break;
    case 88: MUS__NAME(packets_near8_far8)(sim, chunk, f); break;
    case 1040: MUS__NAME(packets_near4_dash)(sim, chunk, f); break;
    case 1044: MUS__NAME(packets_near4_far4_dash)(sim, chunk, f); break;
    case 1080: MUS__NAME(packets_near8_dash)(sim, chunk, f); break;
    case 1084: MUS__NAME(packets_near8_far4_dash)(sim, chunk, f); break;
    case 1088: MUS__NAME(packets_near8_far8_dash)(sim, chunk, f); break;
    case 128: MUS__NAME(packets_paper)(sim, chunk, f); break;
    default: MUS__NAME(packets_paper_dash)(sim, chunk, f); break;
    }
}


/* ---- irregular nodes ---- */

/* `planes` numbers of each listed node: out (planes x lanes) */
static MUS_INLINE void MUS__NAME(slice_take)(int64_t n, const MUS__REAL *restrict y, const int32_t *restrict node,
                                             int32_t planes, MUS__REAL *restrict out)
{
    for (int32_t d = 0; d < planes; d++) {
        const MUS__REAL *restrict plane = y + d * n;
        for (int32_t i = 0; i < MUS__LANES; i++) out[d * MUS__LANES + i] = plane[node[i]];
    }
}


/* one half spring of each lane, from x to p (planes x lanes): sum += s (p - x); dash is a constant */
static MUS_INLINE void MUS__NAME(half_pull)(const MUS__REAL *restrict c, const MUS__REAL *restrict x,
                                            const MUS__REAL *restrict p, int32_t dash, MUS__REAL *restrict sum)
{
    for (int32_t i = 0; i < MUS__LANES; i++) {
        const MUS__REAL d0 = p[i] - x[i], d1 = p[MUS__LANES + i] - x[MUS__LANES + i],
                        d2 = p[2 * MUS__LANES + i] - x[2 * MUS__LANES + i];
        const MUS__REAL l2 = d0 * d0 + d1 * d1 + d2 * d2;
        MUS__REAL s = c[i] - MUS__OVER_ROOT(c[MUS__LANES + i], l2);
        if (dash) {
            const MUS__REAL v0 = p[3 * MUS__LANES + i] - x[3 * MUS__LANES + i],
                            v1 = p[4 * MUS__LANES + i] - x[4 * MUS__LANES + i];
            const MUS__REAL v2 = p[5 * MUS__LANES + i] - x[5 * MUS__LANES + i];
            s += c[2 * MUS__LANES + i] * (d0 * v0 + d1 * v1 + d2 * v2) / (l2 + MUS__TINY2);
        }
        sum[i] += s * d0, sum[MUS__LANES + i] += s * d1, sum[2 * MUS__LANES + i] += s * d2;
    }
}


/* adds the sums of a slice to its nodes; a lane that names the last node again adds zeros */
static MUS_INLINE void MUS__NAME(slice_add)(const int32_t *restrict node, int32_t first, const MUS__REAL *restrict sum,
                                            MUS__REAL *restrict f)
{
    for (int32_t i = 0; i < MUS__LANES; i++) {
        MUS__REAL *out = f + (node[i] - first);
        out[0] += sum[i], out[MUS__SPAN] += sum[MUS__LANES + i], out[2 * MUS__SPAN] += sum[2 * MUS__LANES + i];
    }
}


/* adds the slices of a chunk to f: half springs and weighted differences; dash is a constant */
static MUS_INLINE void MUS__NAME(slice_pull)(const mus__sim *sim, const mus__chunk *chunk, int32_t dash, MUS__REAL *f)
{
    const mus__sell *list = &sim->program->sell;
    const int64_t n = sim->n, constants = sim->program->dashpots ? 3 : 2;
    const int32_t planes = dash ? 6 : 3;
    for (int32_t g = chunk->slice; g < chunk->slice + chunk->nslice; g++) {
        const mus__sell_slice *group = &list->slice[g];
        const int32_t *node = list->node + (int64_t)g * MUS__LANES;
        MUS__REAL sum[3 * MUS__LANES] = {0}, x[6 * MUS__LANES], p[6 * MUS__LANES];
        MUS__NAME(slice_take)(n, sim->phase_y, node, planes, x);
        for (int64_t k = group->half; k < group->half + group->nhalf; k++) {
            MUS__NAME(slice_take)(n, sim->phase_y, list->half_other + k * MUS__LANES, planes, p);
            MUS__NAME(half_pull)((const MUS__REAL *)list->half_constant + k * constants * MUS__LANES, x, p, dash, sum);
        }
        for (int64_t k = group->linear; k < group->linear + group->nlinear; k++) {
            const MUS__REAL *restrict w = (const MUS__REAL *)list->linear_weight + k * MUS__LANES;
            MUS__NAME(slice_take)(n, sim->phase_y, list->linear_other + k * MUS__LANES, 3, p);
            for (int32_t d = 0; d < 3; d++)
                for (int32_t i = 0; i < MUS__LANES; i++)
                    sum[d * MUS__LANES + i] += w[i] * (p[d * MUS__LANES + i] - x[d * MUS__LANES + i]);
        }
        MUS__NAME(slice_add)(node, chunk->first, sum, f);
    }
}


MUS_CLONES
static void MUS__NAME(slices)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    MUS__NAME(slice_pull)(sim, chunk, 0, f);
}


MUS_CLONES
static void MUS__NAME(slices_dash)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    MUS__NAME(slice_pull)(sim, chunk, 1, f);
}


/* adds the pull at the pair ends of a chunk: k d, with the detour in d, at most the tension times the pair's length */
static void MUS__NAME(pair_pull)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    const mus__program *program = sim->program;
    const int64_t n = sim->n;
    const MUS__REAL *y = sim->phase_y;
    for (int32_t e = chunk->end; e < chunk->end + chunk->nend; e++) {
        const mus__pair_end *end = &program->pair_end[e];
        const mus__seam_pair *pair = &program->pair[end->pair];
        const MUS__REAL *a = y + end->node, *b = y + end->other;
        const MUS__REAL d0 = b[0] - a[0] + (MUS__REAL)pair->detour[0], d1 = b[n] - a[n] + (MUS__REAL)pair->detour[1];
        const MUS__REAL d2 = b[2 * n] - a[2 * n] + (MUS__REAL)pair->detour[2];
        const MUS__REAL cap = (MUS__REAL)(program->seam_pull * pair->pull_share * pair->length);
        const MUS__REAL k = (MUS__REAL)(pair->stitched ? pair->strap_k : pair->k);
        const MUS__REAL most = cap / MUS__SQRT(d0 * d0 + d1 * d1 + d2 * d2 + MUS__TINY2);
        const MUS__REAL pull = k < most ? k : most;
        MUS__REAL *out = f + (end->node - chunk->first);
        out[0] += pull * d0, out[MUS__SPAN] += pull * d1, out[2 * MUS__SPAN] += pull * d2;
    }
}


/* adds the pull of the attachments of a chunk: up, for nodes below their level planes */
static void MUS__NAME(held_pull)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    const mus__program *program = sim->program;
    const int64_t n = sim->n;
    for (int32_t h = chunk->attachment; h < chunk->attachment + chunk->nattachment; h++) {
        const mus__attachment *held = &program->attachment[h];
        const mus__level_plane *level = &program->level[held->level][held->right];
        const double *up = level->up, *origin = sim->origin;
        const MUS__REAL *x = (const MUS__REAL *)sim->phase_y + held->node;
        const MUS__REAL u0 = (MUS__REAL)up[0], u1 = (MUS__REAL)up[1], u2 = (MUS__REAL)up[2];
        const MUS__REAL at =
            (MUS__REAL)(level->at - held->below - (up[0] * origin[0] + up[1] * origin[1] + up[2] * origin[2]));
        const MUS__REAL sunk = at - (u0 * x[0] + u1 * x[n] + u2 * x[2 * n]);
        const MUS__REAL most = (MUS__REAL)(held->share * held->most);
        MUS__REAL pull = (MUS__REAL)held->k * (sunk > 0 ? sunk : 0), *out = f + (held->node - chunk->first);
        pull = pull < most ? pull : most;
        out[0] += pull * u0, out[MUS__SPAN] += pull * u1, out[2 * MUS__SPAN] += pull * u2;
    }
}


#include "sim/bend_slider_kernel.h"
#include "sim/contraction_kernel.h"


/* adds the bending of the clamps of a chunk */
static void MUS__NAME(clamp_bend)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    const int64_t n = sim->n;
    for (int32_t k = chunk->clamp; k < chunk->clamp + chunk->nclamp; k++) {
        const mus__hinge *clamp = &sim->program->clamp[k];
        const MUS__REAL c0 = (MUS__REAL)clamp->coef[0], c1 = (MUS__REAL)clamp->coef[1],
                        c2 = (MUS__REAL)clamp->coef[2], c3 = (MUS__REAL)clamp->coef[3];
        for (int64_t d = 0; d < 3; d++) {
            const MUS__REAL *x = (const MUS__REAL *)sim->phase_y + d * n;
            const MUS__REAL e = c0 * x[clamp->node[0]] + c1 * x[clamp->node[1]] + c2 * x[clamp->node[2]] +
                                c3 * x[clamp->node[3]];
            f[d * MUS__SPAN + clamp->node[0] - chunk->first] -= (MUS__REAL)clamp->k * c0 * e;
        }
    }
}


/* all forces of a chunk at phase_y: f (3 x MUS__SPAN) */
static void MUS__NAME(chunk_force)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    if (chunk->npacket > 0)
        MUS__NAME(packets)(sim, chunk, f);
    else
        for (int32_t d = 0; d < 3; d++) memset(f + d * MUS__SPAN, 0, (size_t)chunk->count * sizeof *f);
    if (sim->dashpots)
        MUS__NAME(slices_dash)(sim, chunk, f);
    else
        MUS__NAME(slices)(sim, chunk, f);
    MUS__NAME(pair_pull)(sim, chunk, f);
    if (chunk->nattachment > 0) MUS__NAME(held_pull)(sim, chunk, f);
    if (chunk->ncell > 0) MUS__NAME(cells)(sim, chunk, f);
    if (chunk->nclamp > 0) MUS__NAME(clamp_bend)(sim, chunk, f);
    if (sim->program->nslider > 0) MUS__NAME(slide_add)(sim, chunk, f);
}
