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

#endif
