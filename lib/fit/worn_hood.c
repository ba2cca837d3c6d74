/*
 * worn_hood.c: the hood of a garment and the head that it is for.
 *
 * A hood belongs to the opening for the head that the pattern puts before the face, with cloth over the crown
 * (worn_openings.c). The middle of its face edge is the place of that loop that the pattern puts highest. The head is
 * widest at the brow; the eyes lie below it by a third of what is above it, for they are half way from chin to crown.
 */
#include <math.h>
#include <string.h>

#include "arrange/arrange_nodes.h"
#include "fit/worn_internal.h"
#include "geom/vec.h"

/* [m] to both sides of the middle, to the temples, that two hands take; chosen: less leaves a notch */
#define HOOD_HAND 0.12


void mus__worn_head(const mus_body *body, const mus__worn_axes *axes, mus__head *out)
{
    double girth = 0.0, centre[3];
    const int32_t torso = axes->limb[MUS_WORN_NECK], last = axes->count[MUS_WORN_NECK] - 1;
    memset(out, 0, sizeof *out);
    if (last < 1) return;
    for (int32_t k = mus_body_contour_count(body, torso); k-- > 0;) { /* from the crown down they grow until there */
        const double own = mus__worn_contour(body, torso, k, centre);
        if (!(own > girth)) break;
        girth = own;
        memcpy(out->brow, centre, sizeof centre);
    }
    const double *crown = axes->point[MUS_WORN_NECK][last];
    for (int32_t d = 0; d < 3; d++) {
        out->eyes[d] = out->brow[d] - (crown[d] - out->brow[d]) / 3.0;
        out->up[d] = axes->up[d], out->front[d] = axes->front[d], out->left[d] = axes->left[d];
    }
    out->there = girth > 0.0;
}


/* takes the nodes of a loop within the reach of two hands round its place `middle` */
static void hood_take(const mus_drape *drape, const int32_t *loop, int32_t count, int32_t middle, mus__hood_edge *out)
{
    double lean = 0.0;
    out->count = 1, out->node[0] = loop[middle], out->along[0] = 0.0;
    for (int32_t way = -1; way <= 1; way += 2) {
        double along = 0.0;
        for (int32_t i = 1; i < count && out->count < MUS__HOOD_HAND; i++) {
            const int32_t node = loop[(middle + way * i + count) % count];
            const int32_t last = loop[(middle + way * (i - 1) + count) % count];
            const double *a = drape->x + 3 * (ptrdiff_t)last, *b = drape->x + 3 * (ptrdiff_t)node;
            const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
            along += mus__norm3(d);
            if (along > HOOD_HAND) break;
            out->node[out->count] = node, out->along[out->count++] = way * along;
            lean += way * along * mus__dot3(out->head.left, b);
        }
    }
    for (int32_t i = 0; i < out->count && lean < 0.0; i++) out->along[i] = -out->along[i];
}


mus_status mus__fit_hood(const mus_drape *drape, const mus_pattern *pattern, const mus_body *body, mus__hood_edge *out)
{
    mus__worn_loops loops = {0};
    mus__worn_axes axes;
    memset(out, 0, sizeof *out);
    if (!mus__worn_axes_make(body, &axes)) return MUS_OK;
    mus__worn_head(body, &axes, &out->head);
    if (!out->head.there) return MUS_OK;
    double *placed = mus__new(drape->context, 3 * (int64_t)drape->cloth->nnode, sizeof *placed);
    if (placed == NULL) return mus__fail_memory(drape->context, "the hood of a garment");
    mus__arrange_nodes(drape->cloth, placed);
    mus_status status = mus__worn_loops_make(drape->context, drape->cloth, &loops);
    if (status == MUS_OK) status = mus__worn_expect(pattern, drape->cloth, &axes, placed, &loops);
    if (status == MUS_OK) mus__worn_over(&axes, drape->x, &loops);
    const mus__worn_loop *edge = NULL;
    int32_t middle = 0;
    double high = -INFINITY;
    for (int32_t l = 0; l < loops.nloop && status == MUS_OK; l++) {
        const mus__worn_loop *own = &loops.loop[l];
        for (int32_t i = 0; i < own->count && own->over; i++) {
            const double height = mus__dot3(axes.up, placed + 3 * (ptrdiff_t)loops.node[own->first + i]);
            if (height > high) high = height, middle = i, edge = own;
        }
    }
    if (edge != NULL) hood_take(drape, loops.node + edge->first, edge->count, middle, out);
    if (loops.context != NULL) mus__worn_loops_free(&loops);
    mus__free(drape->context, placed);
    return status;
}
