/*
 * sim_ops.h: what a sim can do in one precision, and the passes of contact that its owner gives it, as tables of
 * functions: a program links the precision and the passes alone that it names.
 */
#ifndef MUS_SIM_SIM_OPS_H
#define MUS_SIM_SIM_OPS_H

#include "contact/contact.h"

typedef struct mus__sim mus__sim;

/* what a phase does with the forces of a chunk: keeps them; a stage of RK4; a step of Euler; of Verlet the last kick, a
 * whole step, the first kick and move */
enum { MUS__PHASE_FORCE, MUS__PHASE_RK1, MUS__PHASE_RK2, MUS__PHASE_RK3, MUS__PHASE_RK4, MUS__PHASE_EULER };
enum { MUS__PHASE_KICK = MUS__PHASE_EULER + 1, MUS__PHASE_VERLET, MUS__PHASE_START, MUS__PHASE_TENSOR };

typedef struct mus__sim_ops {
    size_t real; /* bytes of a number */
    /* f = forces at the places of y (springs, bending, pairs, attachments; no gravity) */
    void (*force)(mus__sim *sim);
    /* one step of symplectic Euler with drag and speed limit, then contact and stitching of pairs */
    void (*euler)(mus__sim *sim, double h);
    /* one step of RK4, then contact */
    void (*rk4)(mus__sim *sim, double h);
    /* `steps` of velocity Verlet with contact after each move: one evaluation a step, one more if f is not fresh */
    void (*verlet)(mus__sim *sim, double h, int32_t steps);
    /* copy between the planes and (n x 3) arrays of doubles */
    void (*put)(mus__sim *sim, const double *x, const double *v);
    void (*get)(const mus__sim *sim, double *x, double *v);
    /* add the places, relative to the sim's origin, to sum (n x 3) */
    void (*add)(const mus__sim *sim, double *sum);
    /* the forces of the last `force`, (n x 3) */
    void (*get_force)(const mus__sim *sim, double *f);
    void (*set_node)(mus__sim *sim, int32_t node, double inverse_mass, double weight);
    /* the same for a step of Euler with inertia tensors: xx, yy, zz, xy, yz, zx of the inverse (6), and the mass */
    void (*set_tensor)(mus__sim *sim, int32_t node, const double *inverse, double mass);
    /* distance [m] beyond the clearance that the node has from all surfaces at least, by the plane cache */
    double (*clear_of)(const mus__sim *sim, int32_t node);
    /* set numbers to 0 whose square is not a normal number: denormal numbers cost ten times as much */
    void (*flush)(mus__sim *sim);
    /* largest speed squared [m2/s2]; NaN when any number is not finite */
    double (*speed2)(const mus__sim *sim);
    void (*snapshot)(mus__sim *sim);
    void (*restore)(mus__sim *sim);
    /* find the pairs of cloth near cloth, and their displacement bounds, after places were changed from outside */
    void (*find_pairs)(mus__sim *sim);
} mus__sim_ops;

/* passes of contact in the sim's precision, set by its owner, so that a program without contact links none; those of
 * self-contact take arrays of the precision, and the kernel casts them */
typedef void (*mus__contact_fn)(const mus__collider *, const mus__contact_rule *, const mus__contact_nodes *,
                                int32_t sweeps, mus__distance_cache *, mus__contact_tally *);
typedef void (*mus__plane_cache_fn)(const mus__collider *, const mus__contact_rule *, const mus__contact_nodes *,
                                    void *planes, mus__contact_tally *);
typedef void (*mus__self_fn)(void);

extern const mus__sim_ops mus__sim_f32;
extern const mus__sim_ops mus__sim_f64;

#endif
