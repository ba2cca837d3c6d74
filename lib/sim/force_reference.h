/*
 * force_reference.h: forces, energy and strain of a force program in double, written plainly.
 *
 * Residuals and reports are taken of them, and the kernels are tested against them.
 */
#ifndef MUS_SIM_FORCE_REFERENCE_H
#define MUS_SIM_FORCE_REFERENCE_H

#include "sim/force_program.h"

/* forces f (n x 3) [N] of springs, bending, hinges and attachments at places x (n x 3), without pairs, gravity and
 * damping; f NULL: the energy alone. Returns the elastic energy [J] */
double mus__program_force(const mus__program *program, int32_t n, const double *x, double *f);
/* largest engineering strain of the stretch springs at x */
double mus__program_strain(const mus__program *program, const double *x);

#endif
