/*
 * calibrate_bending.c: hinges brought to the rigidity of the fabric, panel by panel.
 *
 * On a cylinder of curvature K every element of bending, lattice or hinge, has the energy 1/2 k p K^2 with a p of its
 * own for each direction; a panel of area A should have 1/2 B A K^2. Triangles of the strip miss that by some per cent,
 * at a free border most. So the hinges of a panel change by the least sum of squares of (change / first value) that
 * makes
 *
 *     sum of k p  =  B A  -  lattice  -  half of the seams' hinges
 *
 * along weft, warp, and both bias directions: a panel, sewn or not, then bends as its fabric at every spacing. A hinge
 * keeps half of its first value at least and doubles at most.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "cloth/mesh.h"

/* rounds of the fit; hinges at a limit drop out from round to round. Chosen */
#define CALIBRATE_ROUNDS 8
/* range of a hinge's stiffness, over its first value. Chosen: no hinge may vanish or lower the step bound much */
#define CALIBRATE_LEAST 0.5
#define CALIBRATE_MOST 2.0
/* hinges of a panel below which it is not calibrated: four sums cannot be met by so few. Chosen */
#define CALIBRATE_FEWEST 12
/* ridge added to the normal equations, over their diagonal: a direction in which no hinge of the panel bends (a strap
 * one triangle wide) is left as it is. Chosen: far above rounding, far below the change of any other direction */
#define CALIBRATE_RIDGE 1e-6

/* along weft, warp, and both bias directions */
enum { PARTS = 4 };


void mus__mesh_curvature(const double *axis, int32_t n, const double *coef, const double *xy, double *out)
{
    double q[3] = {0.0, 0.0, 0.0};
    for (int32_t i = 0; i < n; i++) {
        const double dx = xy[2 * i] - xy[0], dy = xy[2 * i + 1] - xy[1];
        const double warp = dx * axis[0] + dy * axis[1], weft = dx * axis[1] - dy * axis[0];
        q[0] += 0.5 * coef[i] * weft * weft;
        q[1] += 0.5 * coef[i] * warp * warp;
        q[2] += coef[i] * weft * warp;
    }
    out[0] = q[0] * q[0];
    out[1] = q[1] * q[1];
    out[2] = 0.25 * (q[0] + q[1] + q[2]) * (q[0] + q[1] + q[2]);
    out[3] = 0.25 * (q[0] + q[1] - q[2]) * (q[0] + q[1] - q[2]);
}


/* unit vector of the warp in the panel's plane */
static mus_status calibrate_axis(const mus__mesh *mesh, int32_t panel, double *axis)
{
    const mus_status status = mus_pattern_grain(mesh->pattern, panel, axis);
    const double size = mus__hypot(axis[0], axis[1]);
    axis[0] /= size, axis[1] /= size;
    return status;
}


/* the sums of k p that the hinges of a panel should have, one for each direction (4) [N m m2] */
static void calibrate_target(const mus__mesh *mesh, int32_t panel, const double *axis, double *target)
{
    const mus_cloth *cloth = mesh->cloth;
    const mus__fabric_lattice *c = &mesh->constant;
    const double square = cloth->spacing * cloth->spacing, area = mus_pattern_panel_area(mesh->pattern, panel);
    const double half = 2.0 * c->cross * square; /* beta / 2 */
    const double weft = c->bend[1] * square + half, warp = c->bend[0] * square + half;
    const double bias = 0.25 * (weft + warp) + 1.5 * half, rigidity[PARTS] = {weft, warp, bias, bias};
    for (int d = 0; d < PARTS; d++) target[d] = area * rigidity[d] - 0.5 * mesh->seam_bend[PARTS * panel + d];

    static const double stencil[3] = {1.0, -2.0, 1.0};
    for (int32_t r = 0; r < cloth->nbend; r++) {
        const mus__bend_run *bend = &cloth->bend[r];
        if (cloth->node_panel[bend->a] != panel) continue;
        double xy[6], part[PARTS];
        memcpy(xy, cloth->rest + 2 * (ptrdiff_t)bend->a, 2 * sizeof *xy);
        memcpy(xy + 2, cloth->rest + 2 * (ptrdiff_t)bend->b, 2 * sizeof *xy);
        memcpy(xy + 4, cloth->rest + 2 * (ptrdiff_t)bend->c, 2 * sizeof *xy);
        mus__mesh_curvature(axis, 3, stencil, xy, part);
        for (int d = 0; d < PARTS; d++) target[d] -= bend->count * bend->k * part[d];
    }
}


/* x with m x = r for a symmetric positive matrix, by Cholesky; m is spoilt. False when it is not positive */
static bool calibrate_solve(double m[PARTS][PARTS], double *r)
{
    for (int i = 0; i < PARTS; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = m[i][j];
            for (int k = 0; k < j; k++) sum -= m[i][k] * m[j][k];
            if (i == j && !(sum > 0.0)) return false;
            m[i][j] = i == j ? sqrt(sum) : sum / m[j][j];
        }
        for (int k = 0; k < i; k++) r[i] -= m[i][k] * r[k];
        r[i] /= m[i][i];
    }
    for (int i = PARTS - 1; i >= 0; i--) {
        for (int k = i + 1; k < PARTS; k++) r[i] -= m[k][i] * r[k];
        r[i] /= m[i][i];
    }
    return true;
}


/* weight of a hinge in the next round: one that has come to a limit stays there */
static double calibrate_weight(const mus__hinge *hinge, double first)
{
    return hinge->k > CALIBRATE_LEAST * first && hinge->k < CALIBRATE_MOST * first ? first * first : 0.0;
}


/* one round over the hinges first .. first + count - 1 with their parts (count x 4) and first values */
static bool calibrate_round(mus__hinge *hinge, int32_t count, const double *part, const double *first,
                            const double *target)
{
    double m[PARTS][PARTS] = {{0.0}}, r[PARTS];
    memcpy(r, target, sizeof r);
    for (int32_t h = 0; h < count; h++) {
        const double *a = part + PARTS * (ptrdiff_t)h, weight = calibrate_weight(&hinge[h], first[h]);
        for (int i = 0; i < PARTS; i++) {
            r[i] -= hinge[h].k * a[i];
            for (int j = 0; j <= i; j++) m[i][j] += weight * a[i] * a[j];
        }
    }
    for (int i = 0; i < PARTS; i++) m[i][i] *= 1.0 + CALIBRATE_RIDGE;
    if (!calibrate_solve(m, r)) return false;
    for (int32_t h = 0; h < count; h++) {
        const double *a = part + PARTS * (ptrdiff_t)h;
        double change = 0.0;
        for (int i = 0; i < PARTS; i++) change += a[i] * r[i];
        const double k = hinge[h].k + calibrate_weight(&hinge[h], first[h]) * change;
        hinge[h].k = fmin(fmax(k, CALIBRATE_LEAST * first[h]), CALIBRATE_MOST * first[h]);
    }
    return true;
}


static mus_status calibrate_panel(mus__mesh *mesh, int32_t panel, int32_t from, int32_t count)
{
    const mus_cloth *cloth = mesh->cloth;
    mus__hinge *hinge = mesh->cloth->hinge + from;
    double axis[2], target[PARTS], *part = mus__new(mesh->context, (PARTS + 1) * (int64_t)count, sizeof *part);
    if (part == NULL) return mus__fail_memory(mesh->context, "the bending of the border");
    double *first = part + PARTS * (ptrdiff_t)count;
    const mus_status status = calibrate_axis(mesh, panel, axis);
    if (status == MUS_OK) {
        for (int32_t h = 0; h < count; h++) {
            double xy[8];
            for (int k = 0; k < 4; k++)
                memcpy(xy + 2 * k, cloth->rest + 2 * (ptrdiff_t)hinge[h].node[k], 2 * sizeof *xy);
            mus__mesh_curvature(axis, 4, hinge[h].coef, xy, part + PARTS * (ptrdiff_t)h);
            first[h] = hinge[h].k;
        }
        calibrate_target(mesh, panel, axis, target);
        for (int round = 0; round < CALIBRATE_ROUNDS; round++)
            if (!calibrate_round(hinge, count, part, first, target)) break;
    }
    mus__free(mesh->context, part);
    return status;
}


mus_status mus__mesh_calibrate(mus__mesh *mesh)
{
    const mus_cloth *cloth = mesh->cloth;
    mus_status status = MUS_OK;
    for (int32_t from = 0, next; from < cloth->nhinge && status == MUS_OK; from = next) {
        const int32_t panel = cloth->node_panel[cloth->hinge[from].node[0]];
        for (next = from + 1; next < cloth->nhinge; next++)
            if (cloth->node_panel[cloth->hinge[next].node[0]] != panel) break;
        if (next - from >= CALIBRATE_FEWEST) status = calibrate_panel(mesh, panel, from, next - from);
    }
    return status;
}
