/* self_contact_f32.c: cloth against cloth in float. */
#include <math.h>
#include <string.h>

#include "base/target_clones.h"
#include "selfcontact/self_contact.h"
#include "contact/contact_template.h"

#define MUS__REAL float
#define MUS__NAME(name) mus__##name##_f32
#include "selfcontact/self_response_kernel.h"

/* for a build of all files in one */
#undef MUS__REAL
#undef MUS__NAME
