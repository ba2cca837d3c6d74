/*
 * float_rounding.c: what the rounding of a float state does to the rest of a cloth, and the precision that a cloth asks
 * for.
 */
#include <math.h>
#include <string.h>

#include "cloth/fabric.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "sim/step_bound.h"

#define FLOAT_ROUNDING 3e-8 /* [m] half an ulp of a float between 0.25 and 0.5 m */
#define ROUNDING_LEFT 0.03  /* share of the force by rounding that the mean leaves; fitted on woven cloths at rest */


/*
 * Places in float are rounded by some FLOAT_ROUNDING, each by itself, so a node of stiffness T feels about T times that
 * force; the mean over the last steps takes most of it away, and leaves ROUNDING_LEFT (fitted: cotton 0.2 of a weight,
 * silk 0.1, wool 0.04, denim 0.03, with room).
 */
double mus__residual_rounding(const mus_drape *drape)
{
    const double *gravity = drape->def.gravity;
    const double g = sqrt(gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    double sum = 0.0;
    int64_t count = 0;
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        const double weight = drape->mass[i] * (g > 0.0 ? g : MUS__GRAVITY);
        const double felt = drape->stepping.stiffness[i] * FLOAT_ROUNDING / weight;
        sum += felt * felt;
        count++;
    }
    return count > 0 ? ROUNDING_LEFT * sqrt(sum / (double)count) : 0.0;
}


int32_t mus__float_too_coarse(mus_drape *drape)
{
    memcpy(drape->mass, drape->cloth->mass, (size_t)drape->n * sizeof *drape->mass);
    mus__program_stiffness_at(&drape->program, drape->n, drape->x, drape->stepping.stiffness, drape->stepping.tangent);
    return mus__residual_rounding(drape) > drape->def.settle_residual;
}
