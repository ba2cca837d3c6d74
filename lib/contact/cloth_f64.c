/* cloth_f64.c: cloth against cloth in double. */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "contact/cloth_self.h"
#include "contact/contact.h"

#define MUS_REAL double
#define MUS_FIELD(name) mus__f64_##name
#define MUS_SELF mus__cloth_self_f64
#define MUS_SELF_LOOK mus__cloth_self_look_f64
#define MUS_SQRT sqrt
#include "contact/cloth_kernel.h"

/* for a build of all files in one */
#undef MUS_REAL
#undef MUS_FIELD
#undef MUS_SELF
#undef MUS_SELF_LOOK
#undef MUS_SQRT
