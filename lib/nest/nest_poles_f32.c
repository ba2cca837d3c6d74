/*
 * nest_poles_f32.c: how much the inscribed circles of two shapes overlap, in float, several pairs at once.
 *
 * The depth d of two circles is the sum of their radii less the distance of their centres. Above epsilon it counts as
 * it is; below it decays as epsilon^2 / (2 epsilon - d), which joins with the same value and slope and stays above 0,
 * so that circles that are apart still pull a search away. Each pair counts with its lesser radius.
 * Source: Gardeyn, Vanden Berghe, Wauters, An open-source heuristic to reboot 2D nesting research, 2025, section 5.
 */
#include <math.h>

#include "base/target_clones.h"
#include "nest/nest_shape.h"


/* the inner loop over the circles of b is the vector: a sum for each of them, added up in the end */
MUS_CLONES static float poles_sum(const mus__nest_poles *a, const mus__nest_poles *b, float dx, float dy, float epsilon)
{
    float sum[MUS__NEST_POLES] = {0.0f};
    const float square = epsilon * epsilon, twice = 2.0f * epsilon;
    for (int32_t i = 0; i < a->n; i++) {
        const float ax = a->x[i] - dx, ay = a->y[i] - dy, ar = a->r[i];
        MUS_ROLLED
        for (int32_t j = 0; j < MUS__NEST_POLES; j++) {
            const float x = b->x[j] - ax, y = b->y[j] - ay, br = b->r[j];
            const float depth = ar + br - sqrtf(x * x + y * y);
            const float shallow = depth < epsilon ? depth : epsilon;
            const float far = square / (twice - shallow), deep = depth - shallow;
            sum[j] += (far + deep) * (ar < br ? ar : br);
        }
    }
    for (int32_t width = MUS__NEST_POLES / 2; width > 0; width /= 2)
        for (int32_t k = 0; k < width; k++) sum[k] += sum[k + width];
    return sum[0];
}


/* a clone shows its name outside the library: so it is not the clone that others call */
float mus__nest_poles_f32(const mus__nest_poles *a, const mus__nest_poles *b, float dx, float dy, float epsilon)
{
    return poles_sum(a, b, dx, dy, epsilon);
}
