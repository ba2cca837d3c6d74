/*
 * force_program_constants.h: constants of a force program in its own precision, read and written one at a time.
 */
#ifndef MUS_SIM_FORCE_PROGRAM_CONSTANTS_H
#define MUS_SIM_FORCE_PROGRAM_CONSTANTS_H

#include "sim/force_program.h"

/* write number i of an array in the program's precision */
static inline void mus__program_put(const mus__program *program, void *array, int64_t i, double value)
{
    if (program->real == sizeof(float))
        ((float *)array)[i] = (float)value;
    else
        ((double *)array)[i] = value;
}


/* number i of an array in the program's precision */
static inline double mus__program_get(const mus__program *program, const void *array, int64_t i)
{
    return program->real == sizeof(float) ? (double)((const float *)array)[i] : ((const double *)array)[i];
}


/* factor on krest in the kernels' tables: 3/8 in double, the factor of Halley's step for 1/sqrt (sim_f64.c) */
static inline double mus__program_rest_factor(const mus__program *program)
{
    return program->real == sizeof(float) ? 1.0 : 0.375;
}


/* numbers in one table */
static inline int32_t mus__program_table_size(const mus__program *program)
{
    return ((program->dashpots ? 3 : 2) * program->near + program->far) * MUS__LANES;
}

#endif
