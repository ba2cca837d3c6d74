/*
 * contraction_kernel.h: the cells of a chunk that couple warp and weft (contraction.h), as a template on the floating
 * type (included by force_kernel.h).
 *
 * Cells are taken 16 at a time, one to a lane. A cell on the border of two chunks is computed in both, and each keeps
 * the forces on its own nodes.
 */

/* constants of all cells: C p q / 2, 1 / (2 p^2), 1 / (2 q^2) */
typedef struct MUS__NAME(cell_constants) {
    MUS__REAL k, over[2];
} MUS__NAME(cell_constants);


/* forces on the corners a, a+1, b, b+1 of 16 cells, each 3 planes of 16; 0 from lane `count` on */
static MUS_INLINE void MUS__NAME(cell_pull)(int64_t n, const MUS__REAL *restrict a, const MUS__REAL *restrict b,
                                            int32_t count, const MUS__NAME(cell_constants) *c, MUS__REAL *restrict pull)
{
    enum { PLANES = 3 * MUS__LANES };
    for (int32_t i = 0; i < MUS__LANES; i++) {
        MUS__REAL qu = 0, qv = 0;
        MUS_UNROLL
        for (int32_t d = 0; d < 3; d++) {
            const MUS__REAL low = a[d * n + i + 1] - a[d * n + i], high = b[d * n + i + 1] - b[d * n + i];
            const MUS__REAL left = b[d * n + i] - a[d * n + i], right = b[d * n + i + 1] - a[d * n + i + 1];
            qu += low * low + high * high, qv += left * left + right * right;
        }
        qu *= c->over[0], qv *= c->over[1];
        const MUS__REAL u2 = qu * qu, v2 = qv * qv, iu = 1 / (u2 * u2 + 1), iv = 1 / (v2 * v2 + 1);
        const MUS__REAL k = i < count ? c->k : 0;
        const MUS__REAL pu = k * c->over[0] * ((MUS__REAL)0.25 - iv / 2) * (8 * (u2 * qu * iu) * iu);
        const MUS__REAL pv = k * c->over[1] * ((MUS__REAL)0.25 - iu / 2) * (8 * (v2 * qv * iv) * iv);
        MUS_UNROLL
        for (int32_t d = 0; d < 3; d++) {
            const MUS__REAL low = pu * (a[d * n + i + 1] - a[d * n + i]), high = pu * (b[d * n + i + 1] - b[d * n + i]);
            const MUS__REAL left = pv * (b[d * n + i] - a[d * n + i]);
            const MUS__REAL right = pv * (b[d * n + i + 1] - a[d * n + i + 1]);
            MUS__REAL *out = pull + d * MUS__LANES + i;
            out[0] = low + left, out[PLANES] = right - low;
            out[2 * PLANES] = high - left, out[3 * PLANES] = -high - right;
        }
    }
}


/* adds 3 planes of 16 to the chunk's forces from its node `at` on, which may be outside */
static MUS_INLINE void MUS__NAME(cell_add)(int32_t at, int32_t nodes, const MUS__REAL *restrict from,
                                           MUS__REAL *restrict f)
{
    if (at >= nodes) return;
    MUS_ROLLED
    for (int32_t d = 0; d < 3; d++) {
        MUS__REAL *restrict out = f + d * MUS__SPAN + at;
        if (at >= 0)
            for (int32_t i = 0; i < MUS__LANES; i++) out[i] += from[d * MUS__LANES + i];
        else
            for (int32_t i = -at; i < MUS__LANES; i++) out[i] += from[d * MUS__LANES + i];
    }
}


/* adds the forces of the cells at the nodes of a chunk */
MUS_CLONES
static void MUS__NAME(cells)(const mus__sim *sim, const mus__chunk *chunk, MUS__REAL *f)
{
    const mus__program *program = sim->program;
    const double *side = program->cell_side;
    const MUS__NAME(cell_constants) c = {(MUS__REAL)(0.5 * program->couple * side[0] * side[1]),
                                         {(MUS__REAL)(0.5 / (side[0] * side[0])),
                                          (MUS__REAL)(0.5 / (side[1] * side[1]))}};
    const MUS__REAL *y = sim->phase_y;
    for (int32_t r = chunk->cell; r < chunk->cell + chunk->ncell; r++) {
        const mus__cell_run *run = &program->cell[r];
        for (int32_t i = 0; i < run->count; i += MUS__LANES) {
            MUS__REAL pull[12 * MUS__LANES];
            MUS__NAME(cell_pull)(sim->n, y + run->a + i, y + run->b + i, run->count - i, &c, pull);
            MUS_ROLLED
            for (int32_t k = 0; k < 4; k++)
                MUS__NAME(cell_add)((k < 2 ? run->a : run->b) + i + k % 2 - chunk->first, chunk->count,
                                    pull + 3 * k * MUS__LANES, f);
        }
    }
}
