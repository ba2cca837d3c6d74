/*
 * contraction.c: the cells of a force program that couple warp and weft (contraction.h).
 *
 * The two edges along one way are the 6-vector w = (e1, e2) / (p root 2), of length r. With i = 1 / (r^8 + 1):
 *
 *     psi = 1/4 - i / 2,   d psi / dw = c w,   c = 4 r^6 i^2,
 *     d2 psi / dw2 = -c (1 + 32 psi) along w, c across it
 */
#include <math.h>

#include "sim/contraction.h"

/* largest sum over both directions of the stiffness of a square cell over C, in any pose: computed from the formula
 * above over stretches from e^-1.2 to e^1.2 */
#define CONTRACTION_MOST 2.08

/* the edges of a cell along one way: their vectors over the rest length, and psi with its derivatives by w */
typedef struct cell_edges {
    double e[2][3], r, psi, across, curve;
} cell_edges;

/* corners a, a+1, b, b+1 at the ends of the two edges along weft, and along warp */
static const int32_t cell_ends[2][2][2] = {{{0, 1}, {2, 3}}, {{0, 2}, {1, 3}}};


static void cell_corners(const mus__cell_run *run, int32_t i, int32_t *node)
{
    node[0] = run->a + i, node[1] = run->a + i + 1, node[2] = run->b + i, node[3] = run->b + i + 1;
}


static cell_edges cell_measure(const double *x, const int32_t *node, int32_t way, double side)
{
    cell_edges w;
    double sum = 0.0;
    for (int32_t k = 0; k < 2; k++)
        for (int32_t d = 0; d < 3; d++) {
            const int32_t *end = cell_ends[way][k];
            w.e[k][d] = (x[3 * (int64_t)node[end[1]] + d] - x[3 * (int64_t)node[end[0]] + d]) / side;
            sum += w.e[k][d] * w.e[k][d];
        }
    const double q = 0.5 * sum, i = 1.0 / (q * q * (q * q) + 1.0);
    w.r = sqrt(q);
    w.psi = 0.25 - 0.5 * i;
    w.across = 4.0 * (q * q * q * i) * i;
    w.curve = -w.across * (1.0 + 32.0 * w.psi);
    return w;
}


/* the part of cells first .. last of a run that has corners in a chunk; returns the number of pieces, 0 to 2 */
static int32_t cell_pieces(const mus__chunk *chunk, const mus__cell_run *run, mus__cell_run *out)
{
    const int32_t line[2] = {run->a, run->b}, end = chunk->first + chunk->count;
    int32_t n = 0;
    for (int32_t k = 0; k < 2; k++) {
        int32_t from = chunk->first - line[k] - 1, to = end - line[k];
        if (from < 0) from = 0;
        if (to > run->count) to = run->count;
        if (from >= to) continue;
        mus__cell_run *last = n > 0 ? &out[n - 1] : NULL;
        const int32_t was = last != NULL ? last->a - run->a : 0;
        if (last != NULL && from <= was + last->count && to >= was) {
            const int32_t low = from < was ? from : was, high = to > was + last->count ? to : was + last->count;
            *last = (mus__cell_run){run->a + low, run->b + low, high - low};
        } else {
            out[n++] = (mus__cell_run){run->a + from, run->b + from, to - from};
        }
    }
    return n;
}


/* counts the pieces of all chunks, or (program->cell there) writes them */
static int64_t cell_spread(const mus_cloth *cloth, mus__program *program)
{
    int64_t count = 0;
    for (int32_t c = 0; c < program->nchunk; c++) {
        mus__chunk *chunk = &program->chunk[c];
        if (program->cell != NULL) chunk->cell = (int32_t)count;
        for (int32_t r = 0; r < cloth->ncell; r++) {
            mus__cell_run piece[2];
            const int32_t n = cell_pieces(chunk, &cloth->cell[r], piece);
            for (int32_t i = 0; i < n && program->cell != NULL; i++) program->cell[count + i] = piece[i];
            count += n;
        }
        if (program->cell != NULL) chunk->ncell = (int32_t)count - chunk->cell;
    }
    return count;
}


mus_status mus__contraction_create(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    if (cloth->ncell == 0) return MUS_OK;
    program->cell = mus__new(context, cell_spread(cloth, program), sizeof *program->cell);
    if (program->cell == NULL) return mus__fail_memory(context, "the cells of a drape");
    cell_spread(cloth, program);
    program->ncell_run = cloth->ncell;
    program->cell_run = cloth->cell;
    program->couple = cloth->couple;
    program->couple_share = cloth->couple_share;
    program->cell_side[0] = cloth->cell_side[0], program->cell_side[1] = cloth->cell_side[1];
    return MUS_OK;
}


double mus__contraction_force(const mus__program *program, const double *x, double *f)
{
    const double *side = program->cell_side, k = program->couple * side[0] * side[1];
    double energy = 0.0;
    for (int32_t r = 0; r < program->ncell_run; r++)
        for (int32_t i = 0; i < program->cell_run[r].count; i++) {
            int32_t node[4];
            cell_corners(&program->cell_run[r], i, node);
            const cell_edges w[2] = {cell_measure(x, node, 0, side[0]), cell_measure(x, node, 1, side[1])};
            energy += k * w[0].psi * w[1].psi;
            for (int32_t way = 0; way < 2 && f != NULL; way++)
                for (int32_t m = 0; m < 6; m++) {
                    const int32_t *end = cell_ends[way][m / 3], d = m % 3;
                    const double pull = 0.5 * k * w[1 - way].psi * w[way].across / side[way] * w[way].e[m / 3][d];
                    f[3 * (int64_t)node[end[0]] + d] += pull;
                    f[3 * (int64_t)node[end[1]] + d] -= pull;
                }
        }
    return energy;
}


void mus__contraction_stiffness(const mus__program *program, double *t)
{
    const double *side = program->cell_side;
    if (program->ncell_run == 0) return;
    const double most = CONTRACTION_MOST * program->couple * fmax(side[0] / side[1], side[1] / side[0]);
    for (int32_t r = 0; r < program->ncell_run; r++)
        for (int32_t i = 0; i < program->cell_run[r].count; i++) {
            int32_t node[4];
            cell_corners(&program->cell_run[r], i, node);
            for (int32_t c = 0; c < 4; c++) t[node[c]] += most;
        }
}


/* adds to the matrices of the ends of a way's edges: `along` the edge, `across` it */
static void cell_tangent(const cell_edges *w, int32_t way, const int32_t *node, double along, double across, double *t)
{
    for (int32_t m = 0; m < 4; m++) {
        const double *e = w->e[m / 2], size2 = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
        const double more = size2 > 0.0 ? fmax(0.0, along - across) / size2 : 0.0, all = size2 > 0.0 ? across : along;
        double *out = t + 6 * (int64_t)node[cell_ends[way][m / 2][m % 2]];
        for (int32_t d = 0; d < 3; d++) {
            out[d] += all + more * e[d] * e[d];
            out[3 + d] += more * e[d] * e[(d + 1) % 3];
        }
    }
}


/*
 * The second variation of E for changes W, Z of the edges along and across, times 1 / C, with w, z their directions:
 *
 *     q/p psi_z (curve_w (w W)^2 + across_w (|W|^2 - (w W)^2)) + 2 c_w r_w c_z r_z (w W) (z Z) + the same of z
 *
 * where 2 (w W) (z Z) <= (w W)^2 + (z Z)^2 and what is negative is left out. |W|^2 is at most the sum of the squares of
 * the changes of the four corners, and (w W)^2 that of their parts along the edges.
 */
void mus__contraction_stiffness_at(const mus__program *program, const double *x, double *tangent)
{
    const double *side = program->cell_side;
    for (int32_t r = 0; r < program->ncell_run; r++)
        for (int32_t i = 0; i < program->cell_run[r].count; i++) {
            int32_t node[4];
            cell_corners(&program->cell_run[r], i, node);
            const cell_edges w[2] = {cell_measure(x, node, 0, side[0]), cell_measure(x, node, 1, side[1])};
            const double both = w[0].across * w[0].r * (w[1].across * w[1].r);
            for (int32_t way = 0; way < 2; way++) {
                const double other = w[1 - way].psi * side[1 - way] / side[way];
                const double along = program->couple * (both + fmax(0.0, other * w[way].curve));
                cell_tangent(&w[way], way, node, along, program->couple * fmax(0.0, other * w[way].across), tangent);
            }
        }
}
