/*
 * drape_internal.h: the data of a drape.
 *
 * The cloth is shared, not copied (it never changes). The sim holds the moving state in float or double, relative to
 * an origin so that float keeps its digits; x and v are the caller's view in double, written by mus__drape_publish().
 */
#ifndef MUS_DRAPE_INTERNAL_H
#define MUS_DRAPE_INTERNAL_H

#include "body/body_level.h"
#include "drape/plan.h"
#include "drape/sim.h"
#include "drape/transfer.h"
#include "muslin/drape.h"
#include "pose/pose_frame.h"

/* bits of mus_drape.pinned: held by the caller, or by layers.c until its layer is sewn */
#define MUS__PINNED 1
#define MUS__WAITS 2

/* [m] a layer of panels starts so much farther out than the one below it */
#define MUS__LAYER_OUT 0.02

/* a plane: where it was at `time`, and how it moves since */
typedef struct mus__drape_plane {
    mus_plane added; /* as the caller gave it, its normal a unit */
    double from[3], velocity[3], spin, time;
} mus__drape_plane;

/* how the body stands, and where it is on the way from one pose to another */
typedef struct mus__drape_stance {
    mus__rig rig;
    mus_pose made, from, to;
    mus__joint_local as_made[MUS_JOINT_COUNT], start[MUS_JOINT_COUNT], end[MUS_JOINT_COUNT];
    mus__frame frame[MUS__PARTS_MOST]; /* where the parts were last put */
    double time, duration;            /* the movement began, and takes so long [s] */
    int32_t posed, carried;           /* nonzero: not as limbs are made; the body came posed */
    mus__body_level level[MUS_HOLD_COUNT][2]; /* as made, left and right */
    double neck, shoulder; /* half breadths where the shoulder line begins at the neck and where it ends; 0: unknown */
} mus__drape_stance;

/* a panel's piece of the garment: what hangs together by seams */
typedef struct mus__slide {
    int32_t piece; /* its lowest panel */
    int32_t panel; /* of a piece: where its uppermost node was */
    double top;    /* and how high that was, along the torso [m] */
    double foot;   /* how high its lowest node was where the pattern puts it */
} mus__slide;

struct mus_drape {
    mus_context *context;
    mus_drape_def def;
    mus_cloth *cloth;
    mus__collider *collider; /* NULL without a body and planes */
    mus__self_contact *self;   /* NULL unless the def asks for it */
    mus__pool *pool;
    mus_drape *parent;       /* of a coarser double, which borrows its collider and pool; NULL */
    mus_drape *coarse;       /* the coarser double, NULL until sew or settle want it (level.c) */
    mus__transfer up, down;  /* from the double and to it */
    mus__plan plan;
    mus__sim sim;
    double friction;
    int32_t n;
    int32_t welded, settled;
    int32_t sewn_so;         /* nonzero: with self_contact: the coarser double lies as the last sew left it */
    int32_t cold;            /* nonzero: not near rest, so a settle starts on the coarse cut */

    double *x, *v;      /* (n x 3) what the caller sees */
    double *force;      /* (n x 3) scratch of reports */
    /* of settle, one block, NULL before the first */
    double *mean;       /* (n x 3) mean place over the last steps before a check */
    double *before;     /* (n x 3) mean place at the check before */
    void *skin;         /* (n x 8) what nodes know of the skin near them */
    double *left;       /* (n x 3) force left over at the check before */
    double *anchor;     /* (n x 3) mean place where it began to lie still */

    double *work;       /* (n x 6) scratch of the stiffness at a pose */
    double *mass;       /* (n) after welding; 0 for nodes that another stands for */
    double *stiffness;  /* (n) bound of the stiffness at each node [N/m] */
    int32_t *rep;       /* (n) node that stands for each; itself when not welded */
    int32_t *pinned;    /* (n) nonzero: held; bits MUS__PINNED, MUS__WAITS */

    /* of mus_drape_step: as last looked at, bound 0 when something changed since */
    double bound, energy, active; /* [s]; [J] all, kinetic and elastic */
    double speed, way;            /* of the fastest node when last checked; how far it may have gone since the look */
    int32_t since_look, parts;    /* steps; parts that a step was divided in at most */

    /* time = time0 + count * dt, so that a long run keeps its clock */
    double time0, dt;
    int64_t count;
    int64_t steps;
    int64_t spring_evaluations, contact_queries; /* contact_queries: those of the coarser doubles */
    double sew_time, settle_time, residual;
    double distance;    /* expected from rest at the last check [m] */

    /* the body: where it was at glide_time, and its velocity since */
    double glide_from[3], glide[3], glide_time;
    mus__drape_stance *stance; /* NULL without a body */
    mus__drape_plane *plane; /* (MUS__PLANES_MAX) as many as the collider has, NULL without */
    int32_t moving;          /* nonzero: the collider was last told of a motion */
    int32_t moved;           /* nonzero: a surface did since nodes were asked what they remember */
    char skipped[96];

    mus_reason reason, start; /* of the last run; what was odd before it (kind MUS_REASON_NONE: nothing) */
    mus__slide *slide;        /* (npanel) of settle, NULL before the first */
};

/* ---- state (drape.c) ---- */

/* a drape round a body, or the coarser double of `parent` */
mus_status mus__drape_make(mus_context *context, const mus_cloth *cloth, const mus_body *body, mus_drape *parent,
                           const mus_drape_def *def, mus_drape **out);
/* positions and velocities of the sim to x and v; welded nodes get the place of the node that stands for them */
void mus__drape_publish(mus_drape *drape);
/* x and v to the sim */
void mus__drape_push(mus_drape *drape);
/* masses, stiffness and inertia anew. scaled 0: true masses, a bound for every pose. scaled nonzero: the bound at the
 * pose that x holds, and inertia raised where the stiffness would ask for a smaller step than the lattice needs (rest
 * shapes do not depend on inertia). Returns the step bound of RK4 [s]. */
double mus__drape_inertia(mus_drape *drape, int32_t scaled);
/* bound of a step of the def's integrator at the pose of x, and the node that sets it; writes the scratch arrays */
double mus__drape_bound(const mus_drape *drape, int32_t *tightest);
/* force evaluations of a step of the def's integrator */
int32_t mus__drape_evaluations(const mus_drape *drape);
/* what the passes of mus_drape_step use, once before it; then `steps` of dt, in parts where the bound asks for them,
 * the clock being `ahead` steps behind */
void mus__drape_prepare(mus_drape *drape, double dt);
void mus__drape_advance(mus_drape *drape, int32_t ahead, int32_t steps, double dt);
/* the next step takes masses, bound and energy anew */
void mus__drape_stale(mus_drape *drape);
/* note `steps` of `h` on the clock and in the counters */
void mus__drape_tick(mus_drape *drape, int64_t steps, double h, int32_t evaluations);

/* places of a cloth's nodes before sewing: x (nnode x 3) (place.c) */
void mus__cloth_place(const mus_cloth *cloth, double *x);
/* those of a panel, `out` farther off on its right side, below 0: on its wrong side; the others stay */
void mus__cloth_place_out(const mus_cloth *cloth, int32_t panel, double out, double *x);

/* ---- surfaces that move, nodes that are fast (glide.c, plane.c, stance.c) ---- */

/* whether the body or a plane moves in a step of `h`, `steps` steps from now; a plane; whether the pose changes */
int32_t mus__drape_moves(const mus_drape *drape, int64_t steps, double h);
int32_t mus__drape_plane_moves(const mus_drape *drape);
int32_t mus__drape_poses(const mus_drape *drape, int64_t steps, double h);
/* frames of the body's parts `steps` steps of `h` from now, NULL: as made */
const mus__frame *mus__drape_frames(mus_drape *drape, int64_t steps, double h);
/* how the body stands: as it came; the same again */
mus_status mus__drape_stance_create(mus_drape *drape, const mus_body *body);
void mus__drape_stance_back(mus_drape *drape);
/* body and planes to where they are `steps` steps of `h` from now; they came there in a step of `came`, 0: at rest */
void mus__drape_stand(mus_drape *drape, int64_t steps, double h, double came);
void mus__drape_stand_planes(mus_drape *drape, int64_t steps, double h, double came);
/* seconds from `then` to `steps` steps of `h` from now */
double mus__drape_since(const mus_drape *drape, double then, int64_t steps, double h);
/* before the first of some steps (the rule of contact set), and before each: where surfaces will be at its end, `steps`
 * from the clock's time; whether contact will sweep */
void mus__drape_meet_first(mus_drape *drape);
void mus__drape_meet(mus_drape *drape, int64_t steps, double h);
/* the body to where it was made, at rest; planes as they were added */
void mus__drape_stand_back(mus_drape *drape);
/* MUS_ERR_STATE when a surface moves: `what` needs it at rest */
mus_status mus__drape_still(const mus_drape *drape, const char *what);
/* names of the passes that this scene has no work for, anew */
void mus__drape_name_skipped(mus_drape *drape);

/* ---- cloth against cloth (self.c) ---- */

/* what it needs, if the def asks for it */
mus_status mus__drape_self_create(mus_drape *drape);
/* its triangles are those of the open or welded cloth */
void mus__drape_self_weld(mus_drape *drape);
/* before steps of `h`, places, masses and contact's rule set: from now on it acts in each. */
mus_status mus__drape_self_ready(mus_drape *drape, double h);
/* panels that fan out wide start folded (flare.c). Whether there was one */
bool mus__drape_flare(mus_drape *drape);
/* panels that begin over each other in one plane are moved apart (apart.c) */
mus_status mus__drape_apart(mus_drape *drape);
/* crossings of a cloth with self_contact drawn apart as far as they go (untangle.c) */
mus_status mus__drape_untangle(mus_drape *drape);
/* pairs of cloth that lie closer than a twentieth of the thickness are put so far apart, where nothing crosses then */
mus_status mus__drape_part(mus_drape *drape);
/* how many nodes cannot move: cloth is nearer to them than numbers tell apart */
int32_t mus__drape_self_frozen(const mus_drape *drape);
/* the rule of steps of `h`, the rule of contact set */
void mus__drape_self_rule(mus_drape *drape, double h);
/* MUS_ERR_LIMIT when a step found more pairs than there is room for */
mus_status mus__drape_self_fits(const mus_drape *drape);
/* mean force that it gave node i since it was forgotten (3) [N], added to `force`; nonzero when there was any */
int32_t mus__drape_self_force(const mus_drape *drape, int32_t i, double *force);
void mus__drape_self_forget(mus_drape *drape);
/* at a check of settling, mean places known: pairs of nodes that linger deep in the body and touch cloth are thinner
 * from now on; nonzero when any is */
int32_t mus__drape_self_give_way(mus_drape *drape);
void mus__drape_self_report(const mus_drape *drape, mus_drape_report *report);

/* ---- levels of the body that edges are held at (hold.c) ---- */

/* where they lie as the body was made */
void mus__drape_levels(mus_drape *drape, const mus_body *body);
/* where they lie now: to the plan; nothing without held nodes */
void mus__drape_hold(mus_drape *drape);
/* half the breadth over the ends of the shoulder lines, and at the neck where they begin; 0 when the body has none */
double mus__drape_shoulder(const mus_drape *drape, double *neck);
/* lift.c: which pairs close over the shoulders, and are straps'; then the ways of open pairs round the body, `hang`:
 * straps pull in full, all else with less; `check` counts the calls. Before welding: whether what lift_start found to
 * be straps is up, and the seam of one that is not (may be NULL) */
void mus__drape_lift_start(mus_drape *drape);
void mus__drape_lift(mus_drape *drape, bool hang, int32_t check);
typedef enum mus__straps { MUS__STRAPS_NONE, MUS__STRAPS_ON, MUS__STRAPS_OFF } mus__straps;
mus__straps mus__drape_strapped(const mus_drape *drape, int32_t *off);
/* where one lies now; there 0 without a body that has it */
void mus__drape_level(const mus_drape *drape, int32_t level, int32_t right, mus__held_level *out);

/* ---- what slides off the body (slide.c) ---- */

/* where the pieces of the garment hang, at x (n x 3): before a settle */
mus_status mus__drape_slide_start(mus_drape *drape, const double *x);
/* nonzero, and the reason written, when one of them has slid off at x; `falling` after which loose cloth counts */
int32_t mus__drape_slid(mus_drape *drape, const double *x, int32_t loose);

/* ---- reasons (reason.c) ---- */

/* note how a run ended; panel, seam and node may be MUS_NONE. The sentence is that of the context's error, or `text` */
void mus__drape_reason_set(mus_drape *drape, int32_t kind, int32_t panel, int32_t seam, int32_t node, double value,
                           const char *text);
/* after sew or settle: what its status says. Returns that, or MUS_ERR_MEMORY where crossings could not be counted */
mus_status mus__drape_reason_status(mus_drape *drape, mus_status status);
/* a kind with its sentence, without a place; and to a caller's struct of this size */
void mus__reason_write(mus_reason *out, int32_t kind, const char *text);
mus_status mus__reason_give(mus_context *context, const mus_reason *own, mus_reason *out);
/* what is odd before sewing (start.c), but for layers: kind MUS_REASON_NONE when nothing is */
void mus__drape_start(const mus_drape *drape, mus_reason *out);

/* ---- welding (weld.c) ---- */
void mus__drape_open(mus_drape *drape);
/* of a seam pair near the end [N/m]: more than the cloth that it joins, so that a tight seam closes */
double mus__drape_pair_stiffness(const mus_drape *drape);
/* what does not wait */
void mus__drape_weld(mus_drape *drape);
/* seams that were open when this layer's sewing began are again, nodes at x (n x 3) */
void mus__drape_reopen(mus_drape *drape, const double *x);

/* ---- forces in double, plain form (forces.c) ---- */

/* force on each node (n x 3) at positions x (n x 3): the reference for the kernels, and what residuals are taken of.
 * Returns the elastic energy [J]. f NULL: energy alone. */
double mus__plan_force(const mus__plan *plan, int32_t n, const double *x, double *f);
/* largest engineering strain of the stretch springs at x */
double mus__plan_strain(const mus__plan *plan, const double *x);
/* rms over free nodes of the force that contact and friction leave, over the node's weight; *unheld (may be NULL) gets
 * that over those that touch nothing */
double mus__drape_residual(const mus_drape *drape, const double *x, double *unheld);
/* largest gap of the seam pairs and, if wanted, the seam that has it; 0 without seams */
double mus__drape_gap(const mus_drape *drape, int32_t *seam);

/* ---- runs (run.c): what sew and settle share ---- */

typedef struct mus__run {
    mus_progress_fn progress;
    void *user;
    const char *phase;
    double next_call; /* wall time of the next progress call */
    int32_t stop;     /* nonzero: the caller's function wants to stop */
    int32_t slid;     /* nonzero: the garment slid off the body */
    int32_t sleeved;  /* nonzero: what closes round limbs is sewn over cloth: round it, and through none */
} mus__run;

void mus__run_start(mus__run *run, const char *phase, mus_progress_fn progress, void *user);
/* calls the caller's function if it is time, and notes in run->stop what it wants */
void mus__run_report(mus__run *run, double progress);
/* MUS_ERR_DIVERGED (and the last good state restored) when a number is not finite or too fast */
mus_status mus__drape_check_motion(mus_drape *drape);
/* MUS_ERR_DIVERGED (and the last good state restored) when a number is not finite, else a new good state */
mus_status mus__drape_guard(mus_drape *drape);
/* sew and settle ask of the skin by planes (contact/near.h), from anew; taken by the first, kept */
mus_status mus__drape_near(mus_drape *drape);
/* what sewing and settling need beside the state (mean, before, left): taken by the first, kept until the drape is
 * destroyed; a first that fails for memory gives it back */
mus_status mus__drape_scratch(mus_drape *drape);
void mus__drape_scratch_free(mus_drape *drape);

/* ---- garments over one another (layers.c) ---- */

typedef mus_status (*mus__drape_sew_fn)(mus_drape *drape, mus__run *run);

/* nonzero: panels are in several layers, and cloth meets cloth */
int32_t mus__drape_layered(const mus_drape *drape);
/* sew and let down layer after layer; `all` sews on every cut, `here` on this one */
mus_status mus__drape_sew_layers(mus_drape *drape, mus__run *run, mus__drape_sew_fn all, mus__drape_sew_fn here);
/* nonzero: the straight way between two nodes goes to the other side of worn cloth, which is that of the layers below
 * the one being sewn: through a sheet of it, not in and out of a fold. Triangles that hold either node are not asked.
 * Cost: the boxes of all worn triangles */
int32_t mus__drape_worn_between(const mus_drape *drape, int32_t i, int32_t k);
/* crossings of a layer's triangles with those of the layers below it */
int64_t mus__drape_worn_crossings(const mus_drape *drape, int32_t layer);
/* what is sewn falls on this cut until it nearly rests (settle.c) */
mus_status mus__drape_let_down(mus_drape *drape, mus__run *run);

#endif
