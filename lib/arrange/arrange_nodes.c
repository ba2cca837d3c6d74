/*
 * arrange_nodes.c: places of nodes where the placements of their panels put them: flat or rolled, turned, moved
 * (mus_placement). Nodes of a mass-spring network have places of their own.
 *
 * A panel with pleats may start folded. Seen along its folds it runs out to an outer fold, back to an inner one and on.
 * Each turn is shallower than the pleat by the share that the placement says, about the same middle:
 *
 *            ___-o        ___-o        o outer fold, at height 0
 *      ___---  /    ___---  /          i inner fold, PLEAT_DEEP below it, and PLEAT_DEEP / 2 at both ends
 *     -       i----        i----
 *
 * so no layer begins in another, and the layers lie in their order. Farther out, or higher, is on the right side of the
 * panel: along the normal of its plane, or against it where the outline runs clockwise.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_nodes.h"
#include "base/elementary.h"

#define PLEAT_DEEP 0.012 /* [m] between the folds of a pleat; chosen: more than the thickness of cloth on cloth */


/* place of the panel's point (x, y), `height` above its plane, in the body frame */
static void place_point(const mus_placement *place, double x, double y, double height, double *out)
{
    double p[3] = {x, y, height};
    if (place->bend != 0.0) {
        const double angle = (x - place->bend_x) / place->bend;
        p[0] = place->bend_x + place->bend * mus__sin(angle) + height * mus__sin(angle);
        p[2] = place->bend * (mus__cos(angle) - 1.0) + height * mus__cos(angle);
    }
    for (int32_t i = 0; i < 3; i++)
        out[i] = place->origin[i] + place->rotation[3 * i] * p[0] + place->rotation[3 * i + 1] * p[1] +
                 place->rotation[3 * i + 2] * p[2];
}


/* 1 where the panel's right side is that of its plane's normal, -1 where it is the other: triangles run as outlines do
 */
static double place_side(const mus_cloth *cloth, int32_t panel)
{
    const mus__panel_mesh *mesh = &cloth->panel[panel];
    if (mesh->triangle_count == 0) return 1.0;
    const int32_t *corner = cloth->triangle + 3 * (int64_t)mesh->first_triangle;
    const double *a = cloth->rest + 2 * (int64_t)corner[0], *b = cloth->rest + 2 * (int64_t)corner[1];
    const double *c = cloth->rest + 2 * (int64_t)corner[2];
    return (b[0] - a[0]) * (c[1] - a[1]) < (c[0] - a[0]) * (b[1] - a[1]) ? -1.0 : 1.0;
}


/* the placement of a panel, moved `out` [m] off on its right side; a panel that is rolled round the body is rolled that
 * much wider */
static mus_placement place_panel(const mus_cloth *cloth, int32_t panel, double out)
{
    mus_placement place = cloth->panel[panel].placement;
    if (out != 0.0) {
        const double along = place_side(cloth, panel) * out;
        for (int32_t d = 0; d < 3; d++) place.origin[d] += along * place.rotation[3 * d + 2];
        if (along * place.bend > 0.0) place.bend += along;
    }
    return place;
}


/* extent of a flat panel along the direction of its pleats: range (2) [m] */
static void place_range(const mus_cloth *cloth, const mus__pleat *pleat, double *range)
{
    const mus__panel_mesh *panel = &cloth->panel[pleat->panel];
    range[0] = INFINITY, range[1] = -INFINITY;
    for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++) {
        const double *rest = cloth->rest + 2 * (int64_t)i, t = rest[0] * pleat->along[0] + rest[1] * pleat->along[1];
        range[0] = fmin(range[0], t), range[1] = fmax(range[1], t);
    }
}


/* the folded line through n pleats from range[0] to t: returns how far it came from range[0] [m]; *height there */
static double place_folded(const mus__pleat *pleat, int32_t n, double fold, const double *range, double t,
                           double *height)
{
    double at = range[0], far = 0.0, low = -0.5 * PLEAT_DEEP;
    for (int32_t i = 0; i < 2 * n; i++) {
        const mus__pleat *own = &pleat[i / 2];
        const bool out = own->outer < own->inner ? i % 2 == 0 : i % 2 == 1;
        const double middle = 0.5 * (own->outer + own->inner), half = 0.5 * fold * fabs(own->inner - own->outer);
        const double next = middle + (i % 2 == 0 ? -half : half), level = out ? 0.0 : -PLEAT_DEEP;
        const double step = i % 2 == 0 ? 1.0 : -1.0, part = fmin(t, next) - at;
        if (t <= next) {
            *height = low + (next > at ? part / (next - at) : 0.0) * (level - low);
            return far + step * part;
        }
        far += step * part;
        at = next, low = level;
    }
    *height = low + (range[1] > at ? (t - at) / (range[1] - at) : 0.0) * (-0.5 * PLEAT_DEEP - low);
    return far + t - at;
}


/* places of the nodes of a panel that starts folded in its `n` pleats, `out` [m] off on its right side */
static void place_pleats(const mus_cloth *cloth, const mus__pleat *pleat, int32_t n, double out, double *x)
{
    const mus__panel_mesh *panel = &cloth->panel[pleat->panel];
    const mus_placement place = place_panel(cloth, pleat->panel, out);
    const double fold = place.fold, side = place_side(cloth, pleat->panel), *along = pleat->along;
    double range[2], height;
    place_range(cloth, pleat, range);
    const double width = place_folded(pleat, n, fold, range, range[1], &height);
    const double start = 0.5 * (range[0] + range[1]) - 0.5 * width;
    for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++) {
        const double *rest = cloth->rest + 2 * (int64_t)i, t = rest[0] * along[0] + rest[1] * along[1];
        const double by = start + place_folded(pleat, n, fold, range, t, &height) - t;
        place_point(&place, rest[0] + by * along[0], rest[1] + by * along[1], side * height, x + 3 * (int64_t)i);
    }
}


void mus__arrange_panel(const mus_cloth *cloth, int32_t index, double out, double *x)
{
    const mus__panel_mesh *panel = &cloth->panel[index];
    const mus_placement place = place_panel(cloth, index, out);
    int32_t first = 0, last;
    while (first < cloth->npleat && cloth->pleat[first].panel != index) first++;
    for (last = first; last < cloth->npleat && cloth->pleat[last].panel == index;) last++;
    if (last > first && place.fold > 0.0) {
        place_pleats(cloth, cloth->pleat + first, last - first, out, x);
        return;
    }
    for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++)
        place_point(&place, cloth->rest[2 * (int64_t)i], cloth->rest[2 * (int64_t)i + 1], 0.0, x + 3 * (int64_t)i);
}


void mus__arrange_nodes(const mus_cloth *cloth, double *x)
{
    if (cloth->place != NULL) {
        memcpy(x, cloth->place, 3 * (size_t)cloth->nnode * sizeof *x);
        return;
    }
    for (int32_t p = 0; p < cloth->npanel; p++)
        if (cloth->panel[p].node_count > 0)
            mus__arrange_panel(cloth, p, MUS__LAYER_OUT * (cloth->panel[p].layer - cloth->panel[p].lies), x);
}
