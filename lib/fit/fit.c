/*
 * fit.c: strain, pressure and gap at each node of a draped garment; fit_girths.c has its levels, fit_spread.c how a
 * quantity is spread over the cloth.
 *
 * Strain: in each triangle F maps vectors in the flat to vectors in space; the strain is |F w| - 1 along the warp w,
 * and the same along the weft. A node gets the mean over its triangles by area in the flat.
 *
 * Pressure: a sheet under tension T round a radius r presses with p = T / r (Laplace). In the mesh that is the sum of
 * the spring forces at a node towards the skin, over the area of the node, stretched as it is: on a cylinder of chords
 * c two pulls T h make  2 T h sin(c / 2r) = T h c / r  to second order. Bending and attachments are left out. Source:
 * Young-Laplace; limits of comfort in the manual page.
 */
#include <math.h>
#include <string.h>

#include "fit/fit_internal.h"
#include "geom/vec.h"
#include "sim/force_reference.h"

#define FIT_FAR 0.3     /* [m] largest gap that is measured */
#define FIT_SLACK 0.001 /* [m] beyond the clearance within which a node lies on the skin */


void mus_fit_destroy(mus_fit *fit)
{
    if (fit == NULL) return;
    mus__free(fit->context, fit->warp);
    mus__free(fit->context, fit);
}


/* |F d| - 1 of a triangle with flat edges a, b (2) and edges p, q (3) in space, along the unit direction d */
static double fit_strain(const double *a, const double *b, const double *p, const double *q, const double *d)
{
    const double area = a[0] * b[1] - a[1] * b[0];
    const double s = (d[0] * b[1] - d[1] * b[0]) / area, t = (a[0] * d[1] - a[1] * d[0]) / area;
    const double w[3] = {s * p[0] + t * q[0], s * p[1] + t * q[1], s * p[2] + t * q[2]};
    return mus__norm3(w) - 1.0;
}


void mus__fit_strains(mus_fit *fit, const mus_drape *drape)
{
    const mus_cloth *cloth = drape->cloth;
    double *area = fit->area; /* six times the area of a node, until all triangles are added */
    for (int32_t k = 0; k < cloth->ntriangle; k++) {
        const int32_t *v = cloth->triangle + 3 * (ptrdiff_t)k;
        double flat[2][2], space[2][3], warp[2] = {0.0, 1.0};
        for (int32_t e = 0; e < 2; e++) {
            for (int32_t d = 0; d < 2; d++)
                flat[e][d] = cloth->rest[2 * (ptrdiff_t)v[e + 1] + d] - cloth->rest[2 * (ptrdiff_t)v[0] + d];
            for (int32_t d = 0; d < 3; d++)
                space[e][d] = drape->x[3 * (ptrdiff_t)v[e + 1] + d] - drape->x[3 * (ptrdiff_t)v[0] + d];
        }
        if (cloth->warp != NULL) memcpy(warp, cloth->warp + 2 * (ptrdiff_t)cloth->node_panel[v[0]], sizeof warp);
        const double weft[2] = {warp[1], -warp[0]};
        const double size = fabs(flat[0][0] * flat[1][1] - flat[0][1] * flat[1][0]);
        if (!(size > 0.0)) continue;
        const double along = fit_strain(flat[0], flat[1], space[0], space[1], warp);
        const double across = fit_strain(flat[0], flat[1], space[0], space[1], weft);
        for (int32_t c = 0; c < 3; c++) {
            fit->warp[v[c]] += size * along;
            fit->weft[v[c]] += size * across;
            area[v[c]] += size;
        }
    }
    for (int32_t i = 0; i < fit->n; i++) {
        if (area[i] > 0.0) fit->warp[i] /= area[i], fit->weft[i] /= area[i];
        area[i] /= 6.0;
    }
}


/* pressure of stretch and shear springs at nodes on the skin, and the gap; force (3 n) is scratch */
static void fit_pressures(mus_fit *fit, const mus_drape *drape, double *force)
{
    mus__program membrane = drape->program;
    const double weight = drape->cloth->fabric.weight;
    membrane.nhalf_bend = membrane.nhinge = membrane.nattachment = membrane.npair = 0;
    membrane.nslider = membrane.nclamp = 0;
    mus__program_force(&membrane, drape->n, drape->x, force);
    for (int32_t i = 0; i < fit->n && drape->scene.collider != NULL; i++) {
        const int32_t r = drape->rep[i];
        const double *x = drape->x + 3 * (ptrdiff_t)r, *f = force + 3 * (ptrdiff_t)r;
        double normal[3 * MUS__TOUCHING_MAX], friction[MUS__TOUCHING_MAX];
        fit->gap[i] = -mus__collider_depth(drape->scene.collider, x, FIT_FAR, NULL);
        if (fit->gap[i] > 1e29) fit->gap[i] = (double)NAN;
        const double reach = drape->def.clearance + mus__drape_lift(drape, r) + FIT_SLACK;
        if (mus__collider_touching(drape->scene.collider, x, reach, normal, friction) == 0) continue;
        const double push = -mus__dot3(f, normal), drawn = (1.0 + fit->warp[i]) * (1.0 + fit->weft[i]);
        if (push > 0.0 && drape->mass[r] > 0.0 && drawn > 0.0)
            fit->pressure[i] = push * weight / (drape->mass[r] * drawn);
    }
}


mus_status mus_fit_create(const mus_drape *drape, const mus_body *body, mus_fit **out)
{
    if (out != NULL) *out = NULL;
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "fit: out is NULL");
    mus_context *context = drape->context;
    mus_fit *fit = mus__new(context, 1, sizeof *fit);
    double *work = mus__new(context, 3 * (int64_t)drape->n, sizeof *work);
    if (fit != NULL) {
        fit->context = context;
        fit->n = drape->n;
        fit->warp = mus__new(context, 5 * (int64_t)drape->n, sizeof *fit->warp);
    }
    mus_status status = work != NULL && fit != NULL && fit->warp != NULL ? MUS_OK : mus__fail_memory(context, "a fit");
    if (status == MUS_OK) {
        fit->weft = fit->warp + fit->n, fit->pressure = fit->weft + fit->n, fit->gap = fit->pressure + fit->n;
        fit->area = fit->gap + fit->n;
        for (int32_t i = 0; i < fit->n; i++) fit->gap[i] = (double)NAN;
        mus__fit_strains(fit, drape);
        fit_pressures(fit, drape, work);
        if (body != NULL) status = mus__fit_levels(fit, drape, body);
    }
    mus__free(context, work);
    if (status == MUS_OK)
        *out = fit;
    else
        mus_fit_destroy(fit);
    return status;
}


int32_t mus_fit_node_count(const mus_fit *fit)
{
    return fit != NULL ? fit->n : 0;
}


const double *mus_fit_warp(const mus_fit *fit)
{
    return fit != NULL ? fit->warp : NULL;
}


const double *mus_fit_weft(const mus_fit *fit)
{
    return fit != NULL ? fit->weft : NULL;
}


const double *mus_fit_pressure(const mus_fit *fit)
{
    return fit != NULL ? fit->pressure : NULL;
}


const double *mus_fit_gap(const mus_fit *fit)
{
    return fit != NULL ? fit->gap : NULL;
}


const double *mus_fit_area(const mus_fit *fit)
{
    return fit != NULL ? fit->area : NULL;
}


int32_t mus_fit_level_count(const mus_fit *fit)
{
    return fit != NULL ? fit->nlevel : 0;
}


mus_status mus_fit_level_get(const mus_fit *fit, int32_t index, mus_fit_level *out)
{
    if (fit == NULL) return MUS_ERR_ARG;
    if (index < 0 || index >= fit->nlevel)
        return mus__fail(fit->context, MUS_ERR_ARG, "fit: level %d is not one of 0 to %d", (int)index,
                         (int)fit->nlevel - 1);
    if (out == NULL || out->size != sizeof *out)
        return mus__fail(fit->context, MUS_ERR_VERSION, "fit level: size unknown; use mus_fit_level_init");
    *out = fit->level[index];
    return MUS_OK;
}
