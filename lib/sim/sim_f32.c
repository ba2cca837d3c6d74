/* kernel_f32.c: the passes of a drape in float. Flags of this file: see the Makefile (errno of sqrt stops
 * vectorising). */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "sim/program_number.h"
#include "sim/sim.h"

#define MUS_REAL float
#define MUS_TINY 1e-18f /* its square is a normal number just so */
#define MUS_FN(name) sim_f32_##name
#define MUS_SQRT sqrtf
#define MUS_OVER_ROOT(a, x) ((a) / sqrtf((x) + 1e-20f)) /* at 0: finite */
#define MUS_CONTACT mus__contact_pass_f32
#define MUS_NEAR mus__plane_cache_pass_f32
#define MUS_CLOTH mus__self_contact_pass_f32
#define MUS_CLOTH_LOOK mus__self_contact_prepare_f32
#define MUS_SIM mus__sim_f32
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
