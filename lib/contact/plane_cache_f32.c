/* plane_cache_f32.c: the contact pass by planes in float. */
#include "base/target_clones.h"
#include "contact/plane_cache.h"
#include "contact/contact_template.h"

#define MUS__REAL float
#define MUS__NAME(name) mus__##name##_f32
#define MUS__PART_FIELDS field32
#include "contact/plane_cache_kernel.h"

/* for a build of all files in one */
#undef MUS__REAL
#undef MUS__NAME
#undef MUS__PART_FIELDS
