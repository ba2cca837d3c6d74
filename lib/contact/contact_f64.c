/* contact_f64.c: the contact pass in double. */
#include "base/target_clones.h"
#include "contact/contact_template.h"

#define MUS__REAL double
#define MUS__NAME(name) mus__##name##_f64
#define MUS__PART_FIELDS field64
#include "contact/contact_kernel.h"

/* for a build of all files in one */
#undef MUS__REAL
#undef MUS__NAME
#undef MUS__PART_FIELDS
