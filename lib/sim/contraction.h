/*
 * contraction.h: lateral contraction: an element in each full cell of the lattice that couples its strain along warp
 * with that along weft.
 *
 *      b ---- b+1     r = root of the mean square of the edges along weft, a to a+1 and b to b+1, over their rest p;
 *      |       |      s = the same of the two along the warp, over q:
 *      |       |
 *      a ---- a+1     E = C p q psi(r) psi(s),   psi(r) = tanh(4 ln r) / 4 = 1/4 - 1 / (2 r^8 + 2)
 *
 * psi is the strain where it is small and stays below a quarter, so that force and stiffness are bounded in every pose.
 * It has no root. E depends on lengths alone: the forces of a cell have no sum and no moment. Edges are measured, not
 * the middle of the cell: a twisted cell whose edges keep their lengths has no strain (with the middle, discs of a soft
 * fabric hung 10 points higher at 5 mm).
 * C is what the fabric's C12 has beyond the diagonals of the cell (lib/cloth/fabric.c).
 *
 * Cells stand on lattice nodes alone, so welding leaves them as they are. Triangles of the strip between the lattice
 * and the border have no such element: they contract as their springs do.
 */
#ifndef MUS_SIM_CONTRACTION_H
#define MUS_SIM_CONTRACTION_H

#include "sim/force_program.h"

/* gives each chunk the cells at its nodes; none without a coupling. The packets of the program are made. Errors:
 * MUS_ERR_MEMORY */
mus_status mus__contraction_create(mus_context *context, const mus_cloth *cloth, mus__program *program);
/* adds the forces of the cells to f (n x 3, NULL: none) at x (n x 3); returns their energy */
double mus__contraction_force(const mus__program *program, const double *x, double *f);
/* adds to t (n) a bound of the cells' stiffness at each node that holds in every pose [N/m] */
void mus__contraction_stiffness(const mus__program *program, double *t);
/* the same at the pose x (n x 3), to the matrices xx, yy, zz, xy, yz, zx of each node: tangent (n x 6) */
void mus__contraction_stiffness_at(const mus__program *program, const double *x, double *tangent);

#endif
