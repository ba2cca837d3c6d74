/*
 * contact_template.h: what the contact passes share, once for float (names mus__*_f32) and once for double
 * (mus__*_f64).
 *
 * A file *_kernel.h is a template on the floating type: MUS__REAL is the type, MUS__NAME(name) the name for that type.
 * It is included once for each.
 */
#ifndef MUS_CONTACT_CONTACT_TEMPLATE_H
#define MUS_CONTACT_CONTACT_TEMPLATE_H

#include <math.h>
#include <string.h>

#include "base/target_clones.h"
#include "contact/contact.h"

/* number of the lowest bit that is set, of a number that is not 0 */
static inline int32_t mus__lowest_bit(uint64_t bits)
{
#if defined(__GNUC__)
    return __builtin_ctzll(bits);
#else
    int32_t k = 0;
    for (; (bits & 1) == 0; bits >>= 1) k++;
    return k;
#endif
}

#define mus__sqrt_f32 sqrtf
#define mus__sqrt_f64 sqrt

#define MUS__REAL float
#define MUS__NAME(name) mus__##name##_f32
#include "limb/radius_field_kernel.h"
#include "contact/contact_manifold_kernel.h"
#include "contact/friction_kernel.h"
#include "contact/collider_surfaces_kernel.h"
#undef MUS__REAL
#undef MUS__NAME

#define MUS__REAL double
#define MUS__NAME(name) mus__##name##_f64
#include "limb/radius_field_kernel.h"
#include "contact/contact_manifold_kernel.h"
#include "contact/friction_kernel.h"
#include "contact/collider_surfaces_kernel.h"
#undef MUS__REAL
#undef MUS__NAME

#endif
