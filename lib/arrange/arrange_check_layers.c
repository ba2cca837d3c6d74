/*
 * arrange_check_layers.c: finds panels that begin through one another, and layers whose order is not the same all
 * round.
 *
 * Layers that the pattern tells are left out: sewing starts each of them clear of those below it.
 *
 * Panels that are sewn to each other may cross near their seam, and sheets in one plane may lie through each other:
 * sewing draws them apart. A panel that stands across another one, to which it is not sewn, does not come free. Layers
 * are components here: no panel of one may go through the other, and one of them lies outside the other everywhere.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "arrange/failure_reason.h"
#include "base/sort.h"
#include "geom/vec.h"

#define ORDER_ACROSS 0.7 /* cosine of the angle of two sheets: steeper ones stand across each other */
#define ORDER_LENGTH 0.1 /* [m] length of a crossing that is a fault */
#define ORDER_NEAR 0.08  /* [m] distance within which one sheet lies over the other */
#define ORDER_SQUARE                                                                                                   \
    0.7 /* of the distance: its component along the normal, for a sheet that is over the node and not beside it */
#define ORDER_PART                                                                                                     \
    0.2 /* of the nodes that have the other layer over or under them: the smaller side of a mixed order has more */
#define ORDER_SAMPLES 400 /* nodes of a layer that are sampled */
#define ORDER_MOST 65536  /* crossings that are looked at, at most */

typedef struct order_look {
    const mus__placed_cloth *placed;
    int32_t *piece; /* (npanel) lowest panel of each one's piece */
    double *normal; /* (n x 3) */
    int32_t *pair;  /* triangles that cross, two by two */
} order_look;


static int32_t order_root(int32_t *link, int32_t i)
{
    while (link[i] != i) i = link[i] = link[link[i]];
    return i;
}


static void order_pieces(order_look *look)
{
    const mus_cloth *cloth = look->placed->cloth;
    for (int32_t p = 0; p < cloth->npanel; p++) look->piece[p] = p;
    for (int32_t p = 0; p < cloth->npair; p++) {
        const int32_t a = order_root(look->piece, cloth->node_panel[cloth->pair[2 * p]]);
        const int32_t b = order_root(look->piece, cloth->node_panel[cloth->pair[2 * p + 1]]);
        look->piece[a > b ? a : b] = a > b ? b : a;
    }
    for (int32_t p = 0; p < cloth->npanel; p++) order_root(look->piece, p);
    for (int32_t p = 0; p < cloth->npanel; p++) look->piece[p] = order_root(look->piece, p);
}


/* whether a seam joins two panels */
static bool order_sewn(const mus_cloth *cloth, int32_t p, int32_t q)
{
    for (int32_t i = 0; i < cloth->npair; i++) {
        const int32_t a = cloth->node_panel[cloth->pair[2 * i]], b = cloth->node_panel[cloth->pair[2 * i + 1]];
        if ((a == p && b == q) || (a == q && b == p)) return true;
    }
    return false;
}


static void order_triangle_normal(const mus__placed_cloth *placed, int32_t triangle, double *out)
{
    const int32_t *v = placed->cloth->triangle + 3 * (ptrdiff_t)triangle;
    const double *a = placed->x + 3 * (ptrdiff_t)v[0], *b = placed->x + 3 * (ptrdiff_t)v[1];
    const double *c = placed->x + 3 * (ptrdiff_t)v[2];
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, e[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    mus__cross3(d, e, out);
    mus__unit3(out);
}


/* whether the pattern tells which of two panels lies over the other, and layers are sewn one by one */
static bool order_told(const mus__placed_cloth *placed, int32_t p, int32_t q)
{
    return placed->layered && placed->cloth->panel[p].layer != placed->cloth->panel[q].layer;
}


/* the two panels of a crossing as one number, the lower one first; -1 for panels that may cross so */
static int64_t order_crossing(const order_look *look, int32_t i)
{
    const mus_cloth *cloth = look->placed->cloth;
    const int32_t *pair = look->pair + 2 * (ptrdiff_t)i;
    const int32_t p = cloth->node_panel[cloth->triangle[3 * (ptrdiff_t)pair[0]]];
    const int32_t q = cloth->node_panel[cloth->triangle[3 * (ptrdiff_t)pair[1]]];
    double m[3], n[3];
    if (p == q || order_told(look->placed, p, q)) return -1;
    order_triangle_normal(look->placed, pair[0], m);
    order_triangle_normal(look->placed, pair[1], n);
    if (look->piece[p] == look->piece[q] && !(fabs(mus__dot3(m, n)) < ORDER_ACROSS)) return -1;
    return p < q ? (int64_t)p * cloth->npanel + q : (int64_t)q * cloth->npanel + p;
}


static int order_by_number(const void *a, const void *b)
{
    const int64_t p = *(const int64_t *)a, q = *(const int64_t *)b;
    return p < q ? -1 : p > q;
}


/* finds two panels that cross too far and are not sewn together; number (count) is scratch */
static void order_through(const order_look *look, int32_t count, int64_t *number, mus_reason *out)
{
    const mus_cloth *cloth = look->placed->cloth;
    for (int32_t i = 0; i < count; i++) number[i] = order_crossing(look, i);
    mus__sort(number, (size_t)count, sizeof *number, order_by_number);
    for (int32_t first = 0, last; first < count; first = last) {
        for (last = first; last < count && number[last] == number[first];) last++;
        if (number[first] < 0) continue;

        /* a line through two meshes passes about two pairs of triangles a spacing */
        const int32_t p = (int32_t)(number[first] / cloth->npanel), q = (int32_t)(number[first] % cloth->npanel);
        if (!(0.5 * (last - first) * cloth->spacing > ORDER_LENGTH) || order_sewn(cloth, p, q)) continue;
        char text[256];
        snprintf(text, sizeof text, "panels %.80s and %.80s begin through each other", mus_cloth_panel_name(cloth, p),
                 mus_cloth_panel_name(cloth, q));
        mus__reason_start_tangled(out, p, MUS_NONE, text);
        return;
    }
}


/* the node of a component that is nearest to node i; MUS_NONE when none is near */
static int32_t order_nearest(const order_look *look, int32_t i, int32_t piece)
{
    const mus_cloth *cloth = look->placed->cloth;
    const double *a = look->placed->x + 3 * (ptrdiff_t)i;
    double least = ORDER_NEAR * ORDER_NEAR;
    int32_t best = MUS_NONE;
    for (int32_t p = 0; p < cloth->npanel; p++) {
        if (look->piece[p] != piece) continue;
        const int32_t first = cloth->panel[p].first_node, last = first + cloth->panel[p].node_count;
        for (int32_t k = first; k < last; k++) {
            const double *b = look->placed->x + 3 * (ptrdiff_t)k;
            const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, far = mus__dot3(d, d);
            if (far < least) least = far, best = k;
        }
    }
    return best;
}


/* finds components of mixed order: b lies over a at some nodes of a and under it at others */
static void order_mixed(const order_look *look, int32_t a, int32_t b, mus_reason *out)
{
    const mus_cloth *cloth = look->placed->cloth;
    int32_t side[2] = {0, 0}, at[2] = {0, 0}, nodes = 0, seen = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) nodes += look->piece[cloth->node_panel[i]] == a;
    const int32_t every = nodes / ORDER_SAMPLES + 1;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        if (look->piece[cloth->node_panel[i]] != a || seen++ % every != 0) continue;
        const int32_t k = order_nearest(look, i, b);
        if (k == MUS_NONE) continue;
        const double *x = look->placed->x + 3 * (ptrdiff_t)i, *y = look->placed->x + 3 * (ptrdiff_t)k;
        const double d[3] = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        const double over = mus__dot3(d, look->normal + 3 * (ptrdiff_t)i);
        if (!(fabs(over) > ORDER_SQUARE * mus__norm3(d))) continue;
        side[over < 0.0]++;
        at[over < 0.0] = i;
    }
    const int32_t less = side[1] < side[0];
    if (!(side[less] > ORDER_PART * (side[0] + side[1]))) return;
    char text[256];
    const int32_t own = cloth->node_panel[at[less]];
    snprintf(text, sizeof text, "layers of %.80s and %.80s begin in no order: the one lies over the other and under it",
             mus_cloth_panel_name(cloth, own), mus_cloth_panel_name(cloth, b));
    mus__reason_start_tangled(out, own, MUS_NONE, text);
}


mus_status mus__arrange_check_layers(const mus__placed_cloth *placed, mus_reason *out)
{
    mus_context *context = placed->context;
    const mus_cloth *cloth = placed->cloth;
    int64_t count = 0;
    if (cloth->npanel < 2) return MUS_OK;
    mus_status status = mus__placed_crossings(placed, 0, NULL, &count);
    const int32_t most = count < ORDER_MOST ? (int32_t)count : ORDER_MOST;
    order_look look = {.placed = placed};
    look.piece = mus__new(context, cloth->npanel, sizeof *look.piece);
    look.normal = mus__new(context, 3 * (int64_t)placed->cloth->nnode, sizeof *look.normal);
    look.pair = mus__new(context, 2 * (int64_t)most, sizeof *look.pair);
    int64_t *number = mus__new(context, most, sizeof *number);
    if (status == MUS_OK && (look.piece == NULL || look.normal == NULL || look.pair == NULL || number == NULL))
        status = mus__fail_memory(context, "the check of an arrangement");
    if (status == MUS_OK && most > 0) status = mus__placed_crossings(placed, most, look.pair, &count);
    if (status == MUS_OK) {
        mus__placed_normals(placed, look.normal);
        order_pieces(&look);
        order_through(&look, most, number, out);
        for (int32_t a = 0; a < cloth->npanel; a++)
            for (int32_t b = a + 1; b < cloth->npanel && out->kind == MUS_REASON_NONE; b++)
                if (look.piece[a] == a && look.piece[b] == b && !order_told(placed, a, b))
                    order_mixed(&look, a, b, out);
    }
    mus__free(context, look.piece);
    mus__free(context, look.normal);
    mus__free(context, look.pair);
    mus__free(context, number);
    return status;
}
