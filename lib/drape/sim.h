/*
 * sim.h: the state of a drape and its steps, the same in float and double.
 *
 * A sim works on planes: y = [x0 | x1 | x2 | v0 | v1 | v2], n each. A step is one to four phases. In each a thread
 * takes its share of the plan's chunks: forces of the chunk into a scratch, then at once what the step does with them.
 * What a phase reads of neighbours it never writes: it writes to another plane (a stage) and they change places.
 *
 * mus__sim_ops is the table of what a sim can do, chosen once at create; no loop reads an option.
 */
#ifndef MUS_DRAPE_SIM_H
#define MUS_DRAPE_SIM_H

#include "base/pool.h"
#include "contact/self_contact.h"
#include "contact/plane_cache.h"
#include "drape/plan.h"

typedef struct mus__sim mus__sim;

/* what a phase does with the forces of a chunk */
enum { PHASE_FORCE, PHASE_RK1, PHASE_RK2, PHASE_RK3, PHASE_RK4, PHASE_EULER, PHASE_KICK, PHASE_VERLET, PHASE_START };

typedef struct mus__sim_ops {
    size_t real; /* bytes of a number */
    /* f = forces at the positions of y (springs, bending, pairs; no gravity) */
    void (*force)(mus__sim *sim);
    /* one step of symplectic Euler with drag and speed limit, then contact and stitches */
    void (*euler)(mus__sim *sim, double h);
    /* one step of RK4, then contact */
    void (*rk4)(mus__sim *sim, double h);
    /* `steps` of velocity Verlet, contact after each move; one evaluation a step, one more if forces are not fresh */
    void (*verlet)(mus__sim *sim, double h, int32_t steps);
    /* copies between the planes and the (n x 3) arrays of doubles */
    void (*put)(mus__sim *sim, const double *x, const double *v);
    void (*get)(const mus__sim *sim, double *x, double *v);
    /* adds the places, from the sim's origin, to sum (n x 3) */
    void (*add)(const mus__sim *sim, double *sum);
    /* forces of the last `force`, (n x 3) */
    void (*get_force)(const mus__sim *sim, double *f);
    void (*set_node)(mus__sim *sim, int32_t node, double inverse_mass, double weight);
    /* places and velocities whose square is no normal number become 0: denormal numbers cost ten times as much */
    void (*flush)(mus__sim *sim);
    /* largest speed squared; NaN when any number is not finite */
    double (*speed2)(const mus__sim *sim);
    void (*snapshot)(mus__sim *sim);
    void (*restore)(mus__sim *sim);
    /* the pairs of cloth near cloth and their balls, where places were changed from outside */
    void (*look)(mus__sim *sim);
} mus__sim_ops;

struct mus__sim {
    const mus__sim_ops *ops;
    mus__plan *plan;
    mus__pool *pool;
    const mus__collider *collider; /* NULL: no contact pass */
    int32_t nodes;
    int32_t n; /* from plane to plane: the nodes, and zeros up to whole blocks of lanes */
    double origin[3]; /* of the state in the body frame: float keeps its digits near it; 0 in double */

    void *memory;   /* all of the following but aside, in one block */
    void *y;        /* (6 n) positions and velocities */
    void *next;     /* (6 n) stage; where steps of Euler and Verlet write: it and y change places */
    void *stage;    /* (3 n) second stage of RK4; (6 n) with dashpots, which read velocities of neighbours */
    void *f;        /* (3 n) forces; in a step of RK4 its first acceleration */
    void *second;   /* (3 n) second acceleration of RK4 */
    void *inverse;  /* (n) 1/inertia, 0 for held or welded nodes */
    void *weight;   /* (n) mass/inertia: what gravity acts with; 0 for held nodes */
    void *good;     /* (6 n) last good state */
    mus__distance_cache *aside; /* (n) what contact need not ask of a node for a while */
    mus__self_contact *self; /* NULL: cloth is not asked of cloth */
    void *near;     /* (8 n) planes of the skin, while sew or settle run; NULL: every node is asked every time */

    /* what the steps use; set between steps, never inside */
    double gravity[3];
    double drag;        /* [1/s] */
    double speed_limit; /* [m/s], of euler */
    int32_t dashpots;
    int32_t fresh;      /* nonzero: f holds the forces at y */
    double collision_distance;
    mus__contact_rule rule;
    mus__self_rule self_rule;
    double self_time;   /* [s] that self->force is the impulse of */
    int32_t swift;      /* nodes are so fast that contact sweeps them */
    mus__contact_tally part_tally[64];
    int64_t force_evaluations;

    /* arguments of the phase now running */
    int32_t phase;
    const void *phase_y; /* where forces are taken */
    void *phase_touch;   /* the state that meets the body after the phase; NULL: none does */
    const void *before;  /* (3 n) places before the step */
    double phase_h;
};

/* what a step asks for cloth on cloth: left out where it is measured what asking costs (tests/guard/self_off.sh) */
#ifdef MUS_WITHOUT_SELF
#define MUS_SELF_OF(sim) ((mus__self_contact *)NULL)
#else
#define MUS_SELF_OF(sim) ((sim)->self)
#endif

extern const mus__sim_ops mus__sim_f32;
extern const mus__sim_ops mus__sim_f64;

/* memory of the sim of `plan` (n, ops and plan set); nothing is kept on failure */
mus_status mus__sim_create(mus_context *context, mus__sim *sim);
void mus__sim_destroy(mus_context *context, mus__sim *sim);

#endif
