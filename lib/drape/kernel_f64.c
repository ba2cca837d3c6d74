/* kernel_f64.c: the passes of a drape in double. Flags of this file: see the Makefile (errno of sqrt stops
 * vectorising). */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "drape/sim.h"

#define MUS_REAL double
#define MUS_FN(name) sim_f64_##name
#define MUS_SQRT sqrt
#define MUS_CONTACT mus__contact_f64
#define MUS_NEAR mus__near_f64
#define MUS_SIM mus__sim_f64
#include "drape/sim_kernel.h"
