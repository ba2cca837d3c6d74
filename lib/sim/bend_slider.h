/*
 * bend_slider.h: friction between threads in bending: a slider beside each bending element.
 *
 * The sliders are made with the elements of a force program. A sim moves them once a step (bend_slider_kernel.h) and
 * keeps their forces for the evaluations of the next; it starts them from the flat cloth when places are set.
 */
#ifndef MUS_SIM_BEND_SLIDER_H
#define MUS_SIM_BEND_SLIDER_H

#include "sim/force_program.h"

/* steps between two moves of the sliders. Chosen: cloth bends thousands of steps long, and the sliders, which write to
 * four nodes each, then cost less than the other forces */
#ifndef MUS__SLIDE_STEPS
#define MUS__SLIDE_STEPS 8
#endif

/* room for the sliders of a cloth; none without friction of bending. Errors: MUS_ERR_MEMORY, MUS_ERR_LIMIT */
mus_status mus__sliders_create(mus_context *context, const mus_cloth *cloth, mus__program *program);
/* the sliders of the stencils and hinges that the program has now, as on the flat cloth */
void mus__sliders_fill(const mus_cloth *cloth, mus__program *program);
/* adds what the sliders change in the forces f (n x 3, NULL: none) at x (n x 3); returns the change of the energy */
double mus__sliders_force(const mus__program *program, const double *x, double *f);

#endif
