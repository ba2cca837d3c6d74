/*
 * evaluate.c: mus_drape_evaluate(): force evaluations by the kernels of a step, which benchmarks time.
 */
#include <string.h>

#include "drape/drape_state.h"


mus_status mus_drape_evaluate(mus_drape *drape, int32_t times)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (times < 0) return mus__fail(drape->context, MUS_ERR_ARG, "drape: times is %d, expected 0 or more", (int)times);

    /* the forces that Verlet keeps for its next step are saved in `second`, which no step uses between steps */
    mus__sim *sim = &drape->sim;
    const size_t bytes = 3 * (size_t)sim->n * sim->ops->real;
    const int32_t fresh = sim->fresh;
    memcpy(sim->second, sim->f, bytes);
    sim->dashpots = drape->program.dashpots;
    for (int32_t i = 0; i < times; i++) sim->ops->force(sim);
    memcpy(sim->f, sim->second, bytes);
    sim->fresh = fresh;
    return MUS_OK;
}
