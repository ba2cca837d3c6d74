/*
 * sim_f32.c: the passes of a sim in float. The Makefile compiles this file with -fno-math-errno: a sqrt that sets errno
 * does not vectorise.
 */
#include <math.h>
#include <string.h>

#include "base/target_clones.h"
#include "sim/force_program_constants.h"
#include "sim/sim.h"

#define MUS__REAL float
#define MUS__TINY 1e-18f /* its square is a normal number just so */
#define MUS__NAME(name) sim_f32_##name
#define MUS__SQRT sqrtf
#define MUS__OVER_ROOT(a, x) ((a) / sqrtf((x) + 1e-20f)) /* at 0: finite */
#define MUS__SIM mus__sim_f32
#include "sim/sim_kernel.h"

/* for a build of all files in one */
#undef MUS__REAL
#undef MUS__TINY
#undef MUS__NAME
#undef MUS__SQRT
#undef MUS__OVER_ROOT
#undef MUS__SIM
