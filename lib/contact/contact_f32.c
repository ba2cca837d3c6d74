/* contact_f32.c: the contact pass in float. */
#include "base/clones.h"
#include "contact/contact.h"

#define MUS_REAL float
#define MUS_FIELD(name) mus__f32_##name
#define MUS_FIELDS field32
#define MUS_CONTACT mus__contact_f32
#define MUS_RUSH mus__contact_rush_f32
#include "contact/contact_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_FIELD
#undef MUS_FIELDS
#undef MUS_CONTACT
#undef MUS_RUSH
