/*
 * dynamic_relaxation.h: relaxation: steps of symplectic Euler with scaled inertia, and what is known of the rest of a
 * drape.
 *
 * Files: dynamic_relaxation.c (memory and the loop that sew, settle and untangle share), residual.c (the force left at
 * each node), settle.c (to rest), untangle.c (crossings drawn apart), slid_off.c (whether a component has left its
 * place).
 */
#ifndef MUS_DRESS_DYNAMIC_RELAXATION_H
#define MUS_DRESS_DYNAMIC_RELAXATION_H

#include "drape/residual.h"
#include "dress/progress.h"

/* how the steps of a batch act */
typedef struct mus__relax_rule {
    double gravity[3];  /* [m/s2] */
    double drag;        /* [1/s] */
    double speed_limit; /* of a node [m/s] */
    double grip;        /* factor on the friction of surfaces, 0..1 */
    double
        push_speed; /* speed at which a node leaves a surface that it is inside of, at most [m/s]; 0: twice the limit */
    double deep_rate; /* that speed over the depth, for deep nodes [1/s]; 0: no more than push_speed */
    bool tensors;     /* inertia tensors where no surface and no cloth is near (drape/inertia.c); relax_create first */
} mus__relax_rule;

/* step [s] at the pose x: `safety` of the bound of symplectic Euler, with scaled inertia, which is set; not less than
 * `least` [s], for which all inertia is raised as far as needed (0: no more than the lattice asks for) */
double mus__relax_step(mus_drape *drape, double safety, double least);
/* before a batch of steps of h [s]: set the rule, and find the pairs of self-contact. Errors: MUS_ERR_MEMORY */
mus_status mus__relax_ready(mus_drape *drape, const mus__relax_rule *rule, double h);
/* `*steps` steps of h [s]; relax.mean gets the mean place of the last `averaged` of them (0: nothing is averaged). The
 * caller notes them on the clock. With a run (NULL: none) its function is asked on the way; where it stops the run,
 * *steps is the number that was taken, and nothing is averaged. Errors: MUS_ERR_DIVERGED (the last good state is
 * restored), MUS_ERR_LIMIT */
mus_status mus__relax_run(mus_drape *drape, mus__progress *run, double h, int32_t *steps, int32_t averaged);

/* memory of mean, before, went, left, moving, inertia and tensor, kept until the drape is destroyed; give it back */
mus_status mus__relax_create(mus_drape *drape);
void mus__relax_clear(mus_drape *drape);

/* let the sewn layers fall on this cut until they nearly rest (settle.c) */
mus_status mus__settle_let_down(mus_drape *drape, mus__progress *run);
/* let the garment fall, coarser cuts first, until it nearly rests; a garment that does not within some seconds is no
 * error (settle.c) */
mus_status mus__settle_roughly(mus_drape *drape, mus__progress *run);

/* with self-contact: draw crossings apart as far as they go (untangle.c). Errors: as mus_drape_untangle, but crossings
 * that are left are none */
mus_status mus__untangle(mus_drape *drape);
/* put pairs of cloth apart that are closer than a twentieth of the thickness, where nothing crosses by it */
mus_status mus__untangle_part(mus_drape *drape);

/* let hands and feet into the sewn clothes: nodes that lie in a foot are lifted over it, and cloth that a finger goes
 * through is drawn off over its tip (draw_off.c). relax.mean is scratch. Returns how many were moved */
int32_t mus__draw_off(mus_drape *drape);

/* note where the components hang at x (n x 3): before a settle. Errors: MUS_ERR_MEMORY */
mus_status mus__slid_off_start(mus_drape *drape, const double *x);
/* nonzero, with the reason written, when a component at x has left its place; `loose`: and when no node is near the
 * body */
int32_t mus__slid_off(mus_drape *drape, const double *x, int32_t loose);

#endif
