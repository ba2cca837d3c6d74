/*
 * contraction.c: the cells of a force program that couple warp and weft (contraction.h).
 *
 * With q = |u|^2 / p^2 and i = 1 / (q^4 + 1):
 *
 *     psi = 1/4 - i / 2,   d psi / du = c u / p^2,   c = 4 q^3 i^2,
 *     d2 psi / du2 = -c (1 + 32 psi) / p^2 along u, c / p^2 across it
 */
#include <math.h>

#include "sim/contraction.h"

/* largest sum over both directions of the stiffness of a square cell over C, in any pose: computed from the formula
 * above over stretches from e^-1.2 to e^1.2 */
#define CELL_MOST 2.08

/* one edge vector of a cell: its direction, and psi with its derivatives for an edge of length 1 */
typedef struct cell_edge {
    double n[3], length, psi, slope, curve, across;
} cell_edge;


/* sign of corner k = a, a+1, b, b+1 in the edge vectors along weft and warp */
static const double cell_sign[2][4] = {{-1.0, 1.0, -1.0, 1.0}, {-1.0, -1.0, 1.0, 1.0}};


static void cell_corners(const mus__cell_run *run, int32_t i, int32_t *node)
{
    node[0] = run->a + i, node[1] = run->a + i + 1, node[2] = run->b + i, node[3] = run->b + i + 1;
}


static cell_edge cell_measure(const double *x, const int32_t *node, const double *sign, double side)
{
    cell_edge e = {{0.0}, 0.0, 0.0, 0.0, 0.0, 0.0};
    for (int32_t k = 0; k < 4; k++)
        for (int32_t d = 0; d < 3; d++) e.n[d] += 0.5 * sign[k] * x[3 * (int64_t)node[k] + d] / side;
    const double q = e.n[0] * e.n[0] + e.n[1] * e.n[1] + e.n[2] * e.n[2], i = 1.0 / (q * q * (q * q) + 1.0);
    e.length = sqrt(q);
    e.psi = 0.25 - 0.5 * i;
    e.across = 4.0 * (q * q * q * i) * i;
    e.slope = e.across * e.length;
    e.curve = -e.across * (1.0 + 32.0 * e.psi);
    for (int32_t d = 0; d < 3 && e.length > 0.0; d++) e.n[d] /= e.length;
    return e;
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
            const cell_edge u = cell_measure(x, node, cell_sign[0], side[0]);
            const cell_edge v = cell_measure(x, node, cell_sign[1], side[1]);
            energy += k * u.psi * v.psi;
            const double pu = -0.5 * k * v.psi * u.slope / side[0], pv = -0.5 * k * u.psi * v.slope / side[1];
            for (int32_t c = 0; c < 4 && f != NULL; c++)
                for (int32_t d = 0; d < 3; d++)
                    f[3 * (int64_t)node[c] + d] += cell_sign[0][c] * pu * u.n[d] + cell_sign[1][c] * pv * v.n[d];
        }
    return energy;
}


void mus__contraction_stiffness(const mus__program *program, double *t)
{
    const double *side = program->cell_side;
    if (program->ncell_run == 0) return;
    const double most = CELL_MOST * program->couple * fmax(side[0] / side[1], side[1] / side[0]);
    for (int32_t r = 0; r < program->ncell_run; r++)
        for (int32_t i = 0; i < program->cell_run[r].count; i++) {
            int32_t node[4];
            cell_corners(&program->cell_run[r], i, node);
            for (int32_t c = 0; c < 4; c++) t[node[c]] += most;
        }
}


/*
 * The second variation of E for changes U, V of the edge vectors, times 1 / C, with s = q / p:
 *
 *     s psi_v (curve_u (n_u U)^2 + across_u (|U|^2 - (n_u U)^2)) + 2 slope_u slope_v (n_u U) (n_v V) + the same of v
 *
 * where 2 (n_u U) (n_v V) <= (n_u U)^2 + (n_v V)^2, what is negative is left out, and |U|^2 is at most the sum of the
 * squares of the changes of the four corners, as the weights are 1/2.
 */
void mus__contraction_stiffness_at(const mus__program *program, const double *x, double *tangent)
{
    const double *side = program->cell_side;
    for (int32_t r = 0; r < program->ncell_run; r++)
        for (int32_t i = 0; i < program->cell_run[r].count; i++) {
            int32_t node[4];
            cell_corners(&program->cell_run[r], i, node);
            const cell_edge e[2] = {cell_measure(x, node, cell_sign[0], side[0]),
                                    cell_measure(x, node, cell_sign[1], side[1])};
            double sum[6] = {0.0};
            for (int32_t k = 0; k < 2; k++) {
                const double *n = e[k].n, other = e[1 - k].psi * side[1 - k] / side[k];
                const double along = program->couple * (e[0].slope * e[1].slope + fmax(0.0, other * e[k].curve));
                const double across = program->couple * fmax(0.0, other * e[k].across);
                for (int32_t d = 0; d < 3; d++) {
                    sum[d] += across + (along - across) * n[d] * n[d];
                    sum[3 + d] += (along - across) * n[d] * n[(d + 1) % 3];
                }
            }
            for (int32_t c = 0; c < 4; c++)
                for (int32_t d = 0; d < 6; d++) tangent[6 * (int64_t)node[c] + d] += sum[d];
        }
}
