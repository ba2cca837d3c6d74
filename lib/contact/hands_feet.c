/*
 * hands_feet.c: the hands and feet of a collider: widened over their digits (digit_cover.c), or as they are put into
 * clothes.
 */
#include <math.h>

#include "contact/hands_feet.h"
#include "contact/offset_surface.h"


void mus__collider_spread(mus__collider *collider, bool spread)
{
    const mus__offset_surface *surface = collider->surface;
    for (int32_t l = 0; l < collider->nparts; l++) {
        double *box = collider->box + 6 * (ptrdiff_t)l;
        if (surface->part[l].foot) {
            /* nothing is in a box whose ends have changed places */
            for (int32_t d = 0; d < 3; d++) {
                const double low = fmin(box[d], box[3 + d]), high = fmax(box[d], box[3 + d]);
                box[d] = spread ? low : high, box[3 + d] = spread ? high : low;
            }
        }
        if (surface->part[l].foot || (!surface->part[l].digits && surface->part[l].stump == 0.0)) continue;
        collider->field64[l] = spread ? surface->field64[l] : surface->slim64[l];
        collider->field32[l] = spread ? surface->field32[l] : surface->slim32[l];
        collider->part[l].end[0] = surface->part[l].end[0];
        if (!spread && surface->part[l].stump > 0.0)
            collider->part[l].end[0] = collider->field64[l].s0 - surface->part[l].stump;
        mus__collider_place(collider, l);
    }
}


uint64_t mus__collider_feet(const mus__collider *collider)
{
    uint64_t feet = 0;
    for (int32_t l = 0; l < collider->nparts; l++) feet |= (uint64_t)collider->surface->part[l].foot << l;
    return feet;
}


uint64_t mus__collider_thin_parts(const mus__collider *collider)
{
    uint64_t thin = 0;
    for (int32_t l = 0; l < collider->nparts; l++)
        thin |= (uint64_t)(collider->surface->part[l].digits || collider->surface->part[l].foot) << l;
    return thin;
}


int32_t mus__collider_ends(const mus__collider *collider, int32_t most, double *end)
{
    int32_t count = 0;
    for (int32_t l = 0; l < collider->nparts; l++) {
        const mus__offset_part *part = &collider->surface->part[l];
        const mus__field_f64 *field = &collider->field64[l];
        for (int32_t k = 0; k < part->ends && count < most; k++, count++)
            for (int32_t i = 0; i < 6; i++) {
                const double *local = part->end_axis[k] + (i < 3 ? 0 : 3), s = field->s0 + local[0];
                const int32_t d = i % 3;
                end[6 * (ptrdiff_t)count + i] = collider->origin[d] + field->origin[d] + s * field->axis[d] +
                                                local[1] * field->side[d] + local[2] * field->front[d];
            }
    }
    return count;
}
