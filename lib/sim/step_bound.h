/*
 * step_bound.h: bounds of stiffness and damping at the nodes of a force program, and the largest stable step.
 */
#ifndef MUS_SIM_STEP_BOUND_H
#define MUS_SIM_STEP_BOUND_H

#include "sim/force_program.h"

/* diagonal bound of the stiffness in every pose: t (nnode) gets T_i = sum over items of k S |w| [N/m] */
void mus__program_stiffness(const mus__program *program, int32_t nnode, double *t);
/* the share of it that bends, hinges, pairs, tacks and attachments give */
void mus__program_stiffness_bending(const mus__program *program, int32_t nnode, double *t);
/* the same at the pose x (nnode x 3): t (nnode) gets a bound of the largest eigenvalue of the 3 x 3 matrix T_i [N/m].
 * A spring gives n n^T along itself, and (1 - rest/l) (1 - n n^T) across where it is stretched. tangent (nnode x 6) is
 * scratch */
void mus__program_stiffness_at(const mus__program *program, int32_t nnode, const double *x, double *t, double *tangent);
/* diagonal bound of the damping: t (nnode) gets the sum of 2 c [N s/m]. *ratio gets the largest dashpot over the
 * stiffness of its spring [s], infinite for a dashpot without a spring */
void mus__program_damping(const mus__program *program, int32_t nnode, double *t, double *ratio);

/* largest step [s] at which RK4 is stable: rate2 bounds omega^2 [1/s2], gamma the damping per mass with drag [1/s] */
double mus__step_bound_rk4(double rate2, double gamma, double ratio, double drag);
/* largest step [s] at which velocity Verlet is stable in motion; gamma without drag */
double mus__step_bound_verlet(double rate2, double gamma);

#endif
