/*
 * weld.c: welding: the nodes that seam pairs join become one node, and the quotient of the pattern becomes real.
 *
 * Classes are found by union-find over the seam pairs. The smallest index is the representative of its class, with the
 * mass of the whole class. Only border nodes are in pairs, and only elements name border nodes, so no run changes.
 */
#include <string.h>

#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "sim/bend_clamp.h"
#include "drape/weld.h"
#include "geom/union_find.h"


double mus__weld_pair_stiffness(const mus_drape *drape)
{
    const double *stretch = drape->cloth->fabric.stretch;
    return 8.0 * (stretch[0] > stretch[1] ? stretch[0] : stretch[1]);
}


/* each node by itself, with its own mass; the program is as it was */
static void separate(mus_drape *drape)
{
    drape->welded = 0;
    mus__union_start(drape->n, drape->rep, NULL);
    for (int32_t i = 0; i < drape->n; i++) drape->mass[i] = drape->cloth->mass[i];
    drape->program.seam_pull = drape->def.seam_pull;
}


void mus__weld_open(mus_drape *drape)
{
    separate(drape);
    mus__program_weld(drape->cloth, NULL, &drape->program);
    mus__clamps_update(drape->cloth, drape->pinned, MUS__PINNED, &drape->program);
    mus__drape_self_weld(drape);

    const double k = mus__weld_pair_stiffness(drape);
    for (int32_t p = 0; p < drape->program.npair; p++) drape->program.pair[p].k = k;
}


/* whether an end of seam pair p is in a layer that waits, from `waits` on; 0: none waits */
static bool weld_waits(const mus_cloth *cloth, int32_t p, int32_t waits)
{
    return waits > 0 && (mus__cloth_layer(cloth, cloth->pair[2 * p]) >= waits ||
                         mus__cloth_layer(cloth, cloth->pair[2 * p + 1]) >= waits);
}


/* welds the seams of panels below layer `waits`; 0: all seams */
static void weld_below(mus_drape *drape, int32_t waits)
{
    const mus_cloth *cloth = drape->cloth;
    int32_t *rep = drape->rep;
    mus__drape_publish(drape);
    for (int32_t p = 0; p < cloth->npair; p++) {
        if (weld_waits(cloth, p, waits)) continue;
        mus__union_join(rep, NULL, cloth->pair[2 * p], cloth->pair[2 * p + 1], 1);
    }

    /* mass, momentum and centre of mass of each class, summed in ascending order */
    for (int32_t i = 0; i < drape->n; i++) mus__union_find(rep, NULL, i);
    double *x = drape->x, *v = drape->v, *mass = drape->mass;
    for (int32_t i = 0; i < drape->n; i++) {
        const int32_t r = rep[i];
        if (r == i) continue;
        const double total = mass[r] + mass[i], share = mass[i] / total;
        for (int32_t d = 0; d < 3; d++) {
            x[3 * r + d] += share * (x[3 * i + d] - x[3 * r + d]);
            v[3 * r + d] += share * (v[3 * i + d] - v[3 * r + d]);
        }
        mass[r] = total;
        mass[i] = 0.0;
        drape->pinned[r] |= drape->pinned[i];
    }
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->pinned[rep[i]]) memset(v + 3 * (int64_t)rep[i], 0, 3 * sizeof *v);

    drape->program.open_from = waits;
    mus__program_weld(cloth, rep, &drape->program);
    mus__clamps_update(cloth, drape->pinned, MUS__PINNED, &drape->program);
    drape->welded = 1;
    mus__drape_self_weld(drape);
    memset(drape->sim.f, 0, 3 * (size_t)drape->sim.n * drape->sim.ops->real);
    mus__drape_push(drape);
    mus__drape_publish(drape);
}


void mus__weld(mus_drape *drape)
{
    weld_below(drape, drape->program.wait_from);
}


void mus__weld_anew(mus_drape *drape)
{
    separate(drape);
    mus__weld(drape);
}


void mus__weld_reopen(mus_drape *drape, const double *x)
{
    const int32_t below = drape->welded ? drape->program.open_from : 0;
    mus__weld_open(drape);
    memcpy(drape->x, x, 3 * (size_t)drape->n * sizeof *x);
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *x);
    mus__drape_push(drape);
    if (below > 0) weld_below(drape, below);
    mus__drape_publish(drape);
}


double mus__weld_gap(const mus_drape *drape, int32_t *seam)
{
    const mus_cloth *cloth = drape->cloth;
    const int32_t waits = drape->program.wait_from;
    double most = 0.0;
    if (seam != NULL) *seam = MUS_NONE;
    for (int32_t p = 0; p < cloth->npair; p++) {
        if (weld_waits(cloth, p, waits)) continue;
        const double *a = drape->x + 3 * (int64_t)cloth->pair[2 * p],
                     *b = drape->x + 3 * (int64_t)cloth->pair[2 * p + 1];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double gap = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (gap <= most && p > 0) continue;
        most = gap;
        if (seam != NULL) *seam = cloth->pair_seam[p];
    }
    return most;
}
