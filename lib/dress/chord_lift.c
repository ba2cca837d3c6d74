/*
 * chord_lift.c: how far nodes stay off the skin so that the flat triangles between them do.
 *
 * Contact holds nodes off the skin. A triangle is flat, and where the body bulges its middle lies deeper than its
 * corners, by L^2 / 8R for an edge of length L over a radius R: 2 mm at 20 mm over a wrist, as much as the clearance.
 * So each node is lifted by what the triangles round it lack: the deepest of their samples says how far the node may
 * come towards the skin. Nodes of fine triangles, or over a flat place, are not lifted; a lift that is no longer asked
 * for goes.
 */
#include <math.h>
#include <string.h>

#include "contact/hands_feet.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "dress/chord_lift.h"
#include "geom/vec.h"
#include "sim/force_program_constants.h"

/* [m] the largest lift; a triangle that lacks more has a limb through it. Distances are of first order: at 9 mm over a
 * shoulder they are 6 % too large */
#define LIFT_MOST 0.01
/* [m] spacing of a mesh that is lifted, at most: the chords of a coarser one lack more than a lift */
#define LIFT_COARSEST 0.05
/* least share of a lift that raises a sample: a lift is at most four times what a sample lacks */
#define LIFT_ACROSS 0.25
#define LIFT_PARTS 4 /* of a triangle's side: samples are the points of this lattice but its corners */


mus_status mus__chord_lift_create(mus_drape *drape)
{
    mus__chord_lift_data *data = &drape->chord_lift;
    if (drape->scene.collider == NULL || drape->scene.collider->nparts == 0 || data->lift != NULL) return MUS_OK;
    if (drape->cloth->spacing > LIFT_COARSEST) return MUS_OK;
    data->lift = mus__new(drape->context, drape->sim.n, sizeof *data->lift);
    data->gap = mus__new(drape->context, 6 * (int64_t)drape->n, sizeof *data->gap);
    if (data->lift == NULL || data->gap == NULL) {
        mus__drape_lift_clear(drape);
        return mus__fail_memory(drape->context, "how far nodes stay off the skin");
    }
    data->lack = data->gap + drape->n;
    data->around = data->lack + drape->n;
    data->normal = data->around + drape->n;
    drape->sim.lift = data->lift;
    return MUS_OK;
}


/* whether node i lies on the skin, or on its lift */
static bool lift_lies(const mus_drape *drape, int32_t i)
{
    const mus__chord_lift_data *data = &drape->chord_lift;
    return data->gap[i] <= drape->def.clearance + (double)data->lift[i] + MUS__LIFT_CLEAR;
}


/* a sample of a triangle: shares of the corners, its place, and what it lacks to be clear */
typedef struct lift_sample {
    double share[3], place[3], lack;
} lift_sample;


/* notes a sample at the corners that it lies between. What it lacks is borne by those that lie on the skin, or by all
 * when none does, along their own normals; where these stand so far across that LIFT_ACROSS of a lift would be left of
 * it, at the tip of a toe, nobody bears it */
static void lift_note(mus_drape *drape, uint64_t parts, const int32_t *corner, const lift_sample *s)
{
    mus__chord_lift_data *data = &drape->chord_lift;
    double normal[3], effect[2] = {0.0, 0.0};
    bool lies[3];
    if (s->lack > 0.0) mus__collider_parts_depth(drape->scene.collider, parts, s->place, INFINITY, normal);
    for (int32_t c = 0; c < 3; c++) {
        const int32_t i = corner[c];
        if (!(s->share[c] > 0.0)) continue;
        data->around[i] = fmax(data->around[i], s->lack);
        if (!(s->lack > 0.0)) continue;
        lies[c] = lift_lies(drape, i);
        const double along = s->share[c] * fmax(mus__dot3(normal, data->normal + 3 * (int64_t)i), 0.0);
        effect[0] += along;
        if (lies[c]) effect[1] += along;
    }
    if (!(s->lack > 0.0)) return;
    const bool some = effect[1] > LIFT_ACROSS;
    const double all = some ? effect[1] : effect[0];
    for (int32_t c = 0; c < 3; c++)
        if (all > LIFT_ACROSS && s->share[c] > 0.0 && (lies[c] || !some))
            data->lack[corner[c]] = fmax(data->lack[corner[c]], s->lack / all);
}


/* the samples of a triangle; those further than `margin` off the skin ask for nothing */
static void lift_triangle(mus_drape *drape, uint64_t of, const int32_t *corner, const double *x, double margin)
{
    const mus__collider *collider = drape->scene.collider;
    const double *p[3];
    double low[3], high[3];
    for (int32_t c = 0; c < 3; c++) p[c] = x + 3 * (int64_t)corner[c];
    for (int32_t d = 0; d < 3; d++) {
        low[d] = fmin(p[0][d], fmin(p[1][d], p[2][d]));
        high[d] = fmax(p[0][d], fmax(p[1][d], p[2][d]));
    }
    const uint64_t parts = of & mus__collider_parts_near(collider, low, high, margin);
    for (int32_t i = 0; i <= LIFT_PARTS && parts != 0; i++)
        for (int32_t j = 0; i + j <= LIFT_PARTS; j++) {
            const int32_t k = LIFT_PARTS - i - j;
            if (i == LIFT_PARTS || j == LIFT_PARTS || k == LIFT_PARTS) continue;
            lift_sample s = {.share = {(double)i / LIFT_PARTS, (double)j / LIFT_PARTS, (double)k / LIFT_PARTS}};
            for (int32_t d = 0; d < 3; d++)
                s.place[d] = s.share[0] * p[0][d] + s.share[1] * p[1][d] + s.share[2] * p[2][d];
            s.lack = mus__collider_parts_depth(collider, parts, s.place, margin, NULL) + MUS__LIFT_CLEAR;
            if (s.lack > -margin && s.lack <= LIFT_MOST) lift_note(drape, parts, corner, &s);
        }
}


/* how far samples and nodes at places x are off the parts `of`, as far as the margin */
static void lift_measure(mus_drape *drape, const double *x, uint64_t of, double margin)
{
    const mus_cloth *cloth = drape->cloth;
    mus__chord_lift_data *data = &drape->chord_lift;
    for (int32_t i = 0; i < drape->n; i++) {
        const double *p = x + 3 * (int64_t)i;
        const uint64_t parts = of & mus__collider_parts_near(drape->scene.collider, p, p, margin);
        double *normal = data->normal + 3 * (int64_t)i;
        normal[0] = normal[1] = normal[2] = 0.0; /* of a node out of reach */
        data->lack[i] = data->around[i] = -margin;
        data->gap[i] = fmin(-mus__collider_parts_depth(drape->scene.collider, parts, p, margin, normal), margin);
    }
    for (int32_t k = 0; k < cloth->ntriangle; k++) {
        const int32_t *own = cloth->triangle + 3 * (int64_t)k;
        const int32_t v[3] = {drape->rep[own[0]], drape->rep[own[1]], drape->rep[own[2]]};
        if (fmin(data->gap[v[0]], fmin(data->gap[v[1]], data->gap[v[2]])) < margin)
            lift_triangle(drape, of, v, x, margin);
    }
}


mus_status mus__chord_lift_begin(mus_drape *drape)
{
    mus__chord_lift_data *data = &drape->chord_lift;
    const double margin = drape->def.clearance + LIFT_MOST;
    const mus_status status = mus__chord_lift_create(drape);
    if (status != MUS_OK || data->lift == NULL) return status;
    lift_measure(drape, drape->x, ~(uint64_t)0, margin);
    for (int32_t i = 0; i < drape->n; i++) {
        const double low = data->gap[i] - drape->def.clearance + data->around[i];
        data->lift[i] = (float)(data->gap[i] < margin ? fmin(fmax(low, 0.0), LIFT_MOST) : 0.0);
    }
    return MUS_OK;
}


double mus__chord_lift(mus_drape *drape, const double *x, bool thin, bool rest)
{
    mus__chord_lift_data *data = &drape->chord_lift;
    const double margin = drape->def.clearance + LIFT_MOST;
    double change = 0.0;
    if (data->lift == NULL) return 0.0;
    lift_measure(drape, x, thin ? mus__collider_thin_parts(drape->scene.collider) : ~(uint64_t)0, margin);
    for (int32_t i = 0; i < drape->n; i++) {
        const double now = (double)data->lift[i], off = data->gap[i] - drape->def.clearance;
        double need = now;
        if (data->lack[i] > 0.0) need = fmin(fmax(off + data->lack[i], now), LIFT_MOST);
        /* off one of two surfaces that face each other is into the other: it would be pinched and not come to rest */
        if (need > 0.0 && mus__collider_pinches(drape->scene.collider, x + 3 * (int64_t)i, drape->def.clearance + need))
            need = 0.0;
        if (data->around[i] < -MUS__LIFT_CLEAR) need = fmin(now, fmax(off + data->around[i], 0.0));
        if (rest) need = fmax(need, now);
        change = fmax(change, need - now);
        /* its plane is asked for anew */
        if (need != now && drape->plane_cache != NULL)
            mus__program_put(&drape->program, drape->plane_cache, 7 * (int64_t)drape->sim.n + i, -1.0);
        data->lift[i] = (float)need;
    }
    return change;
}
