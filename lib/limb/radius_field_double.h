/*
 * radius_field_double.h: the query of a radius field in double, inline, for loops that ask one field many times.
 */
#ifndef MUS_LIMB_RADIUS_FIELD_DOUBLE_H
#define MUS_LIMB_RADIUS_FIELD_DOUBLE_H

#include <math.h>

#include "limb/radius_field.h"

#define MUS__REAL double
#define MUS__NAME(name) mus__body_##name
#define mus__body_sqrt sqrt
#include "limb/radius_field_kernel.h"
#undef MUS__REAL
#undef MUS__NAME

/* the numbers that the query of a field reads; it borrows the tables of the field */
void mus__field_prepare(const mus__field *field, mus__body_field *out);

/* mus__field_depth() of a prepared field */
static inline double mus__field_depth_of(const mus__body_field *field, const double *p, double *normal)
{
    int32_t near;
    const double depth = mus__body_field_query(field, p, MUS__FIELD_MARGIN, normal, &near);
    if (near > 0) return depth;
    normal[0] = normal[1] = normal[2] = 0.0;
    return -1e30;
}

#endif
