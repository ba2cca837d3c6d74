/*
 * worn_through.c: triangles of the cloth that cross triangles of the skin: a count with exact signs.
 *
 * Boxes of both sets of triangles are in one grid (selfcontact/box_grid.h); a pair of one of each crosses when an edge
 * of one meets the other (selfcontact/crossing_count.h). Depth and area are those of samples, by the depth of
 * mus_drape_depth(): sixteen equal parts of each triangle of the cloth that crosses the skin or has a corner in the
 * body.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fit/worn_internal.h"
#include "geom/predicate.h"
#include "geom/vec.h"
#include "selfcontact/box_grid.h"
#include "selfcontact/crossing_count.h"

#define THROUGH_PARTS 4        /* of each side of a triangle: 16 samples */
/* [m] shallower cloth is counted and is no objection; chosen: the depth that `make corpus` allows a node. The chord of
 * a triangle of 20 mm is 1 mm below an arc of 50 mm radius */
#define THROUGH_SEEN 1e-3
#define THROUGH_ROUND 1.2e-7   /* of a coordinate: rounding a double to float changes it by less */

typedef struct through_search {
    const int32_t *cloth, *skin; /* triangles: corners */
    int32_t *item;               /* which triangles of the skin are in the grid, behind those of the cloth */
    const double *x, *body;      /* places of the corners */
    int32_t ncloth, count;
    uint8_t *crosses; /* (ncloth) */
    uint8_t *inside;  /* (nodes of the cloth); right behind crosses */
} through_search;


/* box of triangle k (corners in `corner`, places x), rounded outward: out (6) */
static void through_box(const int32_t *corner, const double *x, float *out)
{
    for (int32_t d = 0; d < 3; d++) {
        const double a = x[3 * (ptrdiff_t)corner[0] + d], b = x[3 * (ptrdiff_t)corner[1] + d];
        const double c = x[3 * (ptrdiff_t)corner[2] + d];
        const double low = fmin(a, fmin(b, c)), high = fmax(a, fmax(b, c));
        out[d] = (float)(low - THROUGH_ROUND * fabs(low));
        out[3 + d] = (float)(high + THROUGH_ROUND * fabs(high));
    }
}


/* does an edge of triangle p (3 corners of x) meet triangle q (3 corners of y)? */
static int32_t through_edges(const int32_t *p, const double *x, const int32_t *q, const double *y)
{
    for (int32_t k = 0; k < 3; k++)
        if (mus__segment_meets_triangle(x + 3 * (ptrdiff_t)p[k], x + 3 * (ptrdiff_t)p[(k + 1) % 3],
                                        y + 3 * (ptrdiff_t)q[0], y + 3 * (ptrdiff_t)q[1], y + 3 * (ptrdiff_t)q[2]))
            return 1;
    return 0;
}


/* whether the corners of triangle p (of x) lie on one side of the plane of q (of y): they do not meet then */
static bool through_beside(const int32_t *p, const double *x, const int32_t *q, const double *y)
{
    const double *a = y + 3 * (ptrdiff_t)q[0], *b = y + 3 * (ptrdiff_t)q[1], *c = y + 3 * (ptrdiff_t)q[2];
    const double first = mus__orient3d(a, b, c, x + 3 * (ptrdiff_t)p[0]);
    for (int32_t k = 1; k < 3; k++)
        if (!(first * mus__orient3d(a, b, c, x + 3 * (ptrdiff_t)p[k]) > 0.0)) return false;
    return true;
}


static void through_pair(void *user, int32_t a, int32_t b)
{
    through_search *s = user;
    const int32_t *cloth = s->cloth + 3 * (ptrdiff_t)a, *skin = s->skin + 3 * (ptrdiff_t)s->item[b - s->ncloth];
    if (through_beside(cloth, s->x, skin, s->body)) return;
    if (!through_edges(cloth, s->x, skin, s->body) && !through_edges(skin, s->body, cloth, s->x)) return;
    s->count++;
    s->crosses[a] = 1;
}


/* depth of a place in the body, 0 outside */
static double through_depth(const mus_drape *drape, const double *place)
{
    const double depth = mus__collider_body_depth(drape->scene.collider, place, 0.0, NULL);
    return depth > 0.0 ? depth : 0.0;
}


/* the deepest sample of triangle k, and its area in the body */
static void through_samples(const mus_drape *drape, int32_t k, mus_worn *out)
{
    const int32_t *v = drape->cloth->triangle + 3 * (ptrdiff_t)k;
    const double *a = drape->x + 3 * (ptrdiff_t)v[0], *b = drape->x + 3 * (ptrdiff_t)v[1];
    const double *c = drape->x + 3 * (ptrdiff_t)v[2];
    const double p[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, q[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    double normal[3];
    mus__cross3(p, q, normal);
    const double part = 0.5 * mus__norm3(normal) / (THROUGH_PARTS * THROUGH_PARTS);
    for (int32_t i = 0; i < THROUGH_PARTS; i++)
        for (int32_t j = 0; j < 2 * (THROUGH_PARTS - i) - 1; j++) {
            /* centre of the j-th part of the i-th row: parts stand up and down by turns */
            const double t = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3.0) / THROUGH_PARTS;
            const double s = (j / 2 + (j % 2 == 0 ? 1.0 : 2.0) / 3.0) / THROUGH_PARTS;
            const double place[3] = {a[0] + s * p[0] + t * q[0], a[1] + s * p[1] + t * q[1],
                                     a[2] + s * p[2] + t * q[2]};
            const double depth = through_depth(drape, place);
            if (depth > 0.0) out->through_area += part;
            if (depth <= out->through_depth) continue;
            out->through_depth = depth;
            memcpy(out->through_place, place, sizeof place);
        }
}


/* depth and area of the triangles that cross the skin, or have a corner in the body */
static void through_measure(const mus__worn_call *call, const through_search *search)
{
    const mus_drape *drape = call->drape;
    mus_worn *out = call->out;
    int32_t first = MUS_NONE;
    out->through = search->count;
    for (int32_t i = 0; i < drape->n; i++)
        search->inside[i] = through_depth(drape, drape->x + 3 * (ptrdiff_t)i) > 0.0;
    for (int32_t k = 0; k < search->ncloth; k++) {
        const int32_t *v = search->cloth + 3 * (ptrdiff_t)k;
        if (search->crosses[k] && first == MUS_NONE) first = k;
        if (search->crosses[k] || search->inside[v[0]] || search->inside[v[1]] || search->inside[v[2]])
            through_samples(drape, k, out);
    }
    if (first == MUS_NONE || out->through_depth <= THROUGH_SEEN) return;
    if (out->kind != MUS_WORN_YES && out->kind != MUS_WORN_UNKNOWN) return;
    char text[128];
    snprintf(text, sizeof text, "cloth goes through the body: %d crossings, %.1f mm deep", (int)out->through,
             1000.0 * out->through_depth);
    const int32_t node = search->cloth[3 * (ptrdiff_t)first];
    mus__worn_note(call, MUS_WORN_THROUGH, MUS_NONE, MUS_NONE, node, out->through_depth, text);
    if (out->through_depth > 0.0) memcpy(out->place, out->through_place, sizeof out->place);
}


/* whether segment a b, with the box from low to high, meets triangle k of the cloth; the boxes are compared first */
static bool through_axis(const mus__worn_call *call, const double *a, const double *b, const double *low,
                         const double *high, int32_t k)
{
    const int32_t *v = call->drape->cloth->triangle + 3 * (ptrdiff_t)k;
    const double *p = call->x + 3 * (ptrdiff_t)v[0], *q = call->x + 3 * (ptrdiff_t)v[1];
    const double *r = call->x + 3 * (ptrdiff_t)v[2];
    for (int32_t d = 0; d < 3; d++)
        if ((p[d] < low[d] && q[d] < low[d] && r[d] < low[d]) || (p[d] > high[d] && q[d] > high[d] && r[d] > high[d]))
            return false;
    return mus__segment_meets_triangle(a, b, p, q, r) != 0;
}


void mus__worn_pierced(const mus__worn_call *call)
{
    static const char *const names[MUS_WORN_LIMBS] = {"the head goes", "the left arm goes", "the right arm goes",
                                                      "the left leg goes", "the right leg goes"};
    const mus__worn_axes *axes = &call->axes;
    for (int32_t limb = 0; limb < MUS_WORN_LIMBS; limb++)
        for (int32_t k = 0; k + 1 < axes->count[limb]; k++) {
            const double *a = axes->point[limb][k], *b = axes->point[limb][k + 1];
            const double low[3] = {fmin(a[0], b[0]), fmin(a[1], b[1]), fmin(a[2], b[2])};
            const double high[3] = {fmax(a[0], b[0]), fmax(a[1], b[1]), fmax(a[2], b[2])};
            for (int32_t t = 0; t < call->drape->cloth->ntriangle; t++) {
                char text[128];
                if (!through_axis(call, a, b, low, high, t)) continue;
                snprintf(text, sizeof text, "%s through the cloth", names[limb]);
                mus__worn_note(call, MUS_WORN_THROUGH, limb, MUS_NONE,
                               call->drape->cloth->triangle[3 * (ptrdiff_t)t], 0.0, text);
                return;
            }
        }
}


mus_status mus__worn_through(const mus__worn_call *call)
{
    const mus_drape *drape = call->drape;
    const mus_cloth *cloth = drape->cloth;
    const int32_t nskin = mus_body_triangle_count(call->body), all = cloth->ntriangle + nskin;
    if (drape->scene.collider == NULL) return MUS_OK;
    through_search search = {.cloth = cloth->triangle, .skin = mus_body_triangles(call->body), .x = drape->x,
                             .body = mus_body_vertices(call->body), .ncloth = cloth->ntriangle};
    mus__box_grid grid = {0};
    search.item = mus__new(drape->context, (int64_t)nskin + 1, sizeof *search.item);
    search.crosses = mus__new(drape->context, (int64_t)cloth->ntriangle + cloth->nnode, sizeof *search.crosses);
    mus_status status = search.item != NULL && search.crosses != NULL ? MUS_OK : MUS_ERR_MEMORY;
    if (status == MUS_OK) status = mus__box_grid_create(drape->context, all, &grid);
    if (status == MUS_OK) {
        float *const box = grid.box;
        float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
        int32_t n = cloth->ntriangle;
        for (int32_t k = 0; k < n; k++) {
            through_box(search.cloth + 3 * (ptrdiff_t)k, search.x, box + 6 * (ptrdiff_t)k);
            for (int32_t d = 0; d < 3; d++) {
                low[d] = fminf(low[d], box[6 * (ptrdiff_t)k + d]);
                high[d] = fmaxf(high[d], box[6 * (ptrdiff_t)k + 3 + d]);
            }
        }
        for (int32_t k = 0; k < nskin; k++) {
            float *own = box + 6 * (ptrdiff_t)n;
            through_box(search.skin + 3 * (ptrdiff_t)k, search.body, own);
            const bool near = own[0] <= high[0] && own[1] <= high[1] && own[2] <= high[2] && own[3] >= low[0] &&
                              own[4] >= low[1] && own[5] >= low[2];
            if (near) search.item[n++ - cloth->ntriangle] = k;
        }
        search.inside = search.crosses + cloth->ntriangle;
        mus__box_grid_between(&grid, cloth->ntriangle, n, 0.0f, through_pair, &search);
        mus__box_grid_destroy(drape->context, &grid);
        through_measure(call, &search);
    }
    mus__free(drape->context, search.crosses);
    mus__free(drape->context, search.item);
    return status == MUS_OK ? MUS_OK : mus__fail_memory(drape->context, "a count of cloth through the body");
}
