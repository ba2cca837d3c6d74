/*
 * muslin/drape.h: cloth in time: placed round a body, sewn, stepped, settled.
 *
 * Create a drape, then place it (nodes go where the pattern's placement says), then sew it (seams are pulled shut by
 * elastic force until all pairs are within the collision distance, then welded), then settle it (to rest under
 * gravity), or step it by hand. mus_drape_step() uses fixed-step classical RK4 (paper eq. 5) or velocity Verlet; sew
 * and settle use symplectic Euler on the same force passes. Contact: node, axial coordinate on its limb, in-between
 * contour at that height, with inelastic response, Coulomb friction and position correction, as impulses. Source:
 * Metaaphanon, Kanongchaiyos, Real-time Cloth Simulation for Garment CAD, 2005, sections 2 and 4 ("paper").
 *
 * The state is bit-identical for any number of threads. A step allocates nothing and logs nothing.
 */
#ifndef MUSLIN_DRAPE_H
#define MUSLIN_DRAPE_H

#include "muslin/arrange.h"
#include "muslin/base.h"
#include "muslin/body.h"
#include "muslin/cloth.h"
#include "muslin/integrate.h"
#include "muslin/pattern.h"
#include "muslin/pose.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mus_drape mus_drape;

/** Options of a drape. */
typedef struct mus_drape_def {
    size_t size;
    double gravity[3];         /* [m/s2], default (0, -9.81, 0) */
    int32_t precision;         /* 32 (float, default), 64 (double), or 0: 64 for cloth so stiff that the rounding of
                                * float alone would leave more force than settle_residual, else 32 */
    int32_t threads;           /* 1 (default) .. 64; the result does not depend on it */
    double collision_distance; /* sewing ends when all pairs are this close [m], default 0.001, at most the spacing */
    double clearance;          /* distance at which cloth is kept off the skin [m], default 0.002 */
    double friction;           /* on skin; NaN (default): the fabric's; infinite: cloth that touches sticks */
    double drag;               /* air drag per mass in mus_drape_step [1/s], default 0.5 */
    double seam_pull;          /* tension that pulls a seam shut [N per m of seam], default 50 */
    double sew_seconds;        /* give up sewing after this much cloth time [s], default 6 */
    double settle_seconds;     /* give up settling after this much cloth time on the finest cut at the latest [s],
                                * default 10; cloth caught on a hook is given up sooner */
    double settle_residual;    /* rest: rms residual force over node weight below this, default 0.02 */
    int32_t integrator;        /* of mus_drape_step: MUS_METHOD_RK4 (default) or MUS_METHOD_VERLET */
    double contact_ball;       /* of mus_drape_step: a node near the skin remembers its contact plane while it stays in
                                * a ball of this radius [m], 0 (default) .. 0.001. At 0.00025 contact is micrometres
                                * off and several times as cheap; contact_impulse of the report then leaves out the
                                * impulses of remembered planes */
    int32_t self_contact;      /* nonzero: cloth meets cloth in stepping, sewing and settling; 0 (default) */
    double thickness;     /* distance at which cloth is kept off cloth [m], default 0.002, at most half the spacing */
    double self_friction; /* of cloth on cloth; NaN (default): the fabric's; infinite: cloth that touches sticks */
    int32_t sew_once;     /* nonzero: sewing gives up when its first try does not close the coarsest cut, for a
                           * caller that has another start; 0 (default): it goes on with straight pulls and finer
                           * cuts */
    double progress_seconds; /* wall time between two calls of a progress function at least [s], default 0.1, looked
                              * at every few steps; 0: it is called at each check of the run alone */
} mus_drape_def;

/** Zero `def`, write the defaults and its size. `size` is sizeof(mus_drape_def) of the caller. */
MUS_API void mus_drape_def_init(mus_drape_def *def, size_t size);

/**
 * Make a drape of a cloth, round a body or (body NULL) in empty space. Nodes start flat in their panels' planes.
 *
 * Cloth and body are copied as far as needed; the caller may destroy them. `def` may be NULL.
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY
 * Memory:  all that stepping will ever need
 */
MUS_API mus_status mus_drape_create(mus_context *context, const mus_cloth *cloth, const mus_body *body,
                                    const mus_drape_def *def, mus_drape **out);

/**
 * Make a plain drape: a cloth in empty space, in float, without self-contact. All else is as by mus_drape_create().
 *
 * A program that makes its drapes by this call alone links no code of bodies, contact, self-contact and double
 * precision, but what other calls name (mus_drape_add_plane).
 * Errors:  MUS_ERR_ARG (also: precision 64, self_contact), MUS_ERR_VERSION, MUS_ERR_MEMORY
 */
MUS_API mus_status mus_drape_create_plain(mus_context *context, const mus_cloth *cloth, const mus_drape_def *def,
                                          mus_drape **out);

/** Destroy a drape; NULL is accepted. */
MUS_API void mus_drape_destroy(mus_drape *drape);

/** Put the nodes where the pattern's placement says, at rest, and open all seams again. */
MUS_API mus_status mus_drape_place(mus_drape *drape);

/**
 * Put the cloth where the cloth of another drape lies, at rest: a refit after a change of fabric, spacing, body or (a
 * little) of the pattern. Seams are welded when those of `from` are.
 *
 * Panels correspond by index, places in a panel relative to its box. `from` may have another spacing and precision.
 * Friction of bending (mus_fabric.bend_hysteresis) begins anew, as in flat cloth that was bent once to where it lies.
 * Errors:  MUS_ERR_ARG (NULL, another number of panels), MUS_ERR_MEMORY; the drape is as it was
 * Cost:    about 1 us a node
 */
MUS_API mus_status mus_drape_warm(mus_drape *drape, const mus_drape *from);

/** Set positions (nodes x 3) [m] and velocities (nodes x 3, may be NULL: zero). Errors: MUS_ERR_ARG (not finite, a
 * position beyond 1e7 m; with precision 32 more than 10 km from the middle of the cloth as placed). */
MUS_API mus_status mus_drape_set_state(mus_drape *drape, const double *positions, const double *velocities);

/** Fix a node at its place (fixed nonzero), or free it. Fixed nodes side by side are a clamp: bending over their border
 * is that of cloth held flat up to it. Errors: MUS_ERR_ARG; MUS_ERR_MEMORY, the node is as it was. Cost: one pass over
 * all nodes of the cloth; n nodes are pinned in a time that grows with n times the number of nodes. */
MUS_API mus_status mus_drape_pin(mus_drape *drape, int32_t node, int32_t fixed);

/**
 * Put a tack in: a stitch of thread between two nodes, a spring of no length that draws them together from now on.
 *
 * E = 1/2 stiffness |x_b - x_a|^2, damped as the fabric's springs. The call moves nothing, and the energy grows by E.
 * mus_drape_step_bound includes the tack at once, and mus_drape_step refuses a step above it. The tack stays through
 * place, warm, set_state, sew and settle, until it is taken out. After welding it connects the merged nodes. It exerts
 * no force while both ends are one node, or while an end belongs to a layer that is not sewn yet. With self_contact its
 * two nodes stay a thickness apart and it pulls with stiffness * thickness; above some newtons the cloth may not come
 * to rest.
 *
 * `index` (may be NULL) gets the number of the tack, the lowest that is free.
 * Units:   stiffness [N/m], 0 (slack) to 1e9
 * Errors:  MUS_ERR_ARG (no such node, a = b, a stiffness not finite or not in its range); MUS_ERR_STATE (both nodes are
 *          fixed, and more than the collision distance apart); MUS_ERR_LIMIT (2^24 tacks); MUS_ERR_MEMORY; the drape is
 *          as it was
 * Memory:  capacity for 16 with the first, doubled when it is full, kept until the drape is destroyed
 * Cost:    about half a microsecond a node; in a step that of an irregular spring, and nothing without tacks
 */
MUS_API mus_status mus_drape_tack(mus_drape *drape, int32_t a, int32_t b, double stiffness, int32_t *index);

/** Take a tack out; its number is free again, and bound and forces are without it. Errors: MUS_ERR_ARG (no such
 * tack). */
MUS_API mus_status mus_drape_untack(mus_drape *drape, int32_t index);

/** Change gravity (3) [m/s2] from now on. Errors: MUS_ERR_ARG (NULL, not finite, beyond 1e4). */
MUS_API mus_status mus_drape_set_gravity(mus_drape *drape, const double *gravity);

/**
 * Largest step for the def's integrator with pose, springs, masses and damping as they are now [s]: proven stable at
 * this pose, and for Verlet below the first resonance of motion.
 *
 * With O^2 = max_i lambda_max(T_i) / m_i, T_i (3 x 3) the sum over springs at node i of 2 k (n n^T + t (1 - n n^T)), n
 * along the spring and t = max(0, 1 - rest/l) of a stretched one, and of 4 k, 8 k, 4 k (identity) for bending,
 * G = drag + max_i (sum of 2 c over dashpots) / m_i and b the largest c / k:
 *
 *   RK4:     h = min(2.62 / O, 2.785 / r),  r = (G + sqrt(G^2 - 4 (G - drag) / b)) / 2, left out where there is no root
 *   Verlet:  h = 3 / (D + sqrt(D^2 + 3 O^2)),  D = G - drag; without dashpots sqrt(3) / O. Any drag is stable
 *
 * Source: every root lies in a half disc or on the real axis (proof: lib/sim/step_bound.c); Runge-Kutta is stable in
 * the half disc of radius 2.62 and from -2.785 to 0. Verlet at one pose is stable to 2 / O; in motion a mode whose
 * period is three steps, sqrt(3) / O, gains energy (Schlick and others, J. Comput. Phys. 140, 1998).
 */
MUS_API double mus_drape_step_bound(const mus_drape *drape);

/**
 * Advance by `steps` steps of `dt` of the def's integrator, with contact after each.
 *
 * The bound is taken anew every 512 steps, or when a node may have gone as far as its neighbour. Where the pose has
 * lowered it below dt, steps are made in equal parts until it is above dt again; step_parts of the report tells the
 * largest number of parts.
 * Errors:  MUS_ERR_ARG (steps < 0; dt negative, not finite, or below 1e-30 s and not 0); MUS_ERR_STEP (dt above the
 *          bound: both in the message);
 *          MUS_ERR_DIVERGED (a node not finite or beyond the speed limit; without a body, planes, open seams and
 *          self-contact: the energy is above that of the start by 1 % of the largest kinetic and elastic energy since.
 *          The state is that of the last good look)
 * Memory:  allocates nothing
 * Cost:    a step is 4 force evaluations (RK4) or 1 (Verlet; its first after a change of the state 1 more) and one
 *          contact pass
 */
MUS_API mus_status mus_drape_step(mus_drape *drape, int32_t steps, double dt);

/**
 * Evaluate the forces of the present state `times` times, as a step does, and throw them away. Benchmarks time it.
 *
 * Errors: MUS_ERR_ARG (times < 0)
 * Memory: allocates nothing; the state stays as it is
 */
MUS_API mus_status mus_drape_evaluate(mus_drape *drape, int32_t times);

/**
 * Move the body as a whole with a constant velocity from now on, in mus_drape_step.
 *
 * `velocity` (3) [m/s]; 0 stops the body where it is. Contact and friction act relative to the body; the report tells
 * penetration at its present place. mus_drape_place puts it back, at rest. Sewing and settling need it at rest
 * (MUS_ERR_STATE).
 * Errors:  MUS_ERR_ARG (not finite, above 1000 m/s); MUS_ERR_STATE (no body)
 */
MUS_API mus_status mus_drape_move_body(mus_drape *drape, const double *velocity);

/**
 * Move the body to a pose: in the next `duration` seconds of mus_drape_step it goes from its present pose to `pose`,
 * each joint along its shortest rotation, and then stands there. Duration 0: it stands there at once, at rest.
 *
 * `pose` is relative to the body as made (mus_body_pose); its place is added to the motion of the body as a whole.
 * Contact and friction act relative to the motion of each part, and fast nodes are swept against it. A new call starts
 * from the pose at that time, so a keyed movement is one call a frame. mus_drape_place puts the body back as it was
 * given to create. Sewing and settling work round a body in any pose, at rest (MUS_ERR_STATE during a movement).
 * Units:   duration [s], 0 to 1e6
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION; MUS_ERR_STATE (no body); MUS_ERR_BODY (an angle beyond its joint's limits)
 * Cost:    on the way about a microsecond a step
 */
MUS_API mus_status mus_drape_pose_body(mus_drape *drape, const mus_pose *pose, double duration);

/**
 * The pose of the body now; `place` includes its motion as a whole.
 *
 * Exact at rest; during a movement the angles are interpolated evenly between the two poses.
 * Errors:  MUS_ERR_ARG; MUS_ERR_STATE (no body)
 */
MUS_API mus_status mus_drape_body_pose(const mus_drape *drape, mus_pose *out);

/** A plane beside the body: ground, incline, table, belt, turntable, shaken table. */
typedef struct mus_plane {
    size_t size;
    double point[3];    /* on it; the middle of a disc, what it spins about [m], default 0 */
    double normal[3];   /* to the side where cloth is, of any length, default (0, 1, 0) */
    double velocity[3]; /* of the plane as a whole [m/s], default 0; along itself: a belt */
    double spin;        /* about the normal through the point [rad/s], default 0 */
    double friction;    /* below 0 (default): the drape's; infinite: what touches, sticks */
    double reach;       /* radius of a disc [m]; 0 (default): no end */
} mus_plane;

/** Zero `plane`, write the defaults and its size. */
MUS_API void mus_plane_init(mus_plane *plane, size_t size);

/**
 * Add a plane to the scene, from now on. Cloth is kept off it, and slides or sticks as on skin, in sewing and settling
 * too.
 *
 * `plane` NULL: the ground, y = 0. `index` (may be NULL) gets its number, from 0 on. Nothing passes an endless plane. A
 * disc is 1 cm thick, and a node farther below it is under the table. The report counts depth below planes and impulses
 * of planes as those of the body. A moving plane moves in mus_drape_step; mus_drape_place puts it back as it was added.
 * Sewing and settling need it at rest (MUS_ERR_STATE).
 * Errors:  MUS_ERR_ARG (not finite, beyond 10 km, 1000 m/s or 1000 rad/s, normal of no length), MUS_ERR_VERSION;
 *          MUS_ERR_LIMIT (32 planes are there), MUS_ERR_MEMORY
 * Cost:    a few multiplications a node and plane, many nodes at once
 */
MUS_API mus_status mus_drape_add_plane(mus_drape *drape, const mus_plane *plane, int32_t *index);

/**
 * Move a plane with `velocity` (3) [m/s] and `spin` [rad/s] from now on, from its present place.
 *
 * Errors:  MUS_ERR_ARG (no such plane, not finite, above 1000)
 */
MUS_API mus_status mus_drape_move_plane(mus_drape *drape, int32_t index, const double *velocity, double spin);

/** The cost of a run of steps, told before it. */
typedef struct mus_estimate {
    size_t size;
    double step;             /* to use: at most 0.9 of the bound, a whole part of the frame [s] */
    double step_bound;       /* [s] */
    int32_t steps_per_frame; /* of `step` each */
    int32_t node;            /* that sets the bound, MUS_NONE without springs */
    double node_mass;        /* [kg] */
    double node_stiffness;   /* lambda_max(T) of it [N/m] */
    double bend_share;       /* share of it from bending, seams, tacks and attachments; the rest is stretch and shear */
    double seconds;          /* CPU seconds for a frame, from a trial of a few steps, which are taken back */
    int64_t node_evaluations; /* a frame */
} mus_estimate;

/** Zero `estimate` and write its size. */
MUS_API void mus_estimate_init(mus_estimate *estimate, size_t size);

/**
 * Estimate step, steps a frame and CPU time of mus_drape_step, and name the node that sets the bound.
 *
 * Units:  frame [s], above 0
 * Errors: MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY
 * Cost:   8 steps; the state is as before
 */
MUS_API mus_status mus_drape_estimate(mus_drape *drape, double frame, mus_estimate *out);

/**
 * Force of springs, tacks, bending and gravity on each node: out (nodes x 3) [N], without contact, damping and open
 * seams.
 *
 * At a fixed node it is minus the reaction of the fixing; at a free node at rest it is minus the force that the skin
 * carries. Welded nodes all have the force on their one node.
 */
MUS_API mus_status mus_drape_forces(const mus_drape *drape, double *out);

/**
 * Depth of points in the body and the planes as they stand now: positive inside.
 *
 * Contact uses the same depth: a node is kept out where depth > -clearance, along this normal. (mus_body_depth() takes
 * the body as it was made; at a shoulder the two differ by some tenths of a millimetre.)
 * Shapes:  points (n x 3) [m], depth (n) [m], normal (n x 3) outward or NULL
 * depth is -1e30, and the normal 0, for a point that is farther than 4 cm from everything.
 * Errors:  MUS_ERR_ARG (NULL; n < 0; a point that is not finite)
 */
MUS_API mus_status mus_drape_depth(const mus_drape *drape, int32_t n, const double *points, double *depth,
                                   double *normal);

/** What a progress function is told. The arrays are borrowed until it returns. */
typedef struct mus_progress {
    size_t size;
    const char *phase;       /* "sew" or "settle" */
    double progress;         /* share of the phase that is done, 0..1 */
    int32_t coarse;          /* nonzero: a coarser cut moves now (mus_cloth_def.coarser); 0: the cloth itself */
    int32_t nodes;           /* of the cut that moves */
    int32_t triangles;       /* of that cut */
    const double *positions; /* (nodes x 3) [m]; welded nodes share their position */
    const int32_t *triangle; /* (triangles x 3) corners */
} mus_progress;

/** Called during mus_drape_sew() and mus_drape_settle() once in def.progress_seconds of wall time at most. A value
 * other than 0 stops the run, which then returns MUS_ERR_STOPPED. The result does not depend on the calls. */
typedef int32_t (*mus_progress_fn)(void *user, const mus_progress *progress);

/**
 * Pull all seams shut and weld them. Gravity is off meanwhile, the body holds its fingers together, and its feet are
 * away; mus_drape_settle() lets them in.
 *
 * The coarser cuts of the cloth are sewn first (mus_cloth_def.coarser). Where the panels of a seam are placed as one
 * goes on from the other, its bending acts from the start and turns both sides towards one plane. With self_contact,
 * panels that begin over each other in one plane are moved apart first: the lower one goes down; of two side by side,
 * each goes half of the way. A few sheets of cloth between the last pairs of a seam do not keep it open: the pairs are
 * welded, and crossings are drawn apart as by mus_drape_untangle(). Worn layers do keep it open: a seam that would go
 * through them stays open, and the error tells so. Crossings that are left are counted by mus_drape_crossings().
 * Errors: MUS_ERR_SEW (the message names the seam and its gap; the state is as far as it got); MUS_ERR_STOPPED (by
 *         `progress`; the state is as far as it got); MUS_ERR_DIVERGED; MUS_ERR_MEMORY (the state is as far as it
 *         got: place it and sew again)
 * Memory: with a progress function 6 doubles a node during the call
 */
MUS_API mus_status mus_drape_sew(mus_drape *drape, mus_progress_fn progress, void *user);

/**
 * Let the cloth come to rest under gravity, on coarser cuts first when it is far from rest.
 *
 * At rest: at the mean place of the last steps (where cloth lies on cloth, of the last 0.05 s) the residual is below
 * settle_residual, and no node's mean place moves faster than 2 mm/s. Of a node that touches skin, plane or cloth no
 * more force counts than moved it in those steps: what springs leave there is only as exact as the normals of the
 * contacts, and a node wedged between surfaces bears thousands of its weight. Where cloth presses a node more than 0.7
 * mm into the body, or lies beside it where two surfaces leave no room for another layer, its thickness yields, down to
 * a quarter, until there is room. Nodes stay off the skin by the clearance and by what the triangles between them need
 * to be off it too; the skin shows through no triangle by more than some tenths of a millimetre, unless it is held
 * there. Errors: MUS_ERR_UNSETTLED (residual in the message), MUS_ERR_STOPPED (by `progress`), MUS_ERR_DIVERGED,
 * MUS_ERR_MEMORY (the state is as far as it got, with STOPPED and MEMORY) Memory: the first sew or settle makes the
 * coarse drapes, a third of the drape, kept until it is destroyed; the first settle 28 doubles, a float and 7 numbers
 * of the state's precision a node, kept too; with a progress function 6 doubles a node during the call Source: dynamic
 * relaxation, Underwood 1983; without self-contact the inertia of a node is the 3 x 3 bound of its stiffness
 */
MUS_API mus_status mus_drape_settle(mus_drape *drape, mus_progress_fn progress, void *user);

/** Positions and velocities (nodes x 3): the drape's own output arrays, written anew at the end of place, set_state,
 * step, sew and settle; the addresses stay the same until the drape is destroyed. Welded nodes share their place. */
MUS_API const double *mus_drape_positions(const mus_drape *drape);
/** See mus_drape_positions(). */
MUS_API const double *mus_drape_velocities(const mus_drape *drape);
/** Number of nodes: the length of the arrays. */
MUS_API int32_t mus_drape_node_count(const mus_drape *drape);

/** Cloth time since place [s]. */
MUS_API double mus_drape_time(const mus_drape *drape);

/**
 * Check the cloth as it lies now, before it is sewn: MUS_REASON_START_TANGLED with panel or seam and a sentence, or
 * MUS_REASON_NONE.
 *
 * A panel inside the body; a seam whose sides lie the wrong way round; panels in each other's place or turned round;
 * panels through one another; layers whose order is not the same all round.
 * Errors: MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY
 * Cost:   some microseconds a node
 */
MUS_API mus_status mus_drape_start(const mus_drape *drape, mus_reason *out);

/** Why the last sew or settle ended as it did. Errors: MUS_ERR_ARG, MUS_ERR_VERSION. */
MUS_API mus_status mus_drape_reason(const mus_drape *drape, mus_reason *out);

/** What a drape did, and its present state. */
typedef struct mus_drape_report {
    size_t size;
    int32_t nodes;
    int32_t springs;            /* each counted once */
    int32_t seams;              /* of the pattern */
    int32_t seams_closed;       /* within the collision distance or welded */
    int32_t welded;             /* nonzero once the pairs are one */
    int32_t worst_seam;         /* the widest open seam, MUS_NONE without seams */
    int32_t settled;            /* nonzero when the last settle got there */
    double max_seam_gap;        /* [m] */
    double max_penetration;     /* deepest node below the skin [m], 0 if none */
    double max_strain;          /* largest engineering strain of a stretch spring (structural or border) */
    double residual;            /* rms over nodes of residual force over node weight, at the end of the last settle or,
                                 * when the cloth was moved since, here */
    double max_speed;           /* [m/s] */
    double energy;              /* kinetic + elastic + potential [J] */
    double step;                /* last step used [s] */
    double step_bound;          /* [s] */
    int64_t steps;              /* of any kind since create */
    int64_t spring_evaluations; /* since create */
    int64_t contact_queries;    /* node against part of the body or plane, since create */
    double sew_time;            /* cloth time spent sewing [s] */
    double settle_time;         /* cloth time spent settling, on all cuts [s] */
    int32_t step_parts;         /* that the last mus_drape_step divided its steps in at most, 1 as a rule */
    double rest_distance;       /* what the last settle expects its farthest node still to go [m] */
    double contact_impulse[3];  /* that the body gave the cloth since create [N s]: take differences over steps */
    int32_t self_contacts;      /* with self_contact: places where cloth lies on cloth, closer than the thickness */
    int64_t self_queries;       /* node against triangle or edge against edge, since create */
} mus_drape_report;

/** Zero `report` and write its size. */
MUS_API void mus_drape_report_init(mus_drape_report *report, size_t size);
/** Take the report. Errors: MUS_ERR_ARG, MUS_ERR_VERSION. */
MUS_API mus_status mus_drape_report_get(const mus_drape *drape, mus_drape_report *out);

/** The passes that this scene has no work for: comma-separated names ("contact,seams,dashpots"), "" if nothing.
 * Borrowed. */
MUS_API const char *mus_drape_skipped(const mus_drape *drape);

/** 64-bit hash of positions, velocities and time (FNV-1a over the bytes of the state in little-endian order). */
MUS_API uint64_t mus_drape_hash(const mus_drape *drape);

/** Gap of each seam pair [m]: out (pairs). */
MUS_API mus_status mus_drape_gaps(const mus_drape *drape, double *out);

/**
 * Pairs of triangles of the cloth that cross, exactly: an edge of one that has no corner in common with the other meets
 * it, borders included. Nodes that a seam joins count as one. 0 is a certificate for the places as published.
 *
 * `pairs` (most x 2, NULL with most 0) gets the first of them.
 * Errors: MUS_ERR_ARG, MUS_ERR_MEMORY
 * Cost:   about a microsecond a node
 */
MUS_API mus_status mus_drape_crossings(const mus_drape *drape, int32_t most, int32_t *pairs, int64_t *count);

/**
 * Draw cloth that crosses cloth apart, by shortening the contours of crossings, in at most 80 rounds. Needs
 * self_contact.
 *
 * MUS_OK with *left 0 is a certificate as that of mus_drape_crossings; from then on nothing crosses. Shallow crossings
 * go; for a sheet halfway through another nothing tells which side is right. The cloth is at rest after the call.
 * Errors: MUS_ERR_TANGLED (*left pairs of triangles still cross; the state is as far as it got); MUS_ERR_ARG;
 *         MUS_ERR_STATE (without self_contact, or a surface moves); MUS_ERR_DIVERGED; MUS_ERR_LIMIT; MUS_ERR_MEMORY
 * Cost:   a count a round, from the 51st round on 12 steps and two counts
 */
MUS_API mus_status mus_drape_untangle(mus_drape *drape, int64_t *left);

/** Smooth unit normals of the cloth (nodes x 3), right side out, averaged over welded seams. */
MUS_API mus_status mus_drape_normals(const mus_drape *drape, double *out);

#ifdef __cplusplus
}
#endif

#endif
