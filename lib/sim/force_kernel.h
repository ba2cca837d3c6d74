/*
 * force_kernel.h: forces of one chunk of a program, as a template on the floating type (MUS_REAL, MUS_FN, MUS_SQRT, and
 * MUS_OVER_ROOT(a, x) for a / sqrt(x + 1e-20), where a is what the program's tables have).
 *
 * The loop over the lanes of a block has a constant count and no branch: it becomes straight vector code, sums in
 * registers, each force stored once. Lanes without a node write behind the chunk's nodes, where the next block, or
 * nothing, follows. Loops differ by what the cloth has, and are chosen once a chunk.
 */

/* sqrt(l2 + TINY) keeps coincident nodes finite */
#define TINY ((MUS_REAL)1e-20)
#define LANES MUS__LANES
#define SPAN (MUS__CHUNK_NODES + MUS__LANES) /* from plane to plane of a chunk's forces */


/* one block; y at its first node, planes n apart; f in the scratch. `near`, `far` and `dash` are constants */
static MUS_INLINE void MUS_FN(block_pull)(int64_t n, const MUS_REAL *restrict y,
                                          const mus__packet_shape *restrict shape, const MUS_REAL *restrict table,
                                          int32_t near, int32_t far, int32_t dash, MUS_REAL *restrict f)
{
    const MUS_REAL *restrict krest = table + near * LANES, *restrict w = krest + near * LANES;
    const MUS_REAL *restrict damp = w + far * LANES;
    for (int32_t i = 0; i < LANES; i++) {
        const MUS_REAL x0 = y[i], x1 = y[n + i], x2 = y[2 * n + i];
        MUS_REAL f0 = 0, f1 = 0, f2 = 0;
        MUS_UNROLL
        for (int32_t k = 0; k < near; k++) {
            const MUS_REAL *p = y + shape->near[k];
            const MUS_REAL d0 = p[i] - x0, d1 = p[n + i] - x1, d2 = p[2 * n + i] - x2;
            const MUS_REAL l2 = d0 * d0 + d1 * d1 + d2 * d2;
            MUS_REAL s = table[k * LANES + i] - MUS_OVER_ROOT(krest[k * LANES + i], l2);
            if (dash) {
                const MUS_REAL v0 = p[3 * n + i] - y[3 * n + i], v1 = p[4 * n + i] - y[4 * n + i];
                const MUS_REAL v2 = p[5 * n + i] - y[5 * n + i];
                s += damp[k * LANES + i] * (d0 * v0 + d1 * v1 + d2 * v2) / (l2 + TINY);
            }
            f0 += s * d0, f1 += s * d1, f2 += s * d2;
        }
        MUS_UNROLL
        for (int32_t k = 0; k < far; k++) {
            const MUS_REAL *p = y + shape->far[k];
            const MUS_REAL s = w[k * LANES + i];
            f0 += s * (p[i] - x0), f1 += s * (p[n + i] - x1), f2 += s * (p[2 * n + i] - x2);
        }
        f[i] = f0, f[SPAN + i] = f1, f[2 * SPAN + i] = f2;
    }
}


/* the blocks of a chunk, with one kind of loop */
#define MUS_BLOCKS(name, near, far, dash)                                                                              \
    MUS_CLONES                                                                                                         \
    static void MUS_FN(name)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)                                \
    {                                                                                                                  \
        const mus__program *program = sim->program;                                                                    \
        const int64_t size = mus__program_table_size(program);                                                         \
        for (int32_t b = chunk->packet; b < chunk->packet + chunk->npacket; b++) {                                     \
            const mus__packet *block = &program->packet[b];                                                            \
            MUS_FN(block_pull)                                                                                         \
            (sim->n, (const MUS_REAL *)sim->phase_y + block->first, &program->shape[block->shape],                     \
             (const MUS_REAL *)program->table + size * block->table, near, far, dash,                                  \
             f + (block->first - chunk->first));                                                                       \
        }                                                                                                              \
    }

MUS_BLOCKS(blocks_near4, 4, 0, 0)
MUS_BLOCKS(blocks_near4_far4, 4, 4, 0)
MUS_BLOCKS(blocks_near8, 8, 0, 0)
MUS_BLOCKS(blocks_near8_far4, 8, 4, 0)
MUS_BLOCKS(blocks_near8_far8, 8, 8, 0)
MUS_BLOCKS(blocks_paper, MUS__NEAR_SLOTS_MAX, 8, 0)
MUS_BLOCKS(blocks_near4_dash, 4, 0, 1)
MUS_BLOCKS(blocks_near4_far4_dash, 4, 4, 1)
MUS_BLOCKS(blocks_near8_dash, 8, 0, 1)
MUS_BLOCKS(blocks_near8_far4_dash, 8, 4, 1)
MUS_BLOCKS(blocks_near8_far8_dash, 8, 8, 1)
MUS_BLOCKS(blocks_paper_dash, MUS__NEAR_SLOTS_MAX, 8, 1)


/* the loop for what the program has */
static void MUS_FN(blocks)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)
{
    switch (10 * sim->program->near + sim->program->far + (sim->dashpots ? 1000 : 0)) {
    case 40: MUS_FN(blocks_near4)(sim, chunk, f); break;
    case 44: MUS_FN(blocks_near4_far4)(sim, chunk, f); break;
    case 80: MUS_FN(blocks_near8)(sim, chunk, f); break;
    case 84: MUS_FN(blocks_near8_far4)(sim, chunk, f); break;
    case 88: MUS_FN(blocks_near8_far8)(sim, chunk, f); break;
    case 1040: MUS_FN(blocks_near4_dash)(sim, chunk, f); break;
    case 1044: MUS_FN(blocks_near4_far4_dash)(sim, chunk, f); break;
    case 1080: MUS_FN(blocks_near8_dash)(sim, chunk, f); break;
    case 1084: MUS_FN(blocks_near8_far4_dash)(sim, chunk, f); break;
    case 1088: MUS_FN(blocks_near8_far8_dash)(sim, chunk, f); break;
    case 128: MUS_FN(blocks_paper)(sim, chunk, f); break;
    default: MUS_FN(blocks_paper_dash)(sim, chunk, f); break;
    }
}


/* ---- irregular nodes ---- */

/* `planes` numbers of each listed node: out (planes x LANES) */
static MUS_INLINE void MUS_FN(group_take)(int64_t n, const MUS_REAL *restrict y, const int32_t *restrict node,
                                          int32_t planes, MUS_REAL *restrict out)
{
    for (int32_t d = 0; d < planes; d++) {
        const MUS_REAL *restrict plane = y + d * n;
        for (int32_t i = 0; i < LANES; i++) out[d * LANES + i] = plane[node[i]];
    }
}


/* one half spring of each lane, from x to p (planes x LANES): sum += s (p - x); `dash` is a constant */
static MUS_INLINE void MUS_FN(half_pull)(const MUS_REAL *restrict c, const MUS_REAL *restrict x,
                                         const MUS_REAL *restrict p, int32_t dash, MUS_REAL *restrict sum)
{
    for (int32_t i = 0; i < LANES; i++) {
        const MUS_REAL d0 = p[i] - x[i], d1 = p[LANES + i] - x[LANES + i], d2 = p[2 * LANES + i] - x[2 * LANES + i];
        const MUS_REAL l2 = d0 * d0 + d1 * d1 + d2 * d2;
        MUS_REAL s = c[i] - MUS_OVER_ROOT(c[LANES + i], l2);
        if (dash) {
            const MUS_REAL v0 = p[3 * LANES + i] - x[3 * LANES + i], v1 = p[4 * LANES + i] - x[4 * LANES + i];
            const MUS_REAL v2 = p[5 * LANES + i] - x[5 * LANES + i];
            s += c[2 * LANES + i] * (d0 * v0 + d1 * v1 + d2 * v2) / (l2 + TINY);
        }
        sum[i] += s * d0, sum[LANES + i] += s * d1, sum[2 * LANES + i] += s * d2;
    }
}


/* a group's sums to its nodes; a lane that has the last node again adds zeros */
static MUS_INLINE void MUS_FN(group_add)(const int32_t *restrict node, int32_t first, const MUS_REAL *restrict sum,
                                         MUS_REAL *restrict f)
{
    for (int32_t i = 0; i < LANES; i++) {
        MUS_REAL *out = f + (node[i] - first);
        out[0] += sum[i], out[SPAN] += sum[LANES + i], out[2 * SPAN] += sum[2 * LANES + i];
    }
}


/* the groups of a chunk: half springs and weighted differences, added to f; `dash` is a constant */
static MUS_INLINE void MUS_FN(group_pull)(const mus__sim *sim, const mus__chunk *chunk, int32_t dash, MUS_REAL *f)
{
    const mus__sell *list = &sim->program->sell;
    const int64_t n = sim->n, constants = sim->program->dashpots ? 3 : 2;
    const int32_t planes = dash ? 6 : 3;
    for (int32_t g = chunk->slice; g < chunk->slice + chunk->nslice; g++) {
        const mus__sell_slice *group = &list->slice[g];
        const int32_t *node = list->node + (int64_t)g * LANES;
        MUS_REAL sum[3 * LANES] = {0}, x[6 * LANES], p[6 * LANES];
        MUS_FN(group_take)(n, sim->phase_y, node, planes, x);
        for (int64_t k = group->half; k < group->half + group->nhalf; k++) {
            MUS_FN(group_take)(n, sim->phase_y, list->half_other + k * LANES, planes, p);
            MUS_FN(half_pull)((const MUS_REAL *)list->half_constant + k * constants * LANES, x, p, dash, sum);
        }
        for (int64_t k = group->linear; k < group->linear + group->nlinear; k++) {
            const MUS_REAL *restrict w = (const MUS_REAL *)list->linear_weight + k * LANES;
            MUS_FN(group_take)(n, sim->phase_y, list->linear_other + k * LANES, 3, p);
            for (int32_t d = 0; d < 3; d++)
                for (int32_t i = 0; i < LANES; i++) sum[d * LANES + i] += w[i] * (p[d * LANES + i] - x[d * LANES + i]);
        }
        MUS_FN(group_add)(node, chunk->first, sum, f);
    }
}


MUS_CLONES
static void MUS_FN(groups)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)
{
    MUS_FN(group_pull)(sim, chunk, 0, f);
}


MUS_CLONES
static void MUS_FN(groups_dash)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)
{
    MUS_FN(group_pull)(sim, chunk, 1, f);
}


/* ends of seam pairs of a chunk: k d, d with the lift, at most the tension times the length of the pair */
static void MUS_FN(pair_pull)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)
{
    const mus__program *program = sim->program;
    const int64_t n = sim->n;
    const MUS_REAL *y = sim->phase_y;
    for (int32_t e = chunk->end; e < chunk->end + chunk->nend; e++) {
        const mus__pair_end *end = &program->pair_end[e];
        const mus__seam_pair *pair = &program->pair[end->pair];
        const MUS_REAL *a = y + end->node, *b = y + end->other;
        const MUS_REAL d0 = b[0] - a[0] + (MUS_REAL)pair->detour[0], d1 = b[n] - a[n] + (MUS_REAL)pair->detour[1];
        const MUS_REAL d2 = b[2 * n] - a[2 * n] + (MUS_REAL)pair->detour[2];
        const MUS_REAL cap = (MUS_REAL)(program->seam_pull * pair->pull_share * pair->length);
        const MUS_REAL k = (MUS_REAL)(pair->stitched ? pair->strap_k : pair->k);
        const MUS_REAL most = cap / MUS_SQRT(d0 * d0 + d1 * d1 + d2 * d2 + TINY);
        const MUS_REAL pull = k < most ? k : most;
        MUS_REAL *out = f + (end->node - chunk->first);
        out[0] += pull * d0, out[SPAN] += pull * d1, out[2 * SPAN] += pull * d2;
    }
}


/* held nodes of a chunk: up to their level where they are below it */
static void MUS_FN(held_pull)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)
{
    const mus__program *program = sim->program;
    const int64_t n = sim->n;
    for (int32_t h = chunk->attachment; h < chunk->attachment + chunk->nattachment; h++) {
        const mus__attachment *held = &program->attachment[h];
        const mus__level_plane *level = &program->level[held->level][held->right];
        const double *up = level->up, *origin = sim->origin;
        const MUS_REAL *x = (const MUS_REAL *)sim->phase_y + held->node;
        const MUS_REAL u0 = (MUS_REAL)up[0], u1 = (MUS_REAL)up[1], u2 = (MUS_REAL)up[2];
        const MUS_REAL at =
            (MUS_REAL)(level->at - held->below - (up[0] * origin[0] + up[1] * origin[1] + up[2] * origin[2]));
        const MUS_REAL sunk = at - (u0 * x[0] + u1 * x[n] + u2 * x[2 * n]);
        const MUS_REAL most = (MUS_REAL)(held->share * held->most);
        MUS_REAL pull = (MUS_REAL)held->k * (sunk > 0 ? sunk : 0), *out = f + (held->node - chunk->first);
        pull = pull < most ? pull : most;
        out[0] += pull * u0, out[SPAN] += pull * u1, out[2 * SPAN] += pull * u2;
    }
}


/* all forces of a chunk at phase_y into f (3 x SPAN) */
static void MUS_FN(chunk_force)(const mus__sim *sim, const mus__chunk *chunk, MUS_REAL *f)
{
    if (chunk->npacket > 0)
        MUS_FN(blocks)(sim, chunk, f);
    else
        for (int32_t d = 0; d < 3; d++) memset(f + d * SPAN, 0, (size_t)chunk->count * sizeof *f);
    if (sim->dashpots)
        MUS_FN(groups_dash)(sim, chunk, f);
    else
        MUS_FN(groups)(sim, chunk, f);
    MUS_FN(pair_pull)(sim, chunk, f);
    if (chunk->nattachment > 0) MUS_FN(held_pull)(sim, chunk, f);
}
