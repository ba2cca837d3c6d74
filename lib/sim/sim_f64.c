/*
 * sim_f64.c: the passes of a sim in double. The Makefile compiles this file with -fno-math-errno: a sqrt that sets
 * errno does not vectorise.
 */
#include <math.h>
#include <string.h>

#include "base/target_clones.h"
#include "sim/force_program_constants.h"
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


#define MUS__REAL double
#define MUS__TINY 1e-150 /* its square is a normal number just so */
#define MUS__NAME(name) sim_f64_##name
#define MUS__SQRT sqrt
#define MUS__OVER_ROOT(a, x) over_root(a, x)
#define MUS__SIM mus__sim_f64
#include "sim/sim_kernel.h"

/* for a build of all files in one */
#undef MUS__REAL
#undef MUS__TINY
#undef MUS__NAME
#undef MUS__SQRT
#undef MUS__OVER_ROOT
#undef MUS__SIM
