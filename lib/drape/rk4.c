/* rk4.c: the integrator of rk4.h, one text for both precisions. */
#include "drape/rk4.h"

#define MUS_REAL float
#define MUS_RHS mus__rhs_f32
#define MUS_RK4 mus__rk4_f32
#include "drape/rk4_kernel.h"
#undef MUS_REAL
#undef MUS_RHS
#undef MUS_RK4

#define MUS_REAL double
#define MUS_RHS mus__rhs_f64
#define MUS_RK4 mus__rk4_f64
#include "drape/rk4_kernel.h"
