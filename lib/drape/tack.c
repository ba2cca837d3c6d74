/*
 * tack.c: tacks, single stitches of thread between two nodes, put in and taken out of a running drape.
 *
 * A tack is a spring of no length, E = k |x_b - x_a|^2 / 2: one more irregular spring of the force program, behind
 * those of the cloth. The pass over irregular springs steps it, every other sum keeps its order, and forces, energies,
 * residuals and the step bound include it. The list names nodes of the cloth as it was cut; welding and opening seams
 * rename them. The program grows here, between steps; the memory of a tack that is taken out stays for the next.
 *
 * A coarse drape has each tack between the nodes that are nearest to its ends, as it has pins.
 */
#include <math.h>

#include "drape/coarse_drape.h"
#include "drape/drape_state.h"

#define TACK_MOST 1e9 /* [N/m] largest stiffness: that of steel of the size of a metre of cloth */


/* whether a node of the cloth is fixed */
static int32_t is_held(const mus_drape *drape, int32_t node)
{
    const int32_t r = drape->rep[node];
    return drape->pinned[r] || drape->mass[r] <= 0.0;
}


static mus_status check_tack(const mus_drape *drape, int32_t a, int32_t b, double stiffness)
{
    mus_context *context = drape->context;
    const int32_t ends[2] = {a, b};
    for (int32_t i = 0; i < 2; i++)
        if (ends[i] < 0 || ends[i] >= drape->n)
            return mus__fail(context, MUS_ERR_ARG, "drape: node %d of a tack, expected 0 to %d", (int)ends[i],
                             (int)drape->n - 1);
    if (a == b) return mus__fail(context, MUS_ERR_ARG, "drape: a tack of node %d with itself", (int)a);
    if (!(stiffness >= 0.0 && stiffness <= TACK_MOST))
        return mus__fail(context, MUS_ERR_ARG, "drape: stiffness of a tack is %g N/m, expected 0 to %g", stiffness,
                         TACK_MOST);

    /* two fixed nodes cannot be drawn within the collision distance */
    double gap2 = 0.0;
    for (int32_t d = 0; d < 3; d++) {
        const double way = drape->x[3 * (int64_t)b + d] - drape->x[3 * (int64_t)a + d];
        gap2 += way * way;
    }
    const double gap = sqrt(gap2);
    if (is_held(drape, a) && is_held(drape, b) && gap > drape->def.collision_distance)
        return mus__fail(context, MUS_ERR_STATE, "drape: a tack of nodes %d and %d cannot close: gap %g m, both held",
                         (int)a, (int)b, gap);
    return MUS_OK;
}


/* takes a changed list of tacks over: forces, bound and rest change, places do not */
static void tacks_changed(mus_drape *drape)
{
    mus__program_tacks_changed(drape->cloth, drape->welded ? drape->rep : NULL, &drape->program);
    drape->sim.fresh = 0;
    drape->relax.settled = drape->coarse.as_sewn = 0;
    drape->relax.residual = NAN;
    mus__drape_stale(drape);
}


mus_status mus_drape_tack(mus_drape *drape, int32_t a, int32_t b, double stiffness, int32_t *index)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus__program *program = &drape->program;
    int32_t k = 0;
    while (k < program->ntack && program->tack[k].a != MUS_NONE) k++;
    mus_status status = check_tack(drape, a, b, stiffness);
    if (status == MUS_OK) status = mus__program_tack_room(drape->context, drape->cloth, k + 1, program);
    if (status != MUS_OK) return status;
    program->tack[k] = (mus__tack){a, b, stiffness};
    if (k == program->ntack) program->ntack++;
    tacks_changed(drape);
    if (index != NULL) *index = k;
    return MUS_OK;
}


mus_status mus_drape_untack(mus_drape *drape, int32_t index)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus__program *program = &drape->program;
    if (index < 0 || index >= program->ntack || program->tack[index].a == MUS_NONE)
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: there is no tack %d", (int)index);
    program->tack[index].a = program->tack[index].b = MUS_NONE;
    while (program->ntack > 0 && program->tack[program->ntack - 1].a == MUS_NONE) program->ntack--;
    tacks_changed(drape);
    return MUS_OK;
}


void mus__tack_restrict(mus_drape *drape)
{
    mus__program *coarse = &drape->coarse.drape->program;
    coarse->ntack = drape->program.ntack;
    for (int32_t t = 0; t < coarse->ntack; t++) {
        const mus__tack *tack = &drape->program.tack[t];
        mus__tack own = {MUS_NONE, MUS_NONE, tack->k};
        if (tack->a != MUS_NONE) {
            own.a = mus__transfer_nearest(&drape->coarse.up, tack->a);
            own.b = mus__transfer_nearest(&drape->coarse.up, tack->b);
        }
        coarse->tack[t] = own;
    }
}
