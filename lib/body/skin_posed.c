/*
 * skin_posed.c: the skin of a posed body: near a bent joint its rings stand between two parts, and their vertices are
 * moved onto the parts, which contact knows.
 *
 * Elsewhere a ring moves with its part, and lies on its field as in the rest pose.
 */
#include <math.h>
#include <string.h>

#include "body/body_make.h"

#define SKIN_ROUNDS 3   /* rounds that bring a vertex to its parts */
#define SKIN_LOOSE 1e-4 /* [m] distance up to which it may stay */
#define SKIN_DEEP 0.012 /* [m] a vertex deeper within the parts is not seen and keeps its place; chosen */


/* whether the ring at s of limb l stands between two parts that the pose turned against each other */
static bool skin_blended(const mus_body *body, int32_t l, double s)
{
    for (int32_t p = 0; p + 1 < body->rig.parts; p++) {
        const mus__part *below = &body->rig.part[p], *above = below + 1;
        if (below->limb != l || above->limb != l) continue;
        if (s <= below->end[1] - above->round[0] || s >= below->end[1] + below->round[1]) continue;
        if (memcmp(body->frame[p].turn, body->frame[p + 1].turn, sizeof body->frame[p].turn) != 0) return true;
    }
    return false;
}


/* move a point x onto the nearest part */
static void skin_settle(const mus_body *body, double *x)
{
    for (int round = 0; round < SKIN_ROUNDS; round++) {
        double best = -1e30, at[3] = {0.0, 0.0, 0.0}, normal[3];
        for (int32_t q = 0; q < body->nfield; q++) {
            const double d = mus__field_depth(&body->field[q], x, normal);
            if (d > best) best = d, memcpy(at, normal, sizeof at);
        }
        if (fabs(best) < SKIN_LOOSE || best < -1e29 || best > SKIN_DEEP) return;
        for (int i = 0; i < 3; i++) x[i] += best * at[i];
    }
}


void mus__body_skin(mus_body *body)
{
    if (body->frame == NULL || !body->jointed) return;
    for (int32_t l = 0; l < body->limb_count; l++) {
        const mus__limb *limb = &body->limb[l];
        const int32_t n = limb->samples;
        bool moved = false;
        for (int32_t ring = 0; ring < limb->rings; ring++) {
            if (!skin_blended(body, l, body->ring[limb->first_ring + ring])) continue;
            double *row = body->vertices + 3 * (limb->first_vertex + 1 + (ptrdiff_t)ring * n);
            for (int32_t k = 0; k < n; k++) skin_settle(body, row + 3 * (ptrdiff_t)k);
            moved = true;
        }
        if (moved)
            mus__ring_normals(body->vertices + 3 * (ptrdiff_t)limb->first_vertex, n, limb->rings, 0,
                              body->normals + 3 * (ptrdiff_t)limb->first_vertex);
    }
}
