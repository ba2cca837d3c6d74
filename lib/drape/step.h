/*
 * step.h: stepping by hand: what it knows of the state, and the parts of mus_drape_step (step.c) that an estimate uses.
 */
#ifndef MUS_DRAPE_STEP_H
#define MUS_DRAPE_STEP_H

#include "muslin/drape.h"

/* what mus_drape_step knows of the state, as of its last look; bound 0: something changed since */
typedef struct mus__stepping {
    double bound;          /* [s] */
    double energy, active; /* [J] all of it at the start; the largest of kinetic and elastic since */
    double speed, way;  /* of the fastest node at the last check [m/s]; how far it may have gone since the look [m] */
    int32_t since_look; /* steps */
    int32_t parts;      /* in which a step was divided, at most, in the last call */
    double *stiffness;  /* (n) bound of the stiffness at each node [N/m] */
    double *tangent;    /* (n x 6) scratch of the stiffness at a pose */
    double *dashpot;    /* (n) bound of the damping at each node [N s/m] */
} mus__stepping;

/* bound of a step [s] of the def's integrator at the pose x, and the node that sets it (tightest may be NULL) */
double mus__drape_bound(const mus_drape *drape, int32_t *tightest);
/* force evaluations of a step of the def's integrator */
int32_t mus__drape_evaluations(const mus_drape *drape);
/* set up the passes of mus_drape_step, once before it */
void mus__drape_prepare(mus_drape *drape, double dt);
/* `steps` steps of dt, in equal parts where the bound asks for them; the clock is `ahead` steps behind */
void mus__drape_advance(mus_drape *drape, int32_t ahead, int32_t steps, double dt);

#endif
