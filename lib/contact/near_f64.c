/* near_f64.c: the contact pass by planes in double. */
#include "base/clones.h"
#include "contact/near.h"

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#define MUS_FIELDS field64
#define MUS_NEAR mus__near_f64
#define MUS_RUSH mus__contact_rush_f64
#define MUS_SQRT sqrt
#include "contact/near_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_FIELD
#undef MUS_FIELDS
#undef MUS_NEAR
#undef MUS_RUSH
#undef MUS_SQRT
