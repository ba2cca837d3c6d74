/*
 * sim.h: the moving state of a cloth and its steps, the same in float and double.
 *
 * The state is planes: y = [x0 | x1 | x2 | v0 | v1 | v2], n numbers each. A step is one to four phases. In each phase a
 * thread takes its share of the program's chunks: it computes the forces of a chunk into its scratch and uses them at
 * once. A phase never writes what it reads of neighbours: it writes to another plane (a stage), and the two change
 * places.
 *
 * mus__sim_ops is the table of what a sim can do in one precision. It is chosen once, at create; no loop reads an
 * option. A sim knows no drape: its owner sets the fields below "what the steps use" between steps.
 */
#ifndef MUS_SIM_SIM_H
#define MUS_SIM_SIM_H

#include "base/thread_pool.h"
#include "contact/plane_cache.h"
#include "selfcontact/self_contact.h"
#include "sim/force_program.h"
#include "sim/sim_ops.h"

struct mus__sim {
    const mus__sim_ops *ops;
    mus__program *program;
    mus__pool *pool;
    const mus__collider *collider; /* NULL: there is no contact pass */
    int32_t nodes;
    int32_t n;        /* numbers of a plane: the nodes, and zeros up to whole packets */
    double origin[3]; /* of the state in the body frame, so that float keeps its digits near it; 0 in double */

    void *memory;    /* one block with all arrays down to last_good */
    void *y;         /* (6 n) places and velocities */
    void *next;      /* (6 n) stage; Euler and Verlet write here, and y and next change places */
    void *stage;     /* (3 n) second stage of RK4; (6 n) with dashpots, which read the velocities of neighbours */
    void *f;         /* (3 n) forces; during a step of RK4 its first acceleration, then the places before the step */
    void *slide_force; /* (3 n) forces of the sliders of bending; empty without any */
    void *second;    /* (3 n) second acceleration of RK4; between steps nobody's */
    void *inverse;   /* (n) 1/inertia, 0 for fixed or welded nodes */
    void *weight;    /* (n) mass/inertia, the factor on gravity; 0 for fixed nodes */
    void *last_good; /* (6 n) the last state that was found good */
    mus__distance_cache *distance_cache;  /* (n) contact need not query a node for a while */
    const float *lift; /* (n) how much farther than the clearance a node stays off a body [m]; NULL: no farther */
    mus__contact_fn contact_pass;         /* set with `collider` */
    mus__plane_cache_fn plane_cache_pass; /* set with `collider` */
    mus__self_fn self_pass, self_prepare; /* set with the self-contact of the owner */
    mus__self_contact *self;              /* NULL: no self-contact */
    void *tensor;      /* (7 n) inverse inertia tensors xx, yy, zz, xy, yz, zx, and masses, for steps of Euler; NULL:
                        * `inverse` is all there is to know */
    void *plane_cache; /* (8 n) contact planes of nodes, in use; NULL: every node is queried in every step */

    /* what the steps use; set between steps, never inside one */
    double gravity[3];  /* [m/s2] */
    double drag;        /* [1/s] */
    double speed_limit; /* [m/s], of euler */
    int32_t dashpots;
    int32_t slide_age;         /* steps since the sliders of bending moved */
    int32_t fresh;             /* nonzero: f holds the forces at y */
    double collision_distance; /* [m] pairs this close are stitched */
    mus__contact_rule rule;
    mus__self_rule self_rule;
    double self_time; /* [s] over which self->force was summed */
    int32_t sweeps;   /* nonzero: nodes are so fast that contact sweeps them */
    mus__contact_tally part_tally[64];
    int64_t force_evaluations;

    /* arguments of the phase that is running */
    int32_t phase;
    const void *phase_y;  /* where forces are taken */
    void *phase_touch;    /* the state that meets the colliders after the phase; NULL: none does */
    const void *x_before; /* (3 n) places before the step */
    double phase_h;       /* [s] */
};

/* self-contact of a sim: a build with MUS_WITHOUT_SELF has none, to measure what asking for it costs
 * (tests/guard/self_off.sh) */
#ifdef MUS_WITHOUT_SELF
#define MUS__SELF_OF(sim) ((mus__self_contact *)NULL)
#else
#define MUS__SELF_OF(sim) ((sim)->self)
#endif

/* memory of the sim of `program`; program, n, nodes and ops are set. Keeps nothing on failure. Errors: MUS_ERR_MEMORY
 */
mus_status mus__sim_create(mus_context *context, mus__sim *sim);
void mus__sim_destroy(mus_context *context, mus__sim *sim);

#endif
