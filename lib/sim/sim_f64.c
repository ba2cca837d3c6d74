/* kernel_f64.c: the passes of a drape in double. Flags of this file: see the Makefile (errno of sqrt stops
 * vectorising). */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "sim/program_number.h"
#include "sim/sim.h"

/*
 * a / sqrt(x) to the last bits: r = 1/sqrt(x) in float, then Halley's step, which leaves the cube of r's error:
 *
 *     r' = 3/8 r (5 - y (10/3 - y)),  y = x r^2
 *
 * The tables have 3/8 a (mus__program_rest_factor). Roots and quotients of doubles would take most of the kernel's
 * time, and each operation saved here is 2 % of it. Basic operations alone: the same bits anywhere. Where x is 0 all is
 * finite.
 */
static MUS_INLINE double over_root(double share, double x)
{
    const double r = (double)(1.0f / sqrtf((float)x + 1e-20f)), y = x * (r * r);
    return share * r * (5.0 - y * (10.0 / 3.0 - y));
}


#define MUS_REAL double
#define MUS_TINY 1e-150
#define MUS_FN(name) sim_f64_##name
#define MUS_SQRT sqrt
#define MUS_OVER_ROOT(a, x) over_root(a, x)
#define MUS_CONTACT mus__contact_pass_f64
#define MUS_NEAR mus__plane_cache_pass_f64
#define MUS_CLOTH mus__self_contact_pass_f64
#define MUS_CLOTH_LOOK mus__self_contact_prepare_f64
#define MUS_SIM mus__sim_f64
#include "sim/sim_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_TINY
#undef MUS_FN
#undef MUS_SQRT
#undef MUS_OVER_ROOT
#undef MUS_CONTACT
#undef MUS_NEAR
#undef MUS_CLOTH
#undef MUS_CLOTH_LOOK
#undef MUS_SIM
