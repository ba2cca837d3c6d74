/*
 * laid_on.c: where a panel starts that is sewn to worn cloth and lies on it, as a collar does on the shoulders.
 *
 * The worn cloth has its shape by now, and the seam is drawn on it. So each node starts where it lies when the panel is
 * laid down from its seam: as far along the seam as in the cut, and as far from it on the surface of the worn cloth,
 * which it covers. A pair of nodes of the seam gives a frame for it: the way along the seam in the cut and on the worn
 * cloth, the way from it into the panel and into the worn cloth. Each pair gives a node a place, and it takes their
 * mean, weighted by the inverse fourth power of the distance. A collar so begun lies down; begun above the neck it may
 * come to stand.
 */
#include <math.h>

#include "dress/laid_on.h"
#include "geom/vec.h"

#define LAID_BESIDE 2.5 /* spacings of a seam that give its direction; chosen: a node or more on both sides */

/* a pair of a seam: its place and its ways along and across, in the cut and in the world */
typedef struct laid_pair {
    double cut[2], cut_along[2], cut_across[2];
    double at[3], along[3], across[3], out[3];
} laid_pair;


/* the nodes of pair k that has one end in the panel and the other in a layer below it; false for any other pair */
static bool laid_ends(const mus_cloth *cloth, int32_t panel, int32_t k, int32_t *own, int32_t *worn)
{
    for (int32_t end = 0; end < 2; end++) {
        *own = cloth->pair[2 * k + end], *worn = cloth->pair[2 * k + 1 - end];
        if (cloth->node_panel[*own] == panel && mus__cloth_layer(cloth, *worn) < cloth->panel[panel].layer) return true;
    }
    return false;
}


/* the way along the seam at `pair`, in the cut and in the world, from the pairs beside it */
static void laid_along(const mus_drape *drape, int32_t panel, laid_pair *pair)
{
    const mus_cloth *cloth = drape->cloth;
    const double reach = LAID_BESIDE * cloth->spacing;
    int32_t own, worn;
    for (int32_t k = 0; k < cloth->npair; k++) {
        if (!laid_ends(cloth, panel, k, &own, &worn)) continue;
        const double *p = cloth->rest + 2 * (int64_t)own, *q = drape->x + 3 * (int64_t)worn;
        const double way[2] = {p[0] - pair->cut[0], p[1] - pair->cut[1]};
        if (mus__hypot(way[0], way[1]) > reach) continue;
        const double sign = way[0] * pair->cut_along[0] + way[1] * pair->cut_along[1] < 0.0 ? -1.0 : 1.0;
        for (int32_t d = 0; d < 2; d++) pair->cut_along[d] += sign * way[d];
        for (int32_t d = 0; d < 3; d++) pair->along[d] += sign * (q[d] - pair->at[d]);
    }
}


/* normal of the worn cloth round a node, and the way from it into that cloth; the way from the node's partner into its
 * panel, in the cut */
static void laid_across(const mus_drape *drape, int32_t own, int32_t worn, double *normal, double *into, double *cut)
{
    const mus_cloth *cloth = drape->cloth;
    for (int32_t t = 0; t < cloth->ntriangle; t++) {
        const int32_t *corner = cloth->triangle + 3 * (int64_t)t;
        const bool mine = corner[0] == own || corner[1] == own || corner[2] == own;
        for (int32_t k = 0; k < 3 && mine; k++)
            for (int32_t d = 0; d < 2; d++)
                cut[d] += cloth->rest[2 * (int64_t)corner[k] + d] - cloth->rest[2 * (int64_t)own + d];
        if (corner[0] != worn && corner[1] != worn && corner[2] != worn) continue;
        const double *a = drape->x + 3 * (int64_t)corner[0], *b = drape->x + 3 * (int64_t)corner[1];
        const double *c = drape->x + 3 * (int64_t)corner[2], *x = drape->x + 3 * (int64_t)worn;
        double ab[3], ac[3], own_normal[3];
        for (int32_t d = 0; d < 3; d++) {
            ab[d] = b[d] - a[d], ac[d] = c[d] - a[d];
            into[d] += a[d] + b[d] + c[d] - 3.0 * x[d];
        }
        mus__cross3(ab, ac, own_normal);
        for (int32_t d = 0; d < 3; d++) normal[d] += own_normal[d];
    }
}


static void laid_unit(double *v, int32_t n)
{
    double length = 0.0;
    for (int32_t d = 0; d < n; d++) length += v[d] * v[d];
    for (int32_t d = 0; d < n; d++) v[d] /= fmax(sqrt(length), 1e-12);
}


static void laid_frame(const mus_drape *drape, int32_t panel, int32_t own, int32_t worn, laid_pair *pair)
{
    double normal[3] = {0.0}, into[3] = {0.0}, cut[2] = {0.0}, out[3] = {0.0};
    *pair = (laid_pair){.cut_along = {0.0}};
    for (int32_t d = 0; d < 2; d++) pair->cut[d] = drape->cloth->rest[2 * (int64_t)own + d];
    for (int32_t d = 0; d < 3; d++) pair->at[d] = drape->x[3 * (int64_t)worn + d];
    laid_along(drape, panel, pair);
    laid_across(drape, own, worn, normal, into, cut);
    if (drape->scene.collider != NULL) mus__collider_depth(drape->scene.collider, pair->at, MUS__LAYERS_REACH, out);
    const double side = mus__dot3(normal, out) < 0.0 ? -1.0 : 1.0;
    for (int32_t d = 0; d < 3; d++) pair->out[d] = side * normal[d];
    laid_unit(pair->cut_along, 2), laid_unit(pair->along, 3), laid_unit(pair->out, 3);
    pair->cut_across[0] = -pair->cut_along[1], pair->cut_across[1] = pair->cut_along[0];
    const double left = cut[0] * pair->cut_across[0] + cut[1] * pair->cut_across[1] < 0.0 ? -1.0 : 1.0;
    for (int32_t d = 0; d < 2; d++) pair->cut_across[d] *= left;
    mus__cross3(pair->out, pair->along, pair->across);
    const double in = mus__dot3(into, pair->across) < 0.0 ? -1.0 : 1.0;
    for (int32_t d = 0; d < 3; d++) pair->across[d] *= in;
}


/* add the place that a pair gives to a node, with its weight */
static void laid_add(const laid_pair *pair, const double *cut, double out, double near, double *sum)
{
    const double way[2] = {cut[0] - pair->cut[0], cut[1] - pair->cut[1]};
    const double along = way[0] * pair->cut_along[0] + way[1] * pair->cut_along[1];
    const double across = way[0] * pair->cut_across[0] + way[1] * pair->cut_across[1];
    const double square = way[0] * way[0] + way[1] * way[1] + near * near, weight = 1.0 / (square * square);
    for (int32_t d = 0; d < 3; d++)
        sum[d] += weight * (pair->at[d] + along * pair->along[d] + across * pair->across[d] + out * pair->out[d]);
    sum[3] += weight;
}


mus_status mus__laid_place(mus_drape *drape, int32_t panel, double out)
{
    const mus_cloth *cloth = drape->cloth;
    const mus__panel_mesh *mesh = &cloth->panel[panel];
    int32_t own, worn, n = 0;
    for (int32_t k = 0; k < cloth->npair; k++) n += laid_ends(cloth, panel, k, &own, &worn);
    laid_pair *pair = mus__new(drape->context, n, sizeof *pair);
    if (pair == NULL) return mus__fail_memory(drape->context, "a start on worn cloth");
    n = 0;
    for (int32_t k = 0; k < cloth->npair; k++)
        if (laid_ends(cloth, panel, k, &own, &worn)) laid_frame(drape, panel, own, worn, &pair[n++]);
    for (int32_t i = mesh->first_node; i < mesh->first_node + mesh->node_count; i++) {
        double sum[4] = {0.0};
        for (int32_t k = 0; k < n; k++)
            laid_add(&pair[k], cloth->rest + 2 * (int64_t)i, out, 0.5 * cloth->spacing, sum);
        for (int32_t d = 0; d < 3; d++) drape->x[3 * (int64_t)i + d] = sum[d] / sum[3];
    }
    mus__free(drape->context, pair);
    return MUS_OK;
}
