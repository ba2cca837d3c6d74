/*
 * bend_clamp.h: bending elements at a clamp: what fixed nodes side by side ask of the element over their border.
 *
 *     fixed  fixed | free          A stencil or hinge whose middle and one side are fixed spans half a cell of cloth
 *       a ---- b ----- c           that is held and half a cell that bends. All of the bend is in that half, so its
 *                                  stiffness is twice as large: the tip of a clamped strip is then off by O(a^2), not
 *                                  by O(a).
 *
 * A clamp adds the element once more, to its only free node. The step bound has room for it: the row sum of that node
 * counts the element 4 times, and the element clamped has 2.
 */
#ifndef MUS_SIM_BEND_CLAMP_H
#define MUS_SIM_BEND_CLAMP_H

#include "sim/force_program.h"

/* room for the clamps of nodes fixed (n) with the bit `bit` set, or (fixed NULL) of any, also after welding. Errors:
 * MUS_ERR_MEMORY; the clamps are as they were */
mus_status mus__clamps_room(mus_context *context, const mus_cloth *cloth, const int32_t *fixed, int32_t bit,
                            mus__program *program);
/* makes the clamps anew; nothing without room. Bare nodes have none: their bends are the caller's */
void mus__clamps_update(const mus_cloth *cloth, const int32_t *fixed, int32_t bit, mus__program *program);
/* adds the forces of the clamps to f (n x 3, NULL: none) at x (n x 3); returns their energy */
double mus__clamps_force(const mus__program *program, const double *x, double *f);

#endif
