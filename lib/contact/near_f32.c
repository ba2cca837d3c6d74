/* near_f32.c: the contact pass by planes in float. */
#include "base/clones.h"
#include "contact/near.h"

#define MUS_REAL float
#define MUS_FIELD(name) mus__f32_##name
#define MUS_FIELDS field32
#define MUS_NEAR mus__near_f32
#define MUS_RUSH mus__contact_rush_f32
#define MUS_SQRT sqrtf
#include "contact/near_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_FIELD
#undef MUS_FIELDS
#undef MUS_NEAR
#undef MUS_RUSH
#undef MUS_SQRT
