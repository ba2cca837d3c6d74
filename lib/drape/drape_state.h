/*
 * drape_state.h: the data of a drape, and the calls that keep it consistent (drape_state.c).
 *
 * The cloth is shared, never copied: it does not change. The sim holds the moving state in float or double; x and v are
 * the caller's view of it in double, written by mus__drape_publish. Each part of the struct has a header of its own.
 */
#ifndef MUS_DRAPE_DRAPE_STATE_H
#define MUS_DRAPE_DRAPE_STATE_H

#include "arrange/placed_cloth.h"
#include "drape/coarse_drape.h"
#include "drape/drape_parts.h"
#include "drape/scene.h"
#include "drape/step.h"
#include "muslin/drape.h"
#include "sim/force_program.h"
#include "sim/sim.h"

/* [bytes] of mus_drape_def when ABI 1 was recorded first, the smallest that is taken */
#define MUS__DRAPE_DEF_FIRST offsetof(mus_drape_def, progress_seconds)

/* bits of mus_drape.pinned: fixed by the caller; fixed until its layer is sewn (layers.c) */
#define MUS__PINNED 1
#define MUS__WAITS 2

/* time = time0 + count * dt, a product, so that a long run keeps its clock */
typedef struct mus__clock {
    double time0, dt; /* [s] */
    int64_t count;
} mus__clock;

/* counted since create; take differences */
typedef struct mus__counters {
    int64_t steps, spring_evaluations;
    int64_t contact_queries;      /* those of the coarse drapes; the drape's own are in sim.part_tally */
    double sew_time, settle_time; /* of cloth [s] */
} mus__counters;

struct mus_drape {
    mus_context *context;
    mus_drape_def def;
    mus_cloth *cloth;
    mus__pool *pool; /* of a coarse drape: its parent's, as is scene.collider */
    int32_t n;

    double *x, *v;   /* (n x 3) places [m] and velocities [m/s], the caller's view */
    double *mass;    /* (n) after welding; 0 for nodes that have another representative */
    int32_t *rep;    /* (n) representative of each node; itself when not welded */
    int32_t *pinned; /* (n) nonzero: fixed; bits MUS__PINNED, MUS__WAITS */
    int32_t welded;

    mus__program program;
    mus__sim sim;
    mus__self_contact *self;              /* self-contact; NULL unless the def asks for it */
    const struct mus__self_ops *self_ops; /* its calls (drape_self.h), set with it */
    const struct mus__drape_kit *kit;     /* what the drape was made with; its coarse drape is made with the same */
    void *plane_cache; /* (8 n) contact planes of nodes in the sim's precision; NULL before the first use */

    mus__chord_lift_data chord_lift;

    mus__scene scene;
    mus__clock clock;
    mus__counters counters;
    mus__stepping stepping;
    mus__coarse coarse;
    mus__sewing sewing;
    mus__relaxation relax;

    mus_reason reason, start; /* of the last run; of the start before it (kind MUS_REASON_NONE: nothing was wrong) */
    char skipped[96];
};

/* the parts that a drape is made with, by pointers: a program links those alone that its kit names (drape.c) */
struct mus__drape_kit {
    const mus__sim_ops *single, *doubles;                           /* the sim in float, and in double; NULL: refused */
    mus_status (*add_body)(mus_drape *drape, const mus_body *body); /* NULL: refused */
    mus_status (*add_self)(mus_drape *drape);                       /* self-contact; NULL: refused */
};

/* make a drape round a body, or the coarse drape of `parent` (drape.c) */
mus_status mus__drape_make(mus_context *context, const mus_cloth *cloth, const mus_body *body, mus_drape *parent,
                           const mus_drape_def *def, const struct mus__drape_kit *kit, mus_drape **out);

/* the cloth with the drape's places, as the rooms below see it; borrowed */
mus__placed_cloth mus__drape_placed(const mus_drape *drape);

/* sim to x and v; a welded node gets the place of its representative */
void mus__drape_publish(mus_drape *drape);
/* the same into x, v (n x 3) of the caller */
void mus__drape_read(const mus_drape *drape, double *x, double *v);
/* x and v to the sim */
void mus__drape_push(mus_drape *drape);
/* the next step takes masses, bound and energy anew */
void mus__drape_stale(mus_drape *drape);
/* MUS_ERR_ARG when a place of x (n x 3) is too far from the origin of a float state */
mus_status mus__drape_check_reach(const mus_drape *drape, const double *x);
/* write the list of passes that this scene has no work for */
void mus__drape_name_skipped(mus_drape *drape);
/* empty the plane cache, taking its memory at the first call, and let the sim use it. Errors: MUS_ERR_MEMORY */
mus_status mus__drape_plane_cache(mus_drape *drape);
/* the largest rate of motion, squared [1/s2], that inertia is to be set for. scaled 0: with true masses, in every pose.
 * scaled nonzero: at the pose x, of the lattice alone: where the stiffness asks for more, inertia is raised (mass
 * scaling; a rest shape does not depend on inertia) */
double mus__drape_rate(mus_drape *drape, int32_t scaled);
/* set the inertia of all nodes for that rate, or a lower one: a node's mass, or more where its stiffness asks for it */
void mus__drape_inertia(mus_drape *drape, double rate2);
/* takes the inertia tensors of the nodes at the state of the sim, for the step of the last mus__drape_inertia()
 * (inertia.c) */
void mus__drape_tensors(mus_drape *drape);
/* MUS_ERR_DIVERGED, with the last good state restored, when a number is not finite or a node is faster than 10 km/s */
mus_status mus__drape_check_motion(mus_drape *drape);
/* the same; else the state becomes the last good one */
mus_status mus__drape_keep_good(mus_drape *drape);

/* note `steps` of `h` on the clock and in the counters */
void mus__drape_tick(mus_drape *drape, int64_t steps, double h, int32_t evaluations);
/* seconds from `then` to `steps` steps of `h` from now */
double mus__clock_since(const mus_drape *drape, double then, int64_t steps, double h);

#endif
