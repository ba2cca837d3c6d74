/*
 * worn_through.c: triangles of the cloth that cross triangles of the skin: a count with exact signs.
 *
 * The box round the cloth is in cells, each with a list of the triangles of the cloth that may be in it; each triangle
 * of the skin asks those of its own cells. A pair crosses when an edge of one meets the other
 * (selfcontact/crossing_count.h). Depth and area are those of samples, by the depth of
 * mus_drape_depth(): sixteen equal parts of each triangle of the cloth that crosses the skin or has a corner in the
 * body.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fit/worn_internal.h"
#include "geom/predicate.h"
#include "geom/vec.h"
#include "selfcontact/crossing_count.h"

#define THROUGH_PARTS 4        /* of each side of a triangle: 16 samples */
#define THROUGH_CELLS 64       /* most along each side of the box round the cloth, in which the skin is looked for */
#define THROUGH_LISTED 100     /* cells a triangle on the mean, at most: fewer where the cloth is flung about */
/* [m] shallower cloth is counted and is no objection; chosen: the depth that `make corpus` allows a node. The chord of
 * a triangle of 20 mm is 1 mm below an arc of 50 mm radius */
#define THROUGH_SEEN 1e-3
#define THROUGH_ROUND 1.2e-7   /* of a coordinate: rounding a double to float changes it by less */

typedef struct through_search {
    const int32_t *cloth, *skin; /* triangles: corners */
    const double *x, *body;      /* places of the corners */
    int32_t ncloth, count;
    uint8_t *crosses; /* (ncloth) */
    uint8_t *inside;  /* (nodes of the cloth); right behind crosses */
} through_search;

/* the box round the cloth in cells of equal size, and which triangles of the cloth may be in each */
typedef struct through_cells {
    float low[3], high[3], each[3]; /* each: cells a metre */
    float *box;                     /* (triangles of the cloth x 6) */
    int32_t side;                   /* cells along each side */
    int32_t *start, *item;          /* (side cubed + 1) of each cell, in item */
} through_cells;


/* box of a triangle (corners in `corner`, places x), rounded outward: out (6) */
static void through_box(const int32_t *corner, const double *x, float *out)
{
    for (int32_t d = 0; d < 3; d++) {
        const double a = x[3 * (ptrdiff_t)corner[0] + d], b = x[3 * (ptrdiff_t)corner[1] + d];
        const double c = x[3 * (ptrdiff_t)corner[2] + d];
        const double low = a < b ? a < c ? a : c : b < c ? b : c, high = a > b ? a > c ? a : c : b > c ? b : c;
        out[d] = (float)(low - THROUGH_ROUND * fabs(low));
        out[3 + d] = (float)(high + THROUGH_ROUND * fabs(high));
    }
}


/* the cells from from[] to to[] that a box (6) lies in; false: it is beside the cloth. Boxes that meet have one in
 * common: no step of the sum falls as its place grows */
static bool through_span(const through_cells *cells, const float *box, int32_t *from, int32_t *to)
{
    const float end = (float)(cells->side - 1);
    for (int32_t d = 0; d < 3; d++) {
        if (!(box[d] <= cells->high[d] && box[3 + d] >= cells->low[d])) return false;
        const float first = (box[d] - cells->low[d]) * cells->each[d];
        const float last = (box[3 + d] - cells->low[d]) * cells->each[d];
        from[d] = first > 0.0f ? first < end ? (int32_t)first : (int32_t)end : 0;
        to[d] = last < end ? (int32_t)last : (int32_t)end;
    }
    return true;
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


/* triangle a of the cloth, and b of the skin */
static void through_pair(through_search *s, int32_t a, int32_t b)
{
    const int32_t *cloth = s->cloth + 3 * (ptrdiff_t)a, *skin = s->skin + 3 * (ptrdiff_t)b;
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


/* the box round n boxes of the cloth, in `side` cells a side; returns how many cells they lie in, all together */
static int64_t through_divide(through_cells *cells, int32_t side, int32_t n)
{
    int64_t all = 0;
    cells->side = side;
    for (int32_t d = 0; d < 3; d++) {
        float low = INFINITY, high = -INFINITY;
        for (int32_t k = 0; k < n; k++) {
            if (cells->box[6 * (ptrdiff_t)k + d] < low) low = cells->box[6 * (ptrdiff_t)k + d];
            if (cells->box[6 * (ptrdiff_t)k + 3 + d] > high) high = cells->box[6 * (ptrdiff_t)k + 3 + d];
        }
        cells->low[d] = low, cells->high[d] = high;
        cells->each[d] = high > low ? (float)side / (high - low) : 0.0f;
    }
    for (int32_t k = 0; k < n; k++) {
        int32_t from[3], to[3];
        if (through_span(cells, cells->box + 6 * (ptrdiff_t)k, from, to))
            all += (int64_t)(to[0] + 1 - from[0]) * (to[1] + 1 - from[1]) * (to[2] + 1 - from[2]);
    }
    return all;
}


/* one pass over the cells of n triangles of the cloth: counts them at each start (item NULL), or lists them before it,
 * which moves it back */
static void through_list(through_cells *cells, int32_t n)
{
    for (int32_t k = 0; k < n; k++) {
        int32_t from[3], to[3];
        if (!through_span(cells, cells->box + 6 * (ptrdiff_t)k, from, to)) continue;
        for (int32_t i = from[0]; i <= to[0]; i++)
            for (int32_t j = from[1]; j <= to[1]; j++) {
                int32_t *row = cells->start + ((ptrdiff_t)i * cells->side + j) * cells->side;
                for (int32_t m = from[2]; m <= to[2]; m++)
                    if (cells->item == NULL) row[m]++;
                    else cells->item[--row[m]] = k;
            }
    }
}


/* a triangle of the skin with those of the cloth in its cells; a pair is met in the first cell of both */
static void through_meet(through_search *search, const through_cells *cells, int32_t skin)
{
    float own[6];
    int32_t from[3], to[3];
    through_box(search->skin + 3 * (ptrdiff_t)skin, search->body, own);
    if (!through_span(cells, own, from, to)) return;
    for (int32_t i = from[0]; i <= to[0]; i++)
        for (int32_t j = from[1]; j <= to[1]; j++)
            for (int32_t m = from[2]; m <= to[2]; m++) {
                const int32_t *start = cells->start + ((ptrdiff_t)i * cells->side + j) * cells->side + m;
                for (int32_t k = start[0]; k < start[1]; k++) {
                    const float *b = cells->box + 6 * (ptrdiff_t)cells->item[k];
                    int32_t first[3], last[3];
                    if (b[3] < own[0] || b[0] > own[3] || b[4] < own[1] || b[1] > own[4] || b[5] < own[2] ||
                        b[2] > own[5])
                        continue;
                    through_span(cells, b, first, last);
                    if ((i == from[0] || i == first[0]) && (j == from[1] || j == first[1]) &&
                        (m == from[2] || m == first[2]))
                        through_pair(search, cells->item[k], skin);
                }
            }
}


/* every triangle of the cloth with each of the skin that is near it */
static mus_status through_find(mus_context *context, through_search *search, int32_t nskin)
{
    const int32_t ncloth = search->ncloth;
    int64_t listed = 0, ncell = 0;
    through_cells cells = {0};
    cells.box = mus__new(context, 6 * (int64_t)ncloth, sizeof *cells.box);
    mus_status status = cells.box != NULL ? MUS_OK : MUS_ERR_MEMORY;
    if (status == MUS_OK) {
        int32_t side = THROUGH_CELLS;
        for (int32_t k = 0; k < ncloth; k++)
            through_box(search->cloth + 3 * (ptrdiff_t)k, search->x, cells.box + 6 * (ptrdiff_t)k);
        while ((listed = through_divide(&cells, side, ncloth)) > (int64_t)THROUGH_LISTED * ncloth) side /= 2;
        ncell = (int64_t)side * side * side;
        cells.start = mus__new(context, ncell + 1, sizeof *cells.start);
        if (cells.start == NULL || listed > INT32_MAX) status = MUS_ERR_MEMORY;
    }
    if (status == MUS_OK) {
        through_list(&cells, ncloth);
        for (int64_t c = 1; c <= ncell; c++) cells.start[c] += cells.start[c - 1];
        cells.item = mus__new(context, listed, sizeof *cells.item);
        if (cells.item == NULL) status = MUS_ERR_MEMORY;
    }
    if (status == MUS_OK) {
        through_list(&cells, ncloth);
        for (int32_t k = 0; k < nskin; k++) through_meet(search, &cells, k);
    }
    mus__free(context, cells.item);
    mus__free(context, cells.start);
    mus__free(context, cells.box);
    return status;
}


mus_status mus__worn_through(const mus__worn_call *call)
{
    const mus_drape *drape = call->drape;
    const mus_cloth *cloth = drape->cloth;
    const int32_t nskin = mus_body_triangle_count(call->body);
    if (drape->scene.collider == NULL || cloth->ntriangle == 0) return MUS_OK;
    through_search search = {.cloth = cloth->triangle, .skin = mus_body_triangles(call->body), .x = drape->x,
                             .body = mus_body_vertices(call->body), .ncloth = cloth->ntriangle};
    search.crosses = mus__new(drape->context, (int64_t)cloth->ntriangle + cloth->nnode, sizeof *search.crosses);
    mus_status status = search.crosses != NULL ? MUS_OK : MUS_ERR_MEMORY;
    if (status == MUS_OK) status = through_find(drape->context, &search, nskin);
    if (status == MUS_OK) {
        search.inside = search.crosses + cloth->ntriangle;
        through_measure(call, &search);
    }
    mus__free(drape->context, search.crosses);
    return status == MUS_OK ? MUS_OK : mus__fail_memory(drape->context, "a count of cloth through the body");
}
