/*
 * layers.c: garments worn over one another, sewn one layer after the other, from inside to outside.
 *
 * A layer that is sewn later waits: its nodes are fixed where they start, and nothing meets them. The innermost layer
 * is sewn and let down as if it were alone. Each next layer starts where it crosses no worn layer: its panels are put
 * along their normals off the body, all equally far, until an exact count finds no crossing. Then each panel comes in
 * again, to where the pattern places it or as near as the worn layers allow. Its seams are drawn shut round the worn
 * layers, which are cloth by now and take part in self-contact, and it is let down too. Only the finest cut knows
 * several layers: coarse cuts of cloth that lies on cloth would cross.
 *
 * Where sleeves come over a layer, it is not let down before they are closed: a part that hangs off an arm would hang
 * out of a sleeve that is still open below. A garment whose upper layers all lie on it, as collars do, is not let down
 * either: they are put on as soon as it is sewn, and it settles as one, on every cut.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_nodes.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "dress/dynamic_relaxation.h"
#include "dress/laid_on.h"
#include "dress/sew.h"
#include "geom/predicate.h"
#include "geom/vec.h"
#include "sim/bend_clamp.h"

#define LAYERS_TRIALS 24  /* starts that are tried, each MUS__LAYER_OUT farther out; chosen: half a metre in all */
#define LAYERS_STEP 0.004 /* [m] in again; chosen: below the distance of two sheets, so that none is jumped */
#define WAY_MOST 8        /* sheets between the nodes of a pair that are told apart; more count as worn cloth between */


/* the lowest layer from `from` on that has a panel; 0 when there is none */
static int32_t layers_next(const mus_cloth *cloth, int32_t from)
{
    int32_t next = 0;
    for (int32_t p = 0; p < cloth->npanel; p++) {
        const int32_t layer = cloth->panel[p].layer;
        if (layer >= from && (next == 0 || layer < next)) next = layer;
    }
    return next;
}


/* whether all panels of layers from `from` on lie on what they are sewn to: they are one garment with it */
static bool layers_lie(const mus_cloth *cloth, int32_t from)
{
    for (int32_t p = 0; p < cloth->npanel; p++)
        if (cloth->panel[p].layer >= from && !cloth->panel[p].lies) return false;
    return true;
}


/* lets panels from layer `from` on wait; 0: none waits */
static void layers_wait(mus_drape *drape, int32_t from)
{
    drape->program.wait_from = from;
    for (int32_t i = 0; i < drape->n; i++) {
        const int32_t waits = from > 0 && mus__cloth_layer(drape->cloth, i) >= from;
        drape->pinned[i] = (drape->pinned[i] & ~MUS__WAITS) | (waits ? MUS__WAITS : 0);
    }
    mus__program_weld(drape->cloth, drape->welded ? drape->rep : NULL, &drape->program);
    mus__clamps_update(drape->cloth, drape->pinned, MUS__PINNED, &drape->program);
    mus__drape_self_weld(drape);
    mus__drape_push(drape);
}


/* whether any panel of layers first .. last starts rolled round more than half a limb */
static int32_t layers_sleeved(const mus_cloth *cloth, int32_t first, int32_t last)
{
    for (int32_t p = 0; p < cloth->npanel; p++) {
        const mus__panel_mesh *panel = &cloth->panel[p];
        double low = INFINITY, high = -INFINITY;
        if (panel->layer < first || panel->layer > last || panel->placement.bend == 0.0) continue;
        for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++) {
            low = fmin(low, cloth->rest[2 * (int64_t)i]);
            high = fmax(high, cloth->rest[2 * (int64_t)i]);
        }
        if (high - low > MUS_PI * fabs(panel->placement.bend)) return 1;
    }
    return 0;
}


/* counts crossings of a layer with the layers below it; or of a panel with all layers up to its own */
typedef struct layers_met {
    const mus_cloth *cloth;
    int32_t layer, panel; /* panel MUS_NONE: crossings of the layer */
    int64_t count;
} layers_met;


static void layers_note(void *user, int32_t p, int32_t q, int32_t of, int32_t met)
{
    layers_met *found = user;
    const int32_t *triangle = found->cloth->triangle;
    (void)p;
    (void)q;
    const int32_t i = triangle[3 * (int64_t)of], k = triangle[3 * (int64_t)met];
    const int32_t a = mus__cloth_layer(found->cloth, i), b = mus__cloth_layer(found->cloth, k);
    if (a > found->layer || b > found->layer) return;
    if (found->panel == MUS_NONE)
        found->count += a != b && (a == found->layer || b == found->layer);
    else
        found->count += found->cloth->node_panel[i] == found->panel || found->cloth->node_panel[k] == found->panel;
}


/* number of these crossings at the drape's places */
static int64_t layers_count(const mus_drape *drape, int32_t layer, int32_t panel)
{
    const mus_cloth *cloth = drape->cloth;
    layers_met found = {cloth, layer, panel, 0};
    mus__crossing_count(&drape->self->grid, cloth->ntriangle, cloth->triangle, drape->self->class_of, drape->x,
                        layers_note, &found);
    return found.count;
}


/* -1 for a panel whose right side faces the body as the pattern places it, else 1. A collar that lies on the shoulders
 * starts with its under side out, above the necklines, and stays above them */
static double layers_side(mus_drape *drape, int32_t panel)
{
    const mus__panel_mesh *mesh = &drape->cloth->panel[panel];
    double away = 0.0;
    if (drape->scene.collider == NULL) return 1.0;
    mus__arrange_panel(drape->cloth, panel, 0.0, drape->x);
    for (int32_t t = mesh->first_triangle; t < mesh->first_triangle + mesh->triangle_count; t++) {
        const int32_t *corner = drape->cloth->triangle + 3 * (int64_t)t;
        const double *a = drape->x + 3 * (int64_t)corner[0], *b = drape->x + 3 * (int64_t)corner[1];
        const double *c = drape->x + 3 * (int64_t)corner[2];
        double ab[3], ac[3], middle[3], normal[3], out[3] = {0.0};
        for (int32_t d = 0; d < 3; d++)
            ab[d] = b[d] - a[d], ac[d] = c[d] - a[d], middle[d] = (a[d] + b[d] + c[d]) / 3.0;
        mus__cross3(ab, ac, normal);
        mus__collider_depth(drape->scene.collider, middle, MUS__LAYERS_REACH, out);
        away += mus__dot3(normal, out);
    }
    return away < 0.0 ? -1.0 : 1.0;
}


/* places a panel `out` [m] off: laid on the worn cloth that it is sewn to, or as the pattern has it */
static mus_status layers_place(mus_drape *drape, int32_t panel, double side, double out)
{
    if (drape->cloth->panel[panel].lies) return mus__laid_place(drape, panel, out);
    mus__arrange_panel(drape->cloth, panel, side * out, drape->x);
    return MUS_OK;
}


/*
 * Moves a panel that is `out` [m] off in again, as long as its crossings do not grow, in steps shorter than the
 * distance of two sheets. The edges of a sleeve that is rolled too wide lie over the limb, not under it, and would be
 * sewn there; a collar far above the neckline would crumple on its way.
 */
static mus_status layers_come_in(mus_drape *drape, int32_t panel, double out)
{
    const int32_t layer = drape->cloth->panel[panel].layer;
    const int64_t met = layers_count(drape, layer, panel);
    const double side = layers_side(drape, panel);
    mus_status status = layers_place(drape, panel, side, out);
    double in = out;
    for (double next = out; next > 0.0 && status == MUS_OK;) {
        next = fmax(next - LAYERS_STEP, 0.0);
        status = layers_place(drape, panel, side, next);
        if (layers_count(drape, layer, panel) > met) break;
        in = next;
    }
    return status != MUS_OK ? status : layers_place(drape, panel, side, fmin(in + LAYERS_STEP, out));
}


/* puts a layer where it starts, clear of the layers below it */
static mus_status layers_start(mus_drape *drape, int32_t layer)
{
    const mus_cloth *cloth = drape->cloth;
    mus_status status = MUS_OK;
    double out = 0.0;
    mus__drape_publish(drape);
    for (int32_t k = 0; k < LAYERS_TRIALS && status == MUS_OK; k++) {
        out = MUS__LAYER_OUT * (layer + k);
        for (int32_t p = 0; p < cloth->npanel && status == MUS_OK; p++)
            if (cloth->panel[p].layer == layer) status = layers_place(drape, p, layers_side(drape, p), out);
        if (layers_count(drape, layer, MUS_NONE) == 0) break;
    }
    for (int32_t p = 0; p < cloth->npanel && status == MUS_OK; p++)
        if (cloth->panel[p].layer == layer) status = layers_come_in(drape, p, out);
    for (int32_t i = 0; i < drape->n; i++)
        if (mus__cloth_layer(cloth, i) == layer) memset(drape->v + 3 * (int64_t)i, 0, 3 * sizeof *drape->v);
    mus__drape_push(drape);
    return status;
}


int32_t mus__layers_needed(const mus_drape *drape)
{
    const int32_t first = drape->cloth->npanel > 0 ? drape->cloth->panel[0].layer : 0;
    for (int32_t p = 1; p < drape->cloth->npanel; p++)
        if (drape->cloth->panel[p].layer != first) return drape->self != NULL;
    return 0;
}


/* ---- worn cloth between two nodes that are to be welded ---- */

/* whether the box of a triangle is clear of the box of the segment p q */
static bool layers_far(const double *p, const double *q, const double *a, const double *b, const double *c)
{
    for (int32_t d = 0; d < 3; d++) {
        if (fmax(p[d], q[d]) < fmin(a[d], fmin(b[d], c[d]))) return true;
        if (fmin(p[d], q[d]) > fmax(a[d], fmax(b[d], c[d]))) return true;
    }
    return false;
}


/* whether the node is a corner of triangle t, or welded to one */
static bool layers_corner(const mus_drape *drape, int32_t t, int32_t node)
{
    const int32_t *rep = drape->rep, *corner = drape->cloth->triangle + 3 * (int64_t)t;
    return rep[corner[0]] == rep[node] || rep[corner[1]] == rep[node] || rep[corner[2]] == rep[node];
}


/* whether two triangles have a corner in common */
static bool layers_share(const mus_drape *drape, int32_t s, int32_t t)
{
    const int32_t *corner = drape->cloth->triangle + 3 * (int64_t)s;
    return layers_corner(drape, t, corner[0]) || layers_corner(drape, t, corner[1]) ||
           layers_corner(drape, t, corner[2]);
}


/* whether two triangles share a corner, or a third triangle shares one with each: the two sides of a fold do */
static bool layers_beside(const mus_drape *drape, int32_t s, int32_t t)
{
    if (layers_share(drape, s, t)) return true;
    for (int32_t k = 0; k < drape->cloth->ntriangle; k++)
        if (layers_share(drape, k, s) && layers_share(drape, k, t)) return true;
    return false;
}


/* a segment through worn cloth: the triangles that it has not come back out of */
typedef struct layers_way {
    int32_t count, triangle[WAY_MOST];
    bool out[WAY_MOST]; /* by its right side */
} layers_way;


/* the segment goes through triangle t. If it went in by the other side beside t, the two cancel: it crossed a fold */
static void layers_pass(const mus_drape *drape, layers_way *way, int32_t t, bool out)
{
    for (int32_t k = 0; k < way->count; k++) {
        if (way->out[k] == out || !layers_beside(drape, way->triangle[k], t)) continue;
        way->count--;
        way->triangle[k] = way->triangle[way->count], way->out[k] = way->out[way->count];
        return;
    }
    way->triangle[way->count] = t, way->out[way->count] = out;
    way->count++;
}


/* A seam under the arm of a worn layer is a ridge: a segment over it goes in and out again, and its two ends are on one
 * side of the cloth */
int32_t mus__layers_between(const mus_drape *drape, int32_t i, int32_t k)
{
    const mus_cloth *cloth = drape->cloth;
    const double *x = drape->x, *p = x + 3 * (int64_t)i, *q = x + 3 * (int64_t)k;
    layers_way way = {.count = 0};
    for (int32_t panel = 0; panel < cloth->npanel; panel++) {
        const mus__panel_mesh *mesh = &cloth->panel[panel];
        if (mesh->layer >= drape->program.open_from) continue;
        for (int32_t t = mesh->first_triangle; t < mesh->first_triangle + mesh->triangle_count; t++) {
            const int32_t *corner = cloth->triangle + 3 * (int64_t)t;
            const double *a = x + 3 * (int64_t)corner[0], *b = x + 3 * (int64_t)corner[1];
            const double *c = x + 3 * (int64_t)corner[2];
            if (layers_far(p, q, a, b, c) || !mus__segment_meets_triangle(p, q, a, b, c)) continue;
            if (layers_corner(drape, t, i) || layers_corner(drape, t, k)) continue;
            layers_pass(drape, &way, t, mus__orient3d(a, b, c, p) > 0.0);
            if (way.count == WAY_MOST) return 1;
        }
    }
    return way.count > 0;
}


int64_t mus__layers_crossings(const mus_drape *drape, int32_t layer)
{
    return layers_count(drape, layer, MUS_NONE);
}


mus_status mus__layers_sew(mus_drape *drape, mus__progress *run, mus__sew_fn all, mus__sew_fn here)
{
    const mus_cloth *cloth = drape->cloth;
    int32_t layer = cloth->panel[0].layer;
    for (int32_t p = 1; p < cloth->npanel; p++)
        if (cloth->panel[p].layer < layer) layer = cloth->panel[p].layer;
    const bool one = layers_lie(cloth, layer + 1);
    mus_status status = MUS_OK;
    for (int32_t first = 1; status == MUS_OK && !run->stop; first = 0) {
        const int32_t next = layers_next(cloth, layer + 1);
        if (!first) status = layers_start(drape, layer);
        if (status != MUS_OK) break;
        layers_wait(drape, next);
        run->sleeved = !first && layers_sleeved(cloth, layer, layer);
        status = first ? all(drape, run) : here(drape, run);
        run->sleeved = 0;
        if (status != MUS_OK || run->stop) break;
        const bool falls = next == 0 ? !one : !layers_lie(cloth, next) && !layers_sleeved(cloth, next, INT32_MAX);
        if (falls) status = mus__settle_let_down(drape, run);
        if (next == 0) break;
        layer = next;
    }
    layers_wait(drape, 0);
    mus__drape_publish(drape);
    drape->relax.far = one || status != MUS_OK;
    if (one) drape->coarse.as_sewn = 0;
    return status;
}
