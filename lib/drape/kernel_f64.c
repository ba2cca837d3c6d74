/* kernel_f64.c: the passes of a drape in double. Flags of this file: see the Makefile (errno of sqrt stops
 * vectorising). */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "drape/sim.h"

/*
 * a / sqrt(x) to the last bit or two: r = 1/sqrt(x) in float, then Halley's step with e = 1 - x r^2, which leaves e^3:
 *
 *     r' = r + r e (1/2 + 3/8 e)
 *
 * Roots and quotients of doubles would take most of the kernel's time. Basic operations alone: the same bits anywhere.
 */
static MUS_INLINE double over_root(double a, double x)
{
    const double r = (double)(1.0f / sqrtf((float)x)), e = 1.0 - x * (r * r);
    return a * (r + r * (e * (0.5 + 0.375 * e)));
}


#define MUS_REAL double
#define MUS_TINY 1e-150
#define MUS_FN(name) sim_f64_##name
#define MUS_SQRT sqrt
#define MUS_OVER_ROOT(a, x) over_root(a, x)
#define MUS_CONTACT mus__contact_f64
#define MUS_NEAR mus__near_f64
#define MUS_SIM mus__sim_f64
#include "drape/sim_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_TINY
#undef MUS_FN
#undef MUS_SQRT
#undef MUS_OVER_ROOT
#undef MUS_CONTACT
#undef MUS_NEAR
#undef MUS_SIM
