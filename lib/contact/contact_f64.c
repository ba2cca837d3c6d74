/* contact_f64.c: the contact pass in double. */
#include "base/clones.h"
#include "contact/contact.h"

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#define MUS_FIELDS field64
#define MUS_CONTACT mus__contact_f64
#define MUS_RUSH mus__contact_rush_f64
#include "contact/contact_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_FIELD
#undef MUS_FIELDS
#undef MUS_CONTACT
#undef MUS_RUSH
