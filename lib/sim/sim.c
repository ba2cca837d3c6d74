/*
 * sim.c: the memory of a sim: one block of numbers, cut into arrays, and the distance cache.
 *
 *   numbers = (29 + 3 with dashpots) n + padding
 *
 * n is the number of nodes rounded up to whole packets, so that all planes of an array have the same offset to cache
 * lines. Where they do not, three vectors of four straddle two lines, and a step takes a tenth longer.
 *
 * Lanes of a packet without a node read up to one packet before and behind an array. These numbers do not count, but
 * they must be there, be finite, and not be written meanwhile; so there are zeros between any two arrays.
 */
#include <string.h>

#include "sim/sim.h"

#define GAP MUS__LANES
#define LINE 64 /* bytes of a cache line; vectors that straddle two are slow */


mus_status mus__sim_create(mus_context *context, mus__sim *sim)
{
    const int64_t n = sim->n, stage = sim->program->dashpots ? 6 : 3;
    const int64_t slides = sim->program->slider_capacity > 0 ? 3 : 0;
    const struct {
        void **array;
        int64_t planes;
    } arrays[] = {{&sim->y, 6},      {&sim->next, 6},    {&sim->stage, stage}, {&sim->f, 3},
                  {&sim->second, 3}, {&sim->inverse, 1}, {&sim->weight, 1},    {&sim->last_good, 6},
                  {&sim->slide_force, slides}};
    const int32_t count = (int32_t)(sizeof arrays / sizeof arrays[0]);
    const int64_t line = LINE / (int64_t)sim->ops->real;
    int64_t total = GAP + line;
    for (int32_t i = 0; i < count; i++) total += arrays[i].planes * n + GAP + line;
    sim->memory = mus__new(context, total, sim->ops->real);
    sim->distance_cache = mus__new(context, n, sizeof *sim->distance_cache);
    if (sim->memory == NULL || sim->distance_cache == NULL) {
        mus__sim_destroy(context, sim);
        return mus__fail_memory(context, "the state of a drape");
    }

    char *at = (char *)sim->memory + GAP * sim->ops->real;
    for (int32_t i = 0; i < count; i++) {
        at += (LINE - (uintptr_t)at % LINE) % LINE;
        *arrays[i].array = at;
        at += (size_t)(arrays[i].planes * n + GAP) * sim->ops->real;
    }
    return MUS_OK;
}


void mus__sim_destroy(mus_context *context, mus__sim *sim)
{
    mus__free(context, sim->memory);
    mus__free(context, sim->distance_cache);
    sim->memory = NULL;
    sim->distance_cache = NULL;
}
